// The writing half of an endpoint on the shared bus: publisher, client (requests) or server (replies).
// Owns a ring of slots and the frames they point to. All state is in the bus, so that any thread of the participant
// may write; only the lists of matched readers are the thread's own.

import {
  BusBlocked,
  BusEndpoint,
  BusHeader,
  BusParticipant,
  BusRing,
  BusSizes,
  BusSlot,
  Durability,
  EndpointKind,
  ErrorCode,
  History,
  keepAllLimit,
  maxSampleLength,
  Reliability,
  serviceLimit,
} from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import { putNanoseconds, type SiteClock } from './clock.ts';
import type { EndpointRecord } from './graph.ts';
import type { Heap } from './link.ts';
import { type ReaderRef, readerRef } from './reader_ref.ts';
import { InfoWord, GID_WORDS, INFO_WORDS } from './sample_info.ts';
import {
  copyBytes,
  findCursor,
  keyIndex,
  maxLog2,
  observed,
  packRing,
  ringBytes,
  ringFits,
  ringFramesOffset,
  ringGeneration,
  ringLog2,
  ringPage,
  slotWord,
  slotWords,
  unit,
} from './shared_ring.ts';
import { noteSample, type Timing } from './timing.ts';

interface RetiredRun {
  readonly page: number;
  readonly pages: number;
}

/** The action of the thread when a writer must wait for a reader: 'stop' ends the wait, 'cannot' forbids it. */
export type Pause = (token: number, mostMs: number) => 'again' | 'stop' | 'cannot';

const firstLog2 = 3;
const minStride = 128;
const maxStride = 64 + 2048;
/** Slots looked at for a frame to use again. */
const searchLimit = 64;
/**
 * A writer that had to wait gives its readers so long to make more room: to be woken costs as much as many samples. It
 * does not wait for any number of them, as a reader may take one and then wait for what this program does next.
 */
const momentMs = 1;

export class SharedWriter {
  readonly record: EndpointRecord;
  private readonly bus: Bus;
  private readonly word: number;
  private readonly service: boolean;
  private readonly ownDepth: number;
  private readonly mayBlock: boolean;
  private readonly clock: SiteClock;
  private readonly timing: Timing;
  private readers: ReaderRef[] = [];
  private participants: number[] = [];
  private retired: RetiredRun[] = [];
  /** As claimFrame() left it. */
  private ring = 0;
  /** Brings the reader list up to date; cheap when the graph's version has not moved. */
  private readonly sync: () => void;
  private readonly pause: Pause;

  constructor(
    bus: Bus,
    record: EndpointRecord,
    clock: SiteClock,
    timing: Timing,
    sync: () => void,
    pause: Pause,
  ) {
    this.bus = bus;
    this.record = record;
    this.clock = clock;
    this.timing = timing;
    this.sync = sync;
    this.pause = pause;
    this.word = bus.endpointWord(keyIndex(record.key));
    this.service = record.kind !== EndpointKind.publisher;
    const { qos } = record;
    const keepAll = qos.history === History.keepAll;
    this.ownDepth = this.service || qos.durability !== Durability.transientLocal
      ? 0
      : keepAll
      ? keepAllLimit
      : Math.max(1, qos.depth);
    this.mayBlock = !this.service && keepAll && qos.reliability === Reliability.reliable;
  }

  match(reader: EndpointRecord): void {
    if (this.readers.some((known) => known.key === reader.key)) return;
    this.readers.push(readerRef(this.bus, reader, this.service, this.record.participant));
    this.listParticipants();
  }

  unmatch(key: number): void {
    this.readers = this.readers.filter((reader) => reader.key !== key);
    this.listParticipants();
  }

  private listParticipants(): void {
    this.participants = [...new Set(this.readers.map((reader) => reader.participant))];
  }

  /** The caller has just looked at the graph. */
  write(heap: Heap, address: number, length: number, info: number): number {
    const { bus, word } = this;
    if (length > maxSampleLength) return ErrorCode.tooLarge;
    this.releaseRetired();
    // Words that only the writer's own threads change are read without Atomics: the caller serialises calls on one endpoint.
    const sequence = (bus.i32[word + BusEndpoint.head]! + 1) | 0;
    let frame = this.claimFrame(sequence, length);
    while (frame === ErrorCode.outOfMemory) {
      // As it is before the search: who comes further meanwhile makes room that the search has not seen.
      const lag = this.lag();
      const outcome = this.reclaim(sequence) ? 0 : this.awaitSlowest(lag);
      if (outcome < 0) return outcome;
      frame = this.claimFrame(sequence, length);
    }
    if (frame < 0) return frame;
    const slot = slotWord(bus, this.ring, sequence);
    const target = this.fill(heap, address, length, info, sequence, frame);
    const i32 = bus.i32;
    i32[slot + BusSlot.frameUnit] = frame;
    i32[slot + BusSlot.length] = length;
    i32[slot + BusSlot.order] = bus.add(BusHeader.order, 1);
    i32[slot + BusSlot.target] = target;
    bus.store(slot, sequence);
    this.count(length);
    bus.store(word + BusEndpoint.head, sequence);
    // A reader that became visible meanwhile has either seen this head or is seen by this look.
    this.sync();
    if (this.timing.ticks) this.noteTime();
    this.signal(target);
    return 0;
  }

  private noteTime(): void {
    const now = this.clock.steadyNs();
    const revived = this.timing.wrote(now);
    for (const { deadline, word, generation } of this.readers) {
      if (deadline === undefined) continue;
      if (this.bus.load(word + BusEndpoint.generation) !== generation) continue;
      noteSample(deadline.cells, deadline.ns, now);
    }
    if (revived) this.bumpReaders();
  }

  /** Tells the readers that hold this writer for dead. */
  assert(): void {
    if (this.timing.assert(this.clock.steadyNs())) this.bumpReaders();
  }

  private bumpReaders(): void {
    for (const participant of this.participants) this.bus.bump(participant);
  }

  /** A frame for the sample, in a slot that holds none. Or an ErrorCode. */
  private claimFrame(sequence: number, length: number): number {
    const { bus, word } = this;
    const room = this.makeRoom(sequence, length);
    if (room < 0) return room;
    const ring = bus.i32[word + BusEndpoint.ring]!;
    this.ring = ring;
    const slot = slotWord(bus, ring, sequence);
    // Nobody expects sequence + 1 in this slot: from here on the old sample is not there. Readers that came since
    // the last look might have it in their hands, so look again.
    bus.store(slot, (sequence + 1) | 0);
    this.sync();
    return this.frameFor(ring, slot, sequence, length);
  }

  /** At the ceiling: gives back the pages of samples that nobody needs any more. False when there were none. */
  private reclaim(sequence: number): boolean {
    const { bus, word } = this;
    const ring = bus.load(word + BusEndpoint.ring);
    if (ring === 0 || !ringFits(bus, ring)) return false;
    let freed = false;
    for (let age = 2; age <= 1 << ringLog2(ring); age += 1) {
      const s = (sequence - age) | 0;
      const slot = slotWord(bus, ring, s);
      if (bus.i32[slot + BusSlot.extentUnit] === 0) continue;
      const held = bus.load(slot) === s;
      if (held && this.wanted(s, age, bus.load(slot + BusSlot.target))) continue;
      if (held) bus.store(slot, (s + 1) | 0);
      this.releaseExtent(slot);
      freed = true;
    }
    return freed;
  }

  /** How many samples the slowest reliable keep_all reader elsewhere has not read. */
  private lag(): number {
    const head = this.bus.load(this.word + BusEndpoint.head);
    let furthest = 0;
    for (const reader of this.readers) {
      if (!reader.reliable || reader.local || reader.depth !== Infinity) continue;
      furthest = Math.max(furthest, (head - this.cursor(reader)) | 0);
    }
    return furthest;
  }

  /** At the ceiling, a writer that may wait does so until the slowest reader, `lag` behind, has come one sample further. */
  private awaitSlowest(lag: number): number {
    if (!this.mayBlock) return ErrorCode.outOfMemory;
    const head = this.bus.load(this.word + BusEndpoint.head);
    const next = (head - lag + 1) | 0;
    if (lag > 0) return this.blockWhile(BusBlocked.release, () => this.keepAllWants(next, false));
    if (this.retired.length === 0) return ErrorCode.outOfMemory;
    return this.blockWhile(BusBlocked.release, () => this.retired.length > 0);
  }

  /** Tells the readers that had nothing to read; the others look again before they rest. */
  private signal(target: number): void {
    const { bus } = this;
    for (let i = 0; i < this.readers.length; i += 1) {
      const reader = this.readers[i]!;
      if (target !== 0 && reader.key !== target) continue;
      const signal = reader.word + BusEndpoint.signal;
      if (bus.load(signal) !== bus.load(reader.word + BusEndpoint.drained)) continue;
      bus.add(signal, 1);
      bus.bump(reader.participant);
    }
  }

  private count(length: number): void {
    const { bus, word } = this;
    const low = bus.i32[word + BusEndpoint.bytesLow]! >>> 0;
    if (low + length > 0xffffffff) bus.add(word + BusEndpoint.bytesHigh, 1);
    bus.i32[word + BusEndpoint.bytesLow] = (low + length) | 0;
  }

  /** Frame header and payload; the header goes back to the caller too. Returns whom the sample is for, 0: all. */
  private fill(
    heap: Heap,
    address: number,
    length: number,
    info: number,
    sequence: number,
    frame: number,
  ): number {
    const { bus, word, record } = this;
    const offset = frame * unit;
    bus.reach(offset + BusSizes.align + length);
    const { i32 } = bus;
    if (sequence === 0) bus.add(word + BusEndpoint.headHigh, 1);
    const high = i32[word + BusEndpoint.headHigh]!;
    const source = info >> 2;
    const h = offset >> 2;
    const given = heap.i32;
    const stamp = InfoWord.sourceTimestamp;
    const related = InfoWord.relatedSequence;
    i32[h + InfoWord.length] = length;
    i32[h + InfoWord.flags] = 0;
    i32[h + InfoWord.sequence] = sequence;
    i32[h + InfoWord.sequence + 1] = high;
    if (given[source + stamp] === 0 && given[source + stamp + 1] === 0) {
      putNanoseconds(i32, h + stamp, this.clock.systemNs());
    } else {
      i32[h + stamp] = given[source + stamp]!;
      i32[h + stamp + 1] = given[source + stamp + 1]!;
    }
    const client = record.kind === EndpointKind.client;
    i32[h + related] = client ? sequence : given[source + related]!;
    i32[h + related + 1] = client ? high : given[source + related + 1]!;
    for (let i = 0; i < GID_WORDS; i += 1) {
      i32[h + InfoWord.relatedGid + i] = client ? record.gid[i]! : given[source + InfoWord.relatedGid + i]!;
      i32[h + InfoWord.writerGid + i] = record.gid[i]!;
    }
    for (let i = 0; i < INFO_WORDS; i += 1) given[source + i] = i32[h + i]!;
    copyBytes(heap.u8, given, address, bus.u8, i32, offset + BusSizes.align, length);
    return record.kind === EndpointKind.server ? given[source + 10]! : 0;
  }

  /** Sees to it that the slot of `sequence` may be written: a ring, grown as readers lag. 0 or an ErrorCode. */
  private makeRoom(sequence: number, length: number): number {
    const { bus, word } = this;
    const stride = Math.min(Math.max(minStride, (BusSizes.align + length + unit - 1) & -unit), maxStride);
    let ring = bus.i32[word + BusEndpoint.ring]!;
    // One that another program has written over is none.
    if (ring === 0 || !ringFits(bus, ring)) {
      const made = this.newRing(firstLog2, stride, 0, sequence);
      if (made < 0) return made;
      ring = made;
    } else {
      this.reachRing(ring);
    }
    const fits = BusSizes.align + length <= maxStride;
    const now = this.strideOf(ring);
    if (fits && stride > now) {
      let wider = now;
      while (wider < stride) wider *= 2;
      const made = this.newRing(ringLog2(ring), Math.min(wider, maxStride), ring, sequence);
      if (made < 0) return made;
      ring = made;
    }
    for (;;) {
      const size = 1 << ringLog2(ring);
      const old = (sequence - size) | 0;
      const slot = slotWord(bus, ring, sequence);
      if (bus.i32[slot] !== old || !this.wanted(old, size, bus.i32[slot + BusSlot.target]!)) return 0;
      if (size < this.sizeLimit(old)) {
        const made = this.newRing(ringLog2(ring) + 1, this.strideOf(ring), ring, sequence);
        if (made < 0) return made;
        ring = made;
        continue;
      }
      if (!this.mayBlock) return 0;
      if (!this.keepAllWants(old, false)) return this.keepAllWants(old, true) ? ErrorCode.outOfMemory : 0;
      const outcome = this.awaitRoom(old);
      if (outcome < 0) return outcome;
      ring = bus.load(word + BusEndpoint.ring);
    }
  }

  private strideOf(ring: number): number {
    const { bus } = this;
    const stride = bus.i32[(bus.pageOffset(ringPage(ring)) >> 2) + BusRing.stride]!;
    return Math.min(Math.max(minStride, stride & -unit), maxStride);
  }

  /** Another thread of the participant may have made the ring. */
  private reachRing(ring: number): void {
    const { bus } = this;
    const offset = bus.pageOffset(ringPage(ring));
    bus.reach(offset + BusSizes.page);
    bus.reach(offset + bus.i32[(offset >> 2) + BusRing.pages]! * BusSizes.page);
  }

  /** Most slots, when `old` is the sample that gives way to the next. */
  private sizeLimit(old: number): number {
    if (this.service) return serviceLimit;
    return this.mayBlock && this.keepAllWants(old, false) ? keepAllLimit : 1 << maxLog2;
  }

  /** Does anyone still have a right to the sample that is `age` behind the one to be written? */
  private wanted(old: number, age: number, target: number): boolean {
    if (age < this.ownDepth) return true;
    for (let i = 0; i < this.readers.length; i += 1) {
      const reader = this.readers[i]!;
      if (target !== 0 && reader.key !== target) continue;
      if (age < reader.depth && !this.hasRead(reader, old)) return true;
    }
    return false;
  }

  /** Asks the reader only when it was not known to be as far. */
  private hasRead(reader: ReaderRef, sequence: number): boolean {
    if (reader.known !== undefined && ((reader.known - sequence) | 0) >= 0) return true;
    reader.known = this.cursor(reader);
    return ((reader.known - sequence) | 0) >= 0;
  }

  /** Does a reliable keep_all reader, here or elsewhere, still have to read the sample? */
  private keepAllWants(old: number, local: boolean): boolean {
    return this.readers.some((reader) =>
      reader.reliable && reader.local === local && reader.depth === Infinity
      && !this.hasRead(reader, old)
    );
  }

  /** Sleeps until the readers that it waits for have read `old`, and a moment. 0 or an ErrorCode. */
  private awaitRoom(old: number): number {
    const { bus, word } = this;
    bus.store(word + BusEndpoint.roomAt, old);
    const outcome = this.blockWhile(BusBlocked.room, () => this.keepAllWants(old, false));
    if (outcome < 0) return outcome;
    const wake = bus.participantWord(this.record.participant) + BusParticipant.wake;
    return this.pause(bus.load(wake), momentMs) === 'stop' ? ErrorCode.stopped : 0;
  }

  /** Sleeps while it is needed and no reader lets go of pages that were taken out of the slots. 0 or an ErrorCode. */
  private blockWhile(tell: number, needed: () => boolean): number {
    const { bus, word } = this;
    const wake = bus.participantWord(this.record.participant) + BusParticipant.wake;
    bus.store(word + BusEndpoint.blocked, tell);
    for (;;) {
      const token = bus.load(wake);
      this.sync();
      if (this.releaseRetired() || !needed()) break;
      const outcome = this.pause(token, Infinity);
      if (outcome === 'again') continue;
      bus.store(word + BusEndpoint.blocked, BusBlocked.no);
      return outcome === 'stop' ? ErrorCode.stopped : ErrorCode.wouldBlock;
    }
    bus.store(word + BusEndpoint.blocked, BusBlocked.no);
    return 0;
  }

  /** How far a reader has come. A reader without a place here has read nothing; one that ended is not waited for. */
  private cursor(reader: ReaderRef): number {
    const { bus } = this;
    let cursor = 0;
    if (reader.pair < 0 || bus.load(reader.pair) !== this.record.key) {
      reader.pair = findCursor(this.bus, reader.word, this.record.key);
    }
    if (reader.pair >= 0) cursor = this.bus.load(reader.pair + 1);
    if (bus.load(reader.word + BusEndpoint.generation) !== reader.generation) {
      return bus.load(this.word + BusEndpoint.head);
    }
    return cursor;
  }

  /** A larger or wider ring with the samples of the old one. Returns the ring word, or an ErrorCode. */
  private newRing(log2: number, stride: number, old: number, sequence: number): number {
    const { bus, word, record } = this;
    const pages = Math.ceil(ringBytes(log2, stride) / BusSizes.page);
    const page = bus.allocate(pages, record.key);
    if (page < 0) return page;
    const base = bus.pageOffset(page);
    const ring = packRing(page, log2, ringGeneration(old) + 1);
    bus.store((base >> 2) + BusRing.stride, stride);
    bus.store((base >> 2) + BusRing.pages, pages);
    const size = 1 << log2;
    for (let i = 0; i < size; i += 1) {
      const slot = slotWord(bus, ring, i);
      bus.i32.fill(0, slot, slot + slotWords);
      bus.store(slot, (i + 1) | 0);
    }
    if (old !== 0) this.moveSamples(old, ring, sequence);
    bus.store(word + BusEndpoint.ring, ring);
    if (old !== 0) {
      const oldPages = bus.load((bus.pageOffset(ringPage(old)) >> 2) + BusRing.pages);
      this.retire(ringPage(old), oldPages);
    }
    return ring;
  }

  private moveSamples(old: number, ring: number, sequence: number): void {
    const { bus } = this;
    const oldSize = 1 << ringLog2(old);
    for (let age = oldSize; age >= 1; age -= 1) {
      const s = (sequence - age) | 0;
      const from = slotWord(bus, old, s);
      const to = slotWord(bus, ring, s);
      const { i32 } = bus;
      const extent = i32[from + BusSlot.extentUnit]!;
      i32[to + BusSlot.extentUnit] = extent;
      i32[to + BusSlot.extentPages] = i32[from + BusSlot.extentPages]!;
      if (bus.load(from) !== s) continue;
      const frame = i32[from + BusSlot.frameUnit]!;
      const length = i32[from + BusSlot.length]!;
      let moved = frame;
      if (frame !== extent) {
        moved = this.inlineFrame(ring, s);
        const bytes = BusSizes.align + length;
        bus.u8.copyWithin(moved * unit, frame * unit, frame * unit + bytes);
      }
      bus.store(to + BusSlot.frameUnit, moved);
      bus.store(to + BusSlot.length, length);
      bus.store(to + BusSlot.order, i32[from + BusSlot.order]!);
      bus.store(to + BusSlot.target, i32[from + BusSlot.target]!);
      bus.store(to, s);
    }
  }

  private inlineFrame(ring: number, sequence: number): number {
    const { bus } = this;
    const base = bus.pageOffset(ringPage(ring));
    const log2 = ringLog2(ring);
    const stride = this.strideOf(ring);
    return (base + ringFramesOffset(log2) + (sequence & ((1 << log2) - 1)) * stride) / unit;
  }

  /** Room for header and payload that nobody reads. A frame, or an ErrorCode. */
  private frameFor(ring: number, slot: number, sequence: number, length: number): number {
    const { bus, record } = this;
    const bytes = BusSizes.align + length;
    const stride = this.strideOf(ring);
    if (bytes <= stride) {
      const frame = this.inlineFrame(ring, sequence);
      if (!this.inlineInUse(frame, stride / unit, (sequence - (1 << ringLog2(ring))) | 0)) {
        this.releaseExtent(slot);
        return frame;
      }
    }
    const pages = Math.ceil(bytes / BusSizes.page);
    if (!this.extentFits(slot, pages)) this.borrowExtent(ring, slot, sequence, pages);
    if (this.extentFits(slot, pages)) return bus.i32[slot + BusSlot.extentUnit]!;
    this.releaseExtent(slot);
    const generous = pages > 8 ? pages + (pages >> 3) : pages;
    let page = bus.allocate(generous, record.key);
    let count = generous;
    if (page < 0) {
      page = bus.allocate(pages, record.key);
      count = pages;
    }
    if (page < 0) return page;
    const frame = bus.pageOffset(page) / unit;
    bus.i32[slot + BusSlot.extentUnit] = frame;
    bus.i32[slot + BusSlot.extentPages] = count;
    return frame;
  }

  private extentFits(slot: number, pages: number): boolean {
    const { i32 } = this.bus;
    const frame = i32[slot + BusSlot.extentUnit]!;
    const has = i32[slot + BusSlot.extentPages]!;
    return frame !== 0 && has >= pages && has <= 4 * pages + 16 && this.bus.holds(frame * unit, has * BusSizes.page)
      && !this.inUse(frame, has * (BusSizes.page / unit));
  }

  /** Takes the extent of a sample that nobody needs any more, so that large messages cycle through few pages. */
  private borrowExtent(ring: number, slot: number, sequence: number, pages: number): void {
    const { bus, bus: { i32 } } = this;
    const size = 1 << ringLog2(ring);
    const steps = Math.min(size, searchLimit);
    for (let age = 2; age < steps; age += 1) {
      const s = (sequence - age) | 0;
      const other = slotWord(bus, ring, s);
      const held = bus.load(other) === s;
      if (i32[other + BusSlot.extentUnit] === 0 || (held && this.wanted(s, age, bus.load(other + BusSlot.target)))) continue;
      if (held) {
        bus.store(other, (s + 1) | 0);
        this.sync();
      }
      if (!this.extentFits(other, pages)) continue;
      const frame = i32[slot + BusSlot.extentUnit]!;
      const count = i32[slot + BusSlot.extentPages]!;
      i32[slot + BusSlot.extentUnit] = i32[other + BusSlot.extentUnit]!;
      i32[slot + BusSlot.extentPages] = i32[other + BusSlot.extentPages]!;
      i32[other + BusSlot.extentUnit] = frame;
      i32[other + BusSlot.extentPages] = count;
      return;
    }
  }

  private releaseExtent(slot: number): void {
    const { bus } = this;
    const frame = bus.i32[slot + BusSlot.extentUnit]!;
    if (frame === 0) return;
    const pages = bus.i32[slot + BusSlot.extentPages]!;
    bus.i32[slot + BusSlot.extentUnit] = 0;
    bus.i32[slot + BusSlot.extentPages] = 0;
    this.retire(bus.pageOf(frame * unit), pages);
  }

  /** Frees pages that no slot points to any more, but later: a reader that came since the last look may still read them. */
  private retire(page: number, pages: number): void {
    this.retired.push({ page, pages });
    this.sync();
    this.releaseRetired();
  }

  /** True when pages came free. */
  private releaseRetired(): boolean {
    const { bus } = this;
    const before = this.retired.length;
    if (before === 0) return false;
    this.retired = this.retired.filter(({ page, pages }) => {
      if (this.inUse(bus.pageOffset(page) / unit, pages * (BusSizes.page / unit))) return true;
      bus.free(page, pages);
      return false;
    });
    return this.retired.length < before;
  }

  /** The same of an inline frame, whose last sample was `old`: who has read that one is done with the frame. */
  private inlineInUse(frame: number, units: number, old: number): boolean {
    for (let i = 0; i < this.readers.length; i += 1) {
      if (!this.hasRead(this.readers[i]!, old)) return this.inUse(frame, units);
    }
    return observed(this.bus, frame, units);
  }

  /** Does a reader have a frame of this range in its hands? */
  private inUse(frame: number, units: number): boolean {
    const { bus } = this;
    for (let i = 0; i < this.readers.length; i += 1) {
      const hazard = bus.load(this.readers[i]!.word + BusEndpoint.hazard);
      if (hazard >= frame && hazard < frame + units) return true;
    }
    return observed(this.bus, frame, units);
  }
}
