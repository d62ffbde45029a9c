// Raw images as pixels: every encoding, rows with padding, and sizes that lie.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pixelWords, pixelsOf } from '../../../runtime/ui/model/image_pixels.ts';
import type { RawImage } from '../../../runtime/ui/model/image_pixels.ts';

function image(encoding: string, width: number, height: number, data: readonly number[] | Uint8Array, step?: number): RawImage {
  const bytes = Uint8Array.from(data);
  return { encoding, width, height, step: step ?? bytes.length / height, isBigEndian: false, data: bytes };
}

function rgba(raw: RawImage): readonly number[] {
  const pixels = pixelsOf(raw);
  return typeof pixels === 'string' ? assert.fail(pixels) : [...pixels.rgba];
}

test('colours in their order', () => {
  assert.deepEqual(rgba(image('rgb8', 1, 1, [1, 2, 3])), [1, 2, 3, 255]);
  assert.deepEqual(rgba(image('bgr8', 1, 1, [1, 2, 3])), [3, 2, 1, 255]);
  assert.deepEqual(rgba(image('rgba8', 1, 1, [1, 2, 3, 4])), [1, 2, 3, 4]);
  assert.deepEqual(rgba(image('bgra8', 1, 1, [1, 2, 3, 4])), [3, 2, 1, 4]);
  assert.deepEqual(rgba(image('mono8', 2, 1, [7, 9])), [7, 7, 7, 255, 9, 9, 9, 255]);
  // Two rows of one pixel, each with a byte that is none.
  assert.deepEqual(rgba(image('mono8', 1, 2, [7, 0, 9, 0], 2)), [7, 7, 7, 255, 9, 9, 9, 255]);
});

test('a square of four gives its colour', () => {
  for (const [encoding, data] of [
    ['bayer_rggb8', [200, 90, 110, 50]],
    ['bayer_bggr8', [50, 90, 110, 200]],
    ['bayer_gbrg8', [90, 50, 200, 110]],
    ['bayer_grbg8', [90, 200, 50, 110]],
  ] as const)
    assert.deepEqual(rgba(image(encoding, 2, 2, data)).slice(0, 4), [200, 100, 50, 255], encoding);
});

test('depth is spread between the nearest and the farthest', () => {
  const floats = new Uint8Array(Float32Array.of(1, 3, Number.NaN, 2).buffer);
  assert.deepEqual(rgba(image('32FC1', 4, 1, floats)), [0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 0, 128, 128, 128, 255]);
  const words = image('16UC1', 2, 1, [0, 1, 0, 3]);
  assert.deepEqual(rgba(words), [0, 0, 0, 255, 255, 255, 255, 255]);
  assert.equal(pixelWords(words, 1, 0), '768');
  assert.equal(pixelWords({ ...words, isBigEndian: true }, 1, 0), '3');
  assert.equal(pixelWords(image('32FC1', 4, 1, floats), 1, 0), '3');
  assert.equal(pixelWords(image('rgb8', 1, 1, [1, 2, 3]), 0, 0), '1 2 3');
  assert.equal(pixelWords(words, 2, 0), '');
});

test('sizes that lie are told', () => {
  for (const raw of [
    image('rgb8', 0, 1, []),
    image('rgb8', 2, 2, [1, 2, 3], 6),
    image('rgb8', 2, 1, [1, 2, 3], 3),
    image('rgb8', 4_000_000_000, 4_000_000_000, [1]),
    image('rgb8', Number.NaN, 1, [1]),
    image('32FC1', 2, 1, [0, 0, 0, 0], 4),
    image('yuv_who_knows', 1, 1, [1]),
    image('constructor', 1, 1, [1]),
  ])
    assert.equal(typeof pixelsOf(raw), 'string');
});
