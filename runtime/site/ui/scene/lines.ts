// Lines with a width, in pixels or in metres.

import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Object3D } from 'three';
import { segments } from './shapes.ts';
import type { Rgba } from './shapes.ts';

/** Beyond this many pieces lines are drawn as thin as can be. */
const MOST_PIECES = 100_000;

export interface LineWidth {
  readonly width: number;
  readonly unit: 'pixels' | 'metres';
}

/** Pairs of points; of one colour, or with a colour for each point (in three's light) and one transparency. */
export function lines(pairs: Float32Array, look: Rgba, colors: Float32Array | null, { width, unit }: LineWidth): Object3D {
  if (pairs.length > MOST_PIECES * 6) return segments(pairs, colors ?? look, look.alpha);
  const geometry = new LineSegmentsGeometry();
  if (pairs.length > 0) geometry.setPositions(pairs);
  if (colors !== null && pairs.length > 0) geometry.setColors(colors);
  const material = new LineMaterial({
    linewidth: width,
    worldUnits: unit === 'metres',
    vertexColors: colors !== null,
    transparent: look.alpha < 1,
    opacity: look.alpha,
  });
  if (colors === null) material.color.copy(look.color);
  const object = new LineSegments2(geometry, material);
  object.frustumCulled = false;
  object.visible = pairs.length > 0;
  return object;
}

/** The pairs of a line through points: three numbers of each. */
export function pairsOf(points: Float32Array): Float32Array {
  const count = Math.max(0, points.length / 3 - 1);
  const pairs = new Float32Array(count * 6);
  for (let i = 0; i < count; i += 1) pairs.set(points.subarray(i * 3, i * 3 + 6), i * 6);
  return pairs;
}
