// Keys, trackbars and the mouse of a window of cv2 (cv_window_topics.ts): the program publishes its trackbars on
// /cv2/NAME/controls, and waits for all three on /cv2/NAME/input.

import { flagMember, member, numberMember, textMember } from './json.ts';

/** As waitKey() gives them under GTK, cut to a byte. */
const NAMED: ReadonlyMap<string, number> = new Map([
  ['Backspace', 8],
  ['Tab', 9],
  ['Enter', 13],
  ['Escape', 27],
  ['Delete', 255],
  ['ArrowLeft', 81],
  ['ArrowUp', 82],
  ['ArrowRight', 83],
  ['ArrowDown', 84],
  ['PageUp', 85],
  ['PageDown', 86],
  ['End', 87],
  ['Home', 80],
]);

/** undefined: it has none, as Shift alone. */
export function keyCode(key: string): number | undefined {
  const code = key.length === 1 ? key.charCodeAt(0) : NAMED.get(key);
  return code !== undefined && code <= 255 ? code : undefined;
}

export interface Trackbar {
  readonly name: string;
  readonly value: number;
  /** The largest value; the least is 0. */
  readonly count: number;
}

export interface WindowControls {
  readonly trackbars: readonly Trackbar[];
  /** The program asks for the mouse. */
  readonly mouse: boolean;
}

export const NO_CONTROLS: WindowControls = { trackbars: [], mouse: false };
const MOST_TRACKBARS = 50;
const LARGEST = 1e9;

/** As a node has published it; the node may be anybody's. */
export function readControls(text: string): WindowControls {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return NO_CONTROLS;
  }
  const bars = member(value, 'trackbars');
  return {
    trackbars: (Array.isArray(bars) ? (bars as readonly unknown[]) : []).slice(0, MOST_TRACKBARS).map((bar) => {
      const count = Math.round(numberMember(bar, 'count', 0, LARGEST, 0));
      return { name: textMember(bar, 'name'), value: Math.round(numberMember(bar, 'value', 0, count, 0)), count };
    }),
    mouse: flagMember(value, 'mouse', false),
  };
}

export type PointerKind = 'move' | 'down' | 'up' | 'double';

/** Buttons of the page, by OpenCV's numbers of events that a button begins with. */
const BUTTONS: readonly Readonly<Record<Exclude<PointerKind, 'move'>, number>>[] = [
  { down: 1, up: 4, double: 7 },
  { down: 3, up: 6, double: 9 },
  { down: 2, up: 5, double: 8 },
];

export interface PointerKeys {
  readonly button: number;
  readonly buttons: number;
  readonly ctrlKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

/** Event, place and flags, as a mouse callback gets them; undefined: a button that OpenCV does not know. */
export function mouseEvent(kind: PointerKind, x: number, y: number, keys: PointerKeys): readonly number[] | undefined {
  const event = kind === 'move' ? 0 : BUTTONS[keys.button]?.[kind];
  const flags = (keys.buttons & 7) | (keys.ctrlKey ? 8 : 0) | (keys.shiftKey ? 16 : 0) | (keys.altKey ? 32 : 0);
  return event === undefined ? undefined : [event, x, y, flags];
}
