// The drawing of a turtle simulator: scenes that begin in the middle of a drawing, pictures, and messages that are wrong.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readPicture, readScene, Sheet } from '../../../runtime/site/ui/model/turtle_scene.ts';
import type { Picture, Scene } from '../../../runtime/site/ui/model/turtle_scene.ts';

const TURTLE = { name: 'turtle1', x: 1, y: 2, theta: 0.5, shape: 3, pen: [1, 2, 3], pen_width: 3, pen_on: true };

/** A scene with strokes whose x1 is their number. */
function scene(picture: number, first: number, count: number): Scene {
  const strokes = Array.from({ length: count }, (_, i) => ({ x1: first + i, y1: 0, x2: 0, y2: 0, r: 9, g: 8, b: 7, width: 3 }));
  const read = readScene({
    width: 500,
    height: 400,
    meter: 45,
    background: new Uint8Array([69, 86, 255]),
    turtles: [TURTLE],
    picture,
    first,
    strokes,
  });
  return read ?? assert.fail();
}

function picture(number: number, strokes: number): Picture {
  return { picture: number, strokes, width: 1, height: 1, rgba: new Uint8ClampedArray(4) };
}

const numbers = (strokes: readonly { readonly x1: number; }[] | null): readonly number[] | null => strokes === null ? null : strokes.map(({ x1 }) => x1);

test('a scene is read as it is', () => {
  const read = scene(1, 0, 1);
  assert.equal(read.background, 'rgb(69 86 255)');
  assert.deepEqual(read.turtles, [{ name: 'turtle1', x: 1, y: 2, theta: 0.5, shape: 3 }]);
  assert.deepEqual(read.strokes, [{ x1: 0, y1: 0, x2: 0, y2: 0, width: 3, color: 'rgb(9 8 7)' }]);
});

test('who follows from the first stroke draws each of them once', () => {
  const sheet = new Sheet();
  assert.deepEqual(sheet.take(scene(1, 0, 2), 'a'), { cleared: true, strokes: scene(1, 0, 2).strokes, ask: false });
  assert.deepEqual(numbers(sheet.take(scene(1, 2, 3), 'a').strokes), [2, 3, 4]);
  // Those that were told already are not drawn again.
  const again = sheet.take(scene(1, 3, 4), 'a');
  assert.deepEqual([numbers(again.strokes), again.cleared, again.ask], [[5, 6], false, false]);
  assert.equal(sheet.takePicture(picture(1, 7)), null);
});

test('who comes late asks once for the picture, and then draws what is newer', () => {
  const sheet = new Sheet();
  const first = sheet.take(scene(1, 10, 2), 'a');
  assert.deepEqual([first.ask, numbers(first.strokes)], [true, [10, 11]]);
  assert.equal(sheet.take(scene(1, 12, 2), 'a').ask, false);
  assert.deepEqual(numbers(sheet.takePicture(picture(1, 13))), [13]);
  const next = sheet.take(scene(1, 14, 1), 'a');
  assert.deepEqual([next.ask, numbers(next.strokes)], [false, [14]]);
});

test('a picture that did not come is asked for again', () => {
  const sheet = new Sheet();
  assert.equal(sheet.take(scene(1, 5, 1), 'a').ask, true);
  assert.equal(sheet.take(scene(1, 6, 1), 'a').ask, false);
  sheet.askAgain();
  assert.equal(sheet.take(scene(1, 7, 1), 'a').ask, true);
});

test('another sheet and another simulator begin anew; a picture of the old sheet is left alone', () => {
  const sheet = new Sheet();
  assert.equal(sheet.take(scene(1, 5, 1), 'a').ask, true);
  const cleared = sheet.take(scene(2, 0, 1), 'a');
  assert.deepEqual([cleared.cleared, cleared.ask, numbers(cleared.strokes)], [true, false, [0]]);
  assert.equal(sheet.takePicture(picture(1, 6)), null);
  const restarted = sheet.take(scene(2, 0, 2), 'b');
  assert.deepEqual([restarted.cleared, numbers(restarted.strokes)], [true, [0, 1]]);
});

test('while no picture comes only the newest strokes wait for it, and what is missing then is asked for again', () => {
  const sheet = new Sheet();
  assert.equal(sheet.take(scene(1, 5, 1), 'a').ask, true);
  for (let i = 0; i < 30; i += 1) assert.equal(sheet.take(scene(1, 6 + i * 1000, 1000), 'a').ask, false);
  const fresh = numbers(sheet.takePicture(picture(1, 6))) ?? [];
  assert.deepEqual([fresh.length, fresh[0], fresh.at(-1)], [10_000, 20_006, 30_005]);
  assert.equal(sheet.take(scene(1, 30_006, 1), 'a').ask, true);
  // One that has all of them leaves nothing to ask for.
  assert.deepEqual(numbers(sheet.takePicture(picture(1, 30_007))), []);
  assert.equal(sheet.take(scene(1, 30_007, 1), 'a').ask, false);
});

test('of a scene with too many strokes the newest are drawn, and the picture is asked for', () => {
  const large = scene(1, 0, 25_000);
  assert.deepEqual([large.first, large.strokes.length], [15_000, 10_000]);
  assert.equal(new Sheet().take(large, 'a').ask, true);
});

test('a picture is its runs of pixels', () => {
  const read = readPicture({
    picture: 4,
    strokes: 2,
    width: 2,
    height: 2,
    lengths: new Uint32Array([1, 2, 1]),
    colors: new Uint32Array([0xff010203, 0, 0xff0a0b0c]),
  });
  assert.deepEqual([...(read?.rgba ?? [])], [1, 2, 3, 255, 0, 0, 0, 0, 0, 0, 0, 0, 10, 11, 12, 255]);
  assert.deepEqual([read?.picture, read?.strokes], [4, 2]);
});

test('what is wrong or too large shows nothing', () => {
  for (
    const value of [null, 7, 'x', [], {}, { width: 0, height: 5, meter: 45 }, { width: 1e9, height: 500, meter: 45 }, {
      width: 500,
      height: 500,
      meter: Number.NaN,
    }]
  )
    assert.equal(readScene(value), null, JSON.stringify(value));
  assert.equal(readPicture({ width: 2, height: 2, lengths: [5], colors: [0xff000000] }), null);
  assert.equal(readPicture({ width: 2, height: 2, lengths: [-1, 2], colors: [0, 0xff000000] }), null);
  assert.equal(readPicture({ width: 60000, height: 60000, lengths: [], colors: [] }), null);
  const odd = readScene({
    width: 500,
    height: 500,
    meter: 45,
    picture: 1,
    first: 0,
    background: 'red',
    turtles: [null, { ...TURTLE, x: Infinity }, { ...TURTLE, name: 7 }, { ...TURTLE, name: 'x'.repeat(1000) }],
    strokes: [null, { r: 1e9, g: -4, b: 'x' }],
  });
  assert.deepEqual(odd?.turtles.map(({ name }) => name.length), [80]);
  assert.deepEqual(odd?.strokes.map(({ color }) => color), ['rgb(0 0 0)', 'rgb(255 0 0)']);
});
