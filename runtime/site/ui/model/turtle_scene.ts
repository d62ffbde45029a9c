// The contents of a turtle simulator (turtlesim_scene/msg/Scene), and the drawing that is built from scenes, which may
// begin in its middle. Publishers may be hostile: numbers and sizes are bounded. Pure.

import { isList } from '../../decode/yaml.ts';
import { asNumber } from './field_path.ts';
import { isRecord } from './json.ts';

export interface SceneTurtle {
  readonly name: string;
  /** From the lower left corner, in units. */
  readonly x: number;
  readonly y: number;
  /** Radians, counterclockwise from the x axis. */
  readonly theta: number;
  readonly shape: number;
}

/** In pixels of the sheet from its upper left corner. */
export interface Stroke {
  readonly x1: number;
  readonly y1: number;
  readonly x2: number;
  readonly y2: number;
  readonly width: number;
  /** For CSS. */
  readonly color: string;
}

export interface Scene {
  /** The width of the sheet, in pixels. */
  readonly width: number;
  readonly height: number;
  /** Pixels per unit. */
  readonly meter: number;
  /** For CSS. */
  readonly background: string;
  readonly turtles: readonly SceneTurtle[];
  /** Number of the sheet: each clearing takes a new one. */
  readonly picture: number;
  /** Number of the first stroke, from 0 on each sheet. */
  readonly first: number;
  readonly strokes: readonly Stroke[];
}

/** All that was drawn, as pixels: the reply of turtlesim_scene/srv/GetPicture. */
export interface Picture {
  readonly picture: number;
  /** How many strokes are in it. */
  readonly strokes: number;
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

const MOST_PIXELS = 2000;
const MOST_TURTLES = 500;
/** Upper bound for one scene, and for those that wait for the picture: the newest ones stay. The picture has the others. */
const MOST_STROKES = 10_000;
const FAR = 1e5;

/** null when it shows no sheet. */
export function readScene(value: unknown): Scene | null {
  if (!isRecord(value)) return null;
  const width = size(value['width']);
  const height = size(value['height']);
  const meter = asNumber(value['meter']);
  if (width === 0 || height === 0 || !(meter >= 1 && meter <= MOST_PIXELS)) return null;
  const strokes = list(value['strokes']);
  const dropped = Math.max(0, strokes.length - MOST_STROKES);
  return {
    width,
    height,
    meter,
    background: color(list(value['background'])),
    turtles: list(value['turtles']).slice(0, MOST_TURTLES).flatMap(readTurtle),
    picture: asNumber(value['picture']),
    first: asNumber(value['first']) + dropped,
    strokes: strokes.slice(dropped).map(readStroke),
  };
}

/** null when the pixels are not those of a sheet. */
export function readPicture(value: unknown): Picture | null {
  if (!isRecord(value)) return null;
  const width = size(value['width']);
  const height = size(value['height']);
  if (width === 0 || height === 0) return null;
  const rgba = new Uint8ClampedArray(width * height * 4);
  const words = new DataView(rgba.buffer);
  const colors = list(value['colors']);
  let at = 0;
  for (const [index, each] of list(value['lengths']).entries()) {
    const argb = asNumber(colors[index]) >>> 0;
    const end = at + asNumber(each) * 4;
    if (!(end >= at && end <= rgba.length)) return null;
    if (argb >>> 24 === 0) at = end;
    for (; at < end; at += 4) words.setUint32(at, ((argb << 8) | (argb >>> 24)) >>> 0);
  }
  return { picture: asNumber(value['picture']), strokes: asNumber(value['strokes']), width, height, rgba };
}

/** The changes that a scene makes to the visible sheet. */
export interface SheetChange {
  /** Begins with an empty one. */
  readonly cleared: boolean;
  readonly strokes: readonly Stroke[];
  /** Strokes before these were missed: the picture is to be asked for. Told once until takePicture() or askAgain(). */
  readonly ask: boolean;
}

/** Follows the scenes of one topic. */
export class Sheet {
  private publisher = '';
  private picture = Number.NaN;
  /** How many strokes of the sheet are known: all before this one, unless some are missing. */
  private end = 0;
  /** The scenes with strokes that came since strokes were missed. */
  private late: Scene[] = [];
  private missing = false;
  private asked = false;

  /** `publisher` tells a simulator from the one that ran before it. */
  take(scene: Scene, publisher: string): SheetChange {
    const cleared = publisher !== this.publisher || scene.picture !== this.picture;
    if (cleared) {
      this.publisher = publisher;
      this.picture = scene.picture;
      this.end = 0;
      this.late = [];
      this.missing = false;
      this.asked = false;
    }
    const strokes = this.append(scene);
    if (this.missing) this.keep(scene);
    const ask = this.missing && !this.asked;
    this.asked = this.missing;
    return { cleared, strokes, ask };
  }

  /** The strokes that were drawn since the picture was made; null when it is not of this sheet. */
  takePicture(picture: Picture): readonly Stroke[] | null {
    this.asked = false;
    if (!this.missing || picture.picture !== this.picture) return null;
    const { late } = this;
    this.late = [];
    this.missing = false;
    this.end = picture.strokes;
    return late.flatMap((scene) => this.append(scene));
  }

  /** The picture did not come. */
  askAgain(): void {
    this.asked = false;
  }

  /** Those that are dropped here are in the picture, or are asked for once more. */
  private keep(scene: Scene): void {
    if (scene.strokes.length > 0) this.late.push(scene);
    let count = this.late.reduce((sum, { strokes }) => sum + strokes.length, 0);
    while (count > MOST_STROKES) count -= this.late.shift()?.strokes.length ?? count;
  }

  private append(scene: Scene): readonly Stroke[] {
    if (scene.first > this.end) this.missing = true;
    const fresh = scene.strokes.slice(Math.max(0, this.end - scene.first));
    this.end = Math.max(this.end, scene.first + scene.strokes.length);
    return fresh;
  }
}

function readTurtle(value: unknown): readonly SceneTurtle[] {
  if (!isRecord(value)) return [];
  const name = value['name'];
  const [x, y, theta] = [value['x'], value['y'], value['theta']].map(asNumber);
  if (typeof name !== 'string' || x === undefined || y === undefined || theta === undefined) return [];
  if (!(Math.abs(x) < FAR && Math.abs(y) < FAR && Number.isFinite(theta))) return [];
  return [{ name: name.slice(0, 80), x, y, theta, shape: asNumber(value['shape']) }];
}

function readStroke(value: unknown): Stroke {
  const of = isRecord(value) ? value : {};
  return {
    x1: asNumber(of['x1']),
    y1: asNumber(of['y1']),
    x2: asNumber(of['x2']),
    y2: asNumber(of['y2']),
    width: asNumber(of['width']),
    color: color([of['r'], of['g'], of['b']]),
  };
}

function color(channels: readonly unknown[]): string {
  const [r, g, b] = channels.map((each) => Math.min(255, Math.max(0, Math.round(asNumber(each)) || 0)));
  return `rgb(${r ?? 0} ${g ?? 0} ${b ?? 0})`;
}

function size(value: unknown): number {
  const number = asNumber(value);
  return number >= 1 && number <= MOST_PIXELS ? Math.floor(number) : 0;
}

function list(value: unknown): readonly unknown[] {
  return isList(value) ? Array.from(value) : [];
}
