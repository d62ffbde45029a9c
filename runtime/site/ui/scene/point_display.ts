// Displays of points, laser scans and point clouds: the newest message, and those before it for as long as they are to
// stay. Each message has its own place; the buffers of one that goes serve the next one.

import { BufferAttribute, BufferGeometry, Group, Points, PointsMaterial, Sphere, Vector3 } from 'three';
import type { Object3D } from 'three';
import { readScan } from '../model/laser_scan.ts';
import { pointValues, readCloud } from '../model/point_cloud.ts';
import type { PointCloud, PointColors } from '../model/point_cloud.ts';
import { readHeader } from '../model/transform.ts';
import type { HeaderView } from '../model/transform.ts';
import { member } from '../model/json.ts';
import { asNumber } from '../model/field_path.ts';
import { panelTexts } from '../texts_panels.ts';
import type { Anchored, Display, DisplayContext } from './display.ts';
import { disposeOf } from './dispose.ts';
import { POINT_SIZE, linear } from './points.ts';
import { lookOf } from './shapes.ts';

/** Upper bound of the points of all messages that are shown together. */
const MOST_KEPT = 4_000_000;
const MOST_MESSAGES = 2000;

type Read = (message: unknown, by: PointColors) => PointCloud | string;

/** One message on the stage. */
interface Slot {
  readonly object: Points<BufferGeometry, PointsMaterial>;
  message: unknown;
  header: HeaderView;
  sources: Uint32Array;
  /** Seconds of the site's time. */
  came: number;
}

export class PointDisplay implements Display {
  readonly group = new Group();
  problem = '';
  private readonly context: DisplayContext;
  private readonly read: Read;
  private readonly values: (message: unknown, index: number) => ReadonlyMap<string, number>;
  private waiting: unknown[] = [];
  /** The newest one is the last. */
  private slots: Slot[] = [];
  private isRepainted = false;

  private constructor(context: DisplayContext, read: Read, values: (message: unknown, index: number) => ReadonlyMap<string, number>) {
    this.context = context;
    this.read = read;
    this.values = values;
  }

  static scan(context: DisplayContext): PointDisplay {
    return new PointDisplay(context, (message, by) => readScan(message, by) ?? panelTexts.scene.noScan, beamValues);
  }

  static cloud(context: DisplayContext): PointDisplay {
    return new PointDisplay(context, (message, by) => {
      const cloud = readCloud(message, by);
      return cloud === 'no-data' ? panelTexts.scene.noCloud : cloud === 'no-places' ? panelTexts.scene.noPlaces : cloud;
    }, (message, index) => new Map([['point', index], ...pointValues(message, index)]));
  }

  take(message: unknown): void {
    if (this.decay === 0) this.waiting = [message];
    else if (this.waiting.length < MOST_MESSAGES) this.waiting.push(message);
  }

  repaint(): void {
    this.isRepainted = true;
  }

  build(now: number): number | undefined {
    if (this.isRepainted) { for (const slot of this.slots) this.fill(slot, slot.message); }
    this.isRepainted = false;
    const came = this.waiting;
    this.waiting = [];
    const { decay } = this;
    for (const message of came) {
      // In place of one that is over, so that nothing is made and nothing thrown away.
      const [first] = this.slots;
      const slot = first !== undefined && first.came + decay <= now ? (this.slots.shift() ?? first) : this.slot();
      slot.came = now;
      this.fill(slot, message);
      this.slots.push(slot);
    }
    let held = this.slots.reduce((sum, { sources }) => sum + sources.length, 0);
    // The newest one stays.
    while (this.slots.length > 1) {
      const [slot] = this.slots;
      if (slot === undefined || (slot.came + decay > now && held <= MOST_KEPT && this.slots.length <= MOST_MESSAGES)) break;
      this.slots.shift();
      held -= slot.sources.length;
      this.group.remove(slot.object);
      disposeOf(slot.object);
    }
    return this.slots.length > 1 ? (this.slots[0]?.came ?? now) + decay : undefined;
  }

  *anchored(): Iterable<Anchored> {
    for (const { object, header } of this.slots) yield { object, header };
  }

  describe(object: Object3D, index: number | undefined): ReadonlyMap<string, number> {
    const slot = this.slots.find((one) => one.object === object);
    const source = index === undefined ? undefined : slot?.sources[index];
    return slot === undefined || source === undefined ? new Map() : this.values(slot.message, source);
  }

  close(): void {
    for (const { object } of this.slots) disposeOf(object);
    this.group.clear();
    this.slots = [];
  }

  private get decay(): number {
    return this.context.look.decay ?? 0;
  }

  private slot(): Slot {
    const object = new Points(new BufferGeometry(), new PointsMaterial({ sizeAttenuation: false }));
    // Its bounds would be looked for in every point of every message: to leave it out, and to sort it.
    object.frustumCulled = false;
    object.geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    this.group.add(object);
    return { object, message: null, header: readHeader(null), sources: new Uint32Array(), came: 0 };
  }

  private fill(slot: Slot, message: unknown): void {
    const { look } = this.context;
    slot.message = message;
    slot.header = readHeader(message);
    const read = this.read(message, look);
    if (typeof read === 'string') {
      this.problem = read;
      slot.object.geometry.setDrawRange(0, 0);
      slot.sources = new Uint32Array();
      return;
    }
    const { positions, colors, sources, leftOut } = read;
    this.problem = leftOut > 0 ? panelTexts.scene.leftOut(leftOut) : '';
    slot.sources = sources;
    const { geometry, material } = slot.object;
    put(geometry, 'position', positions, (from, to) => to.set(from));
    if (colors !== null) put(geometry, 'color', colors, linear);
    geometry.setDrawRange(0, sources.length);
    const { color, alpha } = lookOf(this.context);
    if (material.vertexColors !== (colors !== null)) {
      material.vertexColors = colors !== null;
      material.needsUpdate = true;
    }
    if (colors === null) material.color.copy(color);
    else material.color.setRGB(1, 1, 1);
    material.transparent = alpha < 1;
    material.opacity = alpha;
    material.depthWrite = alpha >= 1;
    material.size = look.size ?? POINT_SIZE;
  }
}

/** Into the buffer that is there when it has room for it, else into one with some to spare. */
function put(geometry: BufferGeometry, name: string, values: Float32Array, fill: (from: Float32Array, to: Float32Array) => void): void {
  const known = geometry.hasAttribute(name) ? geometry.getAttribute(name) : undefined;
  if (known instanceof BufferAttribute && known.array.length >= values.length && known.array.length <= 4 * values.length + 3000) {
    fill(values, known.array as Float32Array);
    known.clearUpdateRanges();
    known.addUpdateRange(0, values.length);
    known.needsUpdate = true;
    return;
  }
  const room = new Float32Array(Math.ceil((values.length * 1.25) / 3) * 3);
  fill(values, room);
  // The card keeps the old one until the geometry goes.
  geometry.dispose();
  geometry.setAttribute(name, new BufferAttribute(room, 3));
}

function beamValues(message: unknown, index: number): ReadonlyMap<string, number> {
  const at = (name: string): unknown => {
    const list = member(message, name);
    return Array.isArray(list) || ArrayBuffer.isView(list) ? (list as unknown as ArrayLike<unknown>)[index] : undefined;
  };
  const values = [
    ['beam', index],
    ['angle', asNumber(member(message, 'angle_min')) + index * asNumber(member(message, 'angle_increment'))],
    ['range', asNumber(at('ranges'))],
    ['intensity', asNumber(at('intensities'))],
  ] as const;
  return new Map(values.filter(([, value]) => Number.isFinite(value)));
}
