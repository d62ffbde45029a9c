// Raw images as pixels: every encoding, rows with padding, and sizes that lie.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pixelWords } from '../../../runtime/site/ui/model/image_encodings.ts';
import type { RawImage } from '../../../runtime/site/ui/model/image_encodings.ts';
import { pixelsOf, readRange } from '../../../runtime/site/ui/model/image_pixels.ts';
import type { WantedRange } from '../../../runtime/site/ui/model/image_pixels.ts';

function image(encoding: string, width: number, height: number, data: readonly number[] | Uint8Array, step?: number): RawImage {
  const bytes = Uint8Array.from(data);
  return { encoding, width, height, step: step ?? bytes.length / height, isBigEndian: false, data: bytes };
}

function rgba(raw: RawImage, range?: WantedRange): readonly number[] {
  const pixels = pixelsOf(raw, range);
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
  for (
    const [encoding, data] of [
      ['bayer_rggb8', [200, 90, 110, 50]],
      ['bayer_bggr8', [50, 90, 110, 200]],
      ['bayer_gbrg8', [90, 50, 200, 110]],
      ['bayer_grbg8', [90, 200, 50, 110]],
    ] as const
  )
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
  assert.equal(pixelWords(words, 2, 0), '');
});

test('16 bits of each colour, in both byte orders, and what they are called', () => {
  // 65535 is 255, 257 is 1, 25700 is 100.
  const little = [0xff, 0xff, 0x01, 0x01, 0x64, 0x64];
  assert.deepEqual(rgba(image('rgb16', 1, 1, little)), [255, 1, 100, 255]);
  assert.deepEqual(rgba(image('bgr16', 1, 1, little)), [100, 1, 255, 255]);
  assert.deepEqual(rgba(image('rgba16', 1, 1, [...little, 0x80, 0x80])), [255, 1, 100, 128]);
  assert.deepEqual(rgba(image('bgra16', 1, 1, [...little, 0x80, 0x80])), [100, 1, 255, 128]);
  const big = { ...image('rgb16', 1, 1, [0x12, 0x34, 0, 1, 0, 2]), isBigEndian: true };
  assert.equal(pixelWords(big, 0, 0), 'R 4660 G 1 B 2');
  assert.deepEqual(rgba(big), [18, 0, 0, 255]);
  assert.equal(pixelWords(image('bgra16', 1, 1, [1, 0, 2, 0, 3, 0, 4, 0]), 0, 0), 'B 1 G 2 R 3 A 4');
});

test('two pixels that share their colours, by BT.601', () => {
  // Red as Y 81, U 90, V 240: 1.164 (81 - 16) + 1.596 (240 - 128) = 254; green and blue come below 0.
  // Y 235 with the same colours: 254.9 + 178.8 is white's 255; 254.9 - 91.1 + 14.9 = 179; 254.9 - 76.7 = 178.
  const red = [254, 0, 0, 255, 255, 179, 178, 255];
  assert.deepEqual(rgba(image('yuv422', 2, 1, [90, 81, 240, 235])), red);
  assert.deepEqual(rgba(image('uyvy', 2, 1, [90, 81, 240, 235])), red);
  assert.deepEqual(rgba(image('yuv422_yuy2', 2, 1, [81, 90, 235, 240])), red);
  assert.deepEqual(rgba(image('yuyv', 2, 1, [81, 90, 235, 240])), red);
  assert.equal(pixelWords(image('yuv422', 2, 1, [90, 81, 240, 235]), 1, 0), 'Y 235 U 90 V 240');
  assert.equal(pixelWords(image('yuv422_yuy2', 2, 2, [1, 2, 3, 4, 81, 90, 235, 240]), 0, 1), 'Y 81 U 90 V 240');
  // Grey has no colour: 16 is black, 235 is white.
  assert.deepEqual(rgba(image('yuyv', 2, 1, [16, 128, 235, 128])), [0, 0, 0, 255, 255, 255, 255, 255]);
});

test('an image takes the place of the last one of its size', () => {
  const first = pixelsOf(image('rgba8', 2, 1, [1, 2, 3, 4, 250, 251, 252, 253]));
  assert.ok(typeof first !== 'string');
  const next = pixelsOf(image('32FC1', 2, 1, [...new Uint8Array(Float32Array.of(Number.NaN, 2).buffer)]), undefined, first.rgba);
  assert.ok(typeof next !== 'string');
  assert.equal(next.rgba, first.rgba);
  assert.deepEqual([...next.rgba], [0, 0, 0, 0, 128, 128, 128, 255]);
  const larger = pixelsOf(image('bgra8', 1, 2, [1, 2, 3, 4, 5, 6, 7, 8]), undefined, next.rgba.slice(0, 4));
  assert.deepEqual(typeof larger === 'string' ? larger : [...larger.rgba], [3, 2, 1, 4, 7, 6, 5, 8]);
});

test('signed numbers, and a range that is given', () => {
  // -2, 0, 2 and 6 as 16 bits.
  const signed = image('16SC1', 4, 1, [0xfe, 0xff, 0, 0, 2, 0, 6, 0]);
  assert.equal(pixelWords(signed, 0, 0), '-2');
  const grey = (raw: RawImage, range?: WantedRange): readonly number[] => rgba(raw, range).filter((_, i) => i % 4 === 0);
  assert.deepEqual(grey(signed), [0, 64, 128, 255]);
  assert.deepEqual(grey(signed, { least: 0, most: 4 }), [0, 0, 128, 255]);
  assert.deepEqual(grey(signed, { least: undefined, most: 2 }), [0, 128, 255, 255]);
  assert.deepEqual(grey(signed, { least: 4, most: 4 }), [128, 128, 128, 128]);
  const pixels = pixelsOf(image('mono16', 2, 1, [1, 0, 3, 0]), { least: 0, most: undefined });
  assert.deepEqual(typeof pixels === 'string' ? pixels : pixels.range, { least: 0, most: 3 });
  const colours = pixelsOf(image('rgb8', 1, 1, [1, 2, 3]));
  assert.equal(typeof colours === 'string' ? colours : colours.range, null);
  assert.deepEqual(readRange({ least: -1.5, most: 'x' }), { least: -1.5, most: undefined });
  assert.deepEqual(readRange({ least: 1e300, most: null }), { least: undefined, most: undefined });
});

test('a pixel in the words of its encoding', () => {
  assert.equal(pixelWords(image('rgb8', 1, 1, [1, 2, 3]), 0, 0), 'R 1 G 2 B 3');
  assert.equal(pixelWords(image('bgr8', 1, 1, [1, 2, 3]), 0, 0), 'B 1 G 2 R 3');
  assert.equal(pixelWords(image('8UC3', 1, 1, [1, 2, 3]), 0, 0), '1 2 3');
  assert.equal(pixelWords(image('mono8', 1, 2, [7, 0, 9, 0], 2), 0, 1), '9');
  const bayer = image('bayer_gbrg8', 2, 2, [90, 50, 200, 110]);
  assert.deepEqual([[0, 0], [1, 0], [0, 1], [1, 1]].map(([x = 0, y = 0]) => pixelWords(bayer, x, y)), ['G 90', 'B 50', 'R 200', 'G 110']);
  assert.equal(pixelWords(bayer, 0, -1), '');
});

test('sizes that lie are told', () => {
  for (
    const raw of [
      image('rgb8', 0, 1, []),
      image('rgb8', 2, 2, [1, 2, 3], 6),
      image('rgb8', 2, 1, [1, 2, 3], 3),
      image('rgb8', 4_000_000_000, 4_000_000_000, [1]),
      image('rgb8', Number.NaN, 1, [1]),
      image('32FC1', 2, 1, [0, 0, 0, 0], 4),
      image('yuv_who_knows', 1, 1, [1]),
      image('yuv422', 3, 1, [1, 2, 3, 4, 5, 6]),
      image('rgb16', 2, 1, [1, 2, 3, 4, 5, 6], 6),
      image('constructor', 1, 1, [1]),
    ]
  )
    assert.equal(typeof pixelsOf(raw), 'string');
});
