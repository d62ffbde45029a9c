// Where the boxes and wires of a graph stand: dagre's layered layout. The only file that knows dagre. Pure.

import { Graph, layout } from '@dagrejs/dagre';
import type { Picture } from './graph_picture.ts';

export interface Point {
  readonly x: number;
  readonly y: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** x and y are those of its middle. */
export interface Place extends Point, Size {}

export interface Sizes {
  readonly boxes: ReadonlyMap<string, Size>;
  /** The sizes of the labels on wires. */
  readonly wires: ReadonlyMap<string, Size>;
}

export interface Route {
  readonly points: readonly Point[];
  /** Where what is written on it stands. */
  readonly label: Point | null;
}

export interface GraphLayout {
  readonly boxes: ReadonlyMap<string, Place>;
  readonly routes: ReadonlyMap<string, Route>;
}

export type Direction = 'right' | 'down';

const BETWEEN_BOXES = 22;
const BETWEEN_WIRES = 14;
const BETWEEN_LAYERS = { right: 84, down: 56 } as const;

export function layOut(picture: Picture, sizes: Sizes, direction: Direction): GraphLayout {
  const graph = new Graph({ compound: true, multigraph: true });
  graph.setGraph({
    rankdir: direction === 'right' ? 'LR' : 'TB',
    nodesep: BETWEEN_BOXES,
    edgesep: BETWEEN_WIRES,
    ranksep: BETWEEN_LAYERS[direction],
    // Turns fewer wires round than the usual way, and is several times as fast where many lead back.
    acyclicer: 'greedy',
  });
  // Numbers for names: what programs call themselves is not a key here.
  const keys = new Map(picture.boxes.map(({ id }, index) => [id, `b${index}`]));
  const groups = new Map(picture.groups.map(({ id }, index) => [id, `g${index}`]));
  for (const [, key] of groups) graph.setNode(key, {});
  for (const { id, parent } of picture.groups) {
    const outer = parent === null ? undefined : groups.get(parent);
    if (outer !== undefined) graph.setParent(groups.get(id) ?? '', outer);
  }
  for (const { id, group } of picture.boxes) {
    const key = keys.get(id) ?? '';
    graph.setNode(key, { ...(sizes.boxes.get(id) ?? NO_SIZE) });
    const outer = group === null ? undefined : groups.get(group);
    if (outer !== undefined) graph.setParent(key, outer);
  }
  picture.wires.forEach(({ id, from, to }, index) => {
    const label = sizes.wires.get(id);
    const [a, b] = [keys.get(from), keys.get(to)];
    if (a !== undefined && b !== undefined) graph.setEdge(a, b, { ...(label ?? NO_SIZE), labelpos: 'c' }, `w${index}`);
  });
  try {
    layout(graph);
  } catch {
    // dagre throws when a wire would end in the middle of a box: better plain than not at all.
    return inColumns(picture, sizes);
  }
  const boxes = new Map(picture.boxes.map(({ id }) => {
    const { x, y, width, height } = placeOf(graph.node(keys.get(id) ?? ''));
    return [id, { x, y, width, height }];
  }));
  const routes = new Map(picture.wires.flatMap(({ id, from, to, lines }, index): [string, Route][] => {
    const edge = routeOf(graph.edge(keys.get(from) ?? '', keys.get(to) ?? '', `w${index}`));
    if (edge === undefined) return [];
    const points = from === to ? edge.points : fromSideToSide(edge.points, boxes.get(from), boxes.get(to), direction);
    return [[id, { points, label: lines.length > 0 ? edge.label : null }]];
  }));
  return { boxes, routes };
}

/** dagre lets a steep wire end at the top of a box, behind the boxes above it in its layer: it ends at the side it comes from. */
function fromSideToSide(
  points: readonly Point[],
  from: Place | undefined,
  to: Place | undefined,
  direction: Direction,
): readonly Point[] {
  const [second, last] = [points[1], points.at(-2)];
  if (points.length < 3 || from === undefined || to === undefined || second === undefined || last === undefined) return points;
  return [sideOf(from, second, direction), ...points.slice(1, -1), sideOf(to, last, direction)];
}

function sideOf({ x, y, width, height }: Place, towards: Point, direction: Direction): Point {
  const near = (middle: number, at: number, size: number): number => middle + Math.max(-size / 5, Math.min(size / 5, at - middle));
  return direction === 'right'
    ? { x: x + (Math.sign(towards.x - x) * width) / 2, y: near(y, towards.y, height) }
    : { x: near(x, towards.x, width), y: y + (Math.sign(towards.y - y) * height) / 2 };
}

/** A column for each group, without routes: for a graph that dagre cannot lay out. */
export function inColumns(picture: Picture, sizes: Sizes): GraphLayout {
  const columns = [null, ...picture.groups.map(({ id }) => id).sort()];
  const places = new Map<string, Place>();
  let left = 0;
  for (const column of columns) {
    const boxes = picture.boxes.filter(({ group }) => group === column);
    const width = Math.max(0, ...boxes.map(({ id }) => sizes.boxes.get(id)?.width ?? 0));
    let top = 0;
    for (const { id } of boxes) {
      const size = sizes.boxes.get(id) ?? NO_SIZE;
      places.set(id, { ...size, x: left + width / 2, y: top + size.height / 2 });
      top += size.height + BETWEEN_BOXES;
    }
    if (boxes.length > 0) left += width + BETWEEN_LAYERS.right;
  }
  return { boxes: places, routes: new Map() };
}

const NO_SIZE: Size = { width: 0, height: 0 };

function numberOf(value: unknown): number {
  return typeof value === 'number' && Number.isFinite(value) ? value : 0;
}

function placeOf(found: unknown): Place {
  const { x, y, width, height } = (found ?? {}) as Partial<Place>;
  return { x: numberOf(x), y: numberOf(y), width: numberOf(width), height: numberOf(height) };
}

function routeOf(found: unknown): { readonly points: readonly Point[]; readonly label: Point; } | undefined {
  const { points, x, y } = (found ?? {}) as { readonly points?: readonly Point[]; } & Partial<Point>;
  if (points === undefined) return undefined;
  return {
    points: points.map((point) => ({ x: numberOf(point.x), y: numberOf(point.y) })),
    label: { x: numberOf(x), y: numberOf(y) },
  };
}
