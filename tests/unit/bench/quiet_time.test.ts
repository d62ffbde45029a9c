// When a page is quiet, and how long it kept its visitor waiting.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { interactive } from '../../bench/quiet_time.ts';

const load = (...tasks: readonly (readonly [start: number, end: number])[]) =>
  ({ firstPaint: 100, largestPaint: 200, tasks: tasks.map(([start, end]) => ({ start, end })) });

test('a page is interactive after the last long task before 500 ms without one', () => {
  assert.deepEqual(interactive(load()), { at: 100, blocked: 0 });
  assert.deepEqual(interactive(load([10, 90])), { at: 100, blocked: 0 });
  assert.deepEqual(interactive(load([200, 300], [400, 460])), { at: 460, blocked: 60 });
  // Behind the quiet it no longer counts; just before its end it does. Tasks come in any order.
  assert.deepEqual(interactive(load([800, 900], [200, 300])), { at: 300, blocked: 50 });
  assert.deepEqual(interactive(load([799, 900], [200, 300])), { at: 900, blocked: 101 });
  // Of a task in which the first paint falls, what follows it.
  assert.deepEqual(interactive(load([50, 250])), { at: 250, blocked: 100 });
});
