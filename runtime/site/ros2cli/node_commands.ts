// ros2 node list and info.

import { isHiddenName, joinName } from '../decode/ros_names.ts';
import type { GraphNodeView, GraphView } from '../contract/session.ts';
import { type Command, CommandError, has } from './command.ts';
import { named, shown } from './graph_lists.ts';

export const nodeCommands: readonly Command[] = [
  {
    words: ['node', 'list'],
    help: 'Output a list of available nodes',
    positionals: [],
    options: [
      { names: ['--all', '-a'], help: 'Display all nodes even hidden ones' },
      { names: ['--count-nodes', '-c'], help: 'Only display the number of nodes discovered' },
    ],
    run: (context, given) => {
      const names = shown(context.session.graph().nodes, has(given, 'all')).map(({ name }) => name);
      if (new Set(names).size < names.length) {
        context.warn('WARNING: Be aware that there are nodes in the graph that share an exact name, which can have unintended side effects.');
      }
      if (has(given, 'count-nodes')) context.print(String(names.length));
      else for (const name of names) context.print(name);
      return Promise.resolve(0);
    },
  },
  {
    words: ['node', 'info'],
    help: 'Output information about a node',
    positionals: [{ name: 'node_name', meaning: 'node' }],
    options: [{ names: ['--include-hidden'], help: 'Display hidden topics, services, and actions as well' }],
    run: (context, given) => {
      const node = findNode(context.session.graph(), given.positionals[0]!);
      if (node === undefined) throw new CommandError(`Unable to find node '${given.positionals[0]}'`);
      const hidden = has(given, 'include-hidden');
      const list = (title: string, of: readonly { readonly name: string; readonly type: string; }[]): string => {
        const rows = named(of.filter(({ name }) => hidden || !isHiddenName(name))).map(({ name, types }) => `    ${name}: ${types.join(', ')}`);
        return [`  ${title}:`, ...(rows.length === 0 ? [''] : rows)].join('\n');
      };
      context.print([
        node.name,
        list('Subscribers', node.subscriptions),
        list('Publishers', node.publishers),
        list('Service Servers', node.services),
        list('Service Clients', node.clients),
        list('Action Servers', node.actionServers),
        list('Action Clients', node.actionClients),
      ].join('\n'));
      return Promise.resolve(0);
    },
  },
];

/** By its full name; `talker` means `/talker`. */
export function findNode(graph: GraphView, given: string): GraphNodeView | undefined {
  const name = given.startsWith('/') ? given : joinName('/', given);
  return graph.nodes.find((node) => node.name === name);
}
