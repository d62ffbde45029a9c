// The behaviour that every link must have, as scenes between workers. Run over both links, under Node.js and in Chromium.

// Compatibility, works: shared-memory link and port link: matching, order, depth, transient_local,
// services

import { BusSizes, Durability, ErrorCode, History, PolicyKind, Reliability, StatusKind, WaitResult } from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import type { World } from './world.ts';

export interface Scene {
  readonly name: string;
  /** Throws when the link does not do what it must. */
  readonly run: (world: World) => Promise<void>;
}

export function equal(actual: unknown, expected: unknown, what: string): void {
  const a = JSON.stringify(actual);
  const e = JSON.stringify(expected);
  if (a !== e) throw new Error(`${what}: ${a?.slice(0, 400)} instead of ${e?.slice(0, 400)}`);
}

export function check(condition: boolean, what: string): void {
  if (!condition) throw new Error(what);
}

export const range = (from: number, to: number): number[] => Array.from({ length: to - from + 1 }, (_, i) => from + i);
export const hex = (bytes: Uint8Array): string => Array.from(bytes, (b) => b.toString(16).padStart(2, '0')).join('');
export const transient = { durability: Durability.transientLocal };
export const bestEffort = { reliability: Reliability.bestEffort };
export const keepAll = { history: History.keepAll };

/** A publisher in one worker, a subscription in another, matched. */
export async function pair(world: World, topic: string, qos = {}, readerQos = qos) {
  const [a, b] = [await world.peer(), await world.peer()];
  const pub = await a.call('publisher', { node: await a.call('node', 'talker'), name: topic, qos });
  const sub = await b.call('subscription', { node: await b.call('node', 'listener'), name: topic, qos: readerQos });
  await a.call('waitMatched', pub, 1);
  await b.call('waitMatched', sub, 1);
  return { a, b, pub, sub };
}

export const scenes: readonly Scene[] = [
  {
    name: 'a message goes from one worker to another',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/chatter');
      const taking = await b.begin('takeNext', sub);
      equal(await a.call('write', pub, new Uint8Array([0, 1, 0, 0, 42])), 1, 'sequence');
      const sample = await taking.result;
      equal([...sample.bytes], [0, 1, 0, 0, 42], 'bytes');
      equal(sample.sequence, 1, 'sequence');
      equal(hex(sample.writerGid), hex(await a.call('gid', pub)), 'writer gid');
      check(Math.abs(Number(sample.sourceTimestamp / 1_000_000n) - Date.now()) < 60_000, 'source timestamp');
      equal(await b.call('take', sub), undefined, 'nothing more');
      equal(await b.call('ready'), [], 'not ready');
    },
  },
  {
    name: 'empty messages and odd lengths keep their bytes',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/odd', keepAll);
      const lengths = [0, 1, 2, 3, 4, 5, 63, 64, 65, 127, 255, 256, 257, 1000, 2047, 2048, 2049, 4095, 4097, 65537];
      for (const length of lengths) {
        await a.call('write', pub, Uint8Array.from({ length }, (_, i) => (i * 7 + length) & 255));
      }
      for (const length of lengths) {
        const { bytes } = await b.call('takeNext', sub);
        equal(bytes.length, length, 'length');
        check(bytes.every((byte, i) => byte === ((i * 7 + length) & 255)), `bytes of ${length}`);
      }
    },
  },
  {
    name: 'different names, types and hashes do not meet',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const node = await a.call('node', 'a');
      const pub = await a.call('publisher', { node, name: '/x', type: 'p/msg/A', hash: 'RIHS01_1' });
      const other = await b.call('node', 'b');
      const name = await b.call('subscription', { node: other, name: '/y', type: 'p/msg/A' });
      const type = await b.call('subscription', { node: other, name: '/x', type: 'p/msg/B' });
      const hash = await b.call('subscription', { node: other, name: '/x', type: 'p/msg/A', hash: 'RIHS01_2' });
      const right = await b.call('subscription', { node: other, name: '/x', type: 'p/msg/A' });
      await b.call('waitMatched', right, 1);
      await a.call('waitMatched', pub, 1);
      for (const sub of [name, type, hash]) equal(await b.call('matched', sub), 0, 'matched');
      await b.call('waitStatus', type, StatusKind.subscriptionIncompatibleType, 1);
      await a.call('waitStatus', pub, StatusKind.publisherIncompatibleType, 1);
      await a.call('writeMany', pub, 1, 1);
      equal(await b.call('takeUntil', right, 1), [1], 'right one');
      for (const sub of [name, type, hash]) equal(await b.call('take', sub), undefined, 'wrong one');
    },
  },
  {
    name: 'incompatible QoS is told to both sides and carries nothing',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const node = await a.call('node', 'a');
      const other = await b.call('node', 'b');
      const cases = [
        { name: '/reliability', offer: bestEffort, ask: {}, policy: PolicyKind.reliability },
        { name: '/durability', offer: {}, ask: transient, policy: PolicyKind.durability },
        { name: '/deadline', offer: {}, ask: { deadline: 1_000_000n }, policy: PolicyKind.deadline },
        { name: '/liveliness', offer: {}, ask: { liveliness: 3 }, policy: PolicyKind.liveliness },
        { name: '/lease', offer: { lease: 5n }, ask: { lease: 4n }, policy: PolicyKind.livelinessLease },
      ];
      for (const { name, offer, ask, policy } of cases) {
        const pub = await a.call('publisher', { node, name, qos: offer });
        const sub = await b.call('subscription', { node: other, name, qos: ask });
        const offered = await a.call('waitStatus', pub, StatusKind.offeredQosIncompatible, 1);
        equal([offered.totalCount, offered.totalChange, offered.lastPolicy], [1, 1, policy], `offered ${name}`);
        const requested = await b.call('waitStatus', sub, StatusKind.requestedQosIncompatible, 1);
        equal([requested.totalCount, requested.lastPolicy], [1, policy], `requested ${name}`);
        equal((await b.call('status', sub, StatusKind.requestedQosIncompatible))?.totalChange, 0, 'change is read once');
        equal([await a.call('matched', pub), await b.call('matched', sub)], [0, 0], 'matched');
        await a.call('writeMany', pub, 1, 1);
        equal(await b.call('take', sub), undefined, 'nothing comes');
      }
    },
  },
  {
    name: 'matched counts follow peers that come and go',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/count');
      const status = await a.call('waitStatus', pub, StatusKind.publicationMatched, 1);
      equal([status.currentCount, status.currentChange], [1, 1], 'current');
      await b.call('destroy', sub);
      await a.call('waitMatched', pub, 0);
      const after = await a.call('status', pub, StatusKind.publicationMatched);
      equal([after?.totalCount, after?.currentCount, after?.currentChange], [1, 0, -1], 'after');
      const again = await b.call('subscription', { node: await b.call('node', 'again'), name: '/count' });
      await a.call('waitMatched', pub, 1);
      await b.call('waitMatched', again, 1);
      equal((await a.call('waitStatus', pub, StatusKind.publicationMatched, 2)).totalCount, 2, 'total');
    },
  },
  {
    name: 'order and completeness of 5000 reliable messages',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/order', keepAll);
      const taking = await b.begin('takeUntil', sub, 5000);
      equal(await a.call('writeMany', pub, 1, 5000, 40), 5000, 'written');
      equal(await taking.result, range(1, 5000), 'numbers');
    },
  },
  {
    name: 'a reliable keep_all writer waits for a slow reader',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/pressure', keepAll);
      const total = 20_000;
      const writing = await a.begin('writeMany', pub, 1, total);
      const numbers = await b.call('takeUntil', sub, total);
      equal(numbers.length, total, 'count');
      check(numbers.every((n, i) => n === i + 1), 'order');
      equal(await writing.result, total, 'written');
    },
  },
  {
    name: 'a reliable keep_all writer waits when memory ends, and loses nothing',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/ceiling', keepAll);
      const total = 300;
      const writing = await a.begin('writeMany', pub, 1, total, 1_000_000);
      const { broker } = world;
      if (broker instanceof SharedBroker) {
        // Nothing is read before the bus is full. A question to the reader lets time pass.
        while (broker.bus.usage().used * BusSizes.page < 250e6) await b.call('gid', sub);
      }
      equal(await b.call('takeUntil', sub, total), range(1, total), 'numbers');
      equal(await writing.result, total, 'written');
    },
  },
  {
    name: 'a writer that waits for a reader goes on when the reader is killed',
    async run(world) {
      const { a, b, pub } = await pair(world, '/pressure_death', keepAll);
      const writing = await a.begin('writeMany', pub, 1, 20_000);
      await b.terminate();
      equal(await writing.result, 20_000, 'written');
    },
  },
  {
    name: 'keep_last gives the newest, in order',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/depth', { depth: 5 });
      await a.call('writeMany', pub, 1, 40);
      const numbers = await b.call('takeUntil', sub, 40);
      equal(numbers.slice(-5), range(36, 40), 'newest');
      check(numbers.length === 5 || world.kind === 'port', 'no more than the depth');
      check(numbers.every((n, i) => i === 0 || n > numbers[i - 1]!), 'order');
    },
  },
  {
    name: 'a subscription deeper than its publisher gets its own depth',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/deep', { depth: 1 }, { depth: 300 });
      await a.call('writeMany', pub, 1, 300);
      equal(await b.call('takeUntil', sub, 300), range(1, 300), 'all');
    },
  },
  {
    name: 'two writers share one queue of the reader, in order of publication',
    async run(world) {
      const [a, b, c] = [await world.peer(), await world.peer(), await world.peer()];
      const sub = await c.call('subscription', { node: await c.call('node', 'c'), name: '/two', qos: { depth: 4 } });
      const pubA = await a.call('publisher', { node: await a.call('node', 'a'), name: '/two' });
      const pubB = await b.call('publisher', { node: await b.call('node', 'b'), name: '/two' });
      await c.call('waitMatched', sub, 2);
      await a.call('waitMatched', pubA, 1);
      await b.call('waitMatched', pubB, 1);
      for (let i = 1; i <= 6; i += 1) {
        await a.call('writeMany', pubA, 2 * i - 1, 1);
        await b.call('writeMany', pubB, 2 * i, 1);
      }
      const numbers = await c.call('takeUntil', sub, 12);
      if (world.kind === 'shared') equal(numbers, [9, 10, 11, 12], 'newest of both');
      for (const rest of [0, 1]) {
        const each = numbers.filter((n) => n % 2 === rest);
        check(each.every((n, i) => i === 0 || n > each[i - 1]!), 'order of each');
      }
    },
  },
  {
    name: 'a late transient_local subscription gets what was kept, a volatile one nothing',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const qos = { ...transient, depth: 3 };
      const pub = await a.call('publisher', { node: await a.call('node', 'a'), name: '/map', qos });
      await a.call('writeMany', pub, 1, 5);
      const node = await b.call('node', 'b');
      const late = await b.call('subscription', { node, name: '/map', qos: { ...transient, depth: 10 } });
      equal(await b.call('takeUntil', late, 5), [3, 4, 5], 'kept');
      const shallow = await b.call('subscription', { node, name: '/map', qos: { ...transient, depth: 1 } });
      equal(await b.call('takeUntil', shallow, 5), [5], 'shallow');
      const now = await b.call('subscription', { node, name: '/map' });
      await b.call('waitMatched', now, 1);
      await a.call('waitMatched', pub, 3);
      await a.call('writeMany', pub, 6, 1);
      equal(await b.call('takeUntil', now, 6), [6], 'volatile');
      equal(await b.call('takeUntil', late, 6), [6], 'late goes on');
    },
  },
  {
    name: 'what a transient_local writer kept comes though the writer sleeps',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const pub = await a.call('publisher', { node: await a.call('node', 'a'), name: '/kept', qos: transient });
      await a.call('writeMany', pub, 1, 2);
      const sleeping = await a.begin('sleep', 3_600_000);
      const sub = await b.call('subscription', { node: await b.call('node', 'b'), name: '/kept', qos: transient });
      equal(await b.call('takeUntil', sub, 2), [1, 2], 'kept');
      a.stop();
      equal(await sleeping.result, WaitResult.stop, 'stopped');
    },
  },
  {
    name: 'eight megabytes arrive whole, again and again',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/image', { depth: 2 });
      const size = 8 << 20;
      const image = new Uint8Array(size);
      for (let round = 1; round <= 6; round += 1) {
        for (let i = 0; i < size; i += 4099) image[i] = (i + round) & 255;
        equal(await a.call('write', pub, image), round, 'sequence');
        const { bytes } = await b.call('takeNext', sub);
        equal(bytes.length, size, 'length');
        for (let i = 0; i < size; i += 4099) if (bytes[i] !== ((i + round) & 255)) throw new Error(`byte ${i}`);
      }
    },
  },
  {
    name: 'a very large message comes right after small ones',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/mixed', { depth: 10 });
      for (const size of [10, 15 << 20, 10, 16 << 20]) {
        check(await a.call('write', pub, new Uint8Array(size)) > 0, 'written');
      }
      for (const size of [10, 15 << 20, 10, 16 << 20]) {
        equal((await b.call('takeNext', sub)).bytes.length, size, 'length');
      }
    },
  },
  {
    name: 'messages larger than there can be room for are refused',
    async run(world) {
      if (world.kind !== 'shared') return;
      const { a, b, pub, sub } = await pair(world, '/huge', { depth: 1 });
      equal(await a.call('write', pub, new Uint8Array(300 << 20)), ErrorCode.outOfMemory, 'refused');
      await a.call('writeMany', pub, 7, 1);
      equal(await b.call('takeUntil', sub, 7), [7], 'goes on');
    },
  },
  {
    name: 'two hundred topics between two workers',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const [na, nb] = [await a.call('node', 'a'), await b.call('node', 'b')];
      const pubs: number[] = [];
      const subs: number[] = [];
      for (let i = 0; i < 200; i += 1) {
        pubs.push(await a.call('publisher', { node: na, name: `/t/n${i}` }));
        subs.push(await b.call('subscription', { node: nb, name: `/t/n${i}` }));
      }
      for (const pub of pubs) await a.call('waitMatched', pub, 1);
      for (const sub of subs) await b.call('waitMatched', sub, 1);
      for (const [i, pub] of pubs.entries()) await a.call('writeMany', pub, i, 1);
      for (const [i, sub] of subs.entries()) equal(await b.call('takeUntil', sub, i), [i], `topic ${i}`);
      equal(await b.call('ready'), [], 'all read');
    },
  },
  {
    name: 'one writer, three readers in two workers, each with all',
    async run(world) {
      const [a, b, c] = [await world.peer(), await world.peer(), await world.peer()];
      const pub = await a.call('publisher', { node: await a.call('node', 'a'), name: '/fan', qos: keepAll });
      const nb = await b.call('node', 'b');
      const one = await b.call('subscription', { node: nb, name: '/fan', qos: keepAll });
      const two = await b.call('subscription', { node: nb, name: '/fan', qos: { depth: 2000 } });
      const three = await c.call('subscription', { node: await c.call('node', 'c'), name: '/fan', qos: keepAll });
      await a.call('waitMatched', pub, 3);
      for (const [peer, sub] of [[b, one], [b, two], [c, three]] as const) await peer.call('waitMatched', sub, 1);
      await a.call('writeMany', pub, 1, 1000);
      for (const [peer, sub] of [[b, one], [b, two], [c, three]] as const) {
        equal(await peer.call('takeUntil', sub, 1000), range(1, 1000), 'numbers');
      }
    },
  },
  {
    name: 'publisher and subscription of one worker meet, unless local publications are ignored',
    async run(world) {
      const a = await world.peer();
      const node = await a.call('node', 'a');
      const pub = await a.call('publisher', { node, name: '/self' });
      const sub = await a.call('subscription', { node, name: '/self' });
      const deaf = await a.call('subscription', { node, name: '/self', flags: 1 });
      equal([await a.call('matched', pub), await a.call('matched', deaf)], [1, 0], 'matched');
      await a.call('writeMany', pub, 1, 2);
      equal(await a.call('takeNumbers', sub), [1, 2], 'own');
      equal(await a.call('takeNumbers', deaf), [], 'ignored');
    },
  },
  {
    name: 'a server answers each of two clients with its own reply',
    async run(world) {
      const [s, a, b] = [await world.peer(), await world.peer(), await world.peer()];
      const server = await s.call('server', { node: await s.call('node', 's'), name: '/add' });
      const ca = await a.call('client', { node: await a.call('node', 'a'), name: '/add' });
      const cb = await b.call('client', { node: await b.call('node', 'b'), name: '/add' });
      await a.call('waitMatched', ca, 1);
      await b.call('waitMatched', cb, 1);
      await s.call('waitMatched', server, 2);
      const serving = await s.begin('serve', server);
      const asked: { peer: typeof a; client: number; byte: number; sequence: number; }[] = [];
      for (let i = 0; i < 50; i += 1) {
        for (const [peer, client, base] of [[a, ca, 0], [b, cb, 100]] as const) {
          const byte = base + i;
          asked.push({ peer, client, byte, sequence: await peer.call('write', client, new Uint8Array([byte])) });
        }
      }
      for (const { peer, client, byte, sequence } of asked) {
        const reply = await peer.call('takeNext', client);
        equal([...reply.bytes], [byte + 1], 'reply');
        equal(reply.relatedSequence, sequence, 'related sequence');
        equal(hex(reply.relatedGid), hex(await peer.call('gid', client)), 'related gid');
      }
      await a.call('write', ca, new Uint8Array([255]));
      equal([...(await a.call('takeNext', ca)).bytes], [0], 'last');
      equal(await serving.result, 100, 'served');
      equal(await b.call('take', cb), undefined, 'no reply of the other');
    },
  },
  {
    name: 'two servers of one name both answer',
    async run(world) {
      const [s, t, a] = [await world.peer(), await world.peer(), await world.peer()];
      const one = await s.call('server', { node: await s.call('node', 's'), name: '/both' });
      const two = await t.call('server', { node: await t.call('node', 't'), name: '/both' });
      const client = await a.call('client', { node: await a.call('node', 'a'), name: '/both' });
      await a.call('waitMatched', client, 2);
      const ends = [await s.begin('serve', one), await t.begin('serve', two)];
      await a.call('write', client, new Uint8Array([255]));
      const replies = [await a.call('takeNext', client), await a.call('takeNext', client)];
      check(hex(replies[0]!.writerGid) !== hex(replies[1]!.writerGid), 'different servers');
      for (const end of ends) equal(await end.result, 0, 'served');
    },
  },
  {
    name: 'six hundred requests wait for a server that is busy',
    async run(world) {
      const [s, a] = [await world.peer(), await world.peer()];
      const server = await s.call('server', { node: await s.call('node', 's'), name: '/slow' });
      const client = await a.call('client', { node: await a.call('node', 'a'), name: '/slow' });
      await a.call('waitMatched', client, 1);
      await s.call('waitMatched', server, 1);
      for (let i = 0; i < 600; i += 1) await a.call('write', client, new Uint8Array([i === 599 ? 255 : i % 250]));
      equal(await s.call('serve', server), 599, 'served');
      for (let i = 0; i < 599; i += 1) {
        const reply = await a.call('takeNext', client);
        equal([reply.bytes[0], reply.relatedSequence], [(i % 250) + 1, i + 1], 'reply');
      }
    },
  },
  {
    name: 'a server that is killed is no longer matched',
    async run(world) {
      const [s, a] = [await world.peer(), await world.peer()];
      await s.call('server', { node: await s.call('node', 's'), name: '/mortal' });
      const client = await a.call('client', { node: await a.call('node', 'a'), name: '/mortal' });
      await a.call('waitMatched', client, 1);
      const waiting = await a.begin('waitMatched', client, 0);
      await s.terminate();
      equal(await waiting.result, 0, 'matched');
    },
  },
  {
    name: 'endpoints and nodes vanish with their worker',
    async run(world) {
      const { a, b, sub } = await pair(world, '/vanish');
      equal((await b.call('waitGraph', 2)).nodes.length, 2, 'nodes');
      const waiting = await b.begin('waitGraph', 1, 1);
      await a.terminate();
      const graph = await waiting.result;
      equal(graph.nodes.map((node) => node.name), ['listener'], 'nodes left');
      equal(await b.call('matched', sub), 0, 'matched');
    },
  },
  {
    name: 'what a worker wrote before it left is still read',
    async run(world) {
      const { a, b, pub, sub } = await pair(world, '/last_words', keepAll);
      await a.call('writeMany', pub, 1, 30, 3000);
      await a.leave();
      equal(await b.call('takeUntil', sub, 30), range(1, 30), 'numbers');
      await b.call('waitMatched', sub, 0);
      const again = await world.peer();
      const next = await again.call('publisher', { node: await again.call('node', 'next'), name: '/last_words', qos: keepAll });
      await again.call('waitMatched', next, 1);
      await b.call('waitMatched', sub, 1);
      await again.call('writeMany', next, 1, 3);
      equal(await b.call('takeUntil', sub, 3), [1, 2, 3], 'a new writer in its place');
    },
  },
  {
    name: 'stop wakes a sleeper and a waiter',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const sleeping = await a.begin('sleep', 3_600_000);
      const waiting = await b.begin('wait', -1);
      a.stop();
      b.stop();
      equal([await sleeping.result, await waiting.result], [WaitResult.stop, WaitResult.stop], 'results');
      check(await a.call('stopRequested'), 'stop requested');
    },
  },
  {
    name: 'wait and sleep end at their time',
    async run(world) {
      const a = await world.peer();
      equal(await a.call('wait', 0), WaitResult.timeout, 'no time');
      equal(await a.call('wait', 20), WaitResult.timeout, 'timeout');
      equal(await a.call('sleep', 20), WaitResult.woken, 'slept');
      equal(await a.call('sleep', 0), WaitResult.woken, 'slept not');
    },
  },
  {
    name: 'the graph shows nodes, endpoints and their QoS',
    async run(world) {
      const [a, b] = [await world.peer(), await world.peer()];
      const node = await a.call('node', 'talker', '/ns');
      const qos = { ...transient, ...bestEffort, depth: 7, deadline: 5_000_000_000n, lifespan: 3n };
      const pub = await a.call('publisher', { node, name: '/ns/chatter', type: 'std_msgs/msg/String', hash: 'RIHS01_a', qos });
      await a.call('server', { node, name: '/ns/add', type: 'x/srv/Add' });
      await a.call('publisher', { node, name: '/hidden', flags: 2 });
      const { nodes, endpoints } = await b.call('waitGraph', 2);
      equal(nodes.map(({ name, namespace }) => [namespace, name]), [['/ns', 'talker']], 'nodes');
      const [first, second] = endpoints;
      equal([first?.kind, first?.name, first?.type, first?.hash, first?.node], [1, '/ns/chatter', 'std_msgs/msg/String', 'RIHS01_a', 0], 'publisher');
      equal([first?.qos.depth, first?.qos.reliability, first?.qos.durability, String(first?.qos.deadline), String(first?.qos.lifespan)], [7,
        Reliability.bestEffort, Durability.transientLocal, '5000000000', '3'], 'qos');
      equal(hex(first?.gid ?? new Uint8Array()), hex(await a.call('gid', pub)), 'gid');
      equal([second?.kind, second?.name], [4, '/ns/add'], 'server');
      await a.call('destroyNode', node);
    },
  },
  {
    name: 'bad arguments get their error codes',
    async run(world) {
      const a = await world.peer();
      const node = await a.call('node', 'a');
      equal(await a.call('publisher', { node: node + 1000, name: '/x' }), ErrorCode.badHandle, 'no such node');
      equal(await a.call('publisher', { node, name: '/'.padEnd(256, 'x') }), ErrorCode.invalidName, 'name too long');
      equal(await a.call('node', ''), ErrorCode.invalidName, 'no name');
      equal(await a.call('matched', 4000), ErrorCode.badHandle, 'no such endpoint');
      equal(await a.call('write', 4000, new Uint8Array(1)), ErrorCode.badHandle, 'no such writer');
      const sub = await a.call('subscription', { node, name: '/x' });
      equal(await a.call('write', sub, new Uint8Array(1)), ErrorCode.badHandle, 'a reader cannot write');
    },
  },
  {
    name: 'lifespan: what is too old is not delivered',
    async run(world) {
      const qos = { ...transient, lifespan: 1_000_000n };
      const { a, b, pub, sub } = await pair(world, '/short', qos);
      await a.call('writeMany', pub, 1, 1);
      await b.call('wait', 30);
      // It lies in the queue by now, or still travels.
      await b.call('sleep', 5);
      equal(await b.call('takeNumbers', sub), [], 'the old one');
      equal(await b.call('ready'), [], 'and nobody waits for it');
      const late = await b.call('subscription', { node: await b.call('node', 'late'), name: '/short', qos });
      await b.call('waitMatched', late, 1);
      await b.call('sleep', 5);
      equal(await b.call('takeNumbers', late), [], 'for a late subscription');
    },
  },
];
