// What of a machine's time others took.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OthersLoad, othersShare, ticksNow } from '../../bench/machine_load.ts';

test('others have what was used and is not ours', () => {
  const before = { all: 1000, used: 500, own: 100 };
  assert.equal(othersShare(before, { all: 1200, used: 650, own: 200 }), 0.25);
  assert.equal(othersShare(before, { all: 1200, used: 600, own: 200 }), 0);
  // Ticks of one process are counted apart from those of the machine, and may be ahead.
  assert.equal(othersShare(before, { all: 1200, used: 590, own: 200 }), 0);
});

test('what this process computes is its own', () => {
  const others = new OthersLoad();
  const before = ticksNow();
  // A fifth of a second of this process, whatever the machine does.
  const end = process.cpuUsage().user + 200_000;
  while (process.cpuUsage().user < end) Math.sqrt(end);
  const after = ticksNow();
  const ticks = after.own - before.own;
  assert.ok(ticks >= 15 && ticks <= after.used - before.used + 2, `${ticks} of ${after.used - before.used}`);
  assert.ok(others.share() >= 0 && others.share() <= 1);
});
