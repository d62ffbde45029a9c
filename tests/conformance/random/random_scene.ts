// One random scene: participants come, make endpoints, write, take, leave and die, call by call. What each call must
// bring is said by the link's own scene: shared_scene.ts, port_scene.ts.

import { Durability, EndpointKind, ErrorCode, flagIgnoreLocal, History, Reliability, SampleInfoLayout } from '../../../runtime/protocol/generated/constants.ts';
import type { Link } from '../../../runtime/site/bus/link.ts';
import { defaultQos, type EndpointQos } from '../../../runtime/site/contract/qos.ts';
import { type Generator } from './generator.ts';
import { Model, type ModelEndpoint, type ModelSample } from './model.ts';

export interface Held {
  readonly model: ModelEndpoint;
  readonly handle: number;
  /** Requests that a server has not answered yet. */
  readonly asked: ModelSample[];
}

export interface Participant {
  readonly index: number;
  readonly link: Link;
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

export abstract class RandomScene {
  protected readonly random: Generator;
  protected readonly model: Model;
  protected readonly people: Participant[] = [];
  /** Third words of the gids. */
  protected readonly keys = new Map<ModelEndpoint, number>();
  protected readonly heap: { u8: Uint8Array; i32: Int32Array; };
  /** The steps that were done, for the report of a failure. */
  readonly story: string[] = [];

  constructor(random: Generator, model: Model) {
    this.random = random;
    this.model = model;
    const buffer = new ArrayBuffer(1 << 16);
    this.heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  }

  /** A new participant's place in the graph. */
  protected abstract admit(): { readonly index: number; readonly link: Link; };
  /** It ends by itself, or dies. */
  protected abstract end(person: Participant, dies: boolean): void;
  /** The sample that a take must return, when it returned `length` bytes with sequence `sequence` of the writer with key `writer`. */
  protected abstract expected(reader: Held, length: number, writer: number, sequence: number): ModelSample | undefined;
  /** Compares counts; `person`'s are wanted. */
  protected abstract count(person: Participant): void;
  /** Whatever else may happen between two calls. */
  protected abstract meanwhile(): void;
  /** Everyone has left: nothing may stay behind. */
  protected abstract close(): void;

  run(steps: number): void {
    this.join();
    this.join();
    for (let step = 0; step < steps; step += 1) this.step();
    while (this.people.length > 0) this.leave(this.random.chance(50));
    this.close();
  }

  protected equal(actual: unknown, expected: unknown, what: string): void {
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
    this.meanwhile();
  }

  protected held(): Held[] {
    return this.people.flatMap((person) => person.held);
  }

  private join(): void {
    const { index, link } = this.admit();
    this.people.push({ index, link, node: link.nodeCreate(`n${index}`, '/'), held: [] });
    this.story.push(`p${index} joins`);
  }

  private leave(dies: boolean): void {
    const at = this.random.below(this.people.length);
    const [person] = this.people.splice(at, 1);
    this.story.push(`p${person!.index} ${dies ? 'dies' : 'leaves'}`);
    this.end(person!, dies);
    for (const { model } of person!.held) this.model.destroy(model);
  }

  private create(person: Participant): void {
    const { random } = this;
    const kind = random.pick([1, 1, 1, 2, 2, 2, 3, 4]);
    const name = random.pick(names);
    const qos = randomQos(random);
    const flags = random.chance(20) ? flagIgnoreLocal : 0;
    const handle = person.link.endpointCreate({ kind, node: person.node, name, type: 't', hash: '', qos, flags });
    this.story.push(
      `p${person.index} makes ${handle}: kind ${kind} ${name} history ${qos.history} depth ${qos.depth} durability ${qos.durability} reliability ${qos.reliability} flags ${flags}`,
    );
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
    const writers = person.held.filter(({ model, asked }) =>
      model.kind === EndpointKind.publisher
      || model.kind === EndpointKind.client || (model.kind === EndpointKind.server && asked.length > 0)
    );
    if (writers.length === 0) return;
    const { model, handle, asked } = random.pick(writers);
    const times = model.kind === EndpointKind.publisher && random.chance(20) ? this.burst() : 1;
    this.story.push(`p${person.index} writes ${times} to ${handle}`);
    for (let i = 0; i < times; i += 1) {
      const length = random.below(random.pick(largest));
      const bytes = new Uint8Array(length).fill(1 + random.below(255));
      const request = model.kind === EndpointKind.server ? asked.shift() : undefined;
      if (model.kind === EndpointKind.server && request === undefined) return;
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

  /** How many samples a writer in a hurry writes at once. */
  protected burst(): number {
    return 12;
  }

  private take(person: Participant): void {
    const readers = person.held.filter(({ model }) => model.kind !== EndpointKind.publisher);
    if (readers.length > 0) this.takeFrom(person, this.random.pick(readers), this.random.pick([1, 2, 100]));
  }

  /** How many were taken. */
  protected takeFrom(person: Participant, reader: Held, atMost: number): number {
    const { heap } = this;
    this.story.push(`p${person.index} takes from ${reader.handle}, ${atMost} at most`);
    for (let taken = 0;; taken += 1) {
      if (taken === atMost) return taken;
      const ready = person.link.ready().includes(reader.handle);
      const length = person.link.take(reader.handle, heap, payloadAt, heap.u8.length - payloadAt, 0);
      const sequence = heap.i32[SampleInfoLayout.sequence >> 2]!;
      const writer = heap.i32[(SampleInfoLayout.writerGid >> 2) + 2]!;
      const expected = this.expected(reader, length, writer, sequence);
      this.equal(length, expected?.bytes.length ?? ErrorCode.nothing, 'length');
      this.equal(ready, expected !== undefined, 'ready');
      if (expected === undefined) return taken;
      this.equal(sequence, expected.sequence, 'sequence');
      this.equal(writer, this.keys.get(expected.writer), 'writer');
      this.equal(heap.i32[SampleInfoLayout.relatedSequence >> 2], expected.relatedSequence, 'related sequence');
      const bytes = heap.u8.subarray(payloadAt, payloadAt + length);
      if (Buffer.compare(bytes, expected.bytes) !== 0) throw new Error(`the payload of ${expected.sequence} is not what was written`);
      if (reader.model.kind === EndpointKind.server) reader.asked.push(expected);
    }
  }

  /** The counts of one participant are those of the model. */
  protected compareCounts(person: Participant): void {
    for (const { model, handle } of person.held) {
      this.equal(person.link.matched(handle), this.model.matched(model).length, `matched of ${handle}`);
    }
    this.equal(person.link.graph().endpoints.length, this.held().length, 'endpoints in the graph');
    this.equal(person.link.graph().nodes.length, this.people.length, 'nodes in the graph');
  }
}
