// A program that writes junk into the memory of the bus: what it says may be wrong then, and messages may be lost, but
// nobody who reads there hangs, fails, or takes memory without end. Each round is a random attack, repeated by its seed.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BusEndpoint, BusHeader, BusSizes, BusTime, EndpointKind, ErrorCode, frameHeaderSize, History } from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { SiteClock } from '../../../runtime/site/bus/clock.ts';
import { graphView } from '../../../runtime/site/bus/graph_view.ts';
import type { Heap } from '../../../runtime/site/bus/link.ts';
import { defaultQos, type EndpointQos } from '../../../runtime/site/contract/qos.ts';
import { Sampler } from '../../../runtime/site/bus/sampler.ts';
import { SharedLink } from '../../../runtime/site/bus/shared_link.ts';
import { slotWord } from '../../../runtime/site/bus/shared_ring.ts';

const watchdog = { timeout: 240_000 };
const rounds = 400;
/** Upper bound for one call, in ms: a loop whose length is a junk number would take minutes. */
const longestMs = 2000;
const room = 4096;

/** Numbers that look random and are the same each time (mulberry32). */
function randomOf(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return (t ^ (t >>> 14)) >>> 0;
  };
}

class Scene {
  readonly broker = new SharedBroker({ ceiling: 32 << 20, participants: 16, nodes: 32, endpoints: 64, graphLog: 64, session: [1, 2] });
  readonly sampler = new Sampler(this.broker);
  readonly a: SharedLink;
  readonly b: SharedLink;
  readonly writers: readonly number[];
  readonly readers: readonly number[];
  private readonly heap: Heap;

  constructor() {
    this.a = this.join();
    this.b = this.join();
    const make = (link: SharedLink, kind: number, name: string, qos: Partial<EndpointQos>): number =>
      link.endpointCreate({
        kind,
        node: link.nodeCreate('n', '/'),
        name,
        type: 't/msg/T',
        hash: '',
        flags: 0,
        qos: { ...defaultQos, ...qos },
      });
    const all = { history: History.keepAll };
    this.writers = [make(this.a, EndpointKind.publisher, '/x', {}), make(this.a, EndpointKind.publisher, '/y', all),
      make(this.a, EndpointKind.client, '/s', {})];
    this.readers = [make(this.b, EndpointKind.subscription, '/x', {}), make(this.b, EndpointKind.subscription, '/y', all),
      make(this.b, EndpointKind.server, '/s', {})];
    const buffer = new ArrayBuffer(frameHeaderSize + room);
    this.heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  }

  private join(): SharedLink {
    const admission = this.broker.admit();
    assert.ok(admission?.ticket.kind === 'shared');
    return new SharedLink({ bus: this.broker.bus, participant: admission.participant, mayBlock: false });
  }

  /** The actions of the other participants, again and again. Each call is an action by itself. */
  *actions(): Generator<() => unknown> {
    const { a, b, broker: { link }, sampler, heap } = this;
    for (const length of [8, 600, room]) {
      for (const writer of this.writers) {
        yield () => {
          heap.i32.fill(0, 0, 16);
          return a.write(writer, heap, frameHeaderSize, length, 0);
        };
      }
      yield () => b.ready();
      for (const reader of this.readers) {
        for (let i = 0; i < 4; i += 1) {
          yield () => {
            const taken = b.take(reader, heap, frameHeaderSize, room, 0);
            assert.ok(taken < 0 || taken <= 1 << 30, `a message of ${taken} bytes`);
            return taken;
          };
        }
      }
      yield () => sampler.sample(Date.now());
      yield () => sampler.lastMessage('/x', Date.now());
      yield () =>
        JSON.stringify(graphView(link.graphReplica.nodes.values(), link.records(), () => 'n'), (_key, value: unknown) =>
          typeof value === 'bigint' ? String(value) : value);
      yield () => [a.graph(), b.graph(), a.matched(this.writers[0]!), b.statusVersion()];
    }
  }
}

/** Where the attack writes: words of one structure, or of any. */
function junk(scene: Scene, random: () => number): void {
  const { broker: { bus } } = scene;
  const { i32 } = bus;
  // The first words say where the tables are, and each thread reads them once, when it begins.
  const header = BusHeader.graphVersion;
  const endpoint = bus.endpointWord(random() % 8);
  const places: readonly (readonly [number, number])[] = [
    [header, (BusHeader.size >> 2) - header],
    [endpoint, BusSizes.endpoint >> 2],
    [endpoint + BusEndpoint.head, 1],
    [endpoint + BusEndpoint.ring, 1],
    [endpoint + BusEndpoint.table, 1],
    [endpoint + BusEndpoint.generation, 1],
    [endpoint, 1],
    [bus.participantWord(random() % 8), BusSizes.participant >> 2],
    [bus.nodeWord(random() % 8), BusSizes.node >> 2],
    [bus.pageOffset(0) >> 2, (64 * BusSizes.page) >> 2],
    [bus.pageOffset(0) >> 2, 64],
    [bus.graphLog, bus.graphLogMask + 1],
    [bus.pageOffset(0) / 4 - 4096, 4096],
  ];
  const [from, count] = places[random() % places.length]!;
  const values = [0, 1, -1, 0x7fffffff, -0x80000000, random() | 0, random() % 4096, (random() % 64) << 20];
  const times = 1 + random() % 40;
  for (let i = 0; i < times; i += 1) {
    const at = from + random() % count;
    if (at >= 8 && at < i32.length) Atomics.store(i32, at, values[random() % values.length]!);
  }
  // So that all look at the tables again.
  if (random() % 2 === 0) Atomics.add(i32, BusHeader.graphVersion, 1 + random() % 200);
}

// Guarantee, hostile input: junk in the shared memory of the bus makes no reader, writer or page hang or fail; messages may be lost
test('whatever stands in the memory of the bus, whoever reads it goes on', watchdog, () => {
  for (let seed = 1; seed <= rounds; seed += 1) {
    const random = randomOf(seed);
    const scene = new Scene();
    for (const act of scene.actions()) act();
    for (let attack = 0; attack < 4; attack += 1) {
      junk(scene, random);
      let step = 0;
      for (const act of scene.actions()) {
        const begin = performance.now();
        try {
          act();
        } catch (error) {
          throw new Error(`seed ${seed}, attack ${attack}, step ${step}: ${error instanceof Error ? error.stack : String(error)}`, { cause: error });
        }
        const took = performance.now() - begin;
        assert.ok(took < longestMs, `seed ${seed}, attack ${attack}, step ${step} took ${took} ms`);
        step += 1;
      }
    }
    scene.broker.end(scene.a.participant);
    scene.broker.gone(scene.a.participant);
    scene.broker.close();
  }
});

test('a law of time that nobody finishes to write holds up nobody', watchdog, () => {
  const { broker } = new Scene();
  const clock = new SiteClock(broker.bus);
  const before = clock.steadyNs();
  Atomics.store(broker.bus.i32, BusHeader.siteTime + BusTime.version, 7);
  const begin = performance.now();
  for (let i = 0; i < 1000; i += 1) assert.ok(clock.steadyNs() >= before);
  assert.ok(performance.now() - begin < longestMs);
  // The next law counts.
  Atomics.store(broker.bus.i32, BusHeader.siteTime + BusTime.version, 8);
  broker.setTime({ realNs: 0, siteNs: 0, rate: 1, limitNs: 5 });
  assert.equal(clock.law().limitNs, 5);
  broker.close();
});

test('a message whose length was written over is lost, and the next one comes', watchdog, () => {
  const scene = new Scene();
  const { a, b, broker: { bus } } = scene;
  const buffer = new ArrayBuffer(frameHeaderSize + room);
  const heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  const [writer, reader] = [scene.writers[0]!, scene.readers[0]!];
  const send = (value: number): void => {
    heap.i32.fill(0);
    heap.u8[frameHeaderSize] = value;
    assert.equal(a.write(writer, heap, frameHeaderSize, 4, 0), 0);
  };
  for (const length of [0x7fffffff, -1, 1 << 29]) {
    send(1);
    const word = bus.endpointWord(writer);
    const ring = bus.i32[word + BusEndpoint.ring]!;
    const head = bus.i32[word + BusEndpoint.head]!;
    bus.i32[slotWord(bus, ring, head) + 2] = length;
    send(2);
    assert.deepEqual(b.ready(), [reader]);
    assert.equal(b.take(reader, heap, frameHeaderSize, room, 0), 4);
    assert.equal(heap.u8[frameHeaderSize], 2);
    assert.equal(b.take(reader, heap, frameHeaderSize, room, 0), ErrorCode.nothing);
  }
  scene.broker.close();
});
