// Points as three draws them: squares of some pixels, with a colour each or one for all.

import { BufferAttribute, BufferGeometry, Points, PointsMaterial, Color, SRGBColorSpace } from 'three';

export const POINT_SIZE = 3; // pixels

/** Points of one colour, or with a colour each: red, green, blue from 0 to 1, as on a screen. */
export function points(positions: Float32Array, colors: string | Float32Array, size = POINT_SIZE): Points<BufferGeometry, PointsMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const material = new PointsMaterial({ size, sizeAttenuation: false });
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
export function linear(colors: Float32Array, out: Float32Array = new Float32Array(colors.length)): Float32Array {
  for (let i = 0; i < colors.length; i += 1) out[i] = LIGHT[Math.round((colors[i] ?? 0) * 255)] ?? 0;
  return out;
}

const LIGHT = Float32Array.from({ length: 256 }, (_, i) => new Color().setRGB(i / 255, 0, 0, SRGBColorSpace).r);
