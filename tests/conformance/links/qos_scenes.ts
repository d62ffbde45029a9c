// Scenes of quality of service: the whole table of what fits, deadlines, liveliness, and what is lost.

// Compatibility, works: QoS on both links: every offer against every request, lifespan, deadlines,
// liveliness (automatic, manual by topic, lease; a node that dies is noticed at once), lost
// messages, with counts on both sides

// Compatibility, differs: a publisher whose node dies -> not alive at once, not after its lease;
// ROS 2 forgets it later, here it is told once

import { Liveliness, StatusKind, WaitResult } from '../../../runtime/protocol/generated/constants.ts';
import { qosTable } from './qos_table.ts';
import { bestEffort, check, equal, keepAll, pair, range, type Scene } from './scenes.ts';

const ms = 1_000_000n;
const hour = 3_600_000n * ms;
const manual = { liveliness: Liveliness.manualByTopic };

export const qosScenes: readonly Scene[] = [
  {
    name: 'every offer meets every request as the table says',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const node = await a.call('node', 'a');
      const other = await b.call('node', 'b');
      for (const { name, kind, cells } of qosTable) {
        for (const [i, { offer, ask, fits }] of cells.entries()) {
          const topic = `/${name}/cell${i}`;
          const pub = await a.call('publisher', { node, name: topic, qos: offer });
          const sub = await b.call('subscription', { node: other, name: topic, qos: ask });
          if (fits) {
            await a.call('waitMatched', pub, 1);
            await b.call('waitMatched', sub, 1);
            await a.call('writeMany', pub, i, 1);
            equal(await b.call('takeUntil', sub, i), [i], `${topic} carries`);
          } else {
            const offered = await a.call('waitStatus', pub, StatusKind.offeredQosIncompatible, 1);
            const requested = await b.call('waitStatus', sub, StatusKind.requestedQosIncompatible, 1);
            equal([offered.lastPolicy, requested.lastPolicy], [kind, kind], `${topic} is blamed`);
            equal([await a.call('matched', pub), await b.call('matched', sub)], [0, 0], `${topic} matched`);
          }
        }
      }
    },
  },
  {
    name: 'a missed deadline wakes both sides and is counted for each period',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/deadline', { deadline: 20n * ms }, { deadline: 30n * ms });
      equal((await a.call('status', pub, StatusKind.offeredDeadlineMissed))?.totalCount, 0, 'before the first sample');
      equal((await b.call('status', sub, StatusKind.requestedDeadlineMissed))?.totalCount, 0, 'before the first sample');
      await a.call('writeMany', pub, 1, 1);
      equal(await b.call('takeUntil', sub, 1), [1], 'the first sample');
      const requested = await b.call('waitStatus', sub, StatusKind.requestedDeadlineMissed, 3);
      check(requested.totalChange === requested.totalCount, 'all changes are told');
      const offered = await a.call('waitStatus', pub, StatusKind.offeredDeadlineMissed, 3);
      check(offered.totalChange === offered.totalCount, 'all changes are told');
      equal(await a.call('status', pub, StatusKind.requestedDeadlineMissed), undefined, 'a publisher requests none');
    },
  },
  {
    name: 'deadlines that pass while a worker sleeps are counted',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/asleep', { deadline: 10n * ms });
      await a.call('writeMany', pub, 1, 1);
      await b.call('takeUntil', sub, 1);
      await a.call('sleep', 100);
      const before = (await a.call('status', pub, StatusKind.offeredDeadlineMissed))?.totalCount ?? 0;
      check(before >= 10, `${before} offered`);
      await a.call('writeMany', pub, 2, 1);
      await b.call('takeUntil', sub, 2);
      const requested = (await b.call('status', sub, StatusKind.requestedDeadlineMissed))?.totalCount ?? 0;
      check(requested >= 9, `${requested} requested`);
    },
  },
  {
    name: 'time wakes nobody who reads no status, and those who do only while they wait',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/unread', { ...manual, deadline: 5n * ms, lease: 5n * ms });
      await a.call('writeMany', pub, 1, 1);
      await b.call('takeUntil', sub, 1);
      for (const peer of [a, b]) equal(await peer.call('wait', 60), WaitResult.timeout, 'not woken');
      await b.call('status', sub, StatusKind.requestedDeadlineMissed);
      equal(await b.call('wait', -1), WaitResult.woken, 'woken by a missed deadline');
      equal(await a.call('wait', 60), WaitResult.timeout, 'the other is not');
    },
  },
  {
    name: 'no deadline runs for a subscription whose writers are gone',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/left', { deadline: 5n * ms });
      await a.call('writeMany', pub, 1, 1);
      await b.call('waitStatus', sub, StatusKind.requestedDeadlineMissed, 1);
      await a.call('destroy', pub);
      await b.call('waitMatched', sub, 0);
      const last = (await b.call('status', sub, StatusKind.requestedDeadlineMissed))?.totalCount;
      await b.call('sleep', 20);
      equal((await b.call('status', sub, StatusKind.requestedDeadlineMissed))?.totalCount, last, 'total');
    },
  },
  {
    name: 'manual liveliness is lost by time and comes back with a sign of life',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/manual', { ...manual, lease: 40n * ms });
      await b.call('waitAlive', sub, 0);
      const dead = await b.call('status', sub, StatusKind.livelinessChanged);
      equal([dead?.currentCount, dead?.totalCount], [0, 1], 'alive and not alive');
      equal((await a.call('waitStatus', pub, StatusKind.livelinessLost, 1)).totalCount, 1, 'lost once');
      const reviving = await b.begin('waitAlive', sub, 1);
      equal(await a.call('assertLiveliness', pub), 0, 'assert');
      const alive = await reviving.result;
      equal([alive.currentChange, alive.totalChange], [1, -1], 'changes');
      await b.call('waitAlive', sub, 0);
      equal((await a.call('waitStatus', pub, StatusKind.livelinessLost, 2)).totalCount, 2, 'lost again');
      const again = await b.begin('waitAlive', sub, 1);
      await a.call('writeMany', pub, 1, 1);
      equal((await again.result).currentCount, 1, 'a sample is a sign of life');
    },
  },
  {
    name: 'a worker that dies is not alive at once, one that leaves is not counted',
    async run(world) {
      const [reader, stays, leaves, dies] = [await world.peer(), await world.peer(), await world.peer(), await world.peer()];
      const sub = await reader.call('subscription', { node: await reader.call('node', 'r'), name: '/alive' });
      for (const peer of [stays, leaves]) {
        await peer.call('publisher', { node: await peer.call('node', 'w'), name: '/alive' });
      }
      const qos = { ...manual, lease: hour };
      await dies.call('publisher', { node: await dies.call('node', 'w'), name: '/alive', qos });
      const all = await reader.call('waitAlive', sub, 3);
      equal([all.currentChange, all.totalCount], [3, 0], 'three are alive');
      const leaving = await reader.begin('waitAlive', sub, 2);
      await leaves.leave();
      equal((await leaving.result).totalChange, 0, 'nobody died');
      const dying = await reader.begin('waitStatus', sub, StatusKind.livelinessChanged, 1);
      await dies.terminate();
      equal((await dying.result).totalChange, 1, 'one died');
      equal((await reader.call('waitAlive', sub, 1)).totalCount, 0, 'and is told once');
    },
  },
  {
    name: 'samples that a keep_all subscription never sees are counted as lost',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/lossy', { ...keepAll, ...bestEffort });
      const total = 40_000;
      await a.call('writeMany', pub, 1, total);
      const numbers = await b.call('takeUntil', sub, total);
      check(numbers.every((n, i) => i === 0 || n > numbers[i - 1]!), 'order');
      const lost = await b.call('status', sub, StatusKind.messageLost);
      equal(lost?.totalCount, total - numbers.length, 'lost');
      check((lost?.totalCount ?? 0) > 0, 'something was lost');
      equal(lost?.totalChange, lost?.totalCount, 'change');
    },
  },
  {
    name: 'what falls out of a keep_last queue is not lost',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/thinned', { depth: 3 });
      await a.call('writeMany', pub, 1, 500);
      equal((await b.call('takeUntil', sub, 500)).slice(-3), range(498, 500), 'newest');
      equal((await b.call('status', sub, StatusKind.messageLost))?.totalCount, 0, 'lost');
    },
  },
  {
    name: 'the status version changes with every status and with nothing else',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/version', { deadline: hour });
      const before = await b.call('statusVersion');
      await a.call('writeMany', pub, 1, 3);
      equal(await b.call('takeUntil', sub, 3), [1, 2, 3], 'data');
      equal(await b.call('statusVersion'), before, 'data is no status');
      const waiting = await b.begin('waitStatusVersion', before);
      const other = await a.call('publisher', { node: await a.call('node', 'b'), name: '/version', qos: bestEffort });
      const changed = await waiting.result;
      check(changed !== before, 'a writer that does not fit');
      const offered = await a.call('waitStatus', other, StatusKind.offeredQosIncompatible, 1);
      equal(offered.totalCount, 1, 'told to the writer');
      const leaving = await b.begin('waitStatusVersion', changed);
      await a.terminate();
      check(await leaving.result !== changed, 'a writer that ends');
    },
  },
];
