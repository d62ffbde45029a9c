// When a page is quiet, and how long it kept its visitor waiting.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { interactive } from '../../bench/quiet_time.ts';

const load = (...tasks: readonly (readonly [start: number, end: number])[]) => ({
  firstPaint: 100,
  largestPaint: 200,
  tasks: tasks.map(([start, end]) => ({ start, end })),
});

test('a page is interactive after the last long task before 500 ms without one', () => {
  assert.deepEqual(interactive(load()), { at: 100, blocked: 0 });
  assert.deepEqual(interactive(load([10, 90])), { at: 100, blocked: 0 });
  assert.deepEqual(interactive(load([200, 300], [400, 460])), { at: 460, blocked: 60 });
  // A task after the quiet time no longer counts; one just before its end does. Tasks come in any order.
  assert.deepEqual(interactive(load([800, 900], [200, 300])), { at: 300, blocked: 50 });
  assert.deepEqual(interactive(load([799, 900], [200, 300])), { at: 900, blocked: 101 });
  // If the first paint is within a task, only the part of the task after the paint counts.
  assert.deepEqual(interactive(load([50, 250])), { at: 250, blocked: 100 });
});
