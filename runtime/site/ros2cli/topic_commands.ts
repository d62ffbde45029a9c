// ros2 topic list, info, type, find.

import { splitNodeName } from '../decode/ros_names.ts';
import type { EndpointQosView } from '../contract/session.ts';
import { misfitPolicy } from '../contract/qos_view.ts';
import { type Command, CommandError, has } from './command.ts';
import { endpointsOf, type OfNode, shown, topicsOf } from './graph_lists.ts';

export const hiddenTopics = { names: ['--include-hidden-topics'], help: 'Consider hidden topics as well' } as const;

export const topicCommands: readonly Command[] = [
  {
    words: ['topic', 'list'],
    help: 'Output a list of available topics',
    positionals: [],
    options: [
      { names: ['--show-types', '-t'], help: 'Additionally show the topic type' },
      { names: ['--count-topics', '-c'], help: 'Only display the number of topics discovered' },
      hiddenTopics,
      { names: ['--verbose', '-v'], help: 'List full details about each topic' },
    ],
    run: (context, given) => {
      const graph = context.session.graph();
      const topics = shown(topicsOf(graph), has(given, 'include-hidden-topics'));
      if (has(given, 'count-topics')) {
        context.print(String(topics.length));
      } else if (has(given, 'verbose')) {
        for (const [head, kind, one] of [['Published', 'publishers', 'publisher'], ['Subscribed', 'subscriptions', 'subscriber']] as const) {
          const rows = topics.flatMap(({ name, types }) => {
            const count = endpointsOf(graph, kind, name).length;
            return count === 0 ? [] : [` * ${name} [${types.join(', ')}] ${count} ${one}${count > 1 ? 's' : ''}`];
          });
          context.print([`${head} topics:`, ...rows, ''].join('\n'));
        }
      } else {
        for (const { name, types } of topics) context.print(has(given, 'show-types') ? `${name} [${types.join(', ')}]` : name);
      }
      return Promise.resolve(0);
    },
  },
  {
    words: ['topic', 'info'],
    help: 'Print information about a topic',
    positionals: [{ name: 'topic_name', meaning: 'topic' }],
    options: [{
      names: ['--verbose', '-v'],
      help:
        'Prints detailed information like the node name, node namespace, topic type, topic type hash, GUID and QoS profile of the publishers and subscribers to this topic',
    }],
    run: (context, given) => {
      const [name = ''] = given.positionals;
      const graph = context.session.graph();
      const topic = topicsOf(graph).find((each) => each.name === name);
      if (topic === undefined) throw new CommandError(`Unknown topic '${name}'`);
      const verbose = has(given, 'verbose');
      const end = verbose ? '\n' : '';
      const lists = [['Publisher', endpointsOf(graph, 'publishers', name)], ['Subscription', endpointsOf(graph, 'subscriptions', name)]] as const;
      context.print(`Type: ${topic.types.length === 1 ? topic.types[0] : `[${topic.types.map((type) => `'${type}'`).join(', ')}]`}${end}`);
      for (const [what, list] of lists) {
        context.print(`${what} count: ${list.length}${end}`);
        if (verbose) { for (const each of list) context.print(`${endpointText(what.toUpperCase(), each)}${end}`); }
      }
      if (verbose) { for (const hint of misfitHints(name, lists[0][1], lists[1][1])) context.warn(hint); }
      return Promise.resolve(0);
    },
  },
  {
    words: ['topic', 'type'],
    help: "Print a topic's type",
    positionals: [{ name: 'topic_name', meaning: 'topic' }],
    options: [],
    run: (context, given) => {
      const topic = topicsOf(context.session.graph()).find(({ name }) => name === given.positionals[0]);
      for (const type of topic?.types ?? []) context.print(type);
      return Promise.resolve(topic === undefined ? 1 : 0);
    },
  },
  {
    words: ['topic', 'find'],
    help: 'Output a list of available topics of a given type',
    positionals: [{ name: 'topic_type', meaning: 'message_type' }],
    options: [{ names: ['--count-topics', '-c'], help: 'Only display the number of topics discovered' }, hiddenTopics],
    run: (context, given) => {
      const [wanted = ''] = given.positionals;
      const found = shown(topicsOf(context.session.graph()), has(given, 'include-hidden-topics')).filter(({ types }) => types.includes(wanted));
      if (has(given, 'count-topics')) context.print(String(found.length));
      else for (const { name } of found) context.print(name);
      return Promise.resolve(0);
    },
  },
];

function endpointText(kind: string, { node, endpoint }: OfNode): string {
  const { namespace, name } = splitNodeName(node.name);
  return [
    `Node name: ${name}`,
    `Node namespace: ${namespace}`,
    `Topic type: ${endpoint.type}`,
    `Topic type hash: ${endpoint.hash === '' ? 'INVALID' : endpoint.hash}`,
    `Endpoint type: ${kind}`,
    `GID: ${endpoint.gid.match(/../g)?.join('.') ?? ''}`,
    'QoS profile:',
    ...qosLines(endpoint.qos).map((line) => `  ${line}`),
  ].join('\n');
}

function qosLines(qos: EndpointQosView): string[] {
  return [
    `Reliability: ${qos.reliability.toUpperCase()}`,
    `History (Depth): ${qos.history === 'keep_all' ? 'KEEP_ALL' : `KEEP_LAST (${qos.depth})`}`,
    `Durability: ${qos.durability.toUpperCase()}`,
    `Lifespan: ${duration(qos.lifespanNs)}`,
    `Deadline: ${duration(qos.deadlineNs)}`,
    `Liveliness: ${qos.liveliness.toUpperCase()}`,
    `Liveliness lease duration: ${duration(qos.leaseNs)}`,
  ];
}

function duration(ns: number): string {
  return ns === 0 ? 'Infinite' : `${ns} nanoseconds`;
}

/** Beside upstream's output, not in it: whose messages do not reach whom, for their QoS. */
function misfitHints(topic: string, publishers: readonly OfNode[], subscriptions: readonly OfNode[]): readonly string[] {
  return publishers.flatMap((from) =>
    subscriptions.flatMap((to) => {
      const policy = misfitPolicy(from.endpoint.qos, to.endpoint.qos);
      return policy === undefined
        ? []
        : [`WARNING: messages of ${from.node.name} on ${topic} do not reach ${to.node.name}: their QoS policies do not fit, ${policy.toUpperCase()}`];
    })
  );
}
