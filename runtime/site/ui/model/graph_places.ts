// Keeps a drawn graph in its place while small things change: a box that leaves leaves a gap and comes back there, and a
// new one finds room near its neighbours. When that cannot be, or much has changed, everything is laid out again. Pure.

import { fitted } from './camera.ts';
import { layOut } from './graph_layout.ts';
import type { Direction, Place, Point, Route, Size, Sizes } from './graph_layout.ts';
import type { Box, Picture, Wire } from './graph_picture.ts';

export interface Arrangement {
  /** The place of each box; also of boxes that have left, for when they come back. */
  readonly places: ReadonlyMap<string, Place>;
  readonly routes: ReadonlyMap<string, Route>;
  readonly groups: ReadonlyMap<string, Place>;
  readonly bounds: Place;
  readonly direction: Direction;
  /** How often everything was laid out again. */
  readonly version: number;
}

/** From so many boxes on a single new one moves none of the others. */
const FEW_BOXES = 8;
const FEW_NEW = 0.2;
/** Larger graphs are laid out in one direction only. */
const MANY_BOXES = 30;
/** Flowing the likely way is worth something. */
const BETTER = 1.3;
const GAP = 18;
const GROUP_ROOM = { side: 12, top: 26, bottom: 12 } as const;
/** So many steps away from where it would stand best. */
const FAR = 8;

/** `view`: the room that it is seen in. */
export function arrange(before: Arrangement | null, picture: Picture, sizes: Sizes, view: Size): Arrangement {
  return (before === null ? null : adapted(before, picture, sizes)) ?? anew(before, picture, sizes, view);
}

/** Everything in new places, in the direction in which it is seen larger. */
export function anew(before: Arrangement | null, picture: Picture, sizes: Sizes, view: Size): Arrangement {
  const likely: Direction = view.width < view.height ? 'down' : 'right';
  const made = [likely, likely === 'right' ? 'down' : 'right'] as const;
  const [first, second] = (picture.boxes.length > MANY_BOXES ? made.slice(0, 1) : made).map((direction) => {
    const { boxes, routes } = layOut(picture, sizes, direction);
    return finished(picture, boxes, routes, direction, (before?.version ?? 0) + 1);
  });
  const seen = ({ bounds }: Arrangement): number => fitted(bounds, view).scale;
  if (first === undefined) throw new TypeError('a graph has at least one direction');
  return second !== undefined && seen(second) > BETTER * seen(first) ? second : first;
}

function adapted(before: Arrangement, picture: Picture, sizes: Sizes): Arrangement | null {
  const places = new Map(before.places);
  const fits = ({ id }: Box): boolean => {
    const [place, size] = [places.get(id), sizes.boxes.get(id)];
    return place !== undefined && place.width === size?.width && place.height === size.height;
  };
  const fresh = picture.boxes.filter((box) => !fits(box));
  const { length } = picture.boxes;
  if (length * 2 < places.size) return null;
  if (fresh.length > 0 && (length < FEW_BOXES || fresh.length > Math.max(1, length * FEW_NEW))) return null;
  const shown = new Map(picture.boxes.filter(fits).map(({ id }) => [id, places.get(id) ?? NOWHERE]));
  for (const box of fresh) {
    const place = roomFor(box, picture, shown, sizes, before.direction);
    if (place === null) return null;
    shown.set(box.id, place);
    places.set(box.id, place);
  }
  const moved = new Set(fresh.map(({ id }) => id));
  const stale = new Set(picture.wires.filter(({ from, to }) => moved.has(from) || moved.has(to)).map(({ id }) => id));
  const routes = new Map([...before.routes].filter(([id]) => !stale.has(id)));
  return finished(picture, places, routes, before.direction, before.version);
}

function finished(
  picture: Picture,
  places: ReadonlyMap<string, Place>,
  routes: ReadonlyMap<string, Route>,
  direction: Direction,
  version: number,
): Arrangement {
  const groups = groupPlaces(picture, places);
  const all = [...picture.boxes.flatMap(({ id }) => places.get(id) ?? []), ...groups.values()];
  const kept = new Map(routes);
  const edges: Place[] = [];
  for (const wire of picture.wires) {
    const route = kept.get(wire.id) ?? directRoute(wire, places, direction);
    if (route === null) continue;
    kept.set(wire.id, route);
    edges.push(...route.points.map((point) => ({ ...point, width: 0, height: 0 })));
  }
  return { places, routes: kept, groups, bounds: around([...all, ...edges]), direction, version };
}

function groupPlaces(picture: Picture, places: ReadonlyMap<string, Place>): ReadonlyMap<string, Place> {
  const found = new Map<string, Place>();
  // Inner ones first: they stand in the outer ones.
  for (const { id } of [...picture.groups].reverse()) {
    const inside = [
      ...picture.boxes.filter(({ group }) => group === id).flatMap((box) => places.get(box.id) ?? []),
      ...picture.groups.filter(({ parent }) => parent === id).flatMap((inner) => found.get(inner.id) ?? []),
    ];
    if (inside.length === 0) continue;
    const { x, y, width, height } = around(inside);
    found.set(id, {
      x,
      y: y + (GROUP_ROOM.bottom - GROUP_ROOM.top) / 2,
      width: width + 2 * GROUP_ROOM.side,
      height: height + GROUP_ROOM.top + GROUP_ROOM.bottom,
    });
  }
  return found;
}

/** A free place beside its neighbours; null when there is none near. */
function roomFor(
  box: Box,
  picture: Picture,
  shown: ReadonlyMap<string, Place>,
  sizes: Sizes,
  direction: Direction,
): Place | null {
  const size = sizes.boxes.get(box.id);
  if (size === undefined) return null;
  const across = direction === 'right';
  const wanted: Point[] = [];
  for (const { from, to } of picture.wires) {
    const other = from === box.id ? shown.get(to) : to === box.id ? shown.get(from) : undefined;
    if (other === undefined) continue;
    const way = from === box.id ? -1 : 1;
    const step = across ? (other.width + size.width) / 2 + 5 * GAP : (other.height + size.height) / 2 + 3 * GAP;
    wanted.push(across ? { x: other.x + way * step, y: other.y } : { x: other.x, y: other.y + way * step });
  }
  const bounds = around([...shown.values()]);
  const start = wanted.length === 0
    ? { x: bounds.x - bounds.width / 2 + size.width / 2, y: bounds.y + bounds.height / 2 + size.height / 2 + GAP }
    : { x: mean(wanted.map(({ x }) => x)), y: mean(wanted.map(({ y }) => y)) };
  const step = { x: (size.width + GAP) / 2, y: (size.height + GAP) / 2 };
  for (const { x, y } of STEPS) {
    const place = { ...size, x: start.x + x * step.x, y: start.y + y * step.y };
    if (isFree(place, box, picture, shown)) return place;
  }
  return null;
}

/** The nearest first. */
const STEPS: readonly Point[] = Array.from({ length: (2 * FAR + 1) ** 2 }, (_, index) => ({
  x: (index % (2 * FAR + 1)) - FAR,
  y: Math.floor(index / (2 * FAR + 1)) - FAR,
})).sort((a, b) => Math.hypot(a.x, a.y) - Math.hypot(b.x, b.y));

function isFree(place: Place, box: Box, picture: Picture, shown: ReadonlyMap<string, Place>): boolean {
  for (const other of shown.values()) if (overlaps(place, other, GAP)) return false;
  if (picture.groups.length === 0) return true;
  // Neither in a group that is not its own, nor may its own grow over others.
  const groups = groupPlaces(picture, new Map([...shown, [box.id, place]]));
  const outer = (id: string | null): string[] => {
    const parent = picture.groups.find((group) => group.id === id)?.parent ?? null;
    return id === null ? [] : [id, ...outer(parent)];
  };
  for (const [id, area] of groups) {
    for (const { id: other, group } of picture.boxes) {
      const at = other === box.id ? place : shown.get(other);
      if (at !== undefined && !outer(group).includes(id) && overlaps(area, at, 0)) return false;
    }
    for (const [second, other] of groups) {
      if (second !== id && !outer(second).includes(id) && !outer(id).includes(second) && overlaps(area, other, 0)) return false;
    }
  }
  return true;
}

function overlaps(a: Place, b: Place, gap: number): boolean {
  return Math.abs(a.x - b.x) * 2 < a.width + b.width + 2 * gap && Math.abs(a.y - b.y) * 2 < a.height + b.height + 2 * gap;
}

/** A curve from one box to the other, for a wire that came later. */
function directRoute(wire: Wire, places: ReadonlyMap<string, Place>, direction: Direction): Route | null {
  const [from, to] = [places.get(wire.from), places.get(wire.to)];
  if (from === undefined || to === undefined) return null;
  const across = direction === 'right';
  const side = (place: Place, way: number): Point =>
    across
      ? { x: place.x + way * place.width / 2, y: place.y }
      : { x: place.x, y: place.y + way * place.height / 2 };
  const out = (point: Point, way: number): Point => across ? { x: point.x + way * 2 * GAP, y: point.y } : { x: point.x, y: point.y + way * 2 * GAP };
  const [start, end] = [side(from, 1), side(to, -1)];
  const middle = { x: (start.x + end.x) / 2, y: (start.y + end.y) / 2 };
  const loop = wire.from === wire.to
    ? [{ x: from.x, y: from.y - from.height / 2 - 2 * GAP }]
    : [];
  return { points: [start, out(start, 1), ...loop, out(end, -1), end], label: wire.lines.length > 0 ? middle : null };
}

function around(places: readonly Place[]): Place {
  if (places.length === 0) return NOWHERE;
  const left = Math.min(...places.map(({ x, width }) => x - width / 2));
  const right = Math.max(...places.map(({ x, width }) => x + width / 2));
  const top = Math.min(...places.map(({ y, height }) => y - height / 2));
  const bottom = Math.max(...places.map(({ y, height }) => y + height / 2));
  return { x: (left + right) / 2, y: (top + bottom) / 2, width: right - left, height: bottom - top };
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

const NOWHERE: Place = { x: 0, y: 0, width: 0, height: 0 };
