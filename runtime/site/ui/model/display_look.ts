// How a display of the 3D view looks, as its visitor or an .rviz file set it; what is not said is as usual. It comes from
// links too.

import { flagMember, isRecord, member, numberMember, textMember } from './json.ts';
import type { Json } from './json.ts';

export interface DisplayLook {
  /** The size of points, in pixels. */
  readonly size?: number;
  /** `#rrggbb`. */
  readonly color?: string;
  /** 0 (not seen) to 1. */
  readonly alpha?: number;
  /** How many seconds of the site's time a message stays after the next one has come. */
  readonly decay?: number;
  /** By what points are coloured: `flat`, `rgb`, `x`, `y`, `z`, or another field. */
  readonly channel?: string;
  /** The values that have the first and the last colour of the rainbow; without, the least and the most that there are. */
  readonly least?: number;
  readonly most?: number;
  readonly scheme?: MapScheme;
  /** Shapes for seeing are hidden. */
  readonly hideVisual?: boolean;
  /** Shapes for collisions are shown. */
  readonly collision?: boolean;
}

/** As RViz calls them. */
export const MAP_SCHEMES = ['map', 'costmap', 'raw'] as const;
export type MapScheme = (typeof MAP_SCHEMES)[number];

export type Setting = 'size' | 'color' | 'alpha' | 'decay' | 'channel' | 'scheme' | 'shapes';

export const PLAIN_LOOK: DisplayLook = {};
export const MOST_DECAY = 600;
export const MOST_SIZE = 50;
const LARGEST = 1e7;
const MOST_LOOKS = 100;
const MOST_LETTERS = 40;

export function isColor(text: string): boolean {
  return /^#[0-9a-f]{6}$/i.test(text);
}

/** Missing or invalid members have the usual value. */
export function readLook(value: unknown): DisplayLook {
  const number = (name: string, least: number, most: number): number => numberMember(value, name, least, most, NaN);
  const color = textMember(value, 'color');
  const channel = textMember(value, 'channel').slice(0, MOST_LETTERS);
  const scheme = MAP_SCHEMES.find((one) => one === member(value, 'scheme'));
  const numbers = {
    size: number('size', 1, MOST_SIZE),
    alpha: number('alpha', 0, 1),
    decay: number('decay', 0, MOST_DECAY),
    least: number('least', -LARGEST, LARGEST),
    most: number('most', -LARGEST, LARGEST),
  };
  return {
    ...Object.fromEntries(Object.entries(numbers).filter(([, one]) => !Number.isNaN(one))),
    ...(isColor(color) ? { color } : {}),
    ...(channel === '' ? {} : { channel }),
    ...(scheme === undefined ? {} : { scheme }),
    ...(flagMember(value, 'hideVisual', false) ? { hideVisual: true } : {}),
    ...(flagMember(value, 'collision', false) ? { collision: true } : {}),
  };
}

/** By topic. */
export type Looks = Readonly<Record<string, DisplayLook>>;

export function readLooks(value: unknown): Looks {
  if (!isRecord(value)) return {};
  const looks = Object.entries(value).slice(0, MOST_LOOKS).map(([topic, look]) => [topic, readLook(look)] as const);
  return Object.fromEntries(looks.filter(([, look]) => Object.keys(look).length > 0));
}

export function writeLooks(looks: Looks): Json {
  return Object.fromEntries(
    Object.entries(looks).slice(0, MOST_LOOKS).map(([topic, look]) => [topic, { ...readLook(look) } as Json]),
  );
}

/** The looks with one of them changed; a member that is undefined is as usual again. */
export function withLook(looks: Looks, topic: string, change: { readonly [K in keyof DisplayLook]?: DisplayLook[K] | undefined; }): Looks {
  const next = readLook({ ...looks[topic], ...change });
  const { [topic]: _, ...others } = looks;
  return Object.keys(next).length === 0 ? others : { ...others, [topic]: next };
}
