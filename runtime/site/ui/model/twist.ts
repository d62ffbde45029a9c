// Driving by hand: which keys and stick positions mean what, and the message that says it. Pure.

import type { GraphView } from '../../contract/session.ts';
import { isHiddenName } from '../../decode/ros_names.ts';
import { stampOf } from './draft_value.ts';

export const TWIST = 'geometry_msgs/msg/Twist';
export const TWIST_STAMPED = 'geometry_msgs/msg/TwistStamped';

/** Parts of the maximum, from -1 to 1. */
export interface Stick {
  /** Forward. */
  readonly ahead: number;
  /** To the left. */
  readonly turn: number;
}

export const REST: Stick = { ahead: 0, turn: 0 };

/** By the place of the key, so that WASD is where it is on every keyboard. */
const KEYS: ReadonlyMap<string, Stick> = new Map([
  ...['ArrowUp', 'KeyW'].map((key): [string, Stick] => [key, { ahead: 1, turn: 0 }]),
  ...['ArrowDown', 'KeyS'].map((key): [string, Stick] => [key, { ahead: -1, turn: 0 }]),
  ...['ArrowLeft', 'KeyA'].map((key): [string, Stick] => [key, { ahead: 0, turn: 1 }]),
  ...['ArrowRight', 'KeyD'].map((key): [string, Stick] => [key, { ahead: 0, turn: -1 }]),
]);

export function keyStick(code: string): Stick | undefined {
  return KEYS.get(code);
}

/** All that is held at once. */
export function sumOf(sticks: Iterable<Stick>): Stick {
  let [ahead, turn] = [0, 0];
  for (const stick of sticks) {
    ahead += stick.ahead;
    turn += stick.turn;
  }
  return { ahead: within(ahead), turn: within(turn) };
}

export function isRest({ ahead, turn }: Stick): boolean {
  return ahead === 0 && turn === 0;
}

function within(value: number): number {
  return Math.max(-1, Math.min(1, value));
}

const DEAD_TOUCH = 0.08;
/** Sticks of a gamepad seldom come to rest at 0. */
const DEAD_PAD = 0.15;

/** A point right of and below the middle of a round pad, in parts of its radius. */
export function pointStick(x: number, y: number): Stick {
  const length = Math.hypot(x, y);
  if (!(length > DEAD_TOUCH)) return REST;
  const scale = length > 1 ? 1 / length : 1;
  return { ahead: still(-y * scale), turn: still(-x * scale) };
}

/** -0 is 0. */
function still(value: number): number {
  return value === 0 ? 0 : value;
}

export interface PadState {
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; }[];
}

/** Reads a gamepad with the standard layout: the left stick, the right one for turning too, and the cross. */
export function padStick({ axes, buttons }: PadState): Stick {
  const axis = (index: number): number => {
    const value = axes[index] ?? 0;
    const size = Math.abs(value);
    return size > DEAD_PAD ? Math.sign(value) * Math.min(1, (size - DEAD_PAD) / (1 - DEAD_PAD)) : 0;
  };
  const pressed = (index: number): number => (buttons[index]?.pressed === true ? 1 : 0);
  return sumOf([
    { ahead: still(-axis(1)), turn: still(-axis(0)) },
    { ahead: 0, turn: still(-axis(2)) },
    { ahead: pressed(12) - pressed(13), turn: pressed(14) - pressed(15) },
  ]);
}

export interface Limits {
  /** m/s */
  readonly linear: number;
  /** rad/s */
  readonly angular: number;
}

/** A Twist, or with `stamp` a TwistStamped; times in ms of the site. */
export function twistOf({ ahead, turn }: Stick, limits: Limits,
  stamp?: { readonly nowMs: number; readonly frame: string; }): Readonly<Record<string, unknown>>
{
  const twist = { linear: { x: ahead * limits.linear, y: 0, z: 0 }, angular: { x: 0, y: 0, z: turn * limits.angular } };
  return stamp === undefined ? twist : { header: { stamp: stampOf(stamp.nowMs), frame_id: stamp.frame }, twist };
}

export interface DriveTopic {
  readonly name: string;
  readonly stamped: boolean;
}

/** Topics on which somebody waits to be driven; those called cmd_vel first. */
export function driveTopics({ nodes }: GraphView): readonly DriveTopic[] {
  const found = new Map<string, DriveTopic>();
  for (const node of nodes) {
    if (isHiddenName(node.name)) continue;
    for (const { name, type } of node.subscriptions)
      if ((type === TWIST || type === TWIST_STAMPED) && !isHiddenName(name)) found.set(`${name} ${type}`, { name, stamped: type === TWIST_STAMPED });
  }
  const rank = ({ name }: DriveTopic): number => (name.endsWith('/cmd_vel') ? 0 : 1);
  return [...found.values()].sort((a, b) => rank(a) - rank(b) || (a.name < b.name ? -1 : a.name > b.name ? 1 : Number(a.stamped) - Number(b.stamped)));
}
