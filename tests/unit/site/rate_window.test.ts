// Rates of topics: steady for slow ones whenever one looks, quick for fast ones, gone when nothing comes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RateWindow } from '../../../runtime/site/contract/rate_window.ts';

const lookMs = 250;

/** Looks at a topic that publishes every `periodMs` from 0 until `untilMs`; returns the rates seen, by time. */
function watch(periodMs: number, untilMs: number, endMs = untilMs): { readonly now: number; readonly hz: number; }[] {
  const window = new RateWindow();
  const seen = [];
  for (let now = 0; now <= endMs; now += lookMs) {
    const count = Math.floor(Math.min(now, untilMs) / periodMs) + 1;
    window.add(count, 100 * count, (count - 1) * periodMs);
    seen.push({ now, hz: window.rate(now).hz });
  }
  return seen;
}

for (const [hz, from] of [[0.5, 2000], [0.3, 3500], [1, 1000], [2, 500], [10, 500], [1000, 500]] as const) {
  test(`${hz} Hz reads ${hz} Hz at every look`, () => {
    for (const { now, hz: shown } of watch(1000 / hz, 40_000)) {
      if (now >= from) assert.ok(Math.abs(shown - hz) < 0.02 * hz, `${shown} Hz at ${now} ms`);
    }
  });
}

test('a topic that stops goes down and then to nothing', () => {
  const after = watch(500, 10_000, 20_000).filter(({ now }) => now > 10_000);
  for (const [i, { hz }] of after.entries()) assert.ok(hz <= (after[i - 1]?.hz ?? 2) + 1e-9);
  assert.ok(after.some(({ hz }) => hz > 0 && hz < 1));
  assert.equal(after.at(-1)?.hz, 0);
  assert.equal(after.find(({ now }) => now >= 13_250)?.hz, 0);
});

test('a change of rate shows within the window', () => {
  const window = new RateWindow();
  let count = 0;
  const publish = (time: number): void => window.add(count += 1, 0, time);
  for (let time = 0; time <= 10_000; time += 1000) publish(time);
  for (let time = 10_050; time <= 12_100; time += 50) publish(time);
  assert.ok(Math.abs(window.rate(12_100).hz - 20) < 0.5);
});

test('bytes follow messages; a publisher that left, or none, counts from nothing', () => {
  const window = new RateWindow();
  assert.deepEqual(window.rate(0), { hz: 0, bytesPerSecond: 0 });
  for (let i = 1; i <= 5; i += 1) window.add(i, 100 * i, 1000 * i);
  assert.deepEqual(window.rate(5000), { hz: 1, bytesPerSecond: 100 });
  window.add(1, 100, 6000);
  assert.deepEqual(window.rate(6000), { hz: 0, bytesPerSecond: 0 });
});
