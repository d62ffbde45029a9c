// Workers that are killed in the middle of whatever they do, on the shared link: nobody else suffers, nothing leaks.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { startNodeWorker } from './node_start.ts';
import { World } from './world.ts';

const watchdog = { timeout: 120_000 };
const rounds = 12;

/** Looks again and again. It gives up before the test's own limit, as that would leave the loop running for ever. */
function until(condition: () => boolean, state: () => string): Promise<void> {
  const end = performance.now() + 60_000;
  return new Promise((resolve, reject) => {
    const look = (): void => {
      if (condition()) resolve();
      else if (performance.now() > end) reject(new Error(state()));
      else setImmediate(look);
    };
    look();
  });
}

for (
  const { what, largest, qos } of [
    { what: 'small messages, depth 10', largest: 200, qos: {} },
    { what: 'mixed sizes, depth 3', largest: 20_000, qos: { depth: 3 } },
    { what: 'keep_all with back pressure', largest: 500, qos: { history: 2 } },
    { what: 'large messages, best effort', largest: 300_000, qos: { reliability: 2, depth: 2 } },
  ]
) {
  test(`writers die while they write: ${what}`, watchdog, async () => {
    const world = new World('shared', startNodeWorker);
    const { broker } = world;
    assert.ok(broker instanceof SharedBroker);
    try {
      const reader = await world.peer();
      const sub = await reader.call('subscription', { node: await reader.call('node', 'reader'), name: '/flood', qos });
      const deaf = await world.peer();
      const slow = await deaf.call('subscription', { node: await deaf.call('node', 'deaf'), name: '/flood', qos: { ...qos, history: 1 } });
      for (let round = 0; round < rounds; round += 1) {
        const writer = await world.peer();
        const pub = await writer.call('publisher', { node: await writer.call('node', 'writer'), name: '/flood', qos });
        const flood = await writer.begin('flood', pub, largest);
        flood.result.catch(() => undefined);
        assert.ok(await reader.call('verify', sub, 40 + round * 3) >= 1);
        await writer.terminate();
      }
      await reader.call('waitMatched', sub, 0);
      while (await reader.call('take', sub) !== undefined) {
        // Whatever the dead have left.
      }
      while (await deaf.call('take', slow) !== undefined) {
        // The same.
      }
      await deaf.terminate();
      await reader.terminate();
      // The broker frees what was left behind.
      await until(() => broker.bus.usage().used === 0, () => `${broker.bus.usage().used} pages are still owned`);
      assert.equal(broker.link.graph().endpoints.length, 0);
    } finally {
      await world.close();
    }
  });
}

test('readers die while they read', watchdog, async () => {
  const world = new World('shared', startNodeWorker);
  try {
    const writer = await world.peer();
    const pub = await writer.call('publisher', { node: await writer.call('node', 'writer'), name: '/x', qos: { history: 2 } });
    const survivor = await world.peer();
    const sub = await survivor.call('subscription', { node: await survivor.call('node', 's'), name: '/x', qos: { history: 2 } });
    const flood = await writer.begin('flood', pub, 3000);
    flood.result.catch(() => undefined);
    for (let round = 0; round < rounds; round += 1) {
      const reader = await world.peer();
      const mine = await reader.call('subscription', { node: await reader.call('node', 'r'), name: '/x', qos: { history: 2 } });
      const reading = await reader.begin('verify', mine, 1_000_000);
      reading.result.catch(() => undefined);
      await survivor.call('verify', sub, 200);
      await reader.terminate();
    }
    assert.equal(await survivor.call('verify', sub, 5000), 1);
  } finally {
    await world.close();
  }
});

test('a worker that spins for ever harms nobody, and vanishes when it is killed', watchdog, async () => {
  const world = new World('shared', startNodeWorker);
  const { broker } = world;
  assert.ok(broker instanceof SharedBroker);
  try {
    const keepAll = { history: 2 };
    const [spinner, a, b] = [await world.peer(), await world.peer(), await world.peer()];
    const node = await spinner.call('node', 'spinner');
    await spinner.call('publisher', { node, name: '/x', qos: keepAll });
    await spinner.call('subscription', { node, name: '/x', qos: { depth: 4 } });
    const pub = await a.call('publisher', { node: await a.call('node', 'a'), name: '/x', qos: keepAll });
    const sub = await b.call('subscription', { node: await b.call('node', 'b'), name: '/x', qos: keepAll });
    await b.call('waitMatched', sub, 2);
    const spinning = await spinner.begin('spin');
    spinning.result.catch(() => undefined);
    const reading = await b.begin('takeUntil', sub, 5000);
    assert.equal(await a.call('writeMany', pub, 1, 5000, 300), 5000);
    assert.equal((await reading.result).length, 5000);
    await spinner.terminate();
    await b.call('waitMatched', sub, 1);
    assert.deepEqual((await a.call('waitGraph', 2)).nodes.map(({ name }) => name), ['a', 'b']);
    await a.terminate();
    await b.terminate();
    await until(() => broker.bus.usage().used === 0, () => `${broker.bus.usage().used} pages are still owned`);
  } finally {
    await world.close();
  }
});

test('a publisher in a tight loop starves no other topic', watchdog, async () => {
  const world = new World('shared', startNodeWorker);
  try {
    const [flooder, a, b] = [await world.peer(), await world.peer(), await world.peer()];
    const flood = await flooder.call('publisher', { node: await flooder.call('node', 'flooder'), name: '/flood', qos: { depth: 1 } });
    const nb = await b.call('node', 'b');
    const drowned = await b.call('subscription', { node: nb, name: '/flood', qos: { depth: 1 } });
    const sub = await b.call('subscription', { node: nb, name: '/quiet' });
    const pub = await a.call('publisher', { node: await a.call('node', 'a'), name: '/quiet' });
    await a.call('waitMatched', pub, 1);
    const flooding = await flooder.begin('flood', flood, 5000);
    flooding.result.catch(() => undefined);
    for (let i = 1; i <= 100; i += 1) {
      await a.call('writeMany', pub, i, 1);
      assert.deepEqual(await b.call('takeUntil', sub, i), [i]);
    }
    assert.equal(await b.call('verify', drowned, 50), 1);
  } finally {
    await world.close();
  }
});
