// ros2 control list_controllers, list_controller_types, list_hardware_components, list_hardware_interfaces.

import { type Command, type Context, type Given, has } from './command.ts';
import { askManager, type ControllerState, controllersOf, type HardwareComponent, type HardwareInterface, managerOption } from './control_calls.ts';

const pythonBool = (value: boolean): string => (value ? 'True' : 'False');

function printList(context: Context, title: string, items: readonly string[]): void {
  context.print([`\t${title}:`, ...items.map((item) => `\t\t${item}`)].join('\n'));
}

function printDetails(context: Context, given: Given, one: ControllerState): void {
  const all = has(given, 'verbose');
  if (all) context.print(`\tupdate_rate: ${one.update_rate} Hz\n\tis_async: ${pythonBool(one.is_async)}`);
  if (all || has(given, 'claimed-interfaces')) printList(context, 'claimed interfaces', one.claimed_interfaces);
  if (all || has(given, 'required-command-interfaces')) printList(context, 'required command interfaces', one.required_command_interfaces);
  if (all || has(given, 'required-state-interfaces')) printList(context, 'required state interfaces', one.required_state_interfaces);
  if (all || has(given, 'chained-interfaces')) {
    printList(context, 'chained to interfaces', one.chain_connections.flatMap((chain) => chain.reference_interfaces.map((name) => name.padEnd(20))));
  }
  if (all || has(given, 'reference-interfaces') || has(given, 'exported-interfaces')) {
    printList(context, 'exported reference interfaces', one.reference_interfaces);
    printList(context, 'exported state interfaces', one.exported_state_interfaces);
  }
}

const width = (texts: readonly string[]): number => Math.max(...texts.map(({ length }) => length));

function availability({ is_available, is_claimed }: HardwareInterface): string {
  return `[${is_available ? 'available' : 'unavailable'}] [${is_claimed ? 'claimed' : 'unclaimed'}]`;
}

function typeOf(given: Given, { data_type }: HardwareInterface): string {
  return has(given, 'verbose') ? ` [${data_type}]` : '';
}

function printComponent(context: Context, given: Given, one: HardwareComponent, number: number): void {
  context.print([
    `Hardware Component ${number}`,
    `\tname: ${one.name}`,
    `\ttype: ${one.type}`,
    `\tplugin name: ${one.plugin_name}`,
    `\tstate: id=${one.state.id} label=${one.state.label}`,
    `\tread/write rate: ${one.rw_rate} Hz`,
    `\tis_async: ${pythonBool(one.is_async)}`,
    '\tcommand interfaces',
    ...one.command_interfaces.map((each) => `\t\t${each.name}${typeOf(given, each)} ${availability(each)}`),
    ...(has(given, 'verbose') ? ['\tstate interfaces'] : []),
    ...(has(given, 'verbose')
      ? one.state_interfaces.map((each) => `\t\t${each.name} [${each.data_type}] [${each.is_available ? 'available' : 'unavailable'}]`)
      : []),
  ].join('\n'));
}

const byName = (a: HardwareInterface, b: HardwareInterface): number => (a.name < b.name ? -1 : a.name > b.name ? 1 : 0);

export const controlLists: readonly Command[] = [
  {
    words: ['control', 'list_controllers'],
    help: 'Output the list of loaded controllers, their type and status',
    positionals: [],
    options: [
      { names: ['--claimed-interfaces'], help: "List controller's claimed interfaces" },
      { names: ['--required-state-interfaces'], help: "List controller's required state interfaces" },
      { names: ['--required-command-interfaces'], help: "List controller's required command interfaces" },
      { names: ['--chained-interfaces'], help: 'List interfaces that the controllers are chained to' },
      { names: ['--reference-interfaces'], help: "List controller's exported references" },
      { names: ['--exported-interfaces'], help: "List controller's exported state and reference interfaces" },
      { names: ['--verbose', '-v'], help: 'List all of these' },
      managerOption,
    ],
    run: async (context, given) => {
      const controllers = await controllersOf(context, given);
      if (controllers.length === 0) {
        context.print('No controllers are currently loaded!');
        return 0;
      }
      const [names, types, states] = [width(controllers.map(({ name }) => name)), width(controllers.map(({ type }) => type)),
        width(controllers.map(({ state }) => state))];
      for (const one of controllers) {
        context.print(`${one.name.padEnd(names)} ${one.type.padEnd(types)}  ${one.state.padEnd(states)}`);
        printDetails(context, given, one);
      }
      return 0;
    },
  },
  {
    words: ['control', 'list_controller_types'],
    help: 'Output the available controller types and their base classes',
    positionals: [],
    options: [managerOption],
    run: async (context, given) => {
      const reply = await askManager(context, given, 'list_controller_types', 'ListControllerTypes');
      const bases = reply['base_classes'] as readonly string[];
      (reply['types'] as readonly string[]).forEach((type, i) => context.print(`${type.padEnd(70)} ${bases[i] ?? ''}`));
      return 0;
    },
  },
  {
    words: ['control', 'list_hardware_components'],
    help: 'Output the list of available hardware components',
    positionals: [],
    options: [{ names: ['--verbose', '-v'], help: 'List the state interfaces too, and the types of all' }, managerOption],
    run: async (context, given) => {
      const reply = await askManager(context, given, 'list_hardware_components', 'ListHardwareComponents');
      (reply['component'] as readonly HardwareComponent[]).forEach((one, i) => printComponent(context, given, one, i + 1));
      return 0;
    },
  },
  {
    words: ['control', 'list_hardware_interfaces'],
    help: 'Output the list of available command and state interfaces',
    positionals: [],
    options: [{ names: ['--verbose', '-v'], help: 'List the types too' }, managerOption],
    run: async (context, given) => {
      const reply = await askManager(context, given, 'list_hardware_interfaces', 'ListHardwareInterfaces');
      const commands = [...reply['command_interfaces'] as readonly HardwareInterface[]].sort(byName);
      const states = [...reply['state_interfaces'] as readonly HardwareInterface[]].sort(byName);
      context.print(['command interfaces', ...commands.map((each) => `\t${each.name}${typeOf(given, each)} ${availability(each)}`)].join('\n'));
      context.print(['state interfaces', ...states.map((each) => `\t${each.name}${typeOf(given, each)}`)].join('\n'));
      return 0;
    },
  },
];
