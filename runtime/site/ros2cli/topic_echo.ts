// ros2 topic echo, and service echo: messages as they come, until Ctrl-C.

import { inFlow } from '../decode/flow_yaml.ts';
import type { Shape } from '../decode/shape.ts';
import { isFloat } from '../decode/shape.ts';
import { fieldOf, isList, isMessage, TRUNCATE_LENGTH, toYaml } from '../decode/yaml.ts';
import { expandName, fullTypeName } from '../decode/ros_names.ts';
import { type Command, CommandError, type Context, type Given, has, numberOf, type Option, untilDone } from './command.ts';
import { reprFloat, reprScalar } from './python_text.ts';
import { filterOf } from './filter_expression.ts';
import { servicesOf } from './graph_lists.ts';
import { chooseTopic, fittingQos, qosOptions, type TopicChoice } from './subscribing.ts';

/** How messages are shown. */
const showOptions: readonly Option[] = [
  { names: ['--csv'], help: 'Output all recursive fields separated by commas' },
  { names: ['--full-length', '-f'], help: 'Output all elements for arrays, bytes, and string' },
  { names: ['--truncate-length', '-l'], value: 'N', number: true, help: 'The length to truncate arrays, bytes, and string to (default: 128)' },
  { names: ['--no-arr'], help: "Don't print array fields of messages" },
  { names: ['--no-str'], help: "Don't print string fields of messages" },
  { names: ['--flow-style'], help: 'Print arrays in one line' },
];

type Value = Readonly<Record<string, unknown>>;

export const topicEcho: Command = {
  words: ['topic', 'echo'],
  help: 'Output messages from a topic',
  positionals: [{ name: 'topic_name', meaning: 'topic' }, { name: 'message_type', meaning: 'message_type', optional: true }],
  options: [
    ...qosOptions,
    ...showOptions,
    { names: ['--field'], value: 'FIELD', help: 'Echo a selected field of a message. Use "." to select sub-fields.' },
    { names: ['--filter'], value: 'FILTER_EXPR', help: 'Python expression over the message m: only messages for which it is true are printed' },
    { names: ['--once'], help: 'Print the first message received and then exit.' },
    { names: ['--timeout'], value: 'N', number: true, help: 'Set a timeout in seconds' },
    { names: ['--raw'], help: 'Echo the raw binary representation' },
  ],
  run: async (context, given) => {
    const [topic = '', typed] = given.positionals;
    return await echo(context, given, chooseTopic(context, topic, typed));
  },
};

/** As service_msgs/msg/ServiceEventInfo numbers them. */
const eventTypes = ['REQUEST_SENT', 'REQUEST_RECEIVED', 'RESPONSE_SENT', 'RESPONSE_RECEIVED'];

export const serviceEcho: Command = {
  words: ['service', 'echo'],
  help: 'Echo a service',
  positionals: [{ name: 'service_name', meaning: 'service' }, { name: 'service_type', meaning: 'service_type', optional: true }],
  options: [...qosOptions, ...showOptions],
  run: async (context, given) => {
    const [service = '', typed] = given.positionals;
    const name = expandName(service, '');
    const type = typed === undefined ? servicesOf(context.session.graph()).find((each) => each.name === name)?.types[0] : fullTypeName(typed, 'srv');
    if (type === undefined)
      throw new CommandError(typed === undefined ? 'Could not determine the type for the passed service' : 'The passed service type is invalid');
    const named = (value: Value): Value => {
      const { info } = value;
      if (!isMessage(info)) return value;
      return { ...value, info: { ...info, event_type: eventTypes[Number(info['event_type'])] ?? info['event_type'] } };
    };
    return await echo(context, given, { name: `${name}/_service_event`, type: `${type}_Event` }, named);
  },
};

/** `seen`: a message as it is to be shown. */
async function echo(context: Context, given: Given, { name, type }: TopicChoice, seen: (value: Value) => Value = (value) => value): Promise<number> {
  const codec = await context.codec();
  const parsed = codec.types.get(type);
  if (typeof parsed === 'string') throw new CommandError(parsed);
  const truncate = has(given, 'full-length') ? null : numberOf(given, 'truncate-length', TRUNCATE_LENGTH);
  const path = given.options.get('field')?.split('.');
  const filter = given.options.get('filter');
  const passes = filter === undefined ? undefined : filterOf(filter);
  const node = context.session.node();
  let failure: string | undefined;
  let came = false;
  await untilDone(context.signal, (done) => {
    const subscription = node.subscription(name, type, fittingQos(context, name, given), (bytes) => {
      if (failure !== undefined || (came && has(given, 'once'))) return;
      const at = has(given, 'raw') && passes === undefined ? undefined : pick(bytes);
      if (at !== undefined && !isWanted(at)) return;
      came = true;
      if (failure === undefined) {
        if (has(given, 'raw')) context.print(pythonBytes(bytes));
        else if (at !== undefined) context.print(show(at));
      }
      if (failure !== undefined || has(given, 'once')) done();
    });
    if (subscription.problem !== undefined) {
      failure = subscription.problem.message;
      queueMicrotask(done);
    }
    const seconds = given.options.get('timeout');
    const timer = seconds === undefined ? [] : [node.timer(Number(seconds) * 1000, () => {
      if (!came) failure = 'No message received within the timeout.';
      done();
    })];
    return [subscription, ...timer];
  });
  if (failure !== undefined) throw new CommandError(failure);
  return 0;

  /** By `--filter`; an expression that fails ends the command. */
  function isWanted({ value }: Selected): boolean {
    if (passes === undefined) return true;
    try {
      return passes(value);
    } catch (error) {
      if (!(error instanceof CommandError)) throw error;
      failure = error.message;
      return true;
    }
  }

  function pick(bytes: Uint8Array): Selected | undefined {
    const decoded = codec.decode(type, bytes);
    if (decoded.kind === 'failed') {
      context.warn(decoded.reason);
      return undefined;
    }
    const at = select(seen(decoded.value as Value), decoded.shape, path ?? []);
    if (typeof at === 'string') {
      failure = `Invalid field '${path?.join('.') ?? ''}': ${at}`;
      return undefined;
    }
    return at;
  }

  function show({ value, shape, float }: Selected): string {
    if (has(given, 'csv')) return csv(value, truncate).join(',');
    if (!isMessage(value)) {
      const text = isList(value)
        ? `[${Array.from(cut(value, truncate), (item) => isMessage(item) ? toYaml(item, shape, truncate).trimEnd() : reprScalar(item, float)).join(', ')}]`
        : typeof value === 'string'
        ? value
        : reprScalar(value, float);
      return `${text}\n---`;
    }
    return `${toYaml(without(value, has(given, 'no-arr'), has(given, 'no-str'), shape), shape, truncate, has(given, 'flow-style') ? inFlow : undefined)}---`;
  }
}

interface Selected {
  readonly value: unknown;
  readonly shape: Shape | null;
  readonly float: boolean;
}

function select(message: unknown, shape: Shape, path: readonly string[]): Selected | string {
  let at: Selected = { value: message, shape, float: false };
  for (const step of path) {
    const match = /^(\w+)((?:\[\d+\])*)$/.exec(step);
    const field = match === null ? undefined : fieldOf(at.shape, match[1]!);
    if (match === null || field === undefined || !isMessage(at.value)) return `there is no field '${step}'`;
    let value: unknown = at.value[field.name];
    for (const [, index] of match[2]!.matchAll(/\[(\d+)\]/g)) {
      if (!isList(value) || Number(index) >= value.length) return `there is no item ${index}`;
      value = value[Number(index)];
    }
    at = { value, shape: field.shape, float: isFloat(field) };
  }
  return at;
}

function cut(list: ArrayLike<unknown>, truncate: number | null): ArrayLike<unknown> {
  return truncate === null || list.length <= truncate ? list : Array.prototype.slice.call(list, 0, truncate);
}

/** Left out fields keep their name, as upstream shows them. */
function without(value: Readonly<Record<string, unknown>>, arrays: boolean, texts: boolean, shape: Shape | null): Readonly<Record<string, unknown>> {
  if (!arrays && !texts) return value;
  return Object.fromEntries(Object.entries(value).map(([name, each]) => {
    const field = fieldOf(shape, name);
    if (isList(each)) return [name, arrays ? `<sequence type: ${field?.type ?? ''}, length: ${each.length}>` : each];
    if (typeof each === 'string') return [name, texts ? `<string length: <${each.length}>>` : each];
    return [name, isMessage(each) ? without(each, arrays, texts, field?.shape ?? null) : each];
  }));
}

function csv(value: unknown, truncate: number | null): string[] {
  if (isList(value)) {
    const items = Array.from(cut(value, truncate)).flatMap((item) => csv(item, truncate));
    return truncate !== null && value.length > truncate ? [...items, '...'] : items;
  }
  if (isMessage(value)) return Object.values(value).flatMap((each) => csv(each, truncate));
  if (typeof value === 'string') return [truncate !== null && value.length > truncate ? `${value.slice(0, truncate)}...` : value];
  return [typeof value === 'number' && !Number.isInteger(value) ? reprFloat(value) : reprScalar(value)];
}

function pythonBytes(bytes: Uint8Array): string {
  const text = Array.from(bytes, (byte) =>
    byte >= 32 && byte < 127 && byte !== 39 && byte !== 92
      ? String.fromCharCode(byte)
      : byte === 39 || byte === 92
      ? `\\${String.fromCharCode(byte)}`
      : `\\x${byte.toString(16).padStart(2, '0')}`).join('');
  return `b'${text}'\n---`;
}
