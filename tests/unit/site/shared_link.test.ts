// Corners of the shared link, with all participants in one thread.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BusPhase, Durability, EndpointKind, ErrorCode, History, StatusKind } from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import type { BusOptions } from '../../../runtime/site/bus/bus.ts';
import { defaultQos, type EndpointQos } from '../../../runtime/site/contract/qos.ts';
import { SharedLink } from '../../../runtime/site/bus/shared_link.ts';

const { publisher, subscription, client, server } = EndpointKind;
const payloadAt = 64;
const length = 8;
const keepAll = { history: History.keepAll };

class Participant {
  readonly link: SharedLink;
  readonly index: number;
  readonly heap: { readonly u8: Uint8Array; readonly i32: Int32Array; };
  private readonly node: number;

  constructor(broker: SharedBroker) {
    this.index = broker.bus.claimParticipant();
    this.link = new SharedLink({ bus: broker.bus, participant: this.index, mayBlock: true });
    this.node = this.link.nodeCreate(`n${this.index}`, '/');
    const buffer = new ArrayBuffer(4096);
    this.heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  }

  make(kind: number, qos: Partial<EndpointQos> = {}, type = 't'): number {
    return this.link.endpointCreate({
      kind,
      node: this.node,
      name: '/x',
      type,
      hash: '',
      flags: 0,
      qos: { ...defaultQos, ...qos },
    });
  }

  write(endpoint: number): number {
    this.heap.i32.fill(0, 0, 16);
    return this.link.write(endpoint, this.heap, payloadAt, length, 0);
  }

  take(endpoint: number): number {
    return this.link.take(endpoint, this.heap, payloadAt, 1000, 0);
  }
}

/** Runs `use` with a broker and `count` participants. */
function among(count: number, use: (broker: SharedBroker, people: Participant[]) => void, options: BusOptions = {}): void {
  const broker = new SharedBroker({ ceiling: 64 << 20, ...options });
  try {
    use(broker, Array.from({ length: count }, () => new Participant(broker)));
  } finally {
    broker.close();
  }
}

test('a keep_last subscription in another node limits no keep_all publisher', () => {
  among(2, (_, [a, b]) => {
    const pub = a!.make(publisher, keepAll);
    a!.make(subscription, keepAll);
    b!.make(subscription);
    for (let i = 0; i < 10_000; i += 1) assert.equal(a!.write(pub), 0, `write ${i}`);
  });
});

test('a flood is one event for its reader, and the next message after it was drained is one more', () => {
  among(2, (_, [a, b]) => {
    const pub = a!.make(publisher, { depth: 200 });
    const sub = b!.make(subscription, { depth: 200 });
    assert.equal(a!.write(pub), 0);
    assert.deepEqual(b!.link.ready(), [sub]);
    assert.equal(b!.take(sub), length);
    assert.deepEqual(b!.link.ready(), []);
    const before = b!.link.wakeToken();
    for (let i = 0; i < 100; i += 1) assert.equal(a!.write(pub), 0);
    assert.equal(b!.link.wakeToken() - before, 1);
    for (let i = 0; i < 100; i += 1) {
      assert.deepEqual(b!.link.ready(), [sub]);
      assert.equal(b!.take(sub), length);
    }
    assert.equal(b!.take(sub), ErrorCode.nothing);
    assert.deepEqual(b!.link.ready(), []);
    assert.equal(b!.link.wakeToken() - before, 1);
    assert.equal(a!.write(pub), 0);
    assert.equal(b!.link.wakeToken() - before, 2);
    assert.deepEqual(b!.link.ready(), [sub]);
  });
});

test('wrong types are no incompatible QoS, and who comes again counts again', () => {
  among(2, (_, [a, b]) => {
    const pub = a!.make(publisher);
    const policies = { durability: Durability.transientLocal };
    b!.make(subscription, {}, 'another');
    const incompatible = (): number | undefined => a!.link.status(pub, StatusKind.offeredQosIncompatible)?.totalCount;
    assert.equal(incompatible(), 0);
    for (let times = 1; times <= 3; times += 1) {
      const other = b!.make(subscription, policies);
      assert.equal(incompatible(), times);
      b!.link.endpointDestroy(other);
      assert.equal(incompatible(), times);
    }
    assert.equal(a!.link.status(pub, StatusKind.publisherIncompatibleType)?.totalCount, 1);
  });
});

test('a deadline goes on when a publisher is replaced while its reader is busy', () => {
  among(3, (_, [reader, first, second]) => {
    const deadline = { deadline: 1_000_000n };
    const sub = reader!.make(subscription, deadline);
    const missed = (): number => reader!.link.status(sub, StatusKind.requestedDeadlineMissed)!.totalCount;
    const one = first!.make(publisher, deadline);
    assert.equal(missed(), 0);
    first!.write(one);
    first!.link.endpointDestroy(one);
    second!.write(second!.make(publisher, deadline));
    const before = missed();
    assert.equal(reader!.link.matched(sub), 1);
    for (let looks = 0; looks < 5000 && missed() === before; looks += 1) reader!.link.sleep(1);
    assert.ok(missed() > before, 'nothing is missed any more');
  });
});

test('a destroyed server is freed though another client has never looked', () => {
  among(3, ({ bus }, [a, b, c]) => {
    const silent = c!.make(client);
    const asking = b!.make(client);
    const srv = a!.make(server);
    assert.equal(b!.write(asking), 0);
    assert.equal(a!.take(srv), length);
    assert.equal(a!.link.write(srv, a!.heap, payloadAt, length, 0), 0);
    assert.equal(b!.take(asking), length);
    assert.equal(c!.link.matched(silent), 1);
    a!.link.endpointDestroy(srv);
    assert.equal(Atomics.load(bus.i32, bus.endpointWord(srv)), BusPhase.free);
  });
});

test('a reply that waits for its client keeps a destroyed server', () => {
  among(2, ({ bus }, [a, b]) => {
    const asking = b!.make(client);
    const srv = a!.make(server);
    assert.equal(b!.write(asking), 0);
    assert.equal(a!.take(srv), length);
    assert.equal(a!.link.write(srv, a!.heap, payloadAt, length, 0), 0);
    a!.link.endpointDestroy(srv);
    assert.equal(Atomics.load(bus.i32, bus.endpointWord(srv)) & 255, BusPhase.departed);
    assert.equal(b!.take(asking), length);
    assert.equal(b!.take(asking), ErrorCode.nothing);
    b!.link.endpointDestroy(asking);
    assert.equal(a!.link.matched(srv), ErrorCode.badHandle);
    assert.equal(Atomics.load(bus.i32, bus.endpointWord(srv)), BusPhase.free);
  });
});

test('without memory for its places a reader is refused, or reads nothing, and leaves nothing behind', () => {
  const small = { participants: 8, nodes: 8, endpoints: 32, graphLog: 64, ceiling: 1 << 20 };
  among(2, ({ bus }, [a, b]) => {
    const others = 99;
    const sub = b!.make(subscription);
    const pubs = Array.from({ length: 9 }, () => a!.make(publisher));
    for (const pub of pubs) assert.equal(a!.write(pub), 0);
    while (bus.allocate(1, others) >= 0);
    assert.equal(b!.make(subscription), ErrorCode.outOfMemory);
    const claimed = Array.from({ length: 32 }, (_, i) => Atomics.load(bus.i32, bus.endpointWord(i)) & 255);
    assert.equal(claimed.filter((phase) => phase === BusPhase.claimed).length, 0);
    const { used } = bus.usage();
    // The default depth is 10: all nine are wanted, and eight have a place.
    for (let i = 0; i < 8; i += 1) assert.equal(b!.take(sub), length);
    assert.equal(b!.take(sub), ErrorCode.nothing);
    assert.equal(bus.usage().used, used);
    bus.freeAll(others);
    a!.write(pubs[8]!);
    assert.equal(b!.take(sub), length);
    assert.equal(b!.take(sub), length);
    assert.equal(b!.take(sub), ErrorCode.nothing);
  }, small);
});
