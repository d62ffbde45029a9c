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
  /** Of what is written on wires. */
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

const kBetweenBoxes = 22;
const kBetweenWires = 14;
const kBetweenLayers = { right: 84, down: 56 } as const;

export function layOut(picture: Picture, sizes: Sizes, direction: Direction): GraphLayout {
  const graph = new Graph({ compound: true, multigraph: true });
  graph.setGraph({
    rankdir: direction === 'right' ? 'LR' : 'TB',
    nodesep: kBetweenBoxes,
    edgesep: kBetweenWires,
    ranksep: kBetweenLayers[direction],
  });
  // Numbers for names: what programs call themselves is no key here.
  const keys = new Map(picture.boxes.map(({ id }, index) => [id, `b${index}`]));
  const groups = new Map(picture.groups.map(({ id }, index) => [id, `g${index}`]));
  for (const [, key] of groups) graph.setNode(key, {});
  for (const { id, parent } of picture.groups) {
    const outer = parent === null ? undefined : groups.get(parent);
    if (outer !== undefined) graph.setParent(groups.get(id) ?? '', outer);
  }
  for (const { id, group } of picture.boxes) {
    const key = keys.get(id) ?? '';
    graph.setNode(key, { ...(sizes.boxes.get(id) ?? kNoSize) });
    const outer = group === null ? undefined : groups.get(group);
    if (outer !== undefined) graph.setParent(key, outer);
  }
  picture.wires.forEach(({ id, from, to }, index) => {
    const label = sizes.wires.get(id);
    const [a, b] = [keys.get(from), keys.get(to)];
    if (a !== undefined && b !== undefined) graph.setEdge(a, b, { ...(label ?? kNoSize), labelpos: 'c' }, `w${index}`);
  });
  layout(graph);
  return {
    boxes: new Map(picture.boxes.map(({ id }) => {
      const { x, y, width, height } = placeOf(graph.node(keys.get(id) ?? ''));
      return [id, { x, y, width, height }];
    })),
    routes: new Map(picture.wires.flatMap(({ id, from, to, lines }, index): [string, Route][] => {
      const edge = routeOf(graph.edge(keys.get(from) ?? '', keys.get(to) ?? '', `w${index}`));
      return edge === undefined ? [] : [[id, { points: edge.points, label: lines.length > 0 ? edge.label : null }]];
    })),
  };
}

const kNoSize: Size = { width: 0, height: 0 };

function numberOf(value: unknown): number {
  return typeof value === 'number' && Number.isFinite(value) ? value : 0;
}

function placeOf(found: unknown): Place {
  const { x, y, width, height } = (found ?? {}) as Partial<Place>;
  return { x: numberOf(x), y: numberOf(y), width: numberOf(width), height: numberOf(height) };
}

function routeOf(found: unknown): { readonly points: readonly Point[]; readonly label: Point } | undefined {
  const { points, x, y } = (found ?? {}) as { readonly points?: readonly Point[] } & Partial<Point>;
  if (points === undefined) return undefined;
  return {
    points: points.map((point) => ({ x: numberOf(point.x), y: numberOf(point.y) })),
    label: { x: numberOf(x), y: numberOf(y) },
  };
}
