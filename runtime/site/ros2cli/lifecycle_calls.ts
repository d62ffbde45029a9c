// The services of managed nodes, asked by values: for the commands and for the page. A CommandError says why there is no
// answer.

import type { GraphNodeView, GraphView } from '../contract/session.ts';
import { callService, type Caller } from './calls.ts';

/** A node that is busy is not waited for without end. */
const timeoutMs = 10_000;

/** As lifecycle_msgs/msg/State, and Transition. */
export interface State {
  readonly id: number;
  readonly label: string;
}

export interface TransitionDescription {
  readonly transition: State;
  readonly start_state: State;
  readonly goal_state: State;
}

export function managedNodes({ nodes }: GraphView): readonly GraphNodeView[] {
  return nodes.filter(({ name, services }) => services.some((service) => service.name === `${name}/get_state`));
}

/** `of`: the node's full name. */
export async function stateOf(caller: Caller, of: string): Promise<State> {
  return (await callService(caller, `${of}/get_state`, 'lifecycle_msgs/srv/GetState', {}, timeoutMs))['current_state'] as State;
}

export async function transitionsOf(caller: Caller, of: string): Promise<readonly TransitionDescription[]> {
  const reply = await callService(caller, `${of}/get_available_transitions`, 'lifecycle_msgs/srv/GetAvailableTransitions', {}, timeoutMs);
  return reply['available_transitions'] as readonly TransitionDescription[];
}

/** Has it succeeded? `patienceMs` of the site's time: its callback may take long. */
export async function changeState(caller: Caller, of: string, transition: number, patienceMs = timeoutMs): Promise<boolean> {
  const request = { transition: { id: transition } };
  return (await callService(caller, `${of}/change_state`, 'lifecycle_msgs/srv/ChangeState', request, patienceMs))['success'] === true;
}
