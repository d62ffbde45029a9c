// ros2 component list, load, unload: over the services of containers.

import { callService } from './calls.ts';
import { allOf, type Command, CommandError, type Context, has } from './command.ts';
import { containersOf } from './graph_lists.ts';
import { textValue } from './parameter_calls.ts';

const container = { name: 'container_node_name', meaning: 'container' } as const;

/** The reply of load_node and similar services. */
interface Reply {
  readonly success: boolean;
  readonly error_message: string;
  readonly unique_id: bigint;
  readonly full_node_name: string;
}

async function ask(context: Context, of: string, verb: string, type: string, request: unknown): Promise<Readonly<Record<string, unknown>>> {
  return await callService(context, `${of}/_container/${verb}`, `composition_interfaces/srv/${type}`, request);
}

function known(context: Context, name: string): string {
  if (!containersOf(context.session.graph()).includes(name)) throw new CommandError(`Unable to find container node '${name}'`);
  return name;
}

async function componentsOf(context: Context, of: string): Promise<string[]> {
  const reply = await ask(context, of, 'list_nodes', 'ListNodes', {});
  const ids = Array.from(reply['unique_ids'] as ArrayLike<bigint>);
  return (reply['full_node_names'] as readonly string[]).map((name, i) => `${ids[i]!}  ${name}`);
}

/** As upstream shows what a container says. */
function capitalized(text: string): string {
  return `${text.slice(0, 1).toUpperCase()}${text.slice(1).toLowerCase()}`;
}

/** Converts texts `name:=value`. */
async function parametersOf(texts: readonly string[]): Promise<unknown[]> {
  return await Promise.all(texts.map(async (text) => {
    const cut = text.indexOf(':=');
    const [name, value] = cut < 0 ? [text, ''] : [text.slice(0, cut), text.slice(cut + 2)];
    return { name, value: await textValue(value) };
  }));
}

export const componentCommands: readonly Command[] = [
  {
    words: ['component', 'list'],
    help: 'Output a list of running containers and components',
    positionals: [{ ...container, optional: true }],
    options: [{ names: ['--containers-only'], help: 'List found containers nodes only' }],
    run: async (context, given) => {
      const [wanted] = given.positionals;
      const alone = wanted !== undefined;
      const containers = alone ? [known(context, wanted)] : containersOf(context.session.graph());
      for (const name of containers) {
        if (!alone) context.print(name);
        if (has(given, 'containers-only')) continue;
        for (const component of await componentsOf(context, name)) context.print(alone ? component : `  ${component}`);
      }
      return 0;
    },
  },
  {
    words: ['component', 'load'],
    help: 'Load a component into a container node',
    positionals: [container, { name: 'package_name', meaning: 'package' }, { name: 'plugin_name', meaning: 'text' }],
    options: [
      { names: ['--node-name', '-n'], value: 'NODE_NAME', help: 'Component node name' },
      { names: ['--node-namespace'], value: 'NODE_NAMESPACE', help: 'Component node namespace' },
      { names: ['--log-level'], value: 'LOG_LEVEL', number: true, help: 'Component node log level' },
      { names: ['--remap-rule', '-r'], value: 'REMAP_RULE', repeated: true, help: "Component node remapping rules, in the 'from:=to' form" },
      { names: ['--parameter', '-p'], value: 'PARAMETER', repeated: true, help: "Component node parameters, in the 'name:=value' form" },
      { names: ['--extra-argument', '-e'], value: 'EXTRA_ARGUMENT', repeated: true, help: "Extra arguments for the container, in the 'name:=value' form" },
    ],
    run: async (context, given) => {
      const [name = '', from, plugin] = given.positionals;
      const { success, error_message: why, unique_id: id, full_node_name: node } = await ask(context, known(context, name), 'load_node', 'LoadNode', {
        package_name: from,
        plugin_name: plugin,
        node_name: given.options.get('node-name') ?? '',
        node_namespace: given.options.get('node-namespace') ?? '',
        log_level: Number(given.options.get('log-level') ?? 0),
        remap_rules: allOf(given, 'remap-rule'),
        parameters: await parametersOf(allOf(given, 'parameter')),
        extra_arguments: await parametersOf(allOf(given, 'extra-argument')),
      }) as unknown as Reply;
      if (!success) throw new CommandError(`Failed to load component: ${capitalized(why)}`);
      context.print(`Loaded component ${id} into '${name}' container node as '${node}'`);
      return 0;
    },
  },
  {
    words: ['component', 'unload'],
    help: 'Unload a component from a container node',
    positionals: [container, { name: 'component_uid', meaning: 'text', many: true }],
    options: [{ names: ['--quiet', '-q'], help: 'Only print component unique IDs' }],
    run: async (context, given) => {
      const [name = '', ...ids] = given.positionals;
      const wrong = ids.find((id) => !/^\d{1,18}$/.test(id));
      if (wrong !== undefined) throw new CommandError(`ros2 component unload: error: argument component_uid: invalid int value: '${wrong}'`);
      known(context, name);
      for (const id of ids) {
        const { success, error_message: why } = await ask(context, name, 'unload_node', 'UnloadNode', { unique_id: BigInt(id) }) as unknown as Reply;
        if (!success) throw new CommandError(`Failed to unload component ${id} from '${name}' container node\n    ${capitalized(why)}`);
        context.print(has(given, 'quiet') ? id : `Unloaded component ${id} from '${name}' container node`);
      }
      return 0;
    },
  },
];
