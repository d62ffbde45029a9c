// The tree of frames as a list of rows, each below its parent; and what is wrong with it. Pure. Names are hostile: a chain
// may be as deep as there are frames.

import type { FrameView, TransformTree } from './transform_tree.ts';

export interface FrameRow {
  readonly frame: FrameView;
  /** How many frames are above it. */
  readonly depth: number;
  /** Is one of a ring of parents. */
  readonly looped: boolean;
}

export interface FrameRows {
  readonly rows: readonly FrameRow[];
  /** Frames that nobody places: one is as it should be. */
  readonly roots: readonly string[];
  readonly loops: readonly (readonly string[])[];
}

export function frameRows(tree: TransformTree): FrameRows {
  const views = new Map(tree.views().map((view) => [view.name, view]));
  const children = new Map<string, string[]>();
  for (const { name, parent } of views.values()) {
    if (parent === null) continue;
    const siblings = children.get(parent);
    if (siblings === undefined) children.set(parent, [name]);
    else siblings.push(name);
  }
  const roots = tree.roots();
  const loops = tree.loops();
  const inLoop = new Set(loops.flat());
  const rows: FrameRow[] = [];
  const done = new Set<string>();
  // The next one is the last of the list.
  const waiting = [...roots, ...loops.map(([first = '']) => first)].reverse().map((name) => ({ name, depth: 0 }));
  for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
    const { name, depth } = next;
    const frame = views.get(name);
    if (frame === undefined || done.has(name)) continue;
    done.add(name);
    rows.push({ frame, depth, looped: inLoop.has(name) });
    for (const child of [...(children.get(name) ?? [])].reverse()) waiting.push({ name: child, depth: depth + 1 });
  }
  return { rows, roots, loops };
}

/** Times per second over what is kept; 0 for a static frame, and for one that nobody has told of lately. `now`: seconds. */
export function frameRate({ isStatic, newest, oldest, count }: FrameView, now: number): number {
  if (isStatic || count < 2 || !(newest > oldest)) return 0;
  const hz = (count - 1) / (newest - oldest);
  return now - newest > Math.max(3, 5 / hz) ? 0 : hz;
}
