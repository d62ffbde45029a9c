// The part of a drawing that is seen: moved, made larger and smaller, fitted to the room there is. Pure.

import type { Place, Point, Size } from './graph_layout.ts';

/** A point of the drawing is seen at `x + scale * point.x`. */
export interface Camera extends Point {
  readonly scale: number;
}

const kLeast = 0.05;
const kMost = 4;
/** Small drawings are not blown up. */
const kMostFitted = 1.1;
const kMargin = 16;

export function fitted(bounds: Place, view: Size): Camera {
  const room = (whole: number, needed: number): number => Math.max(1, whole - 2 * kMargin) / Math.max(1, needed);
  const scale = clamp(Math.min(room(view.width, bounds.width), room(view.height, bounds.height), kMostFitted));
  return { scale, x: view.width / 2 - scale * bounds.x, y: view.height / 2 - scale * bounds.y };
}

/** `at`, a point of the view, stays where it is. */
export function zoomed(camera: Camera, factor: number, at: Point): Camera {
  const scale = clamp(camera.scale * factor);
  const by = scale / camera.scale;
  return { scale, x: at.x - by * (at.x - camera.x), y: at.y - by * (at.y - camera.y) };
}

export function moved(camera: Camera, by: Point): Camera {
  return { ...camera, x: camera.x + by.x, y: camera.y + by.y };
}

/** Moved no more than needed to see that place. */
export function showing(camera: Camera, place: Place, view: Size): Camera {
  const shift = (at: number, half: number, whole: number): number => {
    const [first, last] = [at - half, at + half];
    if (2 * half > whole - 2 * kMargin) return whole / 2 - at;
    return first < kMargin ? kMargin - first : last > whole - kMargin ? whole - kMargin - last : 0;
  };
  const { scale } = camera;
  return moved(camera, {
    x: shift(camera.x + scale * place.x, (scale * place.width) / 2, view.width),
    y: shift(camera.y + scale * place.y, (scale * place.height) / 2, view.height),
  });
}

function clamp(scale: number): number {
  return Math.min(kMost, Math.max(kLeast, scale));
}
