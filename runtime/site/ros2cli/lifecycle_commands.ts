// ros2 lifecycle nodes, get, list, set.

import { type Command, CommandError, type Context } from './command.ts';
import { shown } from './graph_lists.ts';
import { changeState, managedNodes, stateOf, transitionsOf } from './lifecycle_calls.ts';
import { findNode } from './node_commands.ts';

const node = { name: 'node_name', meaning: 'node' } as const;

function managed(context: Context): string[] {
  return shown(managedNodes(context.session.graph()), false).map(({ name }) => name);
}

function managedNode(context: Context, given: string): string {
  const name = findNode(context.session.graph(), given)?.name;
  if (name === undefined || !managed(context).includes(name)) throw new CommandError('Node not found');
  return name;
}

export const lifecycleCommands: readonly Command[] = [
  {
    words: ['lifecycle', 'nodes'],
    help: 'Output a list of nodes with lifecycle',
    positionals: [],
    options: [],
    run: (context) => {
      for (const name of managed(context)) context.print(name);
      return Promise.resolve(0);
    },
  },
  {
    words: ['lifecycle', 'get'],
    help: 'Get lifecycle state for one or more nodes',
    positionals: [{ ...node, optional: true }],
    options: [],
    run: async (context, given) => {
      const [wanted] = given.positionals;
      const names = wanted === undefined ? managed(context) : [managedNode(context, wanted)];
      for (const name of names) {
        const { label, id } = await stateOf(context, name);
        context.print(`${wanted === undefined ? `${name}: ` : ''}${label} [${id}]`);
      }
      return 0;
    },
  },
  {
    words: ['lifecycle', 'list'],
    help: 'Output a list of available transitions',
    positionals: [node],
    options: [],
    run: async (context, given) => {
      for (const { transition, start_state, goal_state } of await transitionsOf(context, managedNode(context, given.positionals[0]!))) {
        context.print(`- ${transition.label} [${transition.id}]\n\tStart: ${start_state.label}\n\tGoal: ${goal_state.label}`);
      }
      return 0;
    },
  },
  {
    words: ['lifecycle', 'set'],
    help: 'Trigger lifecycle state transition',
    positionals: [node, { name: 'transition', meaning: 'transition' }],
    options: [],
    run: async (context, given) => {
      const name = managedNode(context, given.positionals[0]!);
      const wanted = given.positionals[1]!;
      const available = (await transitionsOf(context, name)).map(({ transition }) => transition);
      const chosen = available.find(({ label, id }) => label === wanted || String(id) === wanted);
      if (chosen === undefined) {
        throw new CommandError(['Unknown transition requested, available ones are:', ...available.map(({ label, id }) => `- ${label} [${id}]`)].join('\n'));
      }
      if (!await changeState(context, name, chosen.id)) throw new CommandError('Transitioning failed');
      context.print('Transitioning successful');
      return 0;
    },
  },
];
