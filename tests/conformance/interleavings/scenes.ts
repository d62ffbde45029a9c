// Scenes to be explored: small ones, so that all of their interleavings can be visited. Each begins with what lies on
// the bus already; then come the few calls that race.

import { BusEndpoint, BusHeader, BusSizes, Durability, EndpointKind, History } from '../../../runtime/protocol/generated/constants.ts';
import type { Limits, Run } from './explorer.ts';
import type { Message, Received } from './programs.ts';
import type { EndpointQos } from '../../../runtime/site/contract/qos.ts';
import { keepAllLimit, type Laboratory, sceneLayout, SceneWorld } from './world.ts';

export interface ExploredScene {
  readonly name: string;
  readonly limits?: Limits;
  readonly make: (laboratory: Laboratory) => Run;
}

const keepAll = { history: History.keepAll };
const transient = { durability: Durability.transientLocal };
const ringSlots = 8;

/** Messages numbered from `first` on; the number is in every byte. */
function numbered(first: number, count: number, length = 8): Message[] {
  return Array.from({ length: count }, (_, i) => ({ mark: first + i, length }));
}

const sequences = (received: readonly Received[]): string => received.map((sample) => sample.sequence).join();
const upTo = (last: number) => (received: readonly Received[]): boolean => received.at(-1)?.sequence === last;
const many = (count: number) => (received: readonly Received[]): boolean => received.length === count;

function equal(actual: unknown, expected: unknown, what: string): void {
  if (String(actual) !== String(expected)) throw new Error(`${what}: ${String(actual)} instead of ${String(expected)}`);
}

/** Each writer's samples once, in order, marked as they were written; `from` its first number. */
function ordered(received: readonly Received[], what: string): void {
  const newest = new Map<number, number>();
  for (const { writer, sequence, mark } of received) {
    if (sequence <= (newest.get(writer) ?? 0)) throw new Error(`${what}: ${sequence} after ${newest.get(writer)}`);
    if (mark !== (sequence & 255)) throw new Error(`${what}: ${sequence} has the payload of ${mark}`);
    newest.set(writer, sequence);
  }
}

/** A publisher that has written `before` messages and a subscription that has read none of them. */
function pair(
  laboratory: Laboratory,
  { before = 0, length = 8, qos = {}, pages = 64 }: { before?: number; length?: number; qos?: Partial<EndpointQos>; pages?: number; } = {},
) {
  const world = new SceneWorld(laboratory, { pages });
  const a = world.join();
  const b = world.join();
  const pub = world.publisher(a, qos);
  const sub = world.subscription(b, qos);
  laboratory.now(laboratory.code.publish(a, pub, numbered(1, before, length), []));
  return { world, a, b, pub, sub, written: world.log<number>(), received: world.log<Received>() };
}

export const scenes: readonly ExploredScene[] = [
  {
    name: 'a message to a reader that is about to sleep',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory);
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(1, 2), written));
      world.process('reader', () => listen(b, sub, received, upTo(2)));
      world.finally(() => {
        equal(sequences(received), '1,2', 'received');
        world.closeAll([a, b]);
      });
      return world.run();
    },
  },
  {
    name: 'keep_last: the oldest sample is overwritten while it is read',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: ringSlots });
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(9, 2), written));
      world.process('reader', () => listen(b, sub, received, many(2)));
      world.finally(() => {
        ordered(received, 'received');
        equal(received.length, 2, 'samples');
        if (received[1]!.sequence > 4) throw new Error('a gap');
      });
      return world.run();
    },
  },
  {
    name: 'a ring grows while it is read',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: ringSlots, qos: { depth: 16 } });
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(9, 1), written));
      world.process('reader', () => listen(b, sub, received, many(2)));
      world.finally(() => equal(sequences(received), '1,2', 'received'));
      return world.run();
    },
  },
  {
    name: 'inline frames become wider while they are read',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: 2 });
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(3, 1, 120), written));
      world.process('reader', () => listen(b, sub, received, many(3)));
      world.finally(() => {
        equal(sequences(received), '1,2,3', 'received');
        world.closeAll([a, b]);
      });
      return world.run();
    },
  },
  {
    name: 'large messages take turns in few pages',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: 3, length: 2200, qos: { depth: 1 } });
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(4, 1, 2200), written));
      world.process('reader', () => listen(b, sub, received, upTo(4)));
      world.finally(() => {
        ordered(received, 'received');
        world.closeAll([a, b]);
      });
      return world.run();
    },
  },
  {
    name: 'keep_all: a writer waits for its reader',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: keepAllLimit, qos: keepAll });
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(keepAllLimit + 1, 1), written));
      world.process('reader', () => listen(b, sub, received, many(2)));
      world.finally(() => {
        equal(sequences(received), '1,2', 'received');
        equal(written, keepAllLimit + 1, 'written');
      });
      return world.run();
    },
  },
  {
    name: 'keep_all: a reader takes one sample and then waits for what its writer does next',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: keepAllLimit, qos: keepAll });
      const [next, nextSub] = [world.publisher(a, {}, '/next'), world.subscription(b, {}, '/next')];
      const after = world.log<Received>();
      const { publishThen, listenThen } = laboratory.code;
      world.process('writer', () => publishThen(a, pub, numbered(keepAllLimit + 1, 1), written, next));
      world.process('reader', () => listenThen(b, sub, received, many(1), nextSub, after));
      world.finally(() => {
        equal(sequences(received), '1', 'received');
        equal(written, keepAllLimit + 1, 'written');
        equal(sequences(after), '1', 'received after it');
        world.closeAll([a, b]);
      });
      return world.run();
    },
    limits: { interruptions: 1 },
  },
  {
    name: 'a reader appears while small messages are written',
    make: (laboratory) => appearing(laboratory, { before: ringSlots, length: 8, qos: {}, more: 1 }),
  },
  {
    name: 'a transient_local reader appears while small messages are written',
    make: (laboratory) => appearing(laboratory, { before: ringSlots, length: 8, qos: { ...transient, depth: 2 }, more: 1 }),
  },
  {
    name: 'a reader appears while large messages take turns',
    make: (laboratory) => appearing(laboratory, { before: 1, length: 2200, qos: {}, more: 3 }),
    limits: { interruptions: 2, focus: handovers },
  },
  {
    name: 'a reader appears while a ring is replaced',
    make: (laboratory) => appearing(laboratory, { before: 1, length: 8, qos: {}, more: 2, longer: 120 }),
    limits: { interruptions: 2, focus: handovers },
  },
  {
    name: 'a writer appears while its reader looks',
    make(laboratory) {
      const world = new SceneWorld(laboratory);
      const [a, b] = [world.join(), world.join()];
      const sub = world.subscription(b);
      const received = world.log<Received>();
      const { joinAndPublish, takeAsItComes } = laboratory.code;
      world.process('reader', () => takeAsItComes(b, sub, received));
      world.process('writer', () => joinAndPublish(a, world.describe(a, EndpointKind.publisher), numbered(1, 1)));
      world.finally(() => {
        equal(sequences(received), '1', 'received');
        world.closeAll([a, b]);
      });
      return world.run();
    },
  },
  {
    name: 'two threads of a reader look, but only one of them takes',
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: 1 });
      const { publish, listen, glance } = laboratory.code;
      const other = world.thread(b);
      world.process('writer', () => publish(a, pub, numbered(2, 2), written));
      world.process('taker', () => listen(b, sub, received, upTo(3)));
      world.process('other thread', () => glance(other, 2));
      world.finally(() => {
        equal(sequences(received), '1,2,3', 'received');
        world.closeAll([a, b]);
      });
      return world.run();
    },
    limits: { interruptions: 2, focus: signals },
  },
  {
    name: 'two writers, one reader',
    make(laboratory) {
      const world = new SceneWorld(laboratory);
      const [a, b, c] = [world.join(), world.join(), world.join()];
      const [one, two] = [world.publisher(a), world.publisher(b)];
      const sub = world.subscription(c);
      const { publish, listen } = laboratory.code;
      for (const [hands, pub] of [[a, one], [b, two]] as const) laboratory.now(publish(hands, pub, numbered(1, 1), []));
      const received = world.log<Received>();
      world.process('writer a', () => publish(a, one, numbered(2, 1), []));
      world.process('writer b', () => publish(b, two, numbered(2, 1), []));
      world.process('reader', () => listen(c, sub, received, many(4)));
      world.finally(() => {
        ordered(received, 'received');
        world.closeAll([a, b, c]);
      });
      return world.run();
    },
  },
  {
    name: 'a writer dies at every access, whatever its ring becomes',
    limits: { deaths: 1, interruptions: 0 },
    make: (laboratory) => dyingWriter(laboratory, { before: ringSlots, length: 8, qos: { depth: 16 }, more: 1 }),
  },
  {
    name: 'a writer dies at every access of its first message',
    limits: { deaths: 1, interruptions: 0 },
    make: (laboratory) => dyingWriter(laboratory, { before: 0, length: 8, qos: {}, more: 1 }),
  },
  {
    name: 'a writer of large messages dies at every access',
    limits: { deaths: 1, interruptions: 0 },
    make: (laboratory) => dyingWriter(laboratory, { before: 3, length: 2200, qos: { depth: 1 }, more: 1 }),
  },
  {
    name: 'a writer dies while its reader reads',
    limits: { deaths: 1, interruptions: 1, focus: handovers },
    make: (laboratory) => dyingWriter(laboratory, { before: 1, length: 8, qos: { depth: 2 }, more: 1 }),
  },
  {
    name: 'a terminated writer runs on while the next one begins',
    make(laboratory) {
      const { world, a, b, pub, sub, received } = pair(laboratory, { before: 1, length: 2200 });
      const c = world.join();
      const { publish, succeed, takeOne } = laboratory.code;
      const results = world.log<number>();
      const first = laboratory.now(takeOne(b, sub))!.writer;
      world.process('writer', () => publish(a, pub, numbered(2, 3, 2200), results));
      world.process('page and next', () => succeed(world.broker, a.participant, c, world.describe(c, EndpointKind.publisher), numbered(1, 2, 2200)));
      world.finally(() => {
        for (let sample = laboratory.now(takeOne(b, sub)); sample !== undefined; sample = laboratory.now(takeOne(b, sub))) received.push(sample);
        ordered(received, 'received');
        equal(sequences(received.filter(({ writer }) => writer !== first)), '1,2', 'of the next');
        laboratory.now(world.broker.gone(a.participant));
        world.closeAll([b, c]);
      });
      return world.run();
    },
  },
  {
    name: 'a reader dies at every access and its writer, which waits for it, goes on',
    limits: { deaths: 1, interruptions: 0 },
    make(laboratory) {
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: keepAllLimit, qos: keepAll });
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(keepAllLimit + 1, 2), written));
      const reader = world.process('reader', () => listen(b, sub, received, many(2)));
      world.mayDie(reader, b.participant);
      world.finally(() => {
        ordered(received, 'received');
        equal(written, [keepAllLimit + 1, keepAllLimit + 2], 'written');
        world.closeAll(world.died(reader) ? [a] : [a, b]);
      });
      return world.run();
    },
  },
  {
    name: 'a participant dies while it joins and leaves the graph',
    limits: { deaths: 1, interruptions: 0 },
    make(laboratory) {
      const world = new SceneWorld(laboratory);
      const [a, b] = [world.join(), world.join()];
      const sub = world.subscription(b);
      const { link, node } = a;
      const mortal = world.process('joiner', () => laboratory.code.comeAndGo(a, node, world.describe(a, EndpointKind.publisher)));
      world.mayDie(mortal, a.participant);
      world.process('witness', () => laboratory.code.awaitAlone(b, sub));
      world.finally(() => {
        const graph = laboratory.now(b.link.graph());
        equal(graph.nodes.map(({ name }) => name), [`n${b.participant}`], 'nodes');
        equal(graph.endpoints.length, 1, 'endpoints');
        world.closeAll([b]);
        if (!world.died(mortal)) laboratory.now(laboratory.code.bury(world.broker, link.participant));
      });
      return world.run();
    },
  },
  {
    name: 'the page looks at the newest message while it is overwritten',
    make(laboratory) {
      const world = new SceneWorld(laboratory);
      const a = world.join();
      const pub = world.publisher(a, { depth: 1 });
      const { publish, Sampler } = laboratory.code;
      laboratory.now(publish(a, pub, numbered(1, ringSlots), []));
      const sampler = new Sampler(world.broker);
      laboratory.now(sampler.sample(0));
      world.keep(sampler);
      const seen = world.log<{ bytes: Uint8Array; } | undefined>();
      world.process('writer', () => publish(a, pub, numbered(9, 9), []));
      world.process('page', () => laboratory.code.look(sampler, '/x', seen));
      world.finally(() => {
        for (const last of seen) {
          if (last === undefined) throw new Error('nothing seen');
          if (last.bytes.length !== 8 || last.bytes.some((byte) => byte !== last.bytes[0])) throw new Error(`torn: ${last.bytes.join()}`);
        }
      });
      return world.run();
    },
  },
  {
    name: 'a request and its reply',
    make(laboratory) {
      const world = new SceneWorld(laboratory);
      const [a, b] = [world.join(), world.join()];
      const client = world.create(a, EndpointKind.client);
      const server = world.create(b, EndpointKind.server);
      const answers = world.log<Received>();
      world.process('client', () => laboratory.code.ask(a, client, answers));
      world.process('server', () => laboratory.code.serveOnce(b, server));
      world.finally(() => {
        equal(sequences(answers), '1', 'answers');
        world.closeAll([a, b]);
      });
      return world.run();
    },
  },
  {
    name: 'two writers take pages from one bus, which grows',
    limits: { interruptions: 1 },
    make(laboratory) {
      const world = new SceneWorld(laboratory, { pages: 96 });
      const [a, b, c] = [world.join(), world.join(), world.join()];
      const [one, two] = [world.publisher(a, {}, '/a'), world.publisher(b, {}, '/b')];
      const [first, second] = [world.subscription(c, {}, '/a'), world.subscription(c, {}, '/b')];
      const { publish, takeOne } = laboratory.code;
      // 76 pages are there at first; the memory grows by 16 at a time.
      const rest = world.occupy(72);
      const written = [world.log<number>(), world.log<number>()];
      world.process('writer a', () => publish(a, one, numbered(1, 1, 5000), written[0]!));
      world.process('writer b', () => publish(b, two, numbered(1, 1, 9000), written[1]!));
      world.finally(() => {
        equal(written.join(), '1,1', 'written');
        equal(laboratory.now(takeOne(c, first))?.length, 5000, 'a');
        equal(laboratory.now(takeOne(c, second))?.length, 9000, 'b');
        rest();
        world.closeAll([a, b, c]);
      });
      return world.run();
    },
  },
  {
    name: 'the ninth writer makes a reader move its places, while a keep_all writer waits for it',
    make: (laboratory) => ninthWriter(laboratory, false),
  },
  {
    name: 'a reader dies at every access while the ninth writer makes it move its places',
    limits: { deaths: 1, interruptions: 0 },
    make: (laboratory) => ninthWriter(laboratory, true),
  },
  {
    name: 'at the ceiling a keep_all writer waits until its reader gives pages back',
    make(laboratory) {
      const length = 2100;
      const { world, a, b, pub, sub, written, received } = pair(laboratory, { before: 4, length, qos: keepAll });
      const rest = world.occupy(64 - 5 - 4);
      const { publish, listen } = laboratory.code;
      world.process('writer', () => publish(a, pub, numbered(5, 2, length), written));
      world.process('reader', () => listen(b, sub, received, many(3)));
      world.finally(() => {
        equal(sequences(received), '1,2,3', 'received');
        equal(written, '5,6', 'written');
        rest();
        world.closeAll([a, b]);
      });
      return world.run();
    },
  },
];

/** Where readers and writers tell each other what they hold: the graph's version, hazards, slots, frames. */
function handovers(word: number): boolean {
  if (word === BusHeader.graphVersion) return true;
  const at = word - (sceneLayout.endpoints >> 2);
  if (word >= sceneLayout.pages >> 2) return (word & 7) === 0;
  const field = at % (BusSizes.endpoint >> 2);
  return at >= 0 && (field === BusEndpoint.hazard || field === BusEndpoint.state);
}

/** Where writers and readers tell each other that there is something to read. */
function signals(word: number): boolean {
  const field = (word - (sceneLayout.endpoints >> 2)) % (BusSizes.endpoint >> 2);
  if (word < sceneLayout.endpoints >> 2 || word >= sceneLayout.pages >> 2) return false;
  return field === BusEndpoint.signal || field === BusEndpoint.drained || field === BusEndpoint.head;
}

/** A reader becomes visible while a writer writes, which then leaves. */
function appearing(
  laboratory: Laboratory,
  { before, length, qos, more, longer = length }: { before: number; length: number; qos: Partial<EndpointQos>; more: number; longer?: number; },
): Run {
  const world = new SceneWorld(laboratory);
  const [a, b] = [world.join(), world.join()];
  const pub = world.publisher(a, qos);
  const { publish, publishAndLeave, joinAndListen } = laboratory.code;
  laboratory.now(publish(a, pub, numbered(1, before, length), []));
  const [received, written, promised] = [world.log<Received>(), world.log<number>(), world.log<number>()];
  world.process('writer', () => publishAndLeave(a, pub, numbered(before + 1, more, longer), written));
  const reader = world.process('reader', () => joinAndListen(b, world.describe(b, EndpointKind.subscription, qos), received, written, promised));
  // It has noted where the writer stands and is about to become visible.
  world.leads(reader, world.broker.bus.endpointWord(1) + BusEndpoint.state);
  world.finally(() => {
    ordered(received, 'received');
    // The reader must receive each message whose write began after the reader was there.
    const first = before + (promised[0] ?? more) + 2;
    const got = new Set(received.map((sample) => sample.sequence));
    for (let sequence = first; sequence <= before + more; sequence += 1) {
      if (!got.has(sequence)) throw new Error(`${sequence} is lost: received ${sequences(received)}`);
    }
    world.closeAll([a, b]);
  });
  return world.run();
}

/** A reader has eight writers in its entry; the ninth takes its places to a page of its own. The first writer waits for the reader. */
function ninthWriter(laboratory: Laboratory, mayDie: boolean): Run {
  const world = new SceneWorld(laboratory, { endpoints: 16 });
  const [a, b] = [world.join(), world.join()];
  const sub = world.subscription(b, keepAll);
  const pubs = Array.from({ length: 9 }, () => world.publisher(a, keepAll));
  const { publish, listen, takeOne } = laboratory.code;
  for (const pub of pubs.slice(0, 8)) laboratory.now(publish(a, pub, numbered(1, 1), []));
  for (let i = 0; i < 8; i += 1) laboratory.now(takeOne(b, sub));
  laboratory.now(publish(a, pubs[8]!, numbered(1, 1), []));
  laboratory.now(publish(a, pubs[0]!, numbered(2, keepAllLimit), []));
  const [received, written] = [world.log<Received>(), world.log<number>()];
  world.process('writer', () => publish(a, pubs[0]!, numbered(keepAllLimit + 2, 1), written));
  const reader = world.process('reader', () => listen(b, sub, received, many(3)));
  if (mayDie) world.mayDie(reader, b.participant);
  world.finally(() => {
    const died = world.died(reader);
    if (!died) equal(sequences(received), '1,2,3', 'received');
    equal(written, keepAllLimit + 2, 'written');
    world.closeAll(died ? [a] : [a, b]);
  });
  return world.run();
}

/** A writer that may die; its reader reads what is there and learns that it is alone. */
function dyingWriter(
  laboratory: Laboratory,
  { before, length, qos, more }: { before: number; length: number; qos: Partial<EndpointQos>; more: number; },
): Run {
  const { world, a, b, pub, sub, written, received } = pair(laboratory, { before, length, qos });
  const { publishAndLeave, listen } = laboratory.code;
  const writer = world.process('writer', () => publishAndLeave(a, pub, numbered(before + 1, more, length), written));
  world.mayDie(writer, a.participant);
  world.process('reader', () => listen(b, sub, received, () => false));
  world.finally(() => {
    ordered(received, 'received');
    const depth = qos.depth ?? ringSlots;
    const last = received.at(-1)?.sequence ?? 0;
    if (last < before + written.length) throw new Error(`${before + written.length} was written, ${last} received`);
    if (depth > before) equal(received.length, last, 'samples');
    world.closeAll(world.died(writer) ? [b] : [a, b]);
  });
  return world.run();
}
