// The tree of frames that /tf and /tf_static tell: of each frame its parent and its newest transforms, and where one
// frame is in another. Everything in it may be hostile: loops, names without end, numbers that are none.

import { member } from './json.ts';
import { between, compose, frameName, inverse, IDENTITY, readHeader, readTransform, type Transform } from './transform.ts';

/** As much of a frame's past as tf2 keeps. */
const KEPT_SECONDS = 10;
const MOST_STAMPS = 1000;
const MOST_FRAMES = 5000;
const MOST_NAME_LENGTH = 256;
const MOST_TRANSFORMS = 10_000;

export interface FrameView {
  readonly name: string;
  /** null: nobody says where it is, so it is a root. */
  readonly parent: string | null;
  readonly isStatic: boolean;
  /** Seconds, of the newest and the oldest transform kept; NaN for a root. */
  readonly newest: number;
  readonly oldest: number;
  /** How many are kept between them. */
  readonly count: number;
  /** From the frame to its parent, as told last. */
  readonly transform: Transform;
}

export type Lookup =
  | { readonly kind: 'found'; readonly transform: Transform; }
  /** Nobody has spoken of that frame. */
  | { readonly kind: 'unknown'; readonly frame: string; }
  /** Its parents lead back to itself. */
  | { readonly kind: 'loop'; readonly frame: string; }
  /** The two belong to different trees; these are their roots. */
  | { readonly kind: 'apart'; readonly roots: readonly [string, string]; };

interface Frame {
  readonly name: string;
  parent: string;
  isStatic: boolean;
  /** Ascending; a static frame has one. */
  stamps: number[];
  transforms: Transform[];
}

export class TransformTree {
  private readonly frames = new Map<string, Frame>();
  /** Frames that have children; some of them are in no other way known. */
  private readonly parents = new Map<string, number>();
  private refusedCount = 0;
  private newestStamp = NaN;

  /** Transforms that were none: not finite, without names, onto themselves, or too many. */
  get refused(): number {
    return this.refusedCount;
  }

  /** Seconds; NaN before the first one that is not static. */
  get newest(): number {
    return this.newestStamp;
  }

  /** Takes a tf2_msgs/msg/TFMessage. Tells whether any frame is elsewhere now. */
  addMessage(message: unknown, isStatic: boolean): boolean {
    const list = member(message, 'transforms');
    if (!Array.isArray(list)) return false;
    let moved = false;
    for (const item of list.slice(0, MOST_TRANSFORMS) as readonly unknown[]) {
      const { frame, stamp } = readHeader(item);
      const child = member(item, 'child_frame_id');
      const transform = readTransform(member(item, 'transform'));
      if (typeof child !== 'string' || transform === null) this.refusedCount += 1;
      else if (this.add(frame, frameName(child), transform, Number.isNaN(stamp) ? 0 : stamp, isStatic)) moved = true;
    }
    return moved;
  }

  /** Tells whether the frame is elsewhere now. `stamp`: seconds. */
  add(parent: string, child: string, transform: Transform, stamp: number, isStatic: boolean): boolean {
    const wrong = parent === '' || child === '' || parent === child
      || parent.length > MOST_NAME_LENGTH || child.length > MOST_NAME_LENGTH || !Number.isFinite(stamp);
    const known = this.frames.get(child);
    if (wrong || (known === undefined && this.frames.size >= MOST_FRAMES)) {
      this.refusedCount += 1;
      return false;
    }
    if (!isStatic && !(stamp <= this.newestStamp)) this.newestStamp = stamp;
    if (known === undefined) {
      this.frames.set(child, { name: child, parent, isStatic, stamps: [stamp], transforms: [transform] });
      this.count(parent, 1);
      return true;
    }
    const before = known.transforms.at(-1);
    const same = known.parent === parent && before !== undefined && equal(before, transform);
    const last = known.stamps.at(-1) ?? -Infinity;
    if (known.parent !== parent) {
      this.count(known.parent, -1);
      this.count(parent, 1);
      known.parent = parent;
      begin(known, stamp, transform);
    } else if (isStatic || known.isStatic || stamp < last - KEPT_SECONDS) {
      // The last case is a clock that was set back: what it told before is of another time.
      begin(known, stamp, transform);
      if (!isStatic && stamp < last - KEPT_SECONDS) this.newestStamp = stamp;
    } else {
      insert(known, stamp, transform);
    }
    known.isStatic = isStatic;
    return !same;
  }

  clear(): void {
    this.frames.clear();
    this.parents.clear();
    this.refusedCount = 0;
    this.newestStamp = NaN;
  }

  has(name: string): boolean {
    return this.frames.has(name) || this.parents.has(name);
  }

  /** Sorted by name, roots among them. */
  views(): readonly FrameView[] {
    const views = [...this.frames.values()].map(viewOf);
    for (const name of this.parents.keys())
      if (!this.frames.has(name))
        views.push({ name, parent: null, isStatic: true, newest: NaN, oldest: NaN, count: 0, transform: IDENTITY });
    return views.sort((a, b) => (a.name < b.name ? -1 : 1));
  }

  /** Frames that nobody places, sorted: one for each tree that is not a loop. */
  roots(): readonly string[] {
    return [...this.parents.keys()].filter((name) => !this.frames.has(name)).sort();
  }

  /** Each ring of parents once, from the frame of it that is first by name. */
  loops(): readonly (readonly string[])[] {
    const done = new Set<string>();
    const found: string[][] = [];
    for (const start of this.frames.keys()) {
      const path: string[] = [];
      const here = new Set<string>();
      let name = start;
      while (!done.has(name) && !here.has(name)) {
        here.add(name);
        path.push(name);
        const parent = this.frames.get(name)?.parent;
        if (parent === undefined) break;
        name = parent;
      }
      if (here.has(name) && this.frames.has(name)) {
        const ring = path.slice(path.indexOf(name));
        const first = ring.indexOf(ring.reduce((a, b) => (a < b ? a : b)));
        found.push([...ring.slice(first), ...ring.slice(0, first)]);
      }
      for (const one of here) done.add(one);
    }
    return found;
  }

  /**
   * Where `source` is in `target`: takes a point of source to the same point of target. With a `stamp` in seconds, as
   * it was then, between the transforms around it; before the oldest and after the newest kept, as those say. Without
   * one (or NaN), as told last.
   */
  lookup(target: string, source: string, stamp = NaN): Lookup {
    if (target === source && !this.has(target)) return { kind: 'unknown', frame: target };
    const from = this.toRoot(source, stamp);
    if (from.kind !== 'chain') return from;
    const to = this.toRoot(target, stamp);
    if (to.kind !== 'chain') return to;
    if (from.root !== to.root) return { kind: 'apart', roots: [to.root, from.root] };
    return { kind: 'found', transform: compose(inverse(to.transform), from.transform) };
  }

  /** Where all frames of the same tree are in `target`, as told last; empty when nobody knows it or it hangs on a loop. */
  places(target: string): ReadonlyMap<string, Transform> {
    const places = new Map<string, Transform>();
    const start = this.toRoot(target, NaN);
    if (start.kind !== 'chain') return places;
    const children = new Map<string, Frame[]>();
    for (const frame of this.frames.values()) {
      const siblings = children.get(frame.parent);
      if (siblings === undefined) children.set(frame.parent, [frame]);
      else siblings.push(frame);
    }
    places.set(start.root, inverse(start.transform));
    // Grows while it is walked: from a root no loop is reached, for every frame has one parent.
    for (const [name, transform] of places)
      for (const child of children.get(name) ?? []) places.set(child.name, compose(transform, at(child, NaN)));
    return places;
  }

  private toRoot(
    name: string,
    stamp: number,
  ): Exclude<Lookup, { kind: 'found' | 'apart'; }> | { readonly kind: 'chain'; readonly root: string; readonly transform: Transform; } {
    if (!this.has(name)) return { kind: 'unknown', frame: name };
    const seen = new Set<string>();
    let transform = IDENTITY;
    let root = name;
    for (let frame = this.frames.get(root); frame !== undefined; frame = this.frames.get(root)) {
      if (seen.has(root)) return { kind: 'loop', frame: name };
      seen.add(root);
      transform = compose(at(frame, stamp), transform);
      root = frame.parent;
    }
    return { kind: 'chain', root, transform };
  }

  private count(parent: string, change: number): void {
    const count = (this.parents.get(parent) ?? 0) + change;
    if (count > 0) this.parents.set(parent, count);
    else this.parents.delete(parent);
  }
}

function viewOf({ name, parent, isStatic, stamps, transforms }: Frame): FrameView {
  return {
    name,
    parent,
    isStatic,
    newest: stamps.at(-1) ?? NaN,
    oldest: stamps[0] ?? NaN,
    count: stamps.length,
    transform: transforms.at(-1) ?? IDENTITY,
  };
}

function begin(frame: Frame, stamp: number, transform: Transform): void {
  frame.stamps = [stamp];
  frame.transforms = [transform];
}

/** In the order of time: it comes at the end, but for what was late. Forgets what is too old. */
function insert({ stamps, transforms }: Frame, stamp: number, transform: Transform): void {
  let place = stamps.length;
  while (place > 0 && (stamps[place - 1] ?? 0) > stamp) place -= 1;
  const isSame = place > 0 && stamps[place - 1] === stamp;
  stamps.splice(isSame ? place - 1 : place, isSame ? 1 : 0, stamp);
  transforms.splice(isSame ? place - 1 : place, isSame ? 1 : 0, transform);
  const newest = stamps.at(-1) ?? stamp;
  let old = Math.max(0, stamps.length - MOST_STAMPS);
  while ((stamps[old] ?? newest) < newest - KEPT_SECONDS) old += 1;
  // Now and then rather than each time: a list is moved when its front goes.
  if (old > 64 || stamps.length > MOST_STAMPS + 64) {
    stamps.splice(0, old);
    transforms.splice(0, old);
  }
}

function at({ stamps, transforms }: Frame, stamp: number): Transform {
  const last = stamps.length - 1;
  const newest = transforms[last] ?? IDENTITY;
  if (Number.isNaN(stamp) || stamp >= (stamps[last] ?? 0)) return newest;
  let [low, high] = [0, last];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((stamps[middle] ?? 0) < stamp) low = middle + 1;
    else high = middle;
  }
  const after = transforms[low] ?? newest;
  const before = transforms[low - 1];
  const [start, end] = [stamps[low - 1] ?? 0, stamps[low] ?? 0];
  return before === undefined ? after : between(before, after, (stamp - start) / (end - start));
}

function equal(a: Transform, b: Transform): boolean {
  return (
    a.translation.every((part, index) => part === b.translation[index])
    && a.rotation.every((part, index) => part === b.rotation[index])
  );
}
