// The share of a machine's time that other processes took.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { test } from 'node:test';
import { OthersLoad, othersShare, ticksNow, type Ticks } from '../../bench/machine_load.ts';

const ticks = (all: number, stolen: number, others: [number, number][], orphans: number[] = []): Ticks => ({
  all,
  stolen,
  others: new Map(others),
  orphans: new Set(orphans),
  ours: new Set([9]),
});

test('others have what their processes used, and what was taken from the machine', () => {
  const before = ticks(1000, 10, [[1, 50], [5, 100]]);
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 50], [5, 100]])), 0);
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 60], [5, 140]])), 0.25);
  assert.equal(othersShare(before, ticks(1200, 30, [[1, 60], [5, 120]])), 0.25);
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 50], [5, 100], [7, 20]])), 0.1, 'a process that began meanwhile');
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 50], [5, 140]], [5])), 0.2, 'one that nobody has, as before');
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 50], [5, 100], [8, 80]], [8])), 0, 'one that began meanwhile and that nobody has');
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 50], [5, 100], [9, 80]])), 0, 'one of ours that has lost its parent');
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 50]])), 0, 'one that has ended');
  assert.equal(othersShare(before, ticks(1200, 10, [[1, 5000]])), 1, 'one that has waited for what ran before');
});

/** Computes for a fifth of a second, whatever the machine does. */
const compute = 'const end = process.cpuUsage().user + 200_000; while (process.cpuUsage().user < end) Math.sqrt(end);';

test('what this process and its children compute is not of others', async () => {
  const others = new OthersLoad();
  const before = ticksNow();
  const child = spawn(process.execPath, ['-e', `${compute}; setTimeout(() => undefined, 60_000)`], { stdio: 'ignore' });
  try {
    const end = process.cpuUsage().user + 200_000;
    while (process.cpuUsage().user < end) Math.sqrt(end);
    const after = ticksNow();
    assert.ok(!after.others.has(process.pid) && !after.others.has(child.pid ?? 0));
    // How much passes meanwhile depends on the threads of this process, whose time counts too.
    assert.ok(after.all > before.all);
    assert.ok(others.share() >= 0 && others.share() <= 1);
  } finally {
    child.kill();
    await once(child, 'exit');
  }
});
