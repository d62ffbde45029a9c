// Files of pictures for cv2: what is written is read again, in all forms, and what is broken or a bomb is not a picture.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { crc32, deflateSync } from 'node:zlib';
import { encode as encodePng } from 'fast-png';
import { decodePicture, encodePicture } from '../../../runtime/site/python/picture_files.ts';

/** A PNG file of one row. `data`: the filter of the row and its bytes. */
function png(width: number, depth: number, color: number, data: Uint8Array, palette?: Uint8Array): Uint8Array<ArrayBuffer> {
  const chunk = (name: string, content: Uint8Array): Buffer => {
    const body = Buffer.concat([Buffer.from(name), content]);
    const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(content.length);
    check.writeUInt32BE(crc32(body));
    return Buffer.concat([length, body, check]);
  };
  const head = Buffer.from([0, 0, 0, width, 0, 0, 0, 1, depth, color, 0, 0, 0]);
  return new Uint8Array(Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]),
    chunk('IHDR', head),
    ...(palette === undefined ? [] : [chunk('PLTE', palette)]),
    chunk('IDAT', deflateSync(data)),
    chunk('IEND', new Uint8Array()),
  ]));
}

const bytes = (length: number): Uint8Array<ArrayBuffer> => Uint8Array.from({ length }, (_, i) => (i * 37) & 255);

test('PNG keeps every pixel, with blue first, in 8 and 16 bits', () => {
  for (const [channels, depth] of [[1, 0], [3, 0], [4, 0], [1, 2], [3, 2]] as const) {
    const picture = { rows: 5, cols: 7, channels, depth, bytes: bytes(5 * 7 * channels * (depth === 0 ? 1 : 2)) };
    const file = encodePicture('.png', { ...picture, bytes: picture.bytes.slice() }, 0);
    assert.deepEqual(decodePicture(new Uint8Array(file)), picture, `${channels} channels, depth ${depth}`);
  }
  const red = encodePng({ width: 1, height: 1, data: Uint8Array.of(200, 100, 50), channels: 3, depth: 8 });
  assert.deepEqual([...decodePicture(new Uint8Array(red))!.bytes], [50, 100, 200]);
});

test('a palette, few bits and opacity with gray become what OpenCV has for them', () => {
  const palette = Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9);
  // Three pixels with the indices 0, 2 and 1: of 8 bits, and of 2.
  for (const [depth, row] of [[8, [0, 2, 1]], [2, [0b00_10_01_00]]] as const) {
    const picture = decodePicture(png(3, depth, 3, Uint8Array.of(0, ...row), palette));
    assert.deepEqual(picture, { rows: 1, cols: 3, channels: 3, depth: 0, bytes: Uint8Array.of(3, 2, 1, 9, 8, 7, 6, 5, 4) });
  }
  const bits = decodePicture(png(9, 1, 0, Uint8Array.of(0, 0b1010_1010, 0b1000_0000)));
  assert.deepEqual([...bits!.bytes], [255, 0, 255, 0, 255, 0, 255, 0, 255]);
  const faint = encodePng({ width: 2, height: 1, data: Uint8Array.of(10, 255, 20, 128), channels: 2, depth: 8 });
  assert.deepEqual(decodePicture(new Uint8Array(faint)), { rows: 1, cols: 2, channels: 4, depth: 0, bytes: Uint8Array.of(10, 10, 10, 255, 20, 20, 20, 128) });
});

test('JPEG is near what was written', () => {
  const picture = { rows: 16, cols: 16, channels: 3, depth: 0, bytes: new Uint8Array(16 * 16 * 3).fill(120) };
  const read = decodePicture(new Uint8Array(encodePicture('.jpg', picture, 95)));
  assert.deepEqual([read?.rows, read?.cols, read?.channels], [16, 16, 3]);
  assert.ok(read!.bytes.every((value) => Math.abs(value - 120) < 3));
});

// Guarantee, hostile input: files of pictures that are cut, lie about their size or are far too large are not pictures
test('cut files, other files and bombs are not pictures', () => {
  const whole = new Uint8Array(encodePicture('.png', { rows: 4, cols: 4, channels: 3, depth: 0, bytes: bytes(48) }, 0));
  for (let length = 0; length < whole.length; length += 7) assert.equal(decodePicture(whole.slice(0, length)), undefined, String(length));
  const bomb = whole.slice();
  new DataView(bomb.buffer).setUint32(16, 0x7fffffff);
  assert.equal(decodePicture(bomb), undefined);
  assert.equal(decodePicture(Uint8Array.of(0xff, 0xd8, 0xff, 0xc0, 0, 17, 8, 0xff, 0xff, 0xff, 0xff, 3)), undefined);
  assert.equal(decodePicture(bytes(100)), undefined);
});
