// Lines, arrowheads and the order of what stands in a drawn graph. Pure.

import type { Direction, Place, Point } from './graph_layout.ts';

/** A line through the points, its corners rounded. */
export function pathOf(points: readonly Point[]): string {
  const [first, ...rest] = points;
  if (first === undefined) return '';
  const at = ({ x, y }: Point): string => `${fixed(x)} ${fixed(y)}`;
  let path = `M${at(first)}`;
  rest.forEach((point, index) => {
    const next = rest[index + 1];
    if (next === undefined) path += `L${at(point)}`;
    else path += `${index === 0 ? `L${at(between(first, point))}` : ''}Q${at(point)} ${at(between(point, next))}`;
  });
  return path;
}

const ARROW = { length: 9, width: 3.6 } as const;

/** A closed arrowhead at the last point. */
export function arrowOf(points: readonly Point[]): string {
  const [before, end] = points.slice(-2);
  if (before === undefined || end === undefined) return '';
  const length = Math.hypot(end.x - before.x, end.y - before.y);
  if (length === 0) return '';
  const [dx, dy] = [(end.x - before.x) / length, (end.y - before.y) / length];
  const base = { x: end.x - dx * ARROW.length, y: end.y - dy * ARROW.length };
  const corner = (side: number): string => `${fixed(base.x - side * dy * ARROW.width)} ${fixed(base.y + side * dx * ARROW.width)}`;
  return `M${fixed(end.x)} ${fixed(end.y)}L${corner(1)}L${corner(-1)}Z`;
}

interface Standing {
  readonly place: Place;
}

/** Along the flow, layer by layer; within a layer from the first to the last. */
export function readingOrder<T extends Standing>(items: readonly T[], direction: Direction): readonly T[] {
  const along = ({ place }: T): number => Math.round(direction === 'right' ? place.x : place.y);
  const across = ({ place }: T): number => Math.round(direction === 'right' ? place.y : place.x);
  return items.toSorted((a, b) => along(a) - along(b) || across(a) - across(b));
}

export type ArrowKey = 'ArrowRight' | 'ArrowLeft' | 'ArrowUp' | 'ArrowDown';

const WAYS: Readonly<Record<ArrowKey, Point>> = {
  ArrowRight: { x: 1, y: 0 },
  ArrowLeft: { x: -1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};

/** The nearest one in that direction; what lies aside counts as farther. */
export function nextOf<T extends Standing>(items: readonly T[], index: number, key: ArrowKey): T | undefined {
  const from = items[index]?.place;
  if (from === undefined) return undefined;
  const way = WAYS[key];
  let best: T | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const item of items) {
    const [dx, dy] = [item.place.x - from.x, item.place.y - from.y];
    const ahead = dx * way.x + dy * way.y;
    const aside = Math.abs(dx * way.y) + Math.abs(dy * way.x);
    if (ahead < 1) continue;
    const far = ahead + 2 * aside;
    if (far < least) [best, least] = [item, far];
  }
  return best;
}

function between(a: Point, b: Point): Point {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}

function fixed(value: number): string {
  return String(Number(value.toFixed(1)));
}
