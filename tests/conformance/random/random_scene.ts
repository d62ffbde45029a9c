// One random scene on the shared link: participants come, make endpoints, write, take, leave and die, call by call, and
// each result is what the model says. Nothing may stay behind on the bus.

import {
  Durability, EndpointKind, ErrorCode, flagIgnoreLocal, History, Reliability, SampleInfoLayout,
} from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker } from '../../../runtime/wasm_js/broker.ts';
import { Bus } from '../../../runtime/wasm_js/bus.ts';
import { defaultQos, type EndpointQos } from '../../../runtime/wasm_js/qos.ts';
import { SharedLink } from '../../../runtime/wasm_js/shared_link.ts';
import { type Generator } from './generator.ts';
import { Model, type ModelEndpoint, type ModelSample } from './model.ts';

interface Held {
  readonly model: ModelEndpoint;
  readonly handle: number;
  /** Requests that a server has not answered yet. */
  readonly asked: ModelSample[];
}

interface Participant {
  readonly index: number;
  readonly link: SharedLink;
  readonly node: number;
  readonly held: Held[];
}

const most = { participants: 6, endpoints: 24 };
const names = ['/a', '/b'];
const largest = [1, 60, 64, 200, 2048, 2049, 9000, 60_000];
const payloadAt = 64;

function randomQos(random: Generator): EndpointQos {
  return {
    ...defaultQos,
    reliability: random.chance(70) ? Reliability.reliable : Reliability.bestEffort,
    durability: random.chance(60) ? Durability.volatile : Durability.transientLocal,
    history: random.chance(75) ? History.keepLast : History.keepAll,
    depth: random.pick([0, 1, 2, 3, 8, 9, 40]),
  };
}

export class RandomScene {
  private readonly random: Generator;
  private readonly broker = new SharedBroker({ participants: 16, nodes: 16, endpoints: 64, graphLog: 64, ceiling: 32 << 20 });
  private readonly model = new Model();
  private readonly people: Participant[] = [];
  /** Third words of the gids. */
  private readonly keys = new Map<ModelEndpoint, number>();
  private readonly heap: { u8: Uint8Array; i32: Int32Array };
  /** What was done, for the one who reads a failure. */
  readonly story: string[] = [];

  constructor(random: Generator) {
    this.random = random;
    const buffer = new ArrayBuffer(1 << 16);
    this.heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  }

  run(steps: number): void {
    this.join();
    this.join();
    for (let step = 0; step < steps; step += 1) this.step();
    while (this.people.length > 0) this.leave(this.random.chance(50));
    this.broker.end(this.broker.link.participant);
    this.broker.close();
    this.equal(this.broker.bus.usage().used, 0, 'pages left behind');
  }

  private equal(actual: unknown, expected: unknown, what: string): void {
    if (actual !== expected) throw new Error(`${what}: ${String(actual)} instead of ${String(expected)}`);
  }

  private step(): void {
    const { random } = this;
    const what = random.below(100);
    const person = random.pick(this.people);
    if (what < 3 && this.people.length < most.participants) this.join();
    else if (what < 6 && this.people.length > 2) this.leave(random.chance(50));
    else if (what < 20 && this.held().length < most.endpoints) this.create(person);
    else if (what < 25) this.destroy(person);
    else if (what < 65) this.write(person);
    else if (what < 95) this.take(person);
    else this.count(person);
  }

  private held(): Held[] {
    return this.people.flatMap((person) => person.held);
  }

  private join(): void {
    const index = this.broker.bus.claimParticipant();
    const link = new SharedLink({ bus: new Bus(this.broker.bus.sab), participant: index, mayBlock: false });
    this.people.push({ index, link, node: link.nodeCreate(`n${index}`, '/'), held: [] });
    this.story.push(`p${index} joins`);
  }

  /** Ends by itself, or dies. */
  private leave(dies: boolean): void {
    const at = this.random.below(this.people.length);
    const [person] = this.people.splice(at, 1);
    this.story.push(`p${person!.index} ${dies ? 'dies' : 'leaves'}`);
    if (!dies) person!.link.close();
    this.broker.end(person!.index);
    for (const { model } of person!.held) this.model.destroy(model);
  }

  private create(person: Participant): void {
    const { random } = this;
    const kind = random.pick([1, 1, 1, 2, 2, 2, 3, 4]);
    const name = random.pick(names);
    const qos = randomQos(random);
    const flags = random.chance(20) ? flagIgnoreLocal : 0;
    const handle = person.link.endpointCreate({ kind, node: person.node, name, type: 't', hash: '', qos, flags });
    this.story.push(`p${person.index} makes ${handle}: kind ${kind} ${name} history ${qos.history} depth ${qos.depth} durability ${qos.durability} reliability ${qos.reliability} flags ${flags}`);
    if (handle < 0) throw new Error(`endpointCreate: ${handle}`);
    const model = this.model.create({ participant: person.index, kind, name, qos, flags });
    person.held.push({ model, handle, asked: [] });
    this.keys.set(model, person.link.gid(handle)![2]!);
  }

  private destroy(person: Participant): void {
    if (person.held.length === 0) return;
    const [held] = person.held.splice(this.random.below(person.held.length), 1);
    this.story.push(`p${person.index} destroys ${held!.handle}`);
    person.link.endpointDestroy(held!.handle);
    this.model.destroy(held!.model);
  }

  private write(person: Participant): void {
    const { random, heap } = this;
    const writers = person.held.filter(({ model, asked }) => model.kind === EndpointKind.publisher
      || model.kind === EndpointKind.client || (model.kind === EndpointKind.server && asked.length > 0));
    if (writers.length === 0) return;
    const { model, handle, asked } = random.pick(writers);
    const times = model.kind === EndpointKind.publisher && random.chance(20) ? 12 : 1;
    for (let i = 0; i < times; i += 1) {
      const length = random.below(random.pick(largest));
      const bytes = new Uint8Array(length).fill(1 + random.below(255));
      const request = model.kind === EndpointKind.server ? asked.shift() : undefined;
      if (model.kind === EndpointKind.server && request === undefined) return;
      this.story.push(`p${person.index} writes ${length} to ${handle}`);
      heap.i32.fill(0, 0, 16);
      if (request?.client !== undefined) {
        heap.i32[SampleInfoLayout.relatedSequence >> 2] = request.relatedSequence;
        heap.i32[(SampleInfoLayout.relatedGid >> 2) + 2] = this.keys.get(request.client)!;
      }
      heap.u8.set(bytes, payloadAt);
      this.equal(person.link.write(handle, heap, payloadAt, length, 0), 0, 'write');
      const { sequence } = this.model.write(model, bytes, request);
      this.equal(heap.i32[SampleInfoLayout.sequence >> 2], sequence, 'sequence');
    }
  }

  private take(person: Participant): void {
    const { random, heap } = this;
    const readers = person.held.filter(({ model }) => model.kind !== EndpointKind.publisher);
    if (readers.length === 0) return;
    const reader = random.pick(readers);
    for (let left = random.pick([1, 2, 100]); left > 0; left -= 1) {
      this.story.push(`p${person.index} takes from ${reader.handle}`);
      const ready = person.link.ready().includes(reader.handle);
      const length = person.link.take(reader.handle, heap, payloadAt, heap.u8.length - payloadAt, 0);
      const expected = this.model.take(reader.model);
      this.equal(length, expected?.bytes.length ?? ErrorCode.nothing, 'length');
      if (expected === undefined) return;
      this.equal(ready, true, 'ready');
      this.equal(heap.i32[SampleInfoLayout.sequence >> 2], expected.sequence, 'sequence');
      this.equal(heap.i32[(SampleInfoLayout.writerGid >> 2) + 2], this.keys.get(expected.writer), 'writer');
      this.equal(heap.i32[SampleInfoLayout.relatedSequence >> 2], expected.relatedSequence, 'related sequence');
      const bytes = heap.u8.subarray(payloadAt, payloadAt + length);
      if (Buffer.compare(bytes, expected.bytes) !== 0) throw new Error(`the payload of ${expected.sequence} is not what was written`);
      if (reader.model.kind === EndpointKind.server) reader.asked.push(expected);
    }
  }

  private count(person: Participant): void {
    for (const { model, handle } of person.held) {
      this.equal(person.link.matched(handle), this.model.matched(model).length, `matched of ${handle}`);
    }
    this.equal(person.link.graph().endpoints.length, this.held().length, 'endpoints in the graph');
    this.equal(person.link.graph().nodes.length, this.people.length, 'nodes in the graph');
  }
}
