// The reading half of an endpoint on the shared bus: subscription, server (requests) or client (replies).
// Keeps its place per writer in the bus, so that any thread of the participant may take.

import { BusBlocked, BusEndpoint, BusSizes, BusSlot, Durability, EndpointKind, ErrorCode, History, keepAllLimit } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { SiteClock } from './clock.ts';
import type { EndpointRecord } from './graph.ts';
import type { Heap } from './link.ts';
import { InfoWord } from './sample_info.ts';
import { copyBytes, cursorTable, findCursor, frameFits, keyIndex, ringFits, ringLog2, slotWord, unit } from './shared_ring.ts';

interface WriterRef {
  readonly key: number;
  readonly word: number;
  readonly generation: number;
  readonly participant: number;
  readonly lifespanNs: number;
  /** Word of the pair in the cursor table as last seen, or -1. */
  pair: number;
}

/** Samples of a service are never thinned out; a subscription with keep_last sees its depth newest. */
function depthOf(record: EndpointRecord): number {
  if (record.kind !== EndpointKind.subscription || record.qos.history === History.keepAll) return 0x7fffffff;
  return Math.max(1, record.qos.depth);
}

/** How many samples from before its time a new reader gets; with `past`, all that the writer may still hold. */
function heritage(reader: EndpointRecord, writer: EndpointRecord, head: number, past: boolean): number {
  const both = reader.qos.durability === Durability.transientLocal
    && writer.qos.durability === Durability.transientLocal;
  if (!(both || past) || reader.kind !== EndpointKind.subscription) return 0;
  const depth = ({ qos }: EndpointRecord): number => qos.history === History.keepAll ? keepAllLimit : Math.max(1, qos.depth);
  return Math.min(depth(reader), depth(writer), head >>> 0);
}

export class SharedReader {
  readonly record: EndpointRecord;
  private readonly bus: Bus;
  private readonly clock: SiteClock;
  private readonly word: number;
  private readonly depth: number;
  private readonly filter: boolean;
  /** A gap in what it reads is a loss. */
  private readonly all: boolean;
  private writers: WriterRef[] = [];
  // The result of find(): the sample that comes next.
  private at: WriterRef | undefined;
  private sequence = 0;
  private slot = 0;
  private ring = 0;
  /** Where the only writer's cursor stood when its next sample was found, and no take has followed; else undefined. */
  private foundFrom: number | undefined;
  /** Brings the list of writers up to date; true when the graph has changed. */
  private readonly sync: () => boolean;

  constructor(bus: Bus, record: EndpointRecord, clock: SiteClock, sync: () => boolean) {
    this.bus = bus;
    this.clock = clock;
    this.record = record;
    this.sync = sync;
    this.word = bus.endpointWord(keyIndex(record.key));
    this.depth = depthOf(record);
    this.filter = record.kind === EndpointKind.client;
    this.all = record.kind === EndpointKind.subscription && record.qos.history === History.keepAll;
  }

  /** A writer that fits, be it there or just gone: it is read until its entry is freed. Called by each thread for itself. */
  match(writer: EndpointRecord): void {
    if (this.writers.some((known) => known.key === writer.key)) return;
    this.writers.push({
      key: writer.key,
      word: this.bus.endpointWord(keyIndex(writer.key)),
      generation: writer.key >>> 13,
      participant: writer.participant,
      lifespanNs: Number(writer.qos.lifespan),
      pair: -1,
    });
  }

  /** Before this endpoint is visible: where to begin with a writer that is there already. False: no room for it. */
  startAt(writer: EndpointRecord, past: boolean): boolean {
    const head = this.bus.load(this.bus.endpointWord(keyIndex(writer.key)) + BusEndpoint.head);
    return this.addPair(writer.key, (head - heritage(this.record, writer, head, past)) | 0) >= 0;
  }

  hasData(): boolean {
    const { bus } = this;
    this.foundFrom = undefined;
    for (;;) {
      // In this order: what is drained never gets ahead of the signals.
      const drained = bus.load(this.word + BusEndpoint.drained);
      const signal = bus.load(this.word + BusEndpoint.signal);
      if (signal === drained) return false;
      if (this.find(false)) {
        this.foundFrom = this.writers.length === 1 && this.at !== undefined ? this.cursor(this.at) : undefined;
        return true;
      }
      if (this.settle(drained, signal, false)) return false;
    }
  }

  /**
   * Nothing was found since `signal`: from now on the next writer signals again. One that wrote before it could see
   * that has not: look once more. True when nothing is there.
   */
  private settle(drained: number, signal: number, move: boolean): boolean {
    const { bus, word } = this;
    if (bus.compareExchange(word + BusEndpoint.drained, drained, signal) !== drained) return false;
    this.sync();
    if (!this.find(move)) return true;
    bus.add(word + BusEndpoint.signal, 1);
    bus.bump(this.record.participant);
    return false;
  }

  /** Is what hasData() found still the next sample? Only the taker moves the cursor, so it is read plainly. */
  private keepsFound(): boolean {
    const from = this.foundFrom;
    const writer = this.at;
    this.foundFrom = undefined;
    if (from === undefined || writer === undefined || this.writers.length !== 1 || writer.pair < 0) return false;
    const { bus, bus: { i32 } } = this;
    if (i32[writer.pair] !== writer.key || i32[writer.pair + 1] !== from) return false;
    return this.all || ((bus.load(writer.word + BusEndpoint.head) - this.sequence) | 0) < this.depth;
  }

  take(heap: Heap, address: number, capacity: number, info: number): number {
    const { bus, word } = this;
    for (;;) {
      if (!this.keepsFound()) {
        const drained = bus.load(word + BusEndpoint.drained);
        const signal = bus.load(word + BusEndpoint.signal);
        if (signal === drained) return ErrorCode.nothing;
        if (!this.find(true)) {
          if (this.settle(drained, signal, true)) return ErrorCode.nothing;
          continue;
        }
      }
      const writer = this.at;
      if (writer === undefined) continue;
      const { slot, sequence } = this;
      // Read plainly: the slot is looked at again before they are used.
      const frame = bus.i32[slot + BusSlot.frameUnit]!;
      const length = bus.i32[slot + BusSlot.length]!;
      // From here to the release no writer touches the frame: it looks at the hazard before it writes.
      bus.store(word + BusEndpoint.hazard, frame);
      const held = this.holds(writer);
      if (held && !frameFits(bus, frame, length)) {
        // Another program has written over the slot: the sample is lost.
        this.release(writer, this.passTo(writer, sequence, 0), sequence);
        continue;
      }
      if (!held || length > capacity) {
        this.release(writer, sequence, sequence);
        if (held) return length;
        continue;
      }
      const offset = frame * unit;
      const from = bus.i32;
      const header = offset >> 2;
      const target = info >> 2;
      const to = heap.i32;
      for (let i = 0; i < 16; i += 1) to[target + i] = from[header + i]!;
      copyBytes(bus.u8, from, offset + BusSizes.align, heap.u8, to, address, length);
      const before = this.passTo(writer, sequence, 1);
      this.release(writer, before, sequence);
      if (writer.lifespanNs > 0 && this.expired(heap, target, writer.lifespanNs)) continue;
      return length;
    }
  }

  /** Lets go of the frame, and wakes a writer that waits for that, or for the cursor to come as far as it has now. */
  private release(writer: WriterRef, before: number, after: number): void {
    const { bus } = this;
    bus.store(this.word + BusEndpoint.hazard, 0);
    const blocked = bus.load(writer.word + BusEndpoint.blocked);
    if (blocked === BusBlocked.no) return;
    const room = bus.load(writer.word + BusEndpoint.roomAt);
    if (blocked === BusBlocked.room && (((before - room) | 0) >= 0 || ((after - room) | 0) < 0)) return;
    bus.bump(writer.participant);
  }

  private expired(heap: Heap, info: number, lifespanNs: number): boolean {
    const at = info + InfoWord.sourceTimestamp;
    const stamp = (heap.i32[at]! >>> 0) + heap.i32[at + 1]! * 2 ** 32;
    return this.clock.systemNs() - stamp > lifespanNs;
  }

  /** Still the sample that find() saw? */
  private holds(writer: WriterRef): boolean {
    const { bus } = this;
    return bus.load(this.slot) === this.sequence
      && bus.load(writer.word + BusEndpoint.ring) === this.ring
      && bus.load(writer.word + BusEndpoint.generation) === writer.generation;
  }

  /** Finds the oldest sample that is due; with `move`, cursors pass over what is not. */
  private find(move: boolean): boolean {
    const { bus } = this;
    for (;;) {
      let total = 0;
      let best: WriterRef | undefined;
      let bestSequence = 0;
      let bestSlot = 0;
      let bestRing = 0;
      let bestOrder = 0;
      for (let i = 0; i < this.writers.length; i += 1) {
        const writer = this.writers[i]!;
        const head = bus.load(writer.word + BusEndpoint.head);
        if (bus.load(writer.word + BusEndpoint.generation) !== writer.generation) {
          if (move) i = this.forget(i);
          continue;
        }
        const cursor = this.cursor(writer);
        // The place of a writer that left stays here: the code that frees its entry checks whether all is read.
        if (head === cursor) continue;
        // At the memory's end: without a place for it, what is read would come again and again.
        if (move && writer.pair < 0 && !this.setCursor(writer, cursor)) continue;
        const sequence = this.firstValid(writer, cursor, head, move);
        if (sequence === undefined) continue;
        total += (head - sequence + 1) | 0;
        const order = this.bus.i32[this.slot + BusSlot.order]!;
        if (best === undefined || ((order - bestOrder) | 0) < 0) {
          best = writer;
          bestSequence = sequence;
          bestSlot = this.slot;
          bestRing = this.ring;
          bestOrder = order;
        }
      }
      this.at = best;
      if (best === undefined) return false;
      if (move && total > this.depth) {
        // Several writers share one queue of `depth`: the oldest gives way.
        this.setCursor(best, bestSequence);
        continue;
      }
      this.sequence = bestSequence;
      this.slot = bestSlot;
      this.ring = bestRing;
      return true;
    }
  }

  /** First sequence after the cursor that can be read and is meant for this reader; sets slot and ring. */
  private firstValid(writer: WriterRef, cursor: number, head: number, move: boolean): number | undefined {
    const { bus } = this;
    const behind = (head - cursor) | 0;
    let sequence = (behind < 0 || behind > this.depth ? head - this.depth + 1 : cursor + 1) | 0;
    while (((head - sequence) | 0) >= 0) {
      const ring = bus.load(writer.word + BusEndpoint.ring);
      if (ring === 0) return undefined;
      if (!ringFits(bus, ring)) break;
      const size = 1 << ringLog2(ring);
      const oldest = (head - size + 1) | 0;
      if (((oldest - sequence) | 0) > 0) {
        sequence = oldest;
      }
      const slot = slotWord(bus, ring, sequence);
      if (bus.load(slot) === sequence) {
        const target = this.filter ? bus.i32[slot + BusSlot.target]! : 0;
        if (target === 0 || target === this.record.key) {
          this.slot = slot;
          this.ring = ring;
          return sequence;
        }
      } else if (bus.load(writer.word + BusEndpoint.ring) !== ring) {
        // The writer has moved: these slots may be anything by now.
        continue;
      }
      sequence = (sequence + 1) | 0;
    }
    if (move) this.passTo(writer, head, 0);
    return undefined;
  }

  /**
   * Moves the cursor; of the samples that it passes, all but the last `taken` were overwritten before they were read.
   * Returns where it was.
   */
  private passTo(writer: WriterRef, sequence: number, taken: number): number {
    this.findPair(writer);
    const before = writer.pair < 0 ? 0 : this.bus.i32[writer.pair + 1]!;
    const lost = this.all ? (sequence - before - taken) | 0 : 0;
    this.setCursor(writer, sequence);
    if (lost <= 0) return before;
    this.bus.add(this.word + BusEndpoint.lostTotal, lost);
    this.bus.noteStatus(this.record.participant);
    this.bus.bump(this.record.participant);
    return before;
  }

  private cursor(writer: WriterRef): number {
    const { bus } = this;
    if (writer.pair < 0 || bus.load(writer.pair) !== writer.key) {
      writer.pair = findCursor(this.bus, this.word, writer.key);
    }
    return writer.pair < 0 ? 0 : this.bus.load(writer.pair + 1);
  }

  /** For the taker: nobody else changes the places meanwhile, so they are read plainly. */
  private findPair(writer: WriterRef): void {
    if (writer.pair >= 0 && this.bus.i32[writer.pair] === writer.key) return;
    writer.pair = findCursor(this.bus, this.word, writer.key);
  }

  /** False when the writer has no place yet, and there is no room for one. */
  private setCursor(writer: WriterRef, sequence: number): boolean {
    this.findPair(writer);
    if (writer.pair < 0) writer.pair = this.addPair(writer.key, sequence);
    else this.bus.store(writer.pair + 1, sequence);
    return writer.pair >= 0;
  }

  /** Word of the new pair, or -1. */
  private addPair(key: number, cursor: number): number {
    const { bus } = this;
    for (;;) {
      const { word, entries } = cursorTable(bus, this.word);
      for (let i = 0; i < entries; i += 1) {
        const pair = word + 2 * i;
        if (bus.load(pair) !== 0) continue;
        bus.store(pair + 1, cursor);
        bus.store(pair, key);
        return pair;
      }
      if (!this.growTable(word, entries)) return -1;
    }
  }

  /** The old table stays allocated until the endpoint ends, since a writer may be reading it, but matches no key. */
  private growTable(from: number, entries: number): boolean {
    const { bus } = this;
    const pages = Math.max(1, (entries * 16) / BusSizes.page | 0);
    const page = bus.allocate(pages, this.record.key);
    if (page < 0) return false;
    const to = bus.pageOffset(page) >> 2;
    bus.i32.fill(0, to, to + pages * (BusSizes.page >> 2));
    for (let i = 0; i < 2 * entries; i += 1) bus.store(to + i, bus.load(from + i));
    bus.store(this.word + BusEndpoint.table, (pages << 20) | page);
    for (let i = 0; i < entries; i += 1) bus.store(from + 2 * i, 0);
    for (const writer of this.writers) writer.pair = -1;
    return true;
  }

  /** Drops a writer whose entry is freed; returns the index to go on after. */
  private forget(index: number): number {
    const [writer] = this.writers.splice(index, 1);
    if (writer !== undefined) {
      const pair = findCursor(this.bus, this.word, writer.key);
      if (pair >= 0) this.bus.store(pair, 0);
    }
    return index - 1;
  }
}
