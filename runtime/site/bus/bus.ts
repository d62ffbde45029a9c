// The shared bus: one shared WebAssembly memory with fixed tables and 4 KiB pages. Memory, pages and wake words;
// knows nothing of samples. Every structure has one writer or is changed by compare-and-exchange only, so that a
// worker that is terminated at any instruction leaves nothing locked. Layout: protocol/SPEC.md section 4.

import {
  BusHeader,
  BusParticipant,
  BusParticipantState,
  BusSizes,
  BusTime,
  ErrorCode,
  protocolVersion,
  timeRateOne,
} from '../../protocol/generated/constants.ts';
import { atomicsOf, type BusAtomics } from './bus_atomics.ts';
import type { TimeLaw } from './time_law.ts';
import { decodeUtf8 } from '../contract/utf8.ts';

const magic = 0x52325742;

export interface BusOptions {
  /** Most bytes the bus may grow to. */
  readonly ceiling?: number;
  readonly participants?: number;
  readonly nodes?: number;
  readonly endpoints?: number;
  readonly graphLog?: number;
  /** The first words of every gid; random when omitted. */
  readonly session?: readonly [number, number];
}

export const defaultCeiling = 1 << 30;

function roundUp(value: number, unit: number): number {
  return Math.ceil(value / unit) * unit;
}

/** Bytes by which the memory grows at least. */
const wasmPage = 1 << 16;

/** A bus in the calling thread's hands. Offsets are bytes, `word` arguments are Int32 indices. */
export class Bus {
  readonly memory: WebAssembly.Memory;
  /** Atomic accesses; `i32` is for plain ones. */
  readonly load: BusAtomics['load'];
  readonly store: BusAtomics['store'];
  readonly add: BusAtomics['add'];
  readonly sub: BusAtomics['sub'];
  readonly or: BusAtomics['or'];
  readonly exchange: BusAtomics['exchange'];
  readonly compareExchange: BusAtomics['compareExchange'];
  private readonly size: BusAtomics['size'];
  i32: Int32Array;
  u8: Uint8Array;
  /** The tables only; they never move. */
  readonly i64: BigInt64Array;
  readonly participantCount: number;
  readonly nodeCount: number;
  readonly endpointCount: number;
  readonly graphLogMask: number;
  readonly pageLimit: number;
  private readonly participants: number;
  private readonly nodes: number;
  private readonly endpoints: number;
  readonly graphLog: number;
  private readonly pageTable: number;
  private readonly pages: number;

  constructor(memory: WebAssembly.Memory) {
    this.memory = memory;
    const atomics = atomicsOf(memory);
    this.load = atomics.load;
    this.store = atomics.store;
    this.add = atomics.add;
    this.sub = atomics.sub;
    this.or = atomics.or;
    this.exchange = atomics.exchange;
    this.compareExchange = atomics.compareExchange;
    this.size = atomics.size;
    const { buffer } = memory;
    this.i32 = new Int32Array(buffer);
    this.u8 = new Uint8Array(buffer);
    this.i64 = new BigInt64Array(buffer);
    const header = (word: number): number => this.load(word);
    if (header(BusHeader.magic) !== magic || header(BusHeader.version) !== protocolVersion) {
      throw new RangeError('not a bus of this protocol version');
    }
    this.participants = header(BusHeader.participants) >> 2;
    this.participantCount = header(BusHeader.participantCount);
    this.nodes = header(BusHeader.nodes) >> 2;
    this.nodeCount = header(BusHeader.nodeCount);
    this.endpoints = header(BusHeader.endpoints) >> 2;
    this.endpointCount = header(BusHeader.endpointCount);
    this.graphLog = header(BusHeader.graphLog) >> 2;
    this.graphLogMask = header(BusHeader.graphLogSize) - 1;
    this.pageTable = header(BusHeader.pageTable) >> 2;
    this.pageLimit = header(BusHeader.pageCount);
    this.pages = header(BusHeader.pages);
  }

  /** How many entries of a table were ever used, by the counter in the header: whatever stands there, it is within the table. */
  used(counter: number, count: number): number {
    const high = this.load(counter);
    return high >= 0 && high < count ? high : count;
  }

  /** True for bytes that lie in pages that are there; makes the views reach them. */
  holds(offset: number, length: number): boolean {
    if (!(offset >= this.pages && length >= 0)) return false;
    const end = offset + length;
    if (end <= this.u8.length) return true;
    if (end > this.size() * wasmPage) return false;
    this.renew();
    return true;
  }

  participantWord(index: number): number {
    return this.participants + index * (BusSizes.participant >> 2);
  }

  nodeWord(index: number): number {
    return this.nodes + index * (BusSizes.node >> 2);
  }

  endpointWord(index: number): number {
    return this.endpoints + index * (BusSizes.endpoint >> 2);
  }

  pageOffset(page: number): number {
    return this.pages + page * BusSizes.page;
  }

  pageOf(offset: number): number {
    return Math.floor((offset - this.pages) / BusSizes.page);
  }

  /** Makes the views reach `end`; another thread may have grown the buffer. */
  reach(end: number): void {
    if (end > this.u8.length) this.renew();
  }

  private renew(): void {
    const { memory } = this;
    // An engine may show a thread the old buffer for a while after another thread has grown the memory.
    if (memory.buffer.byteLength < this.size() * wasmPage) memory.grow(0);
    this.i32 = new Int32Array(memory.buffer);
    this.u8 = new Uint8Array(memory.buffer);
  }

  private pagesNow(): number {
    return Math.min(this.pageLimit, Math.floor((this.size() * wasmPage - this.pages) / BusSizes.page));
  }

  /** First page of a free run that now belongs to `owner` (not 0), or ErrorCode.outOfMemory. */
  allocate(count: number, owner: number): number {
    const hint = this.load(BusHeader.pageHint);
    for (;;) {
      const total = this.pagesNow();
      const from = hint >= 0 && hint < total ? hint : 0;
      let page = this.claimRun(from, total, count, owner);
      if (page < 0 && from > 0) page = this.claimRun(0, Math.min(total, from + count), count, owner);
      if (page >= 0) {
        this.store(BusHeader.pageHint, page + count);
        this.reach(this.pageOffset(page + count));
        return page;
      }
      if (!this.grow(total, count)) return ErrorCode.outOfMemory;
    }
  }

  private claimRun(from: number, to: number, count: number, owner: number): number {
    const table = this.pageTable;
    let start = from;
    let held = 0;
    while (start + count <= to) {
      if (this.compareExchange(table + start + held, 0, owner) === 0) {
        held += 1;
        if (held === count) return start;
        continue;
      }
      for (let i = 0; i < held; i += 1) this.store(table + start + i, 0);
      start += held + 1;
      held = 0;
    }
    return -1;
  }

  private grow(total: number, count: number): boolean {
    const step = Math.max(count, Math.min(Math.max(64, total), this.load(BusHeader.growPages)));
    for (const more of [step, count]) {
      const wanted = Math.min(total + more, this.pageLimit);
      if (wanted <= total) return false;
      try {
        this.memory.grow(Math.ceil(this.pageOffset(wanted) / wasmPage) - this.size());
      } catch {
        // Another thread grew further, or the machine has no more memory.
      }
      if (this.pagesNow() > total) {
        this.renew();
        return true;
      }
    }
    return false;
  }

  /** Gives back pages that the caller owns. */
  free(page: number, count: number): void {
    if (page < 0 || count < 0 || page + count > this.pagesNow()) return;
    for (let i = 0; i < count; i += 1) this.store(this.pageTable + page + i, 0);
    if (page < this.load(BusHeader.pageHint)) this.store(BusHeader.pageHint, page);
  }

  /** Gives back all pages of an owner. */
  freeAll(owner: number): void {
    const total = this.pagesNow();
    let lowest = -1;
    for (let page = 0; page < total; page += 1) {
      if (this.load(this.pageTable + page) !== owner) continue;
      this.store(this.pageTable + page, 0);
      if (lowest < 0) lowest = page;
    }
    if (lowest >= 0 && lowest < this.load(BusHeader.pageHint)) {
      this.store(BusHeader.pageHint, lowest);
    }
  }

  /** For tests and the page: how many pages are owned, and how many there are. */
  usage(): { used: number; total: number; } {
    const total = this.pagesNow();
    let used = 0;
    for (let page = 0; page < total; page += 1) if (this.load(this.pageTable + page) !== 0) used += 1;
    return { used, total };
  }

  /** A status of one of the participant's endpoints changed; the event is the caller's. */
  noteStatus(participant: number): void {
    this.add(this.participantWord(participant) + BusParticipant.status, 1);
  }

  /** Signals an event to a participant, and wakes its sleeping threads. */
  bump(participant: number): void {
    const word = this.participantWord(participant);
    this.add(word + BusParticipant.wake, 1);
    if (this.load(word + BusParticipant.sleepers) > 0) {
      Atomics.notify(this.i32, word + BusParticipant.wake);
    }
  }

  /** Asks a participant to stop, as SIGINT does. */
  requestStop(participant: number): void {
    const word = this.participantWord(participant);
    this.add(word + BusParticipant.stop, 1);
    this.rouse(participant);
  }

  /** All sleeps and waits of a participant look again whether they are over. */
  private rouse(participant: number): void {
    const word = this.participantWord(participant);
    this.add(word + BusParticipant.rouse, 1);
    Atomics.notify(this.i32, word + BusParticipant.rouse);
    this.bump(participant);
  }

  /** Time follows another law from now on; who waits is told by rouseAll. Only the page does this. */
  setTime({ realNs, siteNs, rate, limitNs }: TimeLaw): void {
    const { i64 } = this;
    const time = BusHeader.siteTime;
    const put = (word: number, ns: number): void => void Atomics.store(i64, (time + word) >> 1, BigInt(ns));
    this.add(time + BusTime.version, 1);
    this.store(time + BusTime.rate, Math.round(rate * timeRateOne));
    put(BusTime.real, realNs);
    put(BusTime.site, siteNs);
    put(BusTime.limit, limitNs === Infinity ? -1 : limitNs);
    this.add(time + BusTime.version, 1);
  }

  rouseAll(): void {
    for (let index = 0; index < this.participantCount; index += 1) {
      const state = this.load(this.participantWord(index) + BusParticipant.state);
      if (state === BusParticipantState.live) this.rouse(index);
    }
  }

  /** Index of a fresh participant, or ErrorCode.tableFull. */
  claimParticipant(): number {
    for (let index = 0; index < this.participantCount; index += 1) {
      const word = this.participantWord(index);
      const { free, live } = BusParticipantState;
      if (this.compareExchange(word + BusParticipant.state, free, live) !== free) continue;
      this.add(word + BusParticipant.generation, 1);
      this.store(word + BusParticipant.stop, 0);
      this.store(word + BusParticipant.graphInterest, 0);
      this.store(word + BusParticipant.sleepers, 0);
      this.store(word + BusParticipant.status, 0);
      this.store(word + BusParticipant.consolePosted, 0);
      this.store(word + BusParticipant.consoleSeen, 0);
      return index;
    }
    return ErrorCode.tableFull;
  }
}

/** Makes an empty bus; throws RangeError when the machine has no room for it. */
export function createBus(options: BusOptions = {}): Bus {
  const participants = options.participants ?? 512;
  const nodes = options.nodes ?? 2048;
  const endpoints = options.endpoints ?? 8192;
  const graphLog = options.graphLog ?? 4096;
  const ceiling = options.ceiling ?? defaultCeiling;
  const participantsAt = BusHeader.size;
  const nodesAt = participantsAt + participants * BusSizes.participant;
  const endpointsAt = roundUp(nodesAt + nodes * BusSizes.node, 64);
  const graphLogAt = endpointsAt + endpoints * BusSizes.endpoint;
  const pageTableAt = graphLogAt + graphLog * 4;
  const pageCount = Math.floor((ceiling - pageTableAt) / (BusSizes.page + 4)) - 1;
  if (pageCount < 64) throw new RangeError(`a bus of ${ceiling} bytes has no room for its tables`);
  const pagesAt = roundUp(pageTableAt + pageCount * 4, BusSizes.page);
  const first = pagesAt + Math.min(64, pageCount) * BusSizes.page;
  const memory = new WebAssembly.Memory({
    initial: Math.ceil(first / wasmPage),
    maximum: Math.ceil((pagesAt + pageCount * BusSizes.page) / wasmPage),
    shared: true,
  });
  const i32 = new Int32Array(memory.buffer);
  const set = (word: number, value: number): void => {
    i32[word] = value;
  };
  set(BusHeader.version, protocolVersion);
  set(BusHeader.participants, participantsAt);
  set(BusHeader.participantCount, participants);
  set(BusHeader.nodes, nodesAt);
  set(BusHeader.nodeCount, nodes);
  set(BusHeader.endpoints, endpointsAt);
  set(BusHeader.endpointCount, endpoints);
  set(BusHeader.graphLog, graphLogAt);
  set(BusHeader.graphLogSize, graphLog);
  set(BusHeader.pageTable, pageTableAt);
  set(BusHeader.pageCount, pageCount);
  set(BusHeader.pages, pagesAt);
  set(BusHeader.growPages, 16384);
  const session = options.session ?? crypto.getRandomValues(new Int32Array(2));
  set(BusHeader.session0, session[0] ?? 0);
  set(BusHeader.session1, session[1] ?? 0);
  atomicsOf(memory).store(BusHeader.magic, magic);
  return new Bus(memory);
}

/** Text in a slot, of at most as many bytes as there is room for. */
export function readText(bus: Bus, offset: number, length: number, most: number): string {
  return decodeUtf8(bus.u8.slice(offset, offset + (length >= 0 && length <= most ? length : 0)));
}
