// ros2 action list, info, type, send_goal.

import { toYaml } from '../decode/yaml.ts';
import { expandName, fullTypeName } from '../decode/ros_names.ts';
import type { GraphNodeView } from '../contract/session.ts';
import { reason } from './calls.ts';
import { type Command, CommandError, has } from './command.ts';
import { decoded, fillMessage } from './filled_message.ts';
import { actionsOf } from './graph_lists.ts';

export const actionCommands: readonly Command[] = [
  {
    words: ['action', 'list'],
    help: 'Output a list of action names',
    positionals: [],
    options: [
      { names: ['--show-types', '-t'], help: 'Additionally show the action type' },
      { names: ['--count-actions', '-c'], help: 'Only display the number of actions discovered' },
    ],
    run: (context, given) => {
      const actions = actionsOf(context.session.graph());
      if (has(given, 'count-actions')) context.print(String(actions.length));
      else for (const { name, types } of actions) context.print(has(given, 'show-types') ? `${name} [${types.join(', ')}]` : name);
      return Promise.resolve(0);
    },
  },
  {
    words: ['action', 'type'],
    help: "Print an action's type",
    positionals: [{ name: 'action_name', meaning: 'action' }],
    options: [],
    run: (context, given) => {
      const action = actionsOf(context.session.graph()).find(({ name }) => name === given.positionals[0]);
      for (const type of action?.types ?? []) context.print(type);
      return Promise.resolve(action === undefined ? 1 : 0);
    },
  },
  {
    words: ['action', 'info'],
    help: 'Print information about an action',
    positionals: [{ name: 'action_name', meaning: 'action' }],
    options: [
      { names: ['--show-types', '-t'], help: 'Additionally show the action type' },
      { names: ['--count', '-c'], help: 'Only display the number of action clients and servers' },
    ],
    run: (context, given) => {
      const [action = ''] = given.positionals;
      const of = (kind: 'actionServers' | 'actionClients'): string[] =>
        context.session.graph().nodes.flatMap((node: GraphNodeView) =>
          node[kind].filter(({ name }) => name === action).map(({ type }) => `    ${node.name}${has(given, 'show-types') ? ` [${type}]` : ''}`)
        );
      const [clients, servers] = [of('actionClients'), of('actionServers')];
      const rows = has(given, 'count') ? [[], []] : [clients, servers];
      context.print([`Action: ${action}`, `Action clients: ${clients.length}`, ...rows[0]!, `Action servers: ${servers.length}`, ...rows[1]!].join('\n'));
      return Promise.resolve(0);
    },
  },
  {
    words: ['action', 'send_goal'],
    help: 'Send an action goal',
    positionals: [
      { name: 'action_name', meaning: 'action' },
      { name: 'action_type', meaning: 'action_type' },
      { name: 'goal', meaning: 'goal_values' },
    ],
    options: [{ names: ['--feedback', '-f'], help: 'Echo feedback messages for the goal' }],
    run: async (context, given) => {
      const [action = '', typed = '', yaml] = given.positionals;
      const name = expandName(action, '');
      const type = fullTypeName(typed, 'action');
      if (type === undefined) throw new CommandError('The passed action type is invalid');
      const codec = await context.codec();
      const filled = await fillMessage(codec, `${type}_Goal`, yaml, context.session.time.view().now);
      const client = context.session.node().actionClient(name, type);
      try {
        context.print('Waiting for an action server to become available...');
        const goal = client.sendGoal(filled.bytes, {
          timeoutMs: Infinity,
          signal: context.signal,
          onFeedback: (bytes) => {
            const feedback = has(given, 'feedback') ? codec.decode(`${type}_Feedback`, bytes) : undefined;
            if (feedback?.kind === 'value') context.print(`Feedback:\n    ${toYaml(feedback.value, feedback.shape, null)}`);
          },
          onStatus: (status) => {
            if (status === 'accepted') context.print(`Goal accepted with ID: ${goal.id}\n`);
          },
        });
        context.print(`Sending goal:\n     ${toYaml(filled.value, filled.shape, null)}`);
        if (!await goal.accepted) {
          context.print('Goal was rejected.');
          return 1;
        }
        const { status, bytes } = await goal.result;
        const { value, shape } = await decoded(context, `${type}_GetResult_Response`, bytes);
        const inner = shape.find((field) => field.name === 'result')?.shape ?? null;
        context.print(`Result:\n    ${toYaml(value['result'], inner, null)}`);
        context.print(`Goal finished with status: ${status.toUpperCase()}`);
        return 0;
      } catch (error) {
        if (context.signal.aborted) {
          context.print('Canceling goal...');
          return 130;
        }
        throw error instanceof CommandError ? error : new CommandError(reason(error));
      } finally {
        client.close();
      }
    },
  },
];
