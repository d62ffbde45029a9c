// ros2 doctor, and its other name ros2 wtf: looks at nodes, topics and QoS, and reports. Sections of upstream that a site
// has nothing for say so in a row.

import { splitNodeName } from '../decode/ros_names.ts';
import type { EndpointQosView, NodeState, Session } from '../contract/session.ts';
import { type Command, type Context, has } from './command.ts';
import { endpointsOf, topicsOf } from './graph_lists.ts';

type Category = 'network' | 'node' | 'package' | 'platform' | 'middleware' | 'topic';

/** `failing`: an error, not only a warning. */
interface Finding {
  readonly failing: boolean;
  readonly text: string;
}

interface Check {
  readonly category: Category;
  readonly look: (session: Session) => readonly Finding[];
}

type Row = readonly [name: string, content: string];

interface Report {
  readonly category: Category;
  readonly title: string;
  readonly rows: (session: Session) => readonly Row[];
}

const error = (text: string): Finding => ({ failing: true, text });
const warning = (text: string): Finding => ({ failing: false, text });

/** Every node has these for itself. */
const needNobody = ['/parameter_events', '/rosout'];

function countsOf(session: Session): readonly { readonly name: string; readonly publishers: number; readonly subscriptions: number; }[] {
  const graph = session.graph();
  return topicsOf(graph).filter(({ name }) => !needNobody.includes(name)).map(({ name }) => ({
    name,
    publishers: endpointsOf(graph, 'publishers', name).length,
    subscriptions: endpointsOf(graph, 'subscriptions', name).length,
  }));
}

interface Pair {
  readonly topic: string;
  readonly type: string;
  readonly publisher: string;
  readonly subscription: string;
  /** Empty: they fit. */
  readonly reason: string;
}

function pairsOf(session: Session): readonly Pair[] {
  const graph = session.graph();
  const nameOf = (full: string): string => splitNodeName(full).name;
  return topicsOf(graph).flatMap(({ name }) =>
    endpointsOf(graph, 'publishers', name).flatMap((from) =>
      endpointsOf(graph, 'subscriptions', name).map((to) => ({
        topic: name,
        type: from.endpoint.type,
        publisher: nameOf(from.node.name),
        subscription: nameOf(to.node.name),
        reason: misfitReason(from.endpoint.qos, to.endpoint.qos),
      }))
    )
  );
}

/** All that stands between the two, in rmw's words; empty: they fit. */
export function misfitReason(offered: EndpointQosView, requested: EndpointQosView): string {
  const reasons: string[] = [];
  if (offered.reliability === 'best_effort' && requested.reliability === 'reliable') reasons.push('Best effort publisher and reliable subscription');
  if (offered.durability === 'volatile' && requested.durability === 'transient_local') reasons.push('Volatile publisher and transient local subscription');
  if (requested.deadlineNs !== 0 && offered.deadlineNs === 0) reasons.push('Subscription has a deadline, but publisher does not');
  else if (requested.deadlineNs !== 0 && offered.deadlineNs > requested.deadlineNs) reasons.push('Subscription deadline is less than publisher deadline');
  if (offered.liveliness === 'automatic' && requested.liveliness === 'manual_by_topic') {
    reasons.push("Publisher's liveliness is automatic and subscription's is manual by topic");
  }
  if (requested.leaseNs !== 0 && offered.leaseNs === 0) reasons.push('Subscription has a liveliness lease duration, but publisher does not');
  else if (requested.leaseNs !== 0 && offered.leaseNs > requested.leaseNs) reasons.push('Subscription liveliness lease duration is less than publisher');
  return reasons.map((reason) => `ERROR: ${reason};`).join('');
}

function stateText(state: NodeState): string {
  switch (state.kind) {
    case 'exited':
      return `exited with code ${state.code}`;
    case 'crashed':
      return `crashed (${state.code}): ${state.message.split('\n', 1)[0]}`;
    case 'waiting':
      return `waiting for ${state.on.node}`;
    case 'stopped':
    case 'starting':
    case 'running':
      return state.kind;
  }
}

/** In upstream's order, which is that of their names. */
const checks: readonly Check[] = [
  {
    category: 'network',
    look: ({ link }) =>
      link === 'shared'
        ? []
        : [
          warning(
            'Nodes reach each other through message ports, which are slower than shared memory: the page is not cross-origin isolated, or they were asked for.',
          ),
        ],
  },
  {
    category: 'node',
    look: (session) => {
      const names = session.graph().nodes.map(({ name }) => name);
      const shared = [...new Set(names.filter((name, at) => names.indexOf(name) !== at))];
      return [
        ...session.nodes().flatMap(({ id, state }) =>
          state.kind === 'crashed'
            ? [error(`Node ${id} has ${stateText(state)}`)]
            : state.kind === 'exited' && state.code !== 0
            ? [warning(`Node ${id} has ${stateText(state)}.`)]
            : []
        ),
        ...shared.map((name) => warning(`Several nodes have the name ${name}.`)),
      ];
    },
  },
  {
    category: 'middleware',
    look: (session) =>
      pairsOf(session).filter(({ reason }) => reason !== '')
        .map(({ topic, reason }) => error(`QoS compatibility error found on topic '${topic}': ${reason.replace(/^ERROR: /, '')}`)),
  },
  {
    category: 'topic',
    look: (session) =>
      countsOf(session).flatMap(({ name, publishers, subscriptions }) =>
        publishers > 0 && subscriptions === 0
          ? [warning(`Publisher without subscriber detected on ${name}.`)]
          : subscriptions > 0 && publishers === 0
          ? [warning(`Subscriber without publisher detected on ${name}.`)]
          : []
      ),
  },
];

const reports: readonly Report[] = [
  {
    category: 'network',
    title: 'NETWORK CONFIGURATION',
    rows: (
      { link },
    ) => [['device', `none: a site has no network, its nodes reach each other ${link === 'shared' ? 'in shared memory' : 'through message ports'}`]],
  },
  {
    category: 'node',
    title: 'NODE LIST',
    rows: (session) => {
      const nodes = session.nodes();
      return nodes.length === 0 ? [['node', 'none']] : nodes.flatMap(({ id, state }): Row[] => [['node', id], ['state', stateText(state)]]);
    },
  },
  {
    category: 'package',
    title: 'PACKAGE VERSIONS',
    rows: ({ site }) => [['packages', `${site.packages.length}, as ros2 pkg list shows them; sbom.spdx.json of the site has their versions`]],
  },
  {
    category: 'platform',
    title: 'PLATFORM INFORMATION',
    rows: ({ site }) => [
      ['system', 'Emscripten'],
      ['platform info', navigator.userAgent],
      ['release', site.generator],
      ['processor', `wasm32, ${navigator.hardwareConcurrency} logical`],
    ],
  },
  {
    category: 'middleware',
    title: 'QOS COMPATIBILITY LIST',
    rows: (session) => {
      const pairs = pairsOf(session);
      if (pairs.length === 0) return [['compatibility status', 'No publisher/subscriber pairs found']];
      return pairs.flatMap(({ topic, type, publisher, subscription, reason }): Row[] => [
        ['topic [type]', `${topic} [${type}]`],
        ['publisher node', publisher],
        ['subscriber node', subscription],
        ['compatibility status', reason === '' ? 'OK' : reason],
      ]);
    },
  },
  { category: 'middleware', title: 'RMW MIDDLEWARE', rows: () => [['middleware name', 'rmw_wasm_cpp']] },
  {
    category: 'platform',
    title: 'ROS 2 INFORMATION',
    rows: ({ site }) => [
      ['distribution name', site.distro],
      ['distribution type', 'ros2'],
      ['distribution status', 'not known: a site does not ask the index of distributions'],
      ['release platforms', 'emscripten-wasm32'],
    ],
  },
  {
    category: 'topic',
    title: 'TOPIC LIST',
    rows: (session) => {
      const topics = countsOf(session);
      const listed = topics.length === 0 ? [{ name: 'none', publishers: 0, subscriptions: 0 }] : topics;
      return listed.flatMap((
        { name, publishers, subscriptions },
      ): Row[] => [['topic', name], ['publisher count', String(publishers)], ['subscriber count', String(subscriptions)]]);
    },
  },
];

function printReport({ session, print }: Context, { title, rows }: Report): void {
  const all = rows(session);
  const longest = Math.max(...all.map(([name]) => name.length));
  const width = longest < 8 ? 8 : longest + 4;
  print(['', `   ${title}`, ...all.map(([name, content]) => `${name.padEnd(width)}: ${content}`)].join('\n'));
}

function doctor(name: string): Command {
  return {
    words: [name],
    help: 'Check ROS setup and other potential issues',
    positionals: [],
    options: [
      { names: ['--report', '-r'], help: 'Print all reports.' },
      { names: ['--report-failed', '-rf'], help: 'Print reports of failed checks only.' },
      { names: ['--exclude-packages', '-ep'], help: 'Exclude package checks or report.' },
      { names: ['--include-warnings', '-iw'], help: 'Include warnings as failed checks. Warnings are ignored by default.' },
    ],
    run: (context, given) => {
      const wanted = reports.filter(({ category }) => category !== 'package' || !has(given, 'exclude-packages'));
      if (has(given, 'report')) {
        for (const report of wanted) printReport(context, report);
        return Promise.resolve(0);
      }
      const failed = new Set<Category>();
      for (const { category, look } of checks) {
        for (const { failing, text } of look(context.session)) {
          context.warn(`UserWarning: ${failing ? `ERROR: ${text}` : text}`);
          if (failing || has(given, 'include-warnings')) failed.add(category);
        }
      }
      context.print(failed.size === 0
        ? `\nAll ${checks.length} checks passed\n`
        : `\n${failed.size}/${checks.length} check(s) failed\n\nFailed modules: ${[...failed].join(' ')}`);
      if (has(given, 'report-failed')) { for (const report of wanted.filter(({ category }) => failed.has(category))) printReport(context, report); }
      return Promise.resolve(0);
    },
  };
}

export const doctorCommand = doctor('doctor');
export const wtfCommand = doctor('wtf');
