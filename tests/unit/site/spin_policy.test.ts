// Plays exchanges of two threads against a model of the machine: on cores of their own a spinning partner answers at
// once; on one core it keeps the other from running until it sleeps. No clock and no thread takes part.

import { strict as assert } from 'node:assert';
import { test } from 'node:test';
import { longestRest, SpinPolicy, spinMs } from '../../../runtime/site/bus/spin_policy.ts';

/** Chromium's wake-up of a sleeper on an idle core, the switch to another thread on the same core, and the work of a message, ms. */
const wakeMs = 0.055;
const switchMs = 0.008;
const workMs = 0.004;

interface Side {
  readonly policy: SpinPolicy;
  /** It has gone to sleep before the message comes. */
  asleep: boolean;
}

const side = (): Side => ({ policy: new SpinPolicy(), asleep: true });

/** Time from a side's `publish` until the answer is in its hands, ms; `together`: both on one core. */
function roundTrip(near: Side, far: Side, together: boolean): number {
  // The far side has waited since its last answer; whether it sleeps was decided then.
  const nearSpins = near.policy.spinsNow();
  let time = 0;
  if (together) {
    // Nobody else runs before the near side sleeps.
    if (nearSpins) time += spinMs;
    time += switchMs + workMs;
    const farSpins = far.policy.spinsNow();
    if (farSpins) time += spinMs;
    time += switchMs + workMs;
    if (nearSpins) near.policy.spun(false);
    if (farSpins) far.policy.spun(false);
    far.asleep = true;
  } else {
    time += (far.asleep ? wakeMs : 0) + workMs;
    const found = nearSpins && time < spinMs;
    if (nearSpins) near.policy.spun(found);
    time += (found ? 0 : wakeMs) + workMs;
    const farSpins = far.policy.spinsNow();
    if (farSpins) far.policy.spun(true);
    far.asleep = !farSpins;
  }
  near.policy.waited(true, time);
  far.policy.waited(true, time);
  return time;
}

function play(near: Side, far: Side, together: boolean, exchanges: number): { median: number; mean: number; } {
  const times = Array.from({ length: exchanges }, () => roundTrip(near, far, together));
  const mean = times.reduce((sum, each) => sum + each, 0) / exchanges;
  return { median: times.sort((a, b) => a - b)[exchanges >> 1] ?? Number.NaN, mean };
}

test('partners on cores of their own spin, and answer without a wake-up', () => {
  const { median, mean } = play(side(), side(), false, 4000);
  assert.ok(median <= 2 * workMs, `median ${median}`);
  assert.ok(mean <= 2.2 * workMs, `mean ${mean}`);
});

test('partners on one core soon stop spinning, in which each would only keep the other waiting', () => {
  const { median, mean } = play(side(), side(), true, 4000);
  const best = 2 * (switchMs + workMs);
  assert.ok(median <= best, `median ${median}`);
  assert.ok(mean <= best * 1.15, `mean ${mean}`);
});

test('a pair that the scheduler moves apart spins again', () => {
  const near = side();
  const far = side();
  play(near, far, true, 4000);
  play(near, far, false, 2 * longestRest);
  const { median } = play(near, far, false, 1000);
  assert.ok(median <= 2 * workMs, `median ${median}`);
});

test('a timer of 1 ms never spins', () => {
  const policy = new SpinPolicy();
  let spins = 0;
  for (let i = 0; i < 1000; i += 1) {
    if (policy.spinsNow()) spins += 1;
    policy.waited(false, 1);
  }
  assert.equal(spins, 0);
});

test('one whose answers take longer than a spin tries it in one wait of 257', () => {
  const policy = new SpinPolicy();
  let spins = 0;
  for (let i = 0; i < 100 * (longestRest + 1); i += 1) {
    if (policy.spinsNow()) {
      spins += 1;
      policy.spun(false);
    }
    policy.waited(true, 0.3);
  }
  assert.ok(spins <= 100 + 10, `${spins} spins`);
});
