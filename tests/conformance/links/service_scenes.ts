// Scenes of services: many calls at once, and servers and clients that come, go and die.

// Compatibility, works: services on both links: many open calls, answers in any order, servers and
// clients that come, go and die; `wait_for_service` is true only when a call is answered

import { check, equal, range, type Scene } from './scenes.ts';
import type { RemotePeer, World } from './world.ts';

const server = async (peer: RemotePeer): Promise<number> => await peer.call('server', { node: await peer.call('node', 'server'), name: '/serve' });
const client = async (peer: RemotePeer): Promise<number> => await peer.call('client', { node: await peer.call('node', 'client'), name: '/serve' });

async function called(world: World) {
  const [s, a] = [await world.peer(), await world.peer()];
  const [serving, calling] = [await server(s), await client(a)];
  await a.call('waitMatched', calling, 1);
  await s.call('waitMatched', serving, 1);
  return { s, a, serving, calling };
}

export const serviceScenes: readonly Scene[] = [
  {
    name: 'three hundred calls of each of three clients are open at once and answered last first',
    async run(world) {
      const s = await world.peer();
      const serving = await server(s);
      const clients = [await world.peer(), await world.peer(), await world.peer()];
      const handles: number[] = [];
      for (const peer of clients) handles.push(await client(peer));
      for (const [i, peer] of clients.entries()) await peer.call('waitMatched', handles[i]!, 1);
      await s.call('waitMatched', serving, clients.length);
      for (const [i, peer] of clients.entries()) {
        for (let n = 1; n <= 300; n += 1) {
          equal(await peer.call('write', handles[i]!, new Uint8Array([i * 80 + (n % 80)])), n, 'sequence');
        }
      }
      const results = await s.call('serveReversed', serving, 900);
      check(results.every((result) => result > 0), 'all answers were written');
      for (const [i, peer] of clients.entries()) {
        const numbers: number[] = [];
        while (numbers.length < 300) {
          const { bytes, relatedSequence } = await peer.call('takeNext', handles[i]!);
          equal(bytes[0], i * 80 + (relatedSequence % 80) + 1, 'the answer to that request');
          numbers.push(relatedSequence);
        }
        equal(numbers, range(1, 300).reverse(), 'each once');
        equal(await peer.call('take', handles[i]!), undefined, 'nothing else');
      }
    },
  },
  {
    name: 'a server that dies while called leaves the call open; the next server gets the next call only',
    async run(world) {
      const { s, a, calling } = await called(world);
      equal(await a.call('write', calling, new Uint8Array([1])), 1, 'first call');
      await s.terminate();
      await a.call('waitMatched', calling, 0);
      const t = await world.peer();
      const next = await server(t);
      await a.call('waitMatched', calling, 1);
      await t.call('waitMatched', next, 1);
      equal(await t.call('take', next), undefined, 'nothing of before');
      equal(await a.call('write', calling, new Uint8Array([7])), 2, 'second call');
      equal((await t.call('serveReversed', next, 1)).length, 1, 'answered');
      const reply = await a.call('takeNext', calling);
      equal([reply.bytes[0], reply.relatedSequence], [8, 2], 'reply');
      equal(await a.call('take', calling), undefined, 'and no other');
    },
  },
  {
    name: 'a client that dies before its answer harms neither the server nor another client',
    async run(world) {
      const { s, a, serving, calling } = await called(world);
      const b = await world.peer();
      const other = await client(b);
      await b.call('waitMatched', other, 1);
      await s.call('waitMatched', serving, 2);
      await a.call('write', calling, new Uint8Array([1]));
      const request = await s.call('takeNext', serving);
      await a.terminate();
      await s.call('waitMatched', serving, 1);
      const { relatedSequence, relatedGid } = request;
      check(await s.call('write', serving, new Uint8Array([2]), { relatedSequence, relatedGid }) > 0, 'an answer to nobody');
      await b.call('write', other, new Uint8Array([5]));
      await s.call('serveReversed', serving, 1);
      equal((await b.call('takeNext', other)).bytes[0], 6, 'the other goes on');
      equal(await b.call('take', other), undefined, 'and gets no answer that is not its own');
    },
  },
  {
    name: 'whenever a client sees its server, the call is answered',
    async run(world) {
      const [s, a] = [await world.peer(), await world.peer()];
      const node = await s.call('node', 'server');
      const calling = await client(a);
      for (let round = 1; round <= 20; round += 1) {
        const waiting = await a.begin('waitMatched', calling, 1);
        const serving = await s.call('server', { node, name: '/serve' });
        await waiting.result;
        const answering = await s.begin('serveReversed', serving, 1);
        equal(await a.call('write', calling, new Uint8Array([round])), round, 'sequence');
        equal((await a.call('takeNext', calling)).bytes[0], round + 1, 'answer');
        await answering.result;
        await s.call('destroy', serving);
        await a.call('waitMatched', calling, 0);
      }
    },
  },
];
