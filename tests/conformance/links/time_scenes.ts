// Scenes of site time: what the page holds, steps and scales is the time of every wait, sleep, stamp and deadline.

// Compatibility, works: time of the whole site held, stepped and run at another speed: clocks,
// wall and ROS timers, `sleep_for`, `usleep`, `nanosleep`, rates, deadlines, lifespans, leases;
// condition variables, futures and timed mutexes, of threads too

import { Durability, Liveliness, StatusKind, WaitResult } from '../../../runtime/protocol/generated/constants.ts';
import { SiteTimeControl } from '../../../runtime/site/bus/site_time.ts';
import { check, equal, pair, type Scene } from './scenes.ts';
import type { RemotePeer, World } from './world.ts';

const ms = 1_000_000;
const longMs = 600_000;

/**
 * Holds time, with all workers at the same one: who learns of it late has been there already, and stays until the
 * others have come as far.
 */
async function hold(world: World, time: SiteTimeControl, peers: readonly RemotePeer[]): Promise<void> {
  time.pause();
  let furthest = 0;
  for (const peer of peers) furthest = Math.max(furthest, await peer.call('heldMs'));
  const { clock } = world.broker.link;
  time.step(Math.max(ms, Math.ceil(furthest * ms - clock.steadyNs())));
  for (const peer of peers) await peer.call('untilNs', clock.law().limitNs);
}

/** A step, and `peer` has come to its end. */
async function step(world: World, time: SiteTimeControl, stepMs: number, peer: RemotePeer): Promise<void> {
  time.step(stepMs * ms);
  await peer.call('untilNs', world.broker.link.clock.law().limitNs);
}

function timeOf(world: World): SiteTimeControl {
  return new SiteTimeControl(world.broker, () => undefined);
}

/** Lets real time go by: what must not end anything is exactly this. */
function realTime(milliseconds: number): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, milliseconds);
  });
}

/** Whether a promise is settled by now. */
async function over(promise: Promise<unknown>): Promise<boolean> {
  const pending = Symbol('pending');
  return await Promise.race([promise, realTime(0).then(() => pending)]) !== pending;
}

/** `what` ends `afterMs` of site time after it began. */
async function endsAt<T>(time: SiteTimeControl, afterMs: number, result: Promise<T>, what: string): Promise<T> {
  await realTime(3 * afterMs);
  check(!await over(result), `${what} ends while time is held`);
  time.step((afterMs / 2) * ms);
  await realTime(2 * afterMs);
  check(!await over(result), `${what} ends after a step that is too short`);
  time.step(afterMs * ms);
  return await result;
}

export const timeScenes: readonly Scene[] = [
  {
    name: 'a sleep and a wait last while time is held, and end with the step that reaches their time',
    async run(world) {
      const time = timeOf(world);
      const [a, b] = [await world.peer(), await world.peer()];
      await hold(world, time, [a, b]);
      const sleeping = await a.begin('sleep', 20);
      const waiting = await b.begin('waitOut', 20);
      equal(await endsAt(time, 20, Promise.all([sleeping.result, waiting.result]), 'sleep or wait'), [WaitResult.woken, WaitResult.timeout], 'results');
      time.close();
    },
  },
  {
    name: 'who sleeps or waits when time is held ends after it goes on',
    async run(world) {
      const time = timeOf(world);
      const [a, b] = [await world.peer(), await world.peer()];
      const sleeping = await a.begin('sleep', 60);
      const waiting = await b.begin('waitOut', 60);
      time.pause();
      await realTime(120);
      check(!await over(Promise.race([sleeping.result, waiting.result])), 'over while time is held');
      time.resume();
      equal([await sleeping.result, await waiting.result], [WaitResult.woken, WaitResult.timeout], 'results');
      time.close();
    },
  },
  {
    name: 'time at another speed: sleeps, waits and clocks',
    async run(world) {
      const time = timeOf(world);
      const [a, b] = [await world.peer(), await world.peer()];
      const before = await a.call('steadyMs');
      // Begun at the usual speed: over in time only if they learn of the change.
      const sleeping = await a.begin('sleep', longMs);
      const waiting = await b.begin('waitOut', longMs);
      time.setRate(1000);
      equal([await sleeping.result, await waiting.result], [WaitResult.woken, WaitResult.timeout], 'results');
      const passed = await a.call('steadyMs') - before;
      check(passed >= longMs, `${passed} ms have passed`);
      time.close();
    },
  },
  {
    name: 'a stop ends sleeps and waits while time is held',
    async run(world) {
      const time = timeOf(world);
      const [a, b] = [await world.peer(), await world.peer()];
      time.pause();
      const sleeping = await a.begin('sleep', 5);
      const waiting = await b.begin('waitOut', 5);
      a.stop();
      b.stop();
      equal([await sleeping.result, await waiting.result], [WaitResult.stop, WaitResult.stop], 'results');
      time.close();
    },
  },
  {
    name: 'messages pass while time is held, with the stamp of that time',
    async run(world) {
      const time = timeOf(world);
      const { a, b, pub, sub } = await pair(world, '/held');
      await hold(world, time, [a, b]);
      await a.call('writeMany', pub, 1, 1);
      const first = await b.call('takeNext', sub);
      await realTime(20);
      await a.call('writeMany', pub, 2, 1);
      const second = await b.call('takeNext', sub);
      equal(String(second.sourceTimestamp - first.sourceTimestamp), '0', 'between the stamps');
      await step(world, time, 5, a);
      await a.call('writeMany', pub, 3, 1);
      const third = await b.call('takeNext', sub);
      const passed = Number(third.sourceTimestamp - second.sourceTimestamp) / ms;
      check(Math.abs(passed - 5) < 0.001, `${passed} ms between the stamps instead of the step`);
      time.close();
    },
  },
  {
    name: 'a deadline is missed in site time',
    async run(world) {
      const time = timeOf(world);
      const { a, b, pub, sub } = await pair(world, '/deadline', { deadline: BigInt(20 * ms) });
      equal((await b.call('status', sub, StatusKind.requestedDeadlineMissed))?.totalCount, 0, 'before');
      await hold(world, time, [a, b]);
      await a.call('writeMany', pub, 1, 1);
      await b.call('takeNext', sub);
      const missing = await b.begin('waitStatus', sub, StatusKind.requestedDeadlineMissed, 1);
      equal((await endsAt(time, 20, missing.result, 'deadline')).totalCount, 1, 'missed by the reader');
      equal((await a.call('status', pub, StatusKind.offeredDeadlineMissed))?.totalCount, 1, 'missed by the writer');
      time.close();
    },
  },
  {
    name: 'a lease runs out in site time',
    async run(world) {
      const time = timeOf(world);
      const qos = { liveliness: Liveliness.manualByTopic, lease: BigInt(longMs * ms) };
      const { a, b, pub, sub } = await pair(world, '/lease', qos);
      await b.call('waitAlive', sub, 1);
      const lapsing = await b.begin('waitAlive', sub, 0);
      time.setRate(1000);
      equal((await lapsing.result).totalCount, 1, 'lapsed');
      await a.call('waitStatus', pub, StatusKind.livelinessLost, 1);
      time.close();
    },
  },
  {
    name: 'lifespan runs in site time',
    async run(world) {
      const time = timeOf(world);
      const qos = { durability: Durability.transientLocal, lifespan: BigInt(10 * ms) };
      const { a, b, pub, sub } = await pair(world, '/lifespan', qos);
      await hold(world, time, [a, b]);
      await a.call('writeMany', pub, 1, 1);
      await realTime(30);
      equal(await b.call('takeUntil', sub, 1), [1], 'fresh while time is held');
      await a.call('writeMany', pub, 2, 1);
      await step(world, time, 11, b);
      equal(await b.call('take', sub), undefined, 'too old after the step');
      time.close();
    },
  },
];
