// From where a scene is seen: around a point, or straight from above. Metres and radians, z is up. Pure.

import type { Vector } from './transform.ts';
import { flagMember, numberMember } from './json.ts';
import type { Json } from './json.ts';

export interface CameraView {
  /** The point in the middle of the picture. */
  readonly target: Vector;
  readonly distance: number;
  /** The yaw of the camera around the target, in radians. */
  readonly azimuth: number;
  /** Above the horizon. */
  readonly elevation: number;
  /** From above without perspective; x is to the right. */
  readonly top: boolean;
}

export const USUAL_VIEW: CameraView = {
  target: [0, 0, 0],
  distance: 6,
  azimuth: Math.PI / 4,
  elevation: Math.PI / 6,
  top: false,
};

/** The angle of view over the picture's height, in radians. */
export const FIELD_OF_VIEW = Math.PI / 4;

const LEAST_DISTANCE = 0.01;
const MOST_DISTANCE = 1e5;
const FARTHEST = 1e6;
const STEEPEST = Math.PI / 2 - 0.001;

/** Metres, in the distance of the target, for one pixel of a picture so many pixels high. */
export function metresPerPixel(view: CameraView, height: number): number {
  return (2 * view.distance * Math.tan(FIELD_OF_VIEW / 2)) / Math.max(1, height);
}

export function eyeOf({ target: [x, y, z], distance, azimuth, elevation, top }: CameraView): Vector {
  if (top) return [x, y, z + distance];
  const flat = distance * Math.cos(elevation);
  return [x + flat * Math.cos(azimuth), y + flat * Math.sin(azimuth), z + distance * Math.sin(elevation)];
}

/** Turned by a drag of so many pixels: the scene follows the pointer, half a turn for a picture's height. */
export function turned(view: CameraView, dx: number, dy: number, height: number): CameraView {
  const scale = Math.PI / Math.max(1, height);
  const elevation = view.elevation + dy * scale;
  return {
    ...view,
    azimuth: wrapped(view.azimuth - dx * scale),
    elevation: Math.max(-STEEPEST, Math.min(STEEPEST, elevation)),
  };
}

/** Moved in the picture's plane, so that what is at the target's distance stays under the pointer. */
export function panned(view: CameraView, dx: number, dy: number, height: number): CameraView {
  const scale = metresPerPixel(view, height);
  const [right, up] = axesOf(view);
  const part = (index: 0 | 1 | 2): number => bounded(view.target[index] - dx * scale * right[index] + dy * scale * up[index], FARTHEST);
  return { ...view, target: [part(0), part(1), part(2)] };
}

/** Nearer for factors below one. */
export function zoomed(view: CameraView, factor: number): CameraView {
  if (!(factor > 0)) return view;
  return { ...view, distance: Math.max(LEAST_DISTANCE, Math.min(MOST_DISTANCE, view.distance * factor)) };
}

/** The picture's right and up. */
function axesOf({ azimuth, elevation, top }: CameraView): readonly [Vector, Vector] {
  if (top) return [[1, 0, 0], [0, 1, 0]];
  const [s, c] = [Math.sin(azimuth), Math.cos(azimuth)];
  const sine = Math.sin(elevation);
  return [[-s, c, 0], [-sine * c, -sine * s, Math.cos(elevation)]];
}

function wrapped(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}

function bounded(value: number, most: number): number {
  return Math.max(-most, Math.min(most, value));
}

/** From a link or what the browser kept; what is missing or wrong is as usual. */
export function readView(state: unknown): CameraView {
  const at = (name: string, usual: number): number => numberMember(state, name, -FARTHEST, FARTHEST, usual);
  return {
    target: [at('x', 0), at('y', 0), at('z', 0)],
    distance: numberMember(state, 'distance', LEAST_DISTANCE, MOST_DISTANCE, USUAL_VIEW.distance),
    azimuth: numberMember(state, 'azimuth', -Math.PI, Math.PI, USUAL_VIEW.azimuth),
    elevation: numberMember(state, 'elevation', -STEEPEST, STEEPEST, USUAL_VIEW.elevation),
    top: flagMember(state, 'top', false),
  };
}

export function writeView({ target: [x, y, z], distance, azimuth, elevation, top }: CameraView): Json {
  const short = (value: number): number => Number(value.toPrecision(4));
  return {
    x: short(x),
    y: short(y),
    z: short(z),
    distance: short(distance),
    // Short of half a turn, which rounding may pass.
    azimuth: bounded(short(azimuth), 3.141),
    elevation: bounded(short(elevation), 1.569),
    top,
  };
}
