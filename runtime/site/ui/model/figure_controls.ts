// The state of a figure, published on /figures/PROGRAM/NAME/controls, and the coordinates and keys of events that the panel
// publishes on /figures/PROGRAM/NAME/input.

import type { Point, Size } from './graph_layout.ts';
import { flagMember, isRecord, member, textMember } from './json.ts';

const MOST_TEXT = 500;
const CURSORS: ReadonlySet<string> = new Set(['pointer', 'default', 'crosshair', 'move', 'wait', 'ew-resize', 'ns-resize']);

export interface FigureControls {
  readonly title: string;
  /** The figure has a toolbar. */
  readonly tools: boolean;
  /** The active tool of the toolbar. */
  readonly mode: 'none' | 'pan' | 'zoom';
  readonly back: boolean;
  readonly forward: boolean;
  /** The value under the pointer, or a message of a tool. */
  readonly message: string;
  readonly cursor: string;
  /** Two corners of a rectangle over the picture, in its pixels. */
  readonly rubberband: readonly [number, number, number, number] | null;
}

export const NO_FIGURE: FigureControls = {
  title: '',
  tools: false,
  mode: 'none',
  back: false,
  forward: false,
  message: '',
  cursor: 'default',
  rubberband: null,
};

/** Any node can publish on the topic: invalid members get their defaults. */
export function readFigureControls(text: string): FigureControls {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return NO_FIGURE;
  }
  if (!isRecord(value)) return NO_FIGURE;
  const mode = textMember(value, 'mode');
  const cursor = textMember(value, 'cursor');
  const band = member(value, 'rubberband');
  const isBand = Array.isArray(band) && band.length === 4 && band.every((one) => Number.isFinite(one));
  return {
    title: textMember(value, 'title').slice(0, MOST_TEXT),
    tools: flagMember(value, 'tools', false),
    mode: mode === 'pan' || mode === 'zoom' ? mode : 'none',
    back: flagMember(value, 'back', false),
    forward: flagMember(value, 'forward', false),
    message: textMember(value, 'message').slice(0, MOST_TEXT),
    cursor: CURSORS.has(cursor) ? cursor : 'default',
    rubberband: isBand ? (band as unknown as readonly [number, number, number, number]) : null,
  };
}

/** Position of a picture in the middle of a box, scaled down if it does not fit. */
export interface PicturePlace {
  readonly scale: number;
  readonly left: number;
  readonly top: number;
}

export function placeIn(box: Size, picture: Size): PicturePlace {
  const scale = Math.min(1, box.width / picture.width, box.height / picture.height);
  return { scale, left: (box.width - scale * picture.width) / 2, top: (box.height - scale * picture.height) / 2 };
}

/** Converts a point of the box to a pixel of the picture. */
export function pixelIn(place: PicturePlace, { x, y }: Point): Point {
  return { x: Math.round((x - place.left) / place.scale), y: Math.round((y - place.top) / place.scale) };
}

export interface HeldKeys {
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly shiftKey: boolean;
  readonly metaKey: boolean;
}

export function modifiersOf({ ctrlKey, altKey, shiftKey, metaKey }: HeldKeys): readonly string[] {
  return [...(ctrlKey ? ['ctrl'] : []), ...(altKey ? ['alt'] : []), ...(shiftKey ? ['shift'] : []), ...(metaKey ? ['super'] : [])];
}

const DOUBLE_PRESS = { milliseconds: 400, pixels: 4 } as const;

/** Detects the second press of a double click. */
export function pressCounter(): (button: number, at: Point, milliseconds: number) => boolean {
  let last = { button: -1, at: { x: 0, y: 0 }, milliseconds: -Infinity };
  return (button, at, milliseconds) => {
    const isSecond = button === last.button && milliseconds - last.milliseconds <= DOUBLE_PRESS.milliseconds
      && Math.abs(at.x - last.at.x) <= DOUBLE_PRESS.pixels && Math.abs(at.y - last.at.y) <= DOUBLE_PRESS.pixels;
    last = isSecond ? { ...last, milliseconds: -Infinity } : { button, at, milliseconds };
    return isSecond;
  };
}

/** Makes a safe name for a downloaded file. */
export function pngName(name: string): string {
  const plain = name.replace(/[^\w.\- ]/g, '_').replace(/^\.+/, '').slice(0, 100);
  return plain.toLowerCase().endsWith('.png') ? plain : `${plain === '' ? 'figure' : plain}.png`;
}
