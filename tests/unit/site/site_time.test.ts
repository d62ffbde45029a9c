// The page's hand on time, and what a law of time says.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { SiteClock } from '../../../runtime/site/bus/clock.ts';
import type { TimeView } from '../../../runtime/site/contract/session.ts';
import { SiteTimeControl } from '../../../runtime/site/bus/site_time.ts';
import { tellThreads } from '../../../runtime/site/program/thread_waits.ts';

const ms = 1_000_000;

const makers = { shared: () => new SharedBroker({ ceiling: 64 << 20 }), port: () => new PortBroker() };

for (const [kind, make] of Object.entries(makers)) {
  test(`time is held, stepped and scaled by the ${kind} broker`, async () => {
    const broker = make();
    const time = new SiteTimeControl(broker, () => undefined);
    const { clock } = broker.link;
    const states: TimeView['state'][] = [];
    let told: () => void = () => undefined;
    time.onChange(({ state }) => {
      states.push(state);
      told();
    });
    assert.deepEqual([time.view().state, time.view().rate], ['running', 1]);
    assert.ok(Math.abs(time.view().now - Date.now()) < 10_000);
    time.pause();
    const held = clock.steadyNs();
    assert.equal(clock.realMsUntil(held), 0);
    assert.equal(clock.realMsUntil(held + 1000), Infinity);
    time.step(300_000 * ms);
    time.step(400_000 * ms);
    const left = clock.realMsUntil(held + 700_000 * ms);
    assert.ok(left > 600_000 && left <= 700_001, `${left}`);
    assert.equal(clock.realMsUntil(held + 700_001 * ms), Infinity);
    time.setRate(0.5);
    assert.ok(clock.realMsUntil(held + 700_000 * ms) > left);
    time.setRate(1000);
    while (states.at(-1) !== 'paused') {
      await new Promise<void>((resolve) => {
        told = resolve;
      });
    }
    assert.ok(Math.abs(clock.steadyNs() - held - 700_000 * ms) < 100);
    assert.deepEqual(states, ['paused', 'stepping', 'stepping', 'stepping', 'stepping', 'paused']);
    time.resume();
    assert.deepEqual([time.view().state, time.view().rate], ['running', 1000]);
    const soon = clock.realMsUntil(clock.steadyNs() + 5e9 * ms);
    assert.ok(soon > 4e6 && soon <= 5e6, `${soon}`);
    assert.throws(() => time.setRate(0), RangeError);
    assert.throws(() => time.step(-1), RangeError);
    time.close();
    broker.close();
  });
}

test('the end of a step is told whenever it comes', async () => {
  for (let length = 1; length <= 12; length += 1) {
    // A step ends at one look at the clock after another.
    let now = 0;
    const clock = new SiteClock();
    clock.steadyNs = () => (now += 1);
    const broker = { link: { clock }, setTime: () => undefined } as unknown as PortBroker;
    const time = new SiteTimeControl(broker, () => undefined);
    const over = new Promise<void>((resolve) => {
      time.onChange(({ state }) => {
        if (state === 'paused') resolve();
      });
    });
    time.step(length);
    await over;
    time.close();
  }
});

test('a clock does not go back when time was held a moment ago', () => {
  const clock = new SiteClock();
  const now = clock.steadyNs();
  clock.set({ realNs: 0, siteNs: 0, rate: 1, limitNs: now - 5 * ms });
  assert.equal(clock.steadyNs(), now);
});

test('threads that wait under an older law are told, until there are none', () => {
  const memory = new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true });
  const words = new Int32Array(memory.buffer);
  const [list, first, second] = [8, 100, 200];
  words[list >> 2] = first;
  words.set([1000, 2, second], first >> 2);
  words.set([0, -1, 0], second >> 2);
  assert.equal(tellThreads({ memory, waits: list }, 2), true);
  assert.equal(tellThreads({ memory, waits: list }, 4), false);
  words[second >> 2] = 1004;
  words[(first >> 2) + 1] = 4;
  assert.equal(tellThreads({ memory, waits: list }, 4), false, 'about to wait');
  words[(second >> 2) + 1] = 4;
  assert.equal(tellThreads({ memory, waits: list }, 4), true);
});
