// The part of a plot that is seen, and the sample to which the keys move.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { momentBeside, momentNear, movedExtent, pairsWith, zoomedExtent } from '../../../runtime/site/ui/model/plot_view.ts';
import { Samples } from '../../../runtime/site/ui/model/samples.ts';

function series(...times: readonly number[]) {
  const samples = new Samples(16);
  for (const time of times) samples.add(time, 0);
  return { name: '', samples };
}

test('a part is zoomed about a point that stays, and moved', () => {
  assert.deepEqual(zoomedExtent({ least: 0, most: 8 }, 2), { least: 2, most: 6 });
  assert.deepEqual(zoomedExtent({ least: 0, most: 8 }, 2, 0), { least: 0, most: 4 });
  assert.deepEqual(zoomedExtent({ least: 2, most: 6 }, 0.5, 6), { least: -2, most: 6 });
  assert.deepEqual(movedExtent({ least: 0, most: 10 }, -0.2), { least: -2, most: 8 });
  // Finer than numbers are it does not get.
  let part = { least: 1.7e9, most: 1.7e9 + 60 };
  for (let i = 0; i < 200; i += 1) part = zoomedExtent(part, 1.5);
  assert.ok(part.most > part.least && part.most - part.least < 0.01, String(part.most - part.least));
});

test('keys go through the samples of all series, each moment once', () => {
  const all = [series(1, 2, 2, 5), series(2, 3)];
  const seen: number[] = [];
  for (let at: number | null = 1; at !== null; at = momentBeside(all, at, 1)) seen.push(at);
  assert.deepEqual(seen, [1, 2, 3, 5]);
  const back: number[] = [];
  for (let at: number | null = 5; at !== null; at = momentBeside(all, at, -1)) back.push(at);
  assert.deepEqual(back, [5, 3, 2, 1]);
  assert.equal(momentNear(all, 3.9), 3);
  assert.equal(momentNear(all, 99), 5);
  assert.equal(momentNear([series()], 1), null);
  assert.equal(momentBeside([], 1, 1), null);
});

test('points of one series against another, also of several messages at one moment', () => {
  const [x, y] = [new Samples(16), new Samples(16)];
  for (const [time, value] of [[1, 10], [2, 20], [2, 21], [2, 22], [3, 30]] as const) x.add(time, value);
  for (const [time, value] of [[1, -10], [2, -20], [2, -21], [2, -22], [2.5, -25], [3, -30], [9, -90]] as const) y.add(time, value);
  assert.deepEqual(pairsWith(x, y, { least: 1, most: 5 }), [[10, -10], [20, -20], [21, -21], [22, -22], [22, -25], [30, -30]]);
});
