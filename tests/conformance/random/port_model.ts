// The guarantees of the port link (SPEC.md sections 2.3 and 5). Messages travel, so the model does not predict the result of
// a take, but checks whether it is allowed, and which samples must have come when all is quiet.

import { Durability, EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { reads } from '../../../runtime/site/bus/graph.ts';
import { depthOf, Model, type ModelEndpoint, type ModelSample } from './model.ts';

/** A writer as one of its readers knows it. */
interface Pair {
  /** The first sequence that may come. */
  readonly from: number;
  /** The first that must; undefined: the two need not have met yet. */
  owed: number | undefined;
  /** The last that was taken. */
  newest: number;
  /** How often all had been quiet when the two met. */
  readonly epoch: number;
}

export class PortModel extends Model {
  private readonly pairs = new Map<ModelEndpoint, Map<ModelEndpoint, Pair>>();
  /** How often all was quiet when a sample was written. */
  private readonly epochs = new Map<ModelSample, number>();
  private epoch = 0;
  /** Participants where, of a writer's samples, some may have waited for a reader that wants all. */
  private readonly heldUp = new Map<ModelEndpoint, Set<number>>();

  override create(parts: Omit<ModelEndpoint, 'queue' | 'written'>): ModelEndpoint {
    const endpoint = super.create(parts);
    if (reads(endpoint.kind)) this.pairs.set(endpoint, new Map());
    for (const other of this.matched(endpoint)) {
      if (reads(endpoint.kind)) this.meet(other, endpoint);
      if (reads(other.kind)) this.meet(endpoint, other);
    }
    return endpoint;
  }

  private meet(writer: ModelEndpoint, reader: ModelEndpoint): void {
    const from = writer.written.length + 1 - this.granted(writer, reader);
    const local = writer.participant === reader.participant;
    if (!local && wantsAll(reader)) {
      const places = this.heldUp.get(writer) ?? new Set();
      this.heldUp.set(writer, places.add(reader.participant));
    }
    this.pairs.get(reader)!.set(writer, { from, owed: local ? from : undefined, newest: 0, epoch: this.epoch });
  }

  /** How many of the samples that were there before a reader does get. */
  private granted(writer: ModelEndpoint, reader: ModelEndpoint): number {
    if (reader.kind !== EndpointKind.subscription || reader.qos.durability !== Durability.transientLocal) return 0;
    return Math.min(depthOf(writer.qos), depthOf(reader.qos), writer.written.length);
  }

  override destroy(endpoint: ModelEndpoint): void {
    super.destroy(endpoint);
    this.pairs.delete(endpoint);
  }

  /** A participant took no leave: what it said last may be lost, also of writers that it had destroyed before. */
  died(participant: number): void {
    for (const pairs of this.pairs.values()) {
      for (const [writer, pair] of pairs) if (writer.participant === participant) pair.owed = undefined;
    }
  }

  override write(writer: ModelEndpoint, bytes: Uint8Array, answered?: ModelSample): ModelSample {
    const sample = super.write(writer, bytes, answered);
    this.epochs.set(sample, this.epoch);
    return sample;
  }

  /** All messages have arrived: who is there has met. */
  quiet(): void {
    this.epoch += 1;
    for (const [reader, pairs] of this.pairs) {
      for (const [writer, pair] of pairs) {
        if (!this.endpoints.has(writer)) continue;
        pair.owed ??= Math.max(pair.from, writer.written.length + 1 - this.granted(writer, reader));
      }
    }
  }

  /** `reader` has taken a sample. */
  came(reader: ModelEndpoint, writer: ModelEndpoint, sequence: number): ModelSample {
    const pair = this.pairs.get(reader)?.get(writer);
    const sample = writer.written[sequence - 1];
    if (pair === undefined || sample === undefined) throw new Error(`${sequence} is of a writer that does not match`);
    if (sequence < pair.from) throw new Error(`${sequence} was written before the reader was there`);
    if (sequence <= pair.newest) throw new Error(`${sequence} comes after ${pair.newest}`);
    if (reader.kind === EndpointKind.client && sample.client !== reader) throw new Error(`${sequence} is another client's`);
    this.mayLack(reader, writer, pair, sequence);
    pair.newest = sequence;
    return sample;
  }

  /** All is quiet and `reader` has taken what it had. */
  complete(reader: ModelEndpoint): void {
    for (const [writer, pair] of this.pairs.get(reader) ?? []) {
      if (pair.owed !== undefined) this.mayLack(reader, writer, pair, writer.written.length + 1);
    }
  }

  /** Of what is owed, the reader never gets what it has not got before `next`: has newer taken its place? */
  private mayLack(reader: ModelEndpoint, writer: ModelEndpoint, pair: Pair, next: number): void {
    const { owed, newest } = pair;
    const all = wantsAll(reader);
    const first = all && newest > 0 ? newest + 1 : owed;
    if (first === undefined) return;
    const lacking = writer.written.slice(Math.max(first - 1, newest), next - 1)
      .findLast(({ client }) => reader.kind !== EndpointKind.client || client === reader);
    if (lacking === undefined) return;
    const since = this.arrival(lacking, pair);
    let newer = 0;
    for (const [other, known] of this.pairs.get(reader)!) {
      if (other === writer) newer += writer.written.length - lacking.sequence;
      else if (this.heldUp.get(other)?.has(reader.participant) === true) newer += other.written.length;
      else newer += other.written.filter((each) => this.arrival(each, known) >= since).length;
    }
    if (all || newer < depthOf(reader.qos)) throw new Error(`${lacking.sequence} of ${writer.written.length} never came, and only ${newer} did after it`);
  }

  /** In which stretch between two times of quiet a sample comes. */
  private arrival(sample: ModelSample, pair: Pair): number {
    return Math.max(this.epochs.get(sample)!, pair.epoch);
  }
}

function wantsAll(reader: ModelEndpoint): boolean {
  return reader.kind !== EndpointKind.subscription || depthOf(reader.qos) === Infinity;
}
