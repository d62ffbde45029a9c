// Workers that are killed while they run on: a browser ends them some time after it was told to, and the next program
// has begun by then.

import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { check, equal, keepAll, range, type Scene } from './scenes.ts';
import type { RemotePeer, World } from './world.ts';

const perRound = 40;

/** Resolves when no page of a shared bus is in use. */
async function empty({ broker }: World): Promise<void> {
  if (!(broker instanceof SharedBroker)) return;
  while (broker.bus.usage().used > 0) await new Promise((resolve) => setTimeout(resolve, 10));
}

/** Starts the next program at once; what it publishes must come whole and in order until the killed worker is gone, and after. */
async function killAndGoOn(world: World, killed: RemotePeer): Promise<void> {
  let over = false;
  const gone = killed.terminate().then(() => {
    over = true;
  });
  const reader = await world.peer();
  const sub = await reader.call('subscription', { node: await reader.call('node', 'reader'), name: '/good', qos: keepAll });
  const next = await world.peer();
  const pub = await next.call('publisher', { node: await next.call('node', 'next'), name: '/good', qos: keepAll });
  await next.call('waitMatched', pub, 1);
  check(over || next.participant !== killed.participant, 'the next program has the place of one that still runs');
  let rounds = 0;
  for (let more = true; more; rounds += 1) {
    more = !over;
    const first = rounds * perRound + 1;
    const taking = await reader.begin('takeUntil', sub, first + perRound - 1);
    await next.call('writeMany', pub, first, perRound, 5000);
    equal(await taking.result, range(first, first + perRound - 1), 'received');
  }
  equal(await reader.call('matched', sub), 1, 'writers');
  const graph = await reader.call('waitGraph', 2);
  // By their places in the table, and the killed worker's may be free again for the second one.
  equal(graph.nodes.map(({ name }) => name).sort(), ['next', 'reader'], 'nodes');
  await gone;
  await Promise.all([next.terminate(), reader.terminate()]);
  await empty(world);
}

export const killScenes: readonly Scene[] = [
  {
    name: 'who floods is killed, and the next program starts at once',
    async run(world) {
      const flooder = await world.peer();
      const pub = await flooder.call('publisher', { node: await flooder.call('node', 'flooder'), name: '/flood', qos: { depth: 3 } });
      const hearer = await world.peer();
      const sub = await hearer.call('subscription', { node: await hearer.call('node', 'hearer'), name: '/flood', qos: { depth: 3 } });
      await flooder.call('waitMatched', pub, 1);
      await hearer.call('waitMatched', sub, 1);
      const flood = await flooder.begin('flood', pub, 20_000);
      flood.result.catch(() => undefined);
      await hearer.call('verify', sub, 1);
      await hearer.terminate();
      await killAndGoOn(world, flooder);
    },
  },
  {
    name: 'who makes nodes and endpoints for ever is killed, and the next program starts at once',
    async run(world) {
      const maker = await world.peer();
      const making = await maker.begin('makeForEver', '/good');
      making.result.catch(() => undefined);
      await killAndGoOn(world, maker);
    },
  },
];
