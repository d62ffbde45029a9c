// Gamepads of the Gamepad API as the nodes of the package joy read them (runtime/packages/tools/joy/src/gamepad_device.hpp):
// right and down are positive, and a gamepad of the standard layout has the axes and buttons that SDL gives an Xbox gamepad. Pure.

import type { TopicView } from '../../contract/session.ts';

export const JOY = 'sensor_msgs/msg/Joy';
export const RUMBLE_TOPIC = '/_gamepad/rumble';
/** Nodes look for so many. */
export const MOST_GAMEPADS = 4;

const WANTED = /^\/_gamepad\/(joystick|controller)_(\d)$/;
/** Buttons of the Gamepad API's standard layout; 17 is the touchpad, which not every browser has. */
const BUTTON = { leftTrigger: 6, rightTrigger: 7, up: 12, down: 13, left: 14, right: 15 } as const;
/** A, B, X, Y, left and right shoulder, back, start, guide, left and right stick. */
const JOYSTICK_BUTTONS: readonly number[] = [0, 1, 2, 3, 4, 5, 8, 9, 16, 10, 11];
/** A, B, X, Y, back, guide, start, left and right stick, left and right shoulder, up, down, left, right. */
const CONTROLLER_BUTTONS: readonly number[] = [0, 1, 2, 3, 8, 16, 9, 10, 11, 4, 5, 12, 13, 14, 15];
/** misc and four paddles, which browsers do not report. */
const CONTROLLER_GAP = 5;
const TOUCHPAD = 17;
const MOST_NAME = 200;

export type GamepadLayout = 'joystick' | 'controller';

export interface GamepadWish {
  readonly topic: string;
  readonly layout: GamepadLayout;
  /** The number of the gamepad among those of the page. */
  readonly number: number;
}

/** The topics on which nodes wait for gamepads. */
export function wantedGamepads(topics: readonly TopicView[]): readonly GamepadWish[] {
  return topics.flatMap(({ name, type, subscriptions }) => {
    const [, layout, digit] = WANTED.exec(name) ?? [];
    const number = Number(digit);
    if (subscriptions === 0 || type !== JOY || layout === undefined || number >= MOST_GAMEPADS) return [];
    return [{ topic: name, layout: layout === 'joystick' ? 'joystick' : 'controller', number }];
  });
}

/** The Gamepad API's Gamepad, as far as it is used here. */
export interface GamepadReading {
  readonly id: string;
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number; }[];
}

export interface JoyReading {
  readonly axes: readonly number[];
  readonly buttons: readonly number[];
}

/** undefined: the gamepad has no such layout. */
export function joyReading(pad: GamepadReading, layout: GamepadLayout): JoyReading | undefined {
  if (pad.mapping === 'standard') return layout === 'joystick' ? xboxReading(pad) : controllerReading(pad);
  return layout === 'joystick' ? { axes: [...pad.axes], buttons: pad.buttons.map(({ pressed }) => Number(pressed)) } : undefined;
}

function xboxReading(pad: GamepadReading): JoyReading {
  const [leftX, leftY, rightX, rightY] = sticks(pad);
  const { down, left, leftTrigger, right, rightTrigger, up } = BUTTON;
  const trigger = (index: number): number => 2 * valueOf(pad, index) - 1;
  return {
    axes: [
      leftX,
      leftY,
      trigger(leftTrigger),
      rightX,
      rightY,
      trigger(rightTrigger),
      pressedOf(pad, right) - pressedOf(pad, left),
      pressedOf(pad, down) - pressedOf(pad, up),
    ],
    buttons: JOYSTICK_BUTTONS.map((index) => pressedOf(pad, index)),
  };
}

function controllerReading(pad: GamepadReading): JoyReading {
  const { leftTrigger, rightTrigger } = BUTTON;
  return {
    axes: [...sticks(pad), valueOf(pad, leftTrigger), valueOf(pad, rightTrigger)],
    buttons: [
      ...CONTROLLER_BUTTONS.map((index) => pressedOf(pad, index)),
      ...Array.from({ length: CONTROLLER_GAP }, () => 0),
      pressedOf(pad, TOUCHPAD),
    ],
  };
}

function sticks({ axes }: GamepadReading): readonly [number, number, number, number] {
  return [axes[0] ?? 0, axes[1] ?? 0, axes[2] ?? 0, axes[3] ?? 0];
}

function valueOf({ buttons }: GamepadReading, index: number): number {
  return buttons[index]?.value ?? 0;
}

function pressedOf({ buttons }: GamepadReading, index: number): number {
  return Number(buttons[index]?.pressed === true);
}

/** The same gamepad, while nobody touches it. */
export function atRest({ id, mapping, axes, buttons }: GamepadReading): GamepadReading {
  return { id, mapping, axes: axes.map(() => 0), buttons: buttons.map(() => ({ pressed: false, value: 0 })) };
}

/** The word `rumble` or `still`, and the name. */
export function frameOf(id: string, canRumble: boolean): string {
  return `${canRumble ? 'rumble' : 'still'} ${id.slice(0, MOST_NAME)}`;
}

/**
 * Numbers for the gamepads with these indexes of the browser: those of `before` remain, and new ones get the lowest numbers that
 * are free. By index.
 */
export function gamepadNumbers(before: ReadonlyMap<number, number>, indexes: readonly number[]): ReadonlyMap<number, number> {
  const numbers = new Map(indexes.flatMap((index) => {
    const number = before.get(index);
    return number === undefined ? [] : [[index, number]];
  }));
  const taken = new Set(numbers.values());
  for (const index of indexes) {
    if (numbers.has(index)) continue;
    let number = 0;
    while (taken.has(number)) number += 1;
    taken.add(number);
    numbers.set(index, number);
  }
  return numbers;
}
