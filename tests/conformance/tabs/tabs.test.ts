// The scenes of the links, with each two peers in two tabs, and what only tabs have.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { StatusKind } from '../../../runtime/protocol/generated/constants.ts';
import { allScenes } from '../links/all_scenes.ts';
import { startNodeWorker } from '../links/node_start.ts';
import { TabsWorld } from './tabs_world.ts';

const watchdog = { timeout: 120_000 };
const transient = { durability: 1, depth: 5 };

/** Those that do not look at what is the mirror's own (gids), or at who waits for whom and when. */
const across = [
  'empty messages and odd lengths keep their bytes',
  'different names, types and hashes do not meet',
  'incompatible QoS is told to both sides and carries nothing',
  'matched counts follow peers that come and go',
  'order and completeness of 5000 reliable messages',
  'one writer, three readers in two workers, each with all',
  'a late transient_local subscription gets what was kept, a volatile one nothing',
  'eight megabytes arrive whole, again and again',
  'publisher and subscription of one worker meet, unless local publications are ignored',
  'a server answers each of two clients with its own reply',
  'two servers of one name both answer',
  'six hundred requests wait for a server that is busy',
  'what a worker wrote before it left is still read',
];

for (const kinds of [['shared', 'shared'], ['shared', 'port']] as const) {
  for (const name of across) {
    test(`${kinds.join(' and ')}: ${name}`, watchdog, async () => {
      const world = new TabsWorld(kinds, startNodeWorker);
      try {
        const scene = allScenes.find((each) => each.name === name);
        assert.ok(scene, 'there is no such scene');
        await scene.run(world);
      } finally {
        await world.close();
      }
    });
  }
}

for (const kind of ['shared', 'port'] as const) {
  test(`${kind}: with three tabs nothing goes round and nothing comes twice`, watchdog, async () => {
    const world = new TabsWorld([kind, kind, kind], startNodeWorker);
    try {
      const peers = [await world.peer(), await world.peer(), await world.peer()];
      const ends = await Promise.all(peers.map(async (peer, i) => {
        const node = await peer.call('node', `n${i}`);
        const pub = await peer.call('publisher', { node, name: '/x', qos: { history: 2 } });
        return { peer, pub, sub: await peer.call('subscription', { node, name: '/x', qos: { history: 2 } }) };
      }));
      for (const { peer, pub, sub } of ends) {
        await peer.call('waitMatched', pub, 3);
        await peer.call('waitMatched', sub, 3);
      }
      for (const [i, { peer, pub }] of ends.entries()) await peer.call('writeMany', pub, 1 + i * 1000, 100);
      for (const { peer, sub } of ends) {
        const numbers: number[] = [];
        while (numbers.length < 300) numbers.push(new DataView((await peer.call('takeNext', sub)).bytes.buffer).getInt32(0, true));
        for (const i of [0, 1, 2]) {
          assert.deepEqual(numbers.filter((n) => Math.floor(n / 1000) === i), Array.from({ length: 100 }, (_, k) => i * 1000 + k + 1));
        }
      }
      assert.equal((await peers[0]!.call('waitGraph', 6)).nodes.length, 3);
      for (const { peer, sub } of ends) assert.equal(await peer.call('take', sub), undefined);
    } finally {
      await world.close();
    }
  });

  test(`${kind}: a tab that is gone leaves nothing, and its writers count as not alive`, watchdog, async () => {
    const world = new TabsWorld([kind, kind], startNodeWorker);
    try {
      const [a, b] = [await world.peerIn(0), await world.peerIn(1)];
      const sub = await a.call('subscription', { node: await a.call('node', 'a'), name: '/x' });
      await b.call('publisher', { node: await b.call('node', 'b'), name: '/x' });
      await a.call('waitMatched', sub, 1);
      await a.call('waitAlive', sub, 1);
      world.kill(1);
      await a.call('waitMatched', sub, 0);
      const status = await a.call('status', sub, StatusKind.livelinessChanged);
      assert.equal(status?.totalCount, 1);
      assert.deepEqual((await a.call('waitGraph', 1, 1)).nodes.map(({ name }) => name), ['a']);
    } finally {
      await world.close();
    }
  });

  test(`${kind}: a late reader in another tab gets what is kept now, not what was kept for an earlier one`, watchdog, async () => {
    const world = new TabsWorld([kind, kind], startNodeWorker);
    try {
      const [a, b] = [await world.peerIn(0), await world.peerIn(1)];
      const pub = await a.call('publisher', { node: await a.call('node', 'a'), name: '/map', qos: transient });
      const node = await b.call('node', 'b');
      await a.call('writeMany', pub, 1, 7);
      const first = await b.call('subscription', { node, name: '/map', qos: transient });
      assert.deepEqual(await b.call('takeUntil', first, 7), [3, 4, 5, 6, 7]);
      await b.call('destroy', first);
      await a.call('waitMatched', pub, 0);
      await a.call('writeMany', pub, 8, 6);
      const second = await b.call('subscription', { node, name: '/map', qos: transient });
      assert.equal((await b.call('takeUntil', second, 13)).at(-1), 13);
      const third = await b.call('subscription', { node, name: '/map', qos: { ...transient, depth: 2 } });
      assert.deepEqual(await b.call('takeUntil', third, 13), [12, 13]);
    } finally {
      await world.close();
    }
  });
}
