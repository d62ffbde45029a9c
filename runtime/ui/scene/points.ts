// Displays of points: laser scans and point clouds.

import { BufferAttribute, BufferGeometry, Points, PointsMaterial, SRGBColorSpace, Color } from 'three';
import { asNumber } from '../model/field_path.ts';
import { member } from '../model/json.ts';
import { readCloud } from '../model/point_cloud.ts';
import { panelTexts } from '../texts_panels.ts';
import { kFarthest } from './display.ts';
import type { Built } from './newest_display.ts';

const kPointSize = 3; // pixels
const kMostBeams = 1_000_000;

export function laserScan(color: string): (message: unknown) => Built {
  return (message) => {
    const ranges = member(message, 'ranges');
    const start = asNumber(member(message, 'angle_min'));
    const step = asNumber(member(message, 'angle_increment'));
    const nearest = asNumber(member(message, 'range_min'));
    const farthest = asNumber(member(message, 'range_max'));
    if (!isNumbers(ranges) || !Number.isFinite(start) || !Number.isFinite(step))
      return { object: null, problem: panelTexts.scene.noScan };
    const count = Math.min(ranges.length, kMostBeams);
    const positions = new Float32Array(count * 3);
    let found = 0;
    for (let i = 0; i < count; i += 1) {
      const range = Number(ranges[i]);
      // Nothing was hit, or the sensor says that it cannot see there.
      if (!(range >= 0 && range < kFarthest) || range < nearest || range > farthest) continue;
      const angle = start + i * step;
      positions.set([range * Math.cos(angle), range * Math.sin(angle), 0], found * 3);
      found += 1;
    }
    return { object: points(positions.subarray(0, found * 3), color), problem: '' };
  };
}

export function pointCloud(message: unknown): Built {
  const cloud = readCloud(message);
  if (cloud === 'no-data') return { object: null, problem: panelTexts.scene.noCloud };
  if (cloud === 'no-places') return { object: null, problem: panelTexts.scene.noPlaces };
  const problem = cloud.leftOut > 0 ? panelTexts.scene.leftOut(cloud.leftOut) : '';
  return { object: points(cloud.positions, cloud.colors), problem };
}

/** Of one colour, or of one each: red, green, blue from 0 to 1, as on a screen. */
export function points(positions: Float32Array, colors: string | Float32Array, size = kPointSize): Points<BufferGeometry, PointsMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const material = new PointsMaterial({ size: size * Math.min(2, devicePixelRatioOf()), sizeAttenuation: false });
  if (typeof colors === 'string') {
    material.color.set(colors);
  } else {
    geometry.setAttribute('color', new BufferAttribute(linear(colors), 3));
    material.vertexColors = true;
  }
  const object = new Points(geometry, material);
  // Its bounds would be looked for in every point of every message.
  object.frustumCulled = false;
  return object;
}

/** three reckons with light, not with a screen's numbers. */
export function linear(colors: Float32Array): Float32Array {
  const color = new Color();
  const out = new Float32Array(colors.length);
  for (let i = 0; i + 2 < colors.length; i += 3) {
    color.setRGB(colors[i] ?? 0, colors[i + 1] ?? 0, colors[i + 2] ?? 0, SRGBColorSpace).toArray(out, i);
  }
  return out;
}

function devicePixelRatioOf(): number {
  return typeof devicePixelRatio === 'number' ? devicePixelRatio : 1;
}

function isNumbers(value: unknown): value is ArrayLike<number> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}
