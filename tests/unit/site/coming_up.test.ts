// A command of `ros2` looks at the graph when the nodes of a site have made what they make.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ComingUp, longEnough } from '../../../runtime/site/session/coming_up.ts';
import type { SiteNode } from '../../../runtime/site/contract/session.ts';

const never = new AbortController().signal;
const node = { id: 'talker-1' } as SiteNode;

/** Time passes, and what waits for it goes on. */
async function pass(timers: { tick(ms: number): void; }, ms: number): Promise<void> {
  for (let passed = 0; passed < ms; passed += 1000) {
    timers.tick(1000);
    await Promise.resolve();
  }
}

test('an interpreter that loads is waited for, however long that takes', async (t) => {
  t.mock.timers.enable({ apis: ['setInterval'] });
  let loading = true;
  let over = false;
  const waited = longEnough(() => loading, never).then(() => {
    over = true;
  });
  await pass(t.mock.timers, 300_000);
  assert.equal(over, false);
  loading = false;
  await pass(t.mock.timers, 19_000);
  assert.equal(over, false);
  await pass(t.mock.timers, 2000);
  await waited;
});

test('Ctrl-C ends the wait', async () => {
  const abort = new AbortController();
  const waited = longEnough(() => true, abort.signal);
  abort.abort();
  await waited;
  await longEnough(() => true, abort.signal);
});

test('a program that computes for ever is not waited for, one that loads is', async (t) => {
  t.mock.timers.enable({ apis: ['setInterval'] });
  let loading = true;
  const comingUp = new ComingUp(() => loading);
  await comingUp.none(never);
  comingUp.begins(node);
  let over = false;
  const waited = comingUp.none(never).then(() => {
    over = true;
  });
  await pass(t.mock.timers, 60_000);
  assert.equal(over, false);
  comingUp.settled(node);
  await waited;
  comingUp.begins(node);
  loading = false;
  const later = comingUp.none(never);
  await pass(t.mock.timers, 21_000);
  await later;
});
