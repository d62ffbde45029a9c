// Code shared by echo, hz, bw and delay: the type and the QoS of an existing topic, and options that override them.

import { expandName, fullTypeName } from '../decode/ros_names.ts';
import type { QosRequest } from '../contract/session.ts';
import { type Context, CommandError, type Given, type Option } from './command.ts';
import { endpointsOf, topicsOf } from './graph_lists.ts';

export const qosOptions: readonly Option[] = [
  {
    names: ['--qos-profile'],
    value: 'PROFILE',
    choices: ['default', 'sensor_data', 'services_default', 'parameters', 'parameter_events', 'system_default'],
    help: 'Quality of service preset profile',
  },
  { names: ['--qos-depth'], value: 'N', number: true, help: 'Queue size setting' },
  { names: ['--qos-history'], value: 'HISTORY', choices: ['keep_last', 'keep_all'], help: 'History of samples setting' },
  { names: ['--qos-reliability'], value: 'RELIABILITY', choices: ['reliable', 'best_effort'], help: 'Quality of service reliability setting' },
  { names: ['--qos-durability'], value: 'DURABILITY', choices: ['volatile', 'transient_local'], help: 'Quality of service durability setting' },
];

/** The QoS that the options request. */
export function qosAsked({ options }: Given): QosRequest {
  const profile = options.get('qos-profile');
  const depth = options.get('qos-depth');
  const history = options.get('qos-history');
  const reliability = options.get('qos-reliability');
  const durability = options.get('qos-durability');
  return {
    ...(profile === 'sensor_data' ? { reliability: 'best_effort', depth: 5 } as const : {}),
    ...(profile === 'parameters' || profile === 'parameter_events' ? { depth: 1000 } : {}),
    ...(depth === undefined ? {} : { depth: Number(depth) }),
    ...(history === 'keep_all' ? { history } : {}),
    ...(reliability === 'best_effort' || reliability === 'reliable' ? { reliability } : {}),
    ...(durability === 'transient_local' || durability === 'volatile' ? { durability } : {}),
  };
}

/** The QoS that all publishers of a topic fit, unless the user says otherwise. */
export function fittingQos({ session }: Context, topic: string, given: Given): QosRequest {
  const offered = endpointsOf(session.graph(), 'publishers', topic).map(({ endpoint }) => endpoint.qos);
  const all = offered.length > 0;
  return {
    reliability: !all || offered.every(({ reliability }) => reliability === 'reliable') ? 'reliable' : 'best_effort',
    durability: all && offered.every(({ durability }) => durability === 'transient_local') ? 'transient_local' : 'volatile',
    ...qosAsked(given),
  };
}

export interface TopicChoice {
  readonly name: string;
  readonly type: string;
}

/** `type`: what the user says that it is. */
export function chooseTopic(context: Context, given: string, type: string | undefined): TopicChoice {
  const name = expandName(given, '');
  if (type !== undefined) {
    const full = fullTypeName(type);
    if (full === undefined) throw new CommandError('The passed message type is invalid');
    return { name, type: full };
  }
  const topic = topicsOf(context.session.graph()).find((each) => each.name === name);
  if (topic === undefined) {
    context.warn(`WARNING: topic [${name}] does not appear to be published yet`);
    throw new CommandError('Could not determine the type for the passed topic');
  }
  if (topic.types.length > 1) {
    throw new CommandError(`Cannot echo topic '${name}', as it contains more than one type: [${topic.types.join(', ')}]`);
  }
  return { name, type: topic.types[0]! };
}
