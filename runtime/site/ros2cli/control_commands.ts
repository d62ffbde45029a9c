// ros2 control load_controller, unload_controller, cleanup_controller, reload_controller_libraries, set_controller_state,
// set_hardware_component_state, switch_controllers.

import { type Command, CommandError, type Context, type Given, has, numberOf } from './command.ts';
import { askByName, askManager, controllersOf, managerOption, strictness, switchControllers } from './control_calls.ts';

const controller = { name: 'controller_name', meaning: 'text' } as const;
const states = ['unconfigured', 'inactive', 'active'] as const;
const stateIds: ReadonlyMap<string, number> = new Map([['unconfigured', 1], ['inactive', 2], ['active', 3]]);

function chosenState(text: string): string {
  if (!states.some((state) => state === text)) {
    throw new CommandError(`argument state: invalid choice: '${text}' (choose from 'unconfigured', 'inactive', 'active')`);
  }
  return text;
}

function switchOne(context: Context, given: Given, names: { activate?: readonly string[]; deactivate?: readonly string[]; }): Promise<{ ok: boolean; }> {
  return switchControllers(context, given, { ...names, strictness: strictness.bestEffort, asap: true, timeoutSeconds: 5 });
}

async function loadController(context: Context, given: Given): Promise<number> {
  const [name] = given.positionals as [string];
  if (given.positionals[1] !== undefined) {
    throw new CommandError('a parameter file is not read here: start the spawner with --param-file, in a launch file');
  }
  if ((await controllersOf(context, given)).some((one) => one.name === name)) {
    context.print(`Controller : ${name} already loaded, skipping load_controller!`);
  } else {
    if (!await askByName(context, given, 'load_controller', 'LoadController', name)) {
      throw new CommandError(`Failed loading controller ${name} check controller_manager logs`);
    }
    context.print(`Successfully loaded controller ${name}`);
  }
  const state = given.options.get('set-state');
  if (state === undefined) return 0;
  if (!await askByName(context, given, 'configure_controller', 'ConfigureController', name)) {
    throw new CommandError(`Error configuring controller : ${name}`);
  }
  if (state === 'active' && !(await switchOne(context, given, { activate: [name] })).ok) {
    throw new CommandError(`Error activating controller : ${name}, check controller_manager logs`);
  }
  context.print(`Successfully loaded controller ${name} into state ${state}`);
  return 0;
}

async function setControllerState(context: Context, given: Given): Promise<number> {
  const [name, text] = given.positionals as [string, string];
  const wanted = chosenState(text);
  const now = (await controllersOf(context, given)).find((one) => one.name === name)?.state;
  if (now === undefined) throw new CommandError(`controller ${name} does not seem to be loaded`);
  const done = (ok: boolean, error: string, success: string): number => {
    if (!ok) throw new CommandError(`Error ${error} controller, check controller_manager logs`);
    context.print(`${success} ${name}`);
    return 0;
  };
  if (wanted === 'unconfigured') {
    if (now !== 'inactive') throw new CommandError(`cannot cleanup ${name} from its current state ${now}`);
    return done(await askByName(context, given, 'cleanup_controller', 'CleanupController', name), 'cleaning up', 'successfully cleaned up');
  }
  if (wanted === 'active') {
    if (now !== 'inactive') throw new CommandError(`cannot activate ${name} from its current state ${now}`);
    return done((await switchOne(context, given, { activate: [name] })).ok, 'activating', 'Successfully activated');
  }
  if (now === 'unconfigured') {
    return done(await askByName(context, given, 'configure_controller', 'ConfigureController', name), 'configuring', 'Successfully configured');
  }
  if (now === 'active') {
    return done((await switchOne(context, given, { deactivate: [name] })).ok, 'stopping', 'Successfully deactivated');
  }
  throw new CommandError(`cannot put ${name} in 'inactive' state from its current state ${now}`);
}

async function setComponentState(context: Context, given: Given): Promise<number> {
  const [name, text] = given.positionals as [string, string];
  const label = chosenState(text);
  const reply = await askManager(context, given, 'set_hardware_component_state', 'SetHardwareComponentState', {
    name,
    target_state: { id: stateIds.get(label), label },
  });
  if (reply['ok'] !== true) {
    const action = label === 'unconfigured' ? 'cleaning up' : label === 'inactive' ? 'stopping' : 'activating';
    throw new CommandError(`Error ${action} hardware component, check controller_manager logs`);
  }
  const { id, label: now } = reply['state'] as { id: number; label: string; };
  context.print(`Successfully set ${name} to state lifecycle_msgs.msg.State(id=${id}, label='${now}')`);
  return 0;
}

async function switchMany(context: Context, given: Given): Promise<number> {
  const named = (option: string): readonly string[] => (given.options.get(option) ?? '').split(' ').filter((word) => word !== '');
  const { ok, message } = await switchControllers(context, given, {
    activate: named('activate'),
    deactivate: named('deactivate'),
    strictness: has(given, 'strict') ? strictness.strict : has(given, 'best-effort') ? strictness.bestEffort : strictness.default,
    asap: has(given, 'activate-asap'),
    timeoutSeconds: numberOf(given, 'switch-timeout', 5),
  });
  context.print(message);
  return ok ? 0 : 1;
}

function byName(verb: string, help: string, service: string, type: string, success: string, failure: string): Command {
  return {
    words: ['control', verb],
    help,
    positionals: [controller],
    options: [managerOption],
    run: async (context, given) => {
      const [name] = given.positionals as [string];
      if (!await askByName(context, given, service, type, name)) throw new CommandError(`Error ${failure} controller ${name}, check controller_manager logs`);
      context.print(`Successfully ${success} controller ${name}`);
      return 0;
    },
  };
}

export const controlCommands: readonly Command[] = [
  {
    words: ['control', 'load_controller'],
    help: 'Load a controller in a controller manager',
    positionals: [controller, { name: 'param_file', meaning: 'text', optional: true }],
    options: [{ names: ['--set-state'], value: 'STATE', choices: ['inactive', 'active'], help: 'Set the state of the loaded controller' }, managerOption],
    run: loadController,
  },
  byName('unload_controller', 'Unload a controller in a controller manager', 'unload_controller', 'UnloadController', 'unloaded', 'unloading'),
  byName('cleanup_controller', 'Cleanup a controller in a controller manager', 'cleanup_controller', 'CleanupController', 'cleaned up', 'cleaning up'),
  {
    words: ['control', 'reload_controller_libraries'],
    help: 'Reload controller libraries',
    positionals: [],
    options: [{ names: ['--force-kill'], help: 'Force stop of loaded controllers' }, managerOption],
    run: async (context, given) => {
      const reply = await askManager(context, given, 'reload_controller_libraries', 'ReloadControllerLibraries', { force_kill: has(given, 'force-kill') });
      if (reply['ok'] !== true) throw new CommandError('Error reloading libraries, check controller_manager logs');
      context.print('Reload successful');
      return 0;
    },
  },
  {
    words: ['control', 'set_controller_state'],
    help: 'Adjust the state of the controller',
    positionals: [controller, { name: 'state', meaning: 'text' }],
    options: [managerOption],
    run: setControllerState,
  },
  {
    words: ['control', 'set_hardware_component_state'],
    help: 'Adjust the state of the hardware component',
    positionals: [{ name: 'hardware_component_name', meaning: 'text' }, { name: 'state', meaning: 'text' }],
    options: [managerOption],
    run: setComponentState,
  },
  {
    words: ['control', 'switch_controllers'],
    help: 'Switch controllers in a controller manager',
    positionals: [],
    options: [
      { names: ['--deactivate'], value: 'NAME', many: true, help: 'Name of the controllers to be deactivated' },
      { names: ['--activate'], value: 'NAME', many: true, help: 'Name of the controllers to be activated' },
      { names: ['--strict'], help: 'Set the switch_controllers service strictness to strict' },
      { names: ['--best-effort'], help: 'Set the switch_controllers service strictness to best effort' },
      { names: ['--activate-asap'], help: 'Start asap controllers' },
      { names: ['--switch-timeout'], value: 'SECONDS', number: true, help: 'Timeout for switching controllers' },
      managerOption,
    ],
    run: switchMany,
  },
];
