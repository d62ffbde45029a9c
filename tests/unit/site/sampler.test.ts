// The values of a topic that remain when its publishers leave, seen through a link that the test controls.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { type Broker, PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { PortLink } from '../../../runtime/site/bus/port_link.ts';
import type { WriterSample } from '../../../runtime/site/bus/port_messages.ts';
import { defaultQos } from '../../../runtime/site/contract/qos.ts';
import { Sampler } from '../../../runtime/site/bus/sampler.ts';
import { SharedLink } from '../../../runtime/site/bus/shared_link.ts';

const qos = { reliability: 1, durability: 2, history: 1, depth: 10 };
const lookMs = 250;

class Scene {
  readonly sampler: Sampler;
  private readonly records = new Map<number, object>();
  private readonly samples = new Map<number, WriterSample>();
  asked: readonly string[] = [];
  now = 1000;

  constructor() {
    const link = {
      kind: 'port',
      records: () => [...this.records.values()],
      sampled: () => this.samples,
      samples: { departed: () => [] },
      requestSamples: (topics: readonly string[]) => {
        this.asked = topics;
      },
    };
    this.sampler = new Sampler({ kind: 'port', link } as unknown as Broker);
  }

  join(key: number, type = 'a/msg/A', kind: EndpointKind = EndpointKind.publisher): void {
    this.records.set(key, { key, kind, name: '/topic', type, qos });
  }

  wrote(key: number, count: number, copied = true): void {
    const payload = copied ? Uint8Array.of(key, count) : undefined;
    this.samples.set(key, { key, count, bytes: 2 * count, time: this.now, payload });
  }

  leave(key: number): void {
    this.records.delete(key);
    this.samples.delete(key);
  }

  look() {
    this.now += lookMs;
    return this.sampler.sample(this.now)[0];
  }

  last(): readonly number[] | undefined {
    const message = this.sampler.lastMessage('/topic', this.now);
    return message === undefined ? undefined : [...message.bytes, message.count];
  }
}

test('the count goes on when one of two publishers leaves, and the rate does not jump', () => {
  const scene = new Scene();
  scene.join(1);
  scene.join(2);
  for (let n = 1; n <= 10; n += 1) {
    scene.wrote(1, n);
    scene.wrote(2, n);
    scene.look();
  }
  scene.leave(1);
  for (let n = 11; n <= 20; n += 1) {
    scene.wrote(2, n);
    const topic = scene.look();
    assert.deepEqual([topic?.publishers, topic?.count], [1, 10 + n]);
    assert.ok((topic?.rateHz ?? 0) <= 8 && (topic?.rateHz ?? 0) >= 4, `${topic?.rateHz} Hz`);
  }
  assert.deepEqual(scene.last(), [2, 20, 30]);
});

test('without a publisher there is no rate, but what was; a new one goes on from there', () => {
  const scene = new Scene();
  scene.join(1);
  for (let n = 1; n <= 8; n += 1) {
    scene.wrote(1, n);
    scene.look();
  }
  scene.leave(1);
  const alone = scene.look();
  assert.deepEqual([alone?.publishers, alone?.count, alone?.rateHz, alone?.qos.length], [0, 8, 0, 1]);
  assert.deepEqual(scene.last(), [1, 8, 8]);
  scene.now += 60_000;
  scene.join(1);
  assert.deepEqual([scene.look()?.count, scene.last()], [8, [1, 8, 8]]);
  for (let n = 1; n <= 3; n += 1) {
    scene.wrote(1, n);
    scene.look();
  }
  const again = scene.look();
  assert.equal(again?.count, 11);
  assert.equal(Math.round(again?.rateHz ?? 0), 4);
  assert.deepEqual(scene.last(), [1, 3, 11]);
});

test('a topic on which nothing was published goes; one that comes again with another type begins anew', () => {
  const scene = new Scene();
  scene.join(1, 'a/msg/A', EndpointKind.subscription);
  assert.equal(scene.look()?.subscriptions, 1);
  scene.leave(1);
  assert.equal(scene.look(), undefined);
  scene.join(2);
  scene.wrote(2, 5);
  scene.look();
  scene.leave(2);
  assert.equal(scene.look()?.count, 5);
  scene.join(3, 'b/msg/B');
  const other = scene.look();
  assert.deepEqual([other?.type, other?.count, scene.last()], ['b/msg/B', 0, undefined]);
});

test('a message that nobody copied is not replaced by an older one', () => {
  const scene = new Scene();
  scene.join(1);
  scene.wrote(1, 1);
  scene.look();
  scene.wrote(1, 2, false);
  assert.equal(scene.look()?.count, 2);
  assert.equal(scene.last(), undefined);
  scene.look();
  assert.deepEqual(scene.asked, ['/topic']);
  scene.wrote(1, 2);
  assert.deepEqual(scene.last(), [1, 2, 2]);
  scene.leave(1);
  assert.equal(scene.look()?.count, 2);
  assert.deepEqual(scene.last(), [1, 2, 2]);
});

/** A program on the shared link that publishes and ends. */
class Program {
  readonly participant: number;
  readonly link: SharedLink;
  private readonly broker: SharedBroker;
  private readonly node: number;
  private readonly heap: { readonly u8: Uint8Array; readonly i32: Int32Array; };

  constructor(broker: SharedBroker) {
    this.broker = broker;
    this.participant = broker.bus.claimParticipant();
    this.link = new SharedLink({ bus: broker.bus, participant: this.participant, mayBlock: false });
    this.node = this.link.nodeCreate('n', '/');
    const buffer = new ArrayBuffer(256);
    this.heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  }

  publisher(name: string): number {
    return this.link.endpointCreate({ kind: EndpointKind.publisher, node: this.node, name, type: 't', hash: '', qos: defaultQos, flags: 0 });
  }

  write(publisher: number, ...bytes: number[]): void {
    for (const byte of bytes) {
      this.heap.i32.fill(0, 0, 16);
      this.heap.u8[64] = byte;
      assert.equal(this.link.write(publisher, this.heap, 64, 1, 0), 0);
    }
  }

  /** As the page does it, which looks when the program is out of the graph. */
  ends(sampler: Sampler, now: number): void {
    this.broker.end(this.participant);
    sampler.sample(now);
    this.broker.gone(this.participant);
  }
}

for (const how of ['exits', 'destroys its publisher and exits', 'is killed'] as const) {
  test(`all that a program published between two looks counts when it ${how}`, () => {
    const broker = new SharedBroker({ ceiling: 64 << 20 });
    const sampler = new Sampler(broker);
    const program = new Program(broker);
    const publisher = program.publisher('/topic');
    program.write(publisher, 1, 2, 3);
    let now = Date.now();
    assert.equal(sampler.sample(now)[0]?.count, 3);
    program.write(publisher, 4, 5);
    const brief = program.publisher('/brief');
    program.write(brief, 9);
    if (how.startsWith('destroys')) { for (const each of [publisher, brief]) program.link.endpointDestroy(each); }
    if (how !== 'is killed') program.link.close();
    program.ends(sampler, now += 1);
    for (let looks = 0; looks < 3; looks += 1) {
      const views = sampler.sample(now += lookMs);
      assert.deepEqual(views.map(({ name, count, publishers }) => [name, count, publishers]), [['/brief', 1, 0], ['/topic', 5, 0]]);
      assert.deepEqual(['/brief', '/topic'].map((name) => sampler.lastMessage(name, now)?.bytes[0]), [9, 5]);
    }
    assert.equal(broker.bus.usage().used, 0);
    broker.close();
  });
}

test('who makes and destroys publishers without end keeps no more than a few', () => {
  const broker = new SharedBroker({ ceiling: 64 << 20 });
  const program = new Program(broker);
  for (let i = 0; i < 200; i += 1) {
    const publisher = program.publisher('/topic');
    program.write(publisher, 1);
    program.link.endpointDestroy(publisher);
    assert.ok(broker.bus.usage().used <= 17, `${broker.bus.usage().used} pages`);
  }
  const sampler = new Sampler(broker);
  program.link.close();
  program.ends(sampler, Date.now());
  assert.equal(broker.bus.usage().used, 0);
  broker.close();
});

test('on message ports, too, all that a program published counts when it exits', { timeout: 60_000 }, async () => {
  const broker = new PortBroker();
  const { link: page } = broker;
  const sampler = new Sampler(broker);
  const { participant, ticket } = broker.admit()!;
  assert.ok(ticket.kind === 'port');
  const link = new PortLink(ticket);
  const publisher = link.endpointCreate({
    kind: EndpointKind.publisher,
    node: link.nodeCreate('n', '/'),
    name: '/topic',
    type: 't',
    hash: '',
    qos: defaultQos,
    flags: 0,
  });
  const endpoints = async (count: number): Promise<void> => {
    while (page.graph().endpoints.length !== count) await page.wait(page.wakeToken(), 1000);
  };
  await endpoints(1);
  let now = Date.now();
  sampler.sample(now);
  const buffer = new ArrayBuffer(256);
  const heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  for (let byte = 1; byte <= 7; byte += 1) {
    heap.i32.fill(0, 0, 16);
    heap.u8[64] = byte;
    assert.equal(await link.write(publisher, heap, 64, 1, 0), 0);
  }
  link.close();
  await endpoints(0);
  broker.end(participant, true);
  for (let looks = 0; looks < 4; looks += 1) {
    const [topic] = sampler.sample(now += lookMs);
    assert.deepEqual([topic?.count, topic?.publishers, sampler.lastMessage('/topic', now)?.bytes[0]], [7, 0, 7]);
  }
  broker.close();
});
