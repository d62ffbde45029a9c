// The world of a simulator as its hidden topics tell it (ros2wasm_sim, src/ros/scene_publisher.hpp): models, their links, and
// where they are. Messages may be anything.

import { asNumber } from './field_path.ts';
import { member, textMember } from './json.ts';
import { readTransform } from './transform.ts';
import type { Transform } from './transform.ts';
import { TransformTree } from './transform_tree.ts';

export const WORLD_FRAME = 'world';
const BETWEEN = '::';
const MOST_TRANSFORMS = 20_000;

export interface ModelEntity {
  readonly name: string;
  /** Frames of its links, `model::link`, in the world's order. */
  readonly links: readonly string[];
}

export class SimWorld {
  readonly tree = new TransformTree();
  private found: readonly ModelEntity[] = [];
  private known = new Map<string, Transform>();
  private inner = new Set<string>();
  private fixed = new Set<string>();

  /** In the world's order. */
  get models(): readonly ModelEntity[] {
    return this.found;
  }

  /** Where a link was last. */
  place(frame: string): Transform | undefined {
    return this.known.get(frame);
  }

  /** Can the link move? Those of static models cannot. */
  moves(frame: string): boolean {
    return !this.fixed.has(frame);
  }

  /** Takes a visualization_msgs/msg/MarkerArray of all shapes: those that do not go with their frame never move. */
  takeShapes(message: unknown): void {
    const list = member(message, 'markers');
    if (!Array.isArray(list)) return;
    this.fixed = new Set((list as readonly unknown[]).filter((one) => member(one, 'frame_locked') === false).map((one) => textMember(one, 'ns')));
  }

  /** Is it a joint, a sensor, or a named place of a link? */
  isInner(frame: string): boolean {
    return this.inner.has(frame);
  }

  /** Takes a tf2_msgs/msg/TFMessage: `moved`, or also other `models` than before, or nothing of that. */
  take(message: unknown): 'models' | 'moved' | 'same' {
    const list = member(message, 'transforms');
    if (!Array.isArray(list)) return 'same';
    const all = (list.slice(0, MOST_TRANSFORMS) as readonly unknown[]).map(readOne).filter((one) => one !== null);
    const isWhole = all[0]?.child === WORLD_FRAME;
    const links = all.filter(({ parent }) => parent === WORLD_FRAME);
    const isOther = isWhole && (links.length !== this.known.size || links.some(({ child }) => !this.known.has(child)));
    if (isOther) {
      this.tree.clear();
      this.known.clear();
      this.inner.clear();
    }
    let moved = false;
    for (const { parent, child, transform } of all) {
      if (parent === '') continue;
      if (parent === WORLD_FRAME) this.known.set(child, transform);
      else this.inner.add(child);
      moved = this.tree.add(parent, child, transform, 0, true) || moved;
    }
    if (isOther) this.found = modelsOf(this.known.keys());
    return isOther ? 'models' : moved ? 'moved' : 'same';
  }

  /**
   * The frame of the world that a sensor's message means: a place in a link, a link, or the scoped name `model/link/sensor`.
   * undefined: the world has none of that name.
   */
  frameOf(name: string): string | undefined {
    const asked = (name.startsWith('/') ? name.slice(1) : name).replaceAll('/', BETWEEN);
    if (asked === '') return undefined;
    if (this.known.has(asked) || this.inner.has(asked)) return asked;
    const ending = `${BETWEEN}${asked.split(BETWEEN).at(-1) ?? ''}`;
    for (const frames of [this.known.keys(), this.inner])
      for (const frame of frames) if (frame.endsWith(ending)) return frame;
    return undefined;
  }
}

function readOne(item: unknown): { readonly parent: string; readonly child: string; readonly transform: Transform; } | null {
  const transform = readTransform(member(item, 'transform'));
  const child = textMember(item, 'child_frame_id');
  return transform === null || child === '' ? null : { parent: textMember(member(item, 'header'), 'frame_id'), child, transform };
}

function modelsOf(frames: Iterable<string>): readonly ModelEntity[] {
  const models = new Map<string, string[]>();
  for (const frame of frames) {
    const name = modelOf(frame);
    const links = models.get(name);
    if (links === undefined) models.set(name, [frame]);
    else links.push(frame);
  }
  return [...models].map(([name, links]) => ({ name, links }));
}

/** The model of a link's frame. */
export function modelOf(frame: string): string {
  const end = frame.indexOf(BETWEEN);
  return end < 0 ? frame : frame.slice(0, end);
}

/** The link's name in its model. */
export function linkOf(frame: string): string {
  const end = frame.indexOf(BETWEEN);
  return end < 0 ? '' : frame.slice(end + BETWEEN.length);
}

export interface SimPace {
  /** Seconds of simulated time. */
  readonly time: number;
  /** Simulated seconds per second of the site. */
  readonly factor: number;
}

/** A gazebo_msgs/msg/PerformanceMetrics. */
export function readPace(message: unknown): SimPace | null {
  const time = asNumber(member(member(message, 'header'), 'stamp'));
  const factor = asNumber(member(message, 'real_time_factor'));
  return Number.isFinite(time) && Number.isFinite(factor) ? { time, factor } : null;
}
