// A scene is drawn coarser while its pictures take too long, and finer again.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Resolution } from '../../../runtime/site/ui/scene/resolution.ts';

test('the resolution drops with dear pictures, has an end, and comes back with cheap ones', () => {
  const resolution = new Resolution();
  assert.deepEqual([resolution.tell(60), resolution.tell(60), resolution.share], [false, false, 1]);
  // One that was quick: the others were by chance.
  resolution.tell(16);
  assert.deepEqual([resolution.tell(60), resolution.tell(60), resolution.tell(60)], [false, false, true]);
  assert.equal(resolution.share, 0.8);
  assert.equal(resolution.isPoor, false);
  for (let i = 0; i < 100; i += 1) resolution.tell(60);
  assert.equal(resolution.share, 0.4);
  // Then something else must be left away, until pictures are cheap again.
  assert.equal(resolution.isPoor, true);
  resolution.tell(16);
  assert.equal(resolution.isPoor, false);
  for (let i = 0; i < 38; i += 1) assert.equal(resolution.tell(16.7), false);
  assert.equal(resolution.tell(16.7), true);
  assert.ok(resolution.share > 0.4 && resolution.share < 0.5);
  for (let i = 0; i < 1000; i += 1) resolution.tell(16.7);
  assert.equal(resolution.share, 1);
});

test('a finer picture that is too dear is tried again later and later', () => {
  const resolution = new Resolution();
  const dear = (): void => {
    for (let i = 0; i < 3; i += 1) resolution.tell(60);
  };
  /** Cheap pictures until it is finer. */
  const tries = (): number => {
    let count = 1;
    while (!resolution.tell(16.7)) count += 1;
    return count;
  };
  dear();
  assert.equal(tries(), 40);
  dear();
  assert.equal(tries(), 80);
  dear();
  assert.equal(tries(), 160);
  // It stays: nothing is in vain any more.
  dear();
  dear();
  assert.equal(tries(), 40);
});
