// The services of a controller manager, asked by values. A CommandError says why there is no answer.

import { callService } from './calls.ts';
import type { Context, Given, Option } from './command.ts';

export interface ControllerState {
  readonly name: string;
  readonly state: string;
  readonly type: string;
  readonly is_async: boolean;
  readonly update_rate: number;
  readonly claimed_interfaces: readonly string[];
  readonly required_command_interfaces: readonly string[];
  readonly required_state_interfaces: readonly string[];
  readonly exported_state_interfaces: readonly string[];
  readonly reference_interfaces: readonly string[];
  readonly chain_connections: readonly { readonly name: string; readonly reference_interfaces: readonly string[]; }[];
}

export interface HardwareInterface {
  readonly name: string;
  readonly data_type: string;
  readonly is_available: boolean;
  readonly is_claimed: boolean;
}

export interface HardwareComponent {
  readonly name: string;
  readonly type: string;
  readonly is_async: boolean;
  readonly rw_rate: number;
  readonly plugin_name: string;
  readonly state: { readonly id: number; readonly label: string; };
  readonly command_interfaces: readonly HardwareInterface[];
  readonly state_interfaces: readonly HardwareInterface[];
}

/** As controller_manager_msgs/srv/SwitchController. */
export const strictness = { default: 0, bestEffort: 1, strict: 2 } as const;

export const managerOption: Option = {
  names: ['--controller-manager', '-c'],
  value: 'CONTROLLER_MANAGER',
  help: 'Name of the controller manager ROS node (default: controller_manager)',
};

/** The manager's name from the command line, from the root. */
function managerOf(given: Given): string {
  const name = given.options.get('controller-manager') ?? 'controller_manager';
  return name.startsWith('/') ? name : `/${name}`;
}

export async function askManager(context: Context, given: Given, service: string, type: string,
  request: unknown = {}): Promise<Readonly<Record<string, unknown>>>
{
  const name = `${managerOf(given)}/${service}`;
  if (!context.session.graph().nodes.some(({ services }) => services.some((each) => each.name === name))) {
    context.warn(`waiting for service ${name} to become available...`);
  }
  return callService(context, name, `controller_manager_msgs/srv/${type}`, request);
}

/** Has it been done? For the services that take the name of a controller. */
export async function askByName(context: Context, given: Given, service: string, type: string, name: string): Promise<boolean> {
  return (await askManager(context, given, service, type, { name }))['ok'] === true;
}

export async function controllersOf(context: Context, given: Given): Promise<readonly ControllerState[]> {
  return (await askManager(context, given, 'list_controllers', 'ListControllers'))['controller'] as readonly ControllerState[];
}

export interface Switch {
  readonly activate?: readonly string[];
  readonly deactivate?: readonly string[];
  readonly strictness: number;
  readonly asap: boolean;
  readonly timeoutSeconds: number;
}

export async function switchControllers(context: Context, given: Given, wanted: Switch): Promise<{ ok: boolean; message: string; }> {
  const sec = Math.floor(wanted.timeoutSeconds);
  const reply = await askManager(context, given, 'switch_controller', 'SwitchController', {
    activate_controllers: wanted.activate ?? [],
    deactivate_controllers: wanted.deactivate ?? [],
    strictness: wanted.strictness,
    activate_asap: wanted.asap,
    timeout: { sec, nanosec: Math.round((wanted.timeoutSeconds - sec) * 1e9) },
  });
  return { ok: reply['ok'] === true, message: String(reply['message']) };
}
