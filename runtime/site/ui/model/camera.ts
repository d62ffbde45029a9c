// The part of a drawing that is seen: moved, made larger and smaller, fitted to the room there is. Pure.

import type { Place, Point, Size } from './graph_layout.ts';

/** A point of the drawing is seen at `x + scale * point.x`. */
export interface Camera extends Point {
  readonly scale: number;
}

/** How far a kind of drawing is scaled. */
export interface CameraLimits {
  readonly least: number;
  readonly most: number;
  /** When it is fitted to its room. */
  readonly mostFitted: number;
  /** Pixels around what is fitted or shown. */
  readonly margin: number;
}

/** Small drawings are not blown up. */
export const DRAWING_LIMITS: CameraLimits = { least: 0.05, most: 4, mostFitted: 1.1, margin: 16 };
/** A picture fills its room, however small it is. */
export const PICTURE_LIMITS: CameraLimits = { least: 0.01, most: 512, mostFitted: 512, margin: 0 };

export function fitted(bounds: Place, view: Size, limits = DRAWING_LIMITS): Camera {
  const room = (whole: number, needed: number): number => Math.max(1, whole - 2 * limits.margin) / Math.max(1, needed);
  const scale = clamp(Math.min(room(view.width, bounds.width), room(view.height, bounds.height), limits.mostFitted), limits);
  return { scale, x: view.width / 2 - scale * bounds.x, y: view.height / 2 - scale * bounds.y };
}

/** `at`, a point of the view, stays where it is. */
export function zoomed(camera: Camera, factor: number, at: Point, limits = DRAWING_LIMITS): Camera {
  const scale = clamp(camera.scale * factor, limits);
  const by = scale / camera.scale;
  return { scale, x: at.x - by * (at.x - camera.x), y: at.y - by * (at.y - camera.y) };
}

export function moved(camera: Camera, by: Point): Camera {
  return { ...camera, x: camera.x + by.x, y: camera.y + by.y };
}

/** Moved no more than needed to see that place. */
export function showing(camera: Camera, place: Place, view: Size, { margin } = DRAWING_LIMITS): Camera {
  const shift = (at: number, half: number, whole: number): number => {
    const [first, last] = [at - half, at + half];
    if (2 * half > whole - 2 * margin) return whole / 2 - at;
    return first < margin ? margin - first : last > whole - margin ? whole - margin - last : 0;
  };
  const { scale } = camera;
  return moved(camera, {
    x: shift(camera.x + scale * place.x, (scale * place.width) / 2, view.width),
    y: shift(camera.y + scale * place.y, (scale * place.height) / 2, view.height),
  });
}

function clamp(scale: number, { least, most }: CameraLimits): number {
  return Math.min(most, Math.max(least, scale));
}
