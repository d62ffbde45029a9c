// The link over the shared bus. One instance per thread; the threads of a participant share the data in the bus.
// Discovery is the endpoint table: a participant that changes it bumps the graph version and wakes those concerned.

import {
  BusEndpoint,
  BusHeader,
  BusNode,
  BusParticipant,
  BusParticipantState,
  BusPhase,
  ErrorCode,
  flagHidden,
  maxNameLength,
  type StatusKind,
  WaitResult,
} from '../../protocol/generated/constants.ts';
import { type Bus, readText } from './bus.ts';
import { BusCells } from './bus_cells.ts';
import { bumpGeneration, claimSlot, departEndpoint, fillEndpoint, logChange, metBefore, nodeBit, raise, readEndpoint } from './bus_tables.ts';
import { SiteClock } from './clock.ts';
import { SharedCredit } from './console_sender.ts';
import { checkDescription, checkNode } from './description_check.ts';
import { type EndpointRecord, Graph, reads, relate, writes } from './graph.ts';
import type { ConsoleCredit, EndpointDescription, EndpointStatus, GraphSnapshot, Heap, Link } from './link.ts';
import { endpointKey, keyIndex } from './shared_ring.ts';
import { SharedReader } from './shared_reader.ts';
import { type Pause, SharedWriter } from './shared_writer.ts';
import { SharedWaits } from './shared_waits.ts';
import type { Turns } from './turns.ts';
import { SharedStatuses } from './shared_statuses.ts';
import { manualLease, Timing } from './timing.ts';
import { freeDeparted } from './unread.ts';

interface Own {
  readonly record: EndpointRecord;
  readonly word: number;
  readonly writer: SharedWriter | undefined;
  readonly reader: SharedReader | undefined;
  readonly timing: Timing;
  readonly matched: Set<number>;
  /** Keys of endpoints with the name whose QoS or type does not fit. */
  readonly strangers: Set<number>;
  /** How many with another QoS there were so far, as this thread saw it. */
  incompatible: number;
}

const encoder = new TextEncoder();

export interface SharedLinkOptions {
  readonly bus: Bus;
  readonly participant: number;
  /** May this thread sleep in Atomics.wait? */
  readonly mayBlock: boolean;
  /** In a stepped run. */
  readonly turns?: Turns | undefined;
}

export class SharedLink implements Link {
  readonly kind = 'shared';
  readonly bus: Bus;
  readonly participant: number;
  readonly clock: SiteClock;
  private readonly mayBlock: boolean;
  private readonly word: number;
  readonly graphReplica = new Graph();
  /** Key of what was last seen in a slot; 0: nothing. */
  private readonly seen: Int32Array;
  private readonly seenNodes: Int32Array;
  private readonly own = new Map<number, Own>();
  private readonly readers: Own[] = [];
  /** The readers that had data at the last look; valid until an event comes after `lookedAt`. undefined: look at all readers. */
  private hopeful: Own[] | undefined;
  private lookedAt = 0;
  private readonly statuses: SharedStatuses;
  /** Own endpoints that were destroyed and are not freed yet, oldest first. */
  private readonly departed = new Map<number, Own>();
  /** Readers that have lost their last writer, until that is settled. */
  private readonly alone = new Set<Own>();
  /** How often each own endpoint was matched so far, as this thread saw it. */
  private readonly totals = new Map<number, number>();
  private version = -1;
  readonly consoleCredit: ConsoleCredit;
  private readonly waits: SharedWaits;
  private readonly syncNow = (): boolean => this.sync();
  private readonly pause: Pause;

  constructor({ bus, participant, mayBlock, turns }: SharedLinkOptions) {
    this.bus = bus;
    this.participant = participant;
    this.mayBlock = mayBlock;
    this.word = bus.participantWord(participant);
    this.consoleCredit = new SharedCredit(bus, this.word);
    this.clock = new SiteClock(bus);
    this.statuses = new SharedStatuses(bus, participant, this.clock);
    this.waits = new SharedWaits({
      bus,
      participant,
      turns,
      clock: this.clock,
      statuses: this.statuses,
      sync: this.syncNow,
    });
    this.seen = new Int32Array(bus.endpointCount);
    this.seenNodes = new Int32Array(bus.nodeCount);
    this.pause = (token, mostMs) => {
      if (!mayBlock) return 'cannot';
      const result = mostMs === Infinity ? this.waits.wait(token, Infinity) : this.waits.waitReally(token, mostMs);
      return result === WaitResult.stop ? 'stop' : 'again';
    };
    this.sync();
  }

  nodeCreate(name: string, namespace: string): number {
    const wrong = checkNode(name, namespace);
    if (wrong < 0) return wrong;
    const nameBytes = encoder.encode(name);
    const namespaceBytes = encoder.encode(namespace);
    const { bus } = this;
    const index = claimSlot(bus, this.participant, bus.nodeCount, (i) => bus.nodeWord(i));
    if (index < 0) return ErrorCode.tableFull;
    const word = bus.nodeWord(index);
    bus.i32[word + BusNode.namespaceLength] = namespaceBytes.length;
    bus.i32[word + BusNode.nameLength] = nameBytes.length;
    bus.u8.set(namespaceBytes, (word << 2) + BusNode.namespaceBytes);
    bus.u8.set(nameBytes, (word << 2) + BusNode.nameBytes);
    bus.add(word + BusNode.generation, 1);
    raise(bus, BusHeader.nodeHigh, index + 1);
    bus.store(word, ((this.participant + 1) << 8) | BusPhase.live);
    logChange(bus, nodeBit | index);
    if (this.ended()) {
      this.nodeDestroy(index);
      return ErrorCode.stopped;
    }
    this.wakeInterested([]);
    return index;
  }

  nodeDestroy(node: number): void {
    const { bus } = this;
    if (node < 0 || node >= bus.nodeCount) return;
    const live = ((this.participant + 1) << 8) | BusPhase.live;
    // Free only when it is logged: until then the broker can tell whose it was.
    const departed = (live & ~255) | BusPhase.departed;
    if (bus.compareExchange(bus.nodeWord(node), live, departed) !== live) return;
    logChange(bus, nodeBit | node);
    bus.store(bus.nodeWord(node), BusPhase.free);
    this.wakeInterested([]);
  }

  endpointCreate(description: EndpointDescription): number {
    const { bus } = this;
    const wrong = checkDescription(description);
    if (wrong < 0) return wrong;
    if (!this.ownsNode(description.node)) return ErrorCode.badHandle;
    const index = claimSlot(bus, this.participant, bus.endpointCount, (i) => bus.endpointWord(i));
    if (index < 0) return ErrorCode.tableFull;
    const word = bus.endpointWord(index);
    if (bus.load(word + BusEndpoint.generation) === 0) bus.store(word + BusEndpoint.generation, 1);
    const key = endpointKey(index, bus.load(word + BusEndpoint.generation));
    const session = [bus.load(BusHeader.session0), bus.load(BusHeader.session1)];
    const { node, past, ...rest } = description;
    const gid = new Int32Array([...session, key, this.participant + 1]);
    const record = { ...rest, key, gid, participant: this.participant, nodeKey: node };
    fillEndpoint(bus, record);
    if (manualLease(record) !== 0) new BusCells(bus, word).exchangeAsserted(this.clock.steadyNs());
    if (reads(record.kind) && !this.placeCursors(record, past === true)) {
      bus.freeAll(key);
      bumpGeneration(bus, word);
      bus.store(word, BusPhase.free);
      return ErrorCode.outOfMemory;
    }
    raise(bus, BusHeader.endpointHigh, index + 1);
    bus.store(word, ((this.participant + 1) << 8) | BusPhase.live);
    logChange(bus, index);
    if (this.ended()) {
      departEndpoint(bus, key, this.participant);
      return ErrorCode.stopped;
    }
    this.sync();
    this.wakeConcerned(key);
    return index;
  }

  /** A browser lets a terminated worker run on for a while: the broker has ended it, and nobody may see more of it. */
  private ended(): boolean {
    return this.bus.load(this.word + BusParticipant.state) !== BusParticipantState.live;
  }

  /** Before a reader is visible: notes where the writers that are there already stand. False when there is no room. */
  private placeCursors(record: EndpointRecord, past: boolean): boolean {
    this.sync();
    const reader = new SharedReader(this.bus, record, this.clock, this.syncNow);
    for (const writer of this.graphReplica.named(record.name)) {
      if (relate(record, writer).kind === 'match' && !reader.startAt(writer, past)) return false;
    }
    return true;
  }

  private ownsNode(node: number): boolean {
    if (node < 0 || node >= this.bus.nodeCount) return false;
    return this.bus.load(this.bus.nodeWord(node)) === (((this.participant + 1) << 8) | BusPhase.live);
  }

  endpointDestroy(endpoint: number): void {
    this.sync();
    const own = this.own.get(endpoint);
    if (own === undefined) return;
    this.departOwn(own);
  }

  private departOwn(own: Own): void {
    if (!departEndpoint(this.bus, own.record.key, this.participant)) return;
    // Endpoints that came since the last look must get the event, too.
    this.sync();
    this.wakeInterested(this.relatives(own.record));
    freeDeparted(this.bus, this.participant, this.departed);
  }

  gid(endpoint: number): Int32Array | undefined {
    return this.find(endpoint)?.record.gid;
  }

  write(endpoint: number, heap: Heap, address: number, length: number, info: number): number {
    // The first look at the graph that a write takes.
    this.sync();
    const writer = this.own.get(endpoint)?.writer;
    if (writer === undefined) return ErrorCode.badHandle;
    const result = writer.write(heap, address, length, info);
    const room = result === ErrorCode.outOfMemory && freeDeparted(this.bus, this.participant, this.departed, 0);
    return room ? writer.write(heap, address, length, info) : result;
  }

  take(endpoint: number, heap: Heap, address: number, capacity: number, info: number): number {
    this.sync();
    const reader = this.own.get(endpoint)?.reader;
    if (reader === undefined) return ErrorCode.badHandle;
    return reader.take(heap, address, capacity, info);
  }

  ready(): readonly number[] {
    // A reader without data gets a signal and an event when data comes: without an event, it still has none.
    const token = this.wakeToken();
    this.sync();
    const looked = token === this.lookedAt && this.hopeful !== undefined ? this.hopeful : this.readers;
    const hopeful: Own[] = [];
    const out: number[] = [];
    for (let i = 0; i < looked.length; i += 1) {
      const own = looked[i]!;
      if (own.reader?.hasData() !== true) continue;
      hopeful.push(own);
      out.push(keyIndex(own.record.key));
    }
    this.hopeful = hopeful;
    this.lookedAt = token;
    return out;
  }

  wakeToken(): number {
    return this.bus.load(this.word + BusParticipant.wake);
  }

  wait(token: number, timeoutMs: number): WaitResult {
    if (!this.mayBlock) throw new TypeError('this thread may not block');
    return this.waits.wait(token, timeoutMs < 0 ? Infinity : timeoutMs);
  }

  wake(): void {
    this.bus.bump(this.participant);
  }

  sleep(durationMs: number): WaitResult {
    if (!this.mayBlock) throw new TypeError('this thread may not block');
    return this.waits.sleep(durationMs);
  }

  awaitTurn(): void {
    this.waits.awaitTurn();
  }

  stops(): number {
    return this.bus.load(this.word + BusParticipant.stop);
  }

  stopRequested(): boolean {
    return this.bus.load(this.word + BusParticipant.stop) !== 0;
  }

  matched(endpoint: number): number {
    this.sync();
    return this.own.get(endpoint)?.matched.size ?? ErrorCode.badHandle;
  }

  status(endpoint: number, kind: StatusKind): EndpointStatus | undefined {
    this.sync();
    const own = this.own.get(endpoint);
    return own === undefined ? undefined : this.statuses.read(own, kind);
  }

  statusVersion(): number {
    this.sync();
    return this.statuses.version();
  }

  assertLiveliness(endpoint: number): number {
    const writer = this.find(endpoint)?.writer;
    if (writer === undefined) return ErrorCode.badHandle;
    writer.assert();
    return 0;
  }

  graphVersion(): number {
    this.bus.store(this.word + BusParticipant.graphInterest, 1);
    return this.bus.load(BusHeader.graphVersion);
  }

  graph(): GraphSnapshot {
    this.graphVersion();
    this.sync();
    return this.graphReplica.snapshot();
  }

  /** Departs whatever this participant still has. */
  close(): void {
    this.sync();
    for (const own of [...this.own.values()]) this.departOwn(own);
    for (const [key, node] of this.graphReplica.nodes) {
      if (node.participant === this.participant) this.nodeDestroy(key);
    }
  }

  /** Records of the endpoints that live now, with their words; for the page's sampler. */
  records(): readonly EndpointRecord[] {
    this.sync();
    return [...this.graphReplica.endpoints.values()].filter((record) => (record.flags & flagHidden) === 0);
  }

  private find(endpoint: number): Own | undefined {
    const own = this.own.get(endpoint);
    if (own !== undefined) return own;
    this.sync();
    return this.own.get(endpoint);
  }

  /** Brings the replica up to the table; false, and one load, when nothing changed. */
  private sync(): boolean {
    const { bus } = this;
    const now = bus.load(BusHeader.graphVersion);
    if (now === this.version) return false;
    const behind = (now - this.version) | 0;
    const known = this.version;
    this.version = now;
    if (known >= 0 && behind > 0 && behind < this.bus.graphLogMask) {
      for (let v = (known + 1) | 0;; v = (v + 1) | 0) {
        const entry = bus.load(this.bus.graphLog + (v & this.bus.graphLogMask));
        if ((entry >>> 16) !== (v & 0xffff)) {
          this.syncAll();
          break;
        }
        if ((entry & nodeBit) !== 0) this.syncNode(entry & 0x7fff);
        else this.syncEndpoint(entry & 0x7fff);
        if (v === now) break;
      }
    } else {
      this.syncAll();
    }
    if (this.departed.size > 0) freeDeparted(this.bus, this.participant, this.departed);
    if (this.alone.size > 0) this.endDeadlines();
    return true;
  }

  /** Without any writer no deadline runs; one that took the place of the last has perhaps written already. */
  private endDeadlines(): void {
    const now = this.clock.steadyNs();
    if (this.bus.load(BusHeader.graphVersion) !== this.version) return;
    for (const own of this.alone) if (own.matched.size === 0) own.timing.pause(now);
    this.alone.clear();
  }

  private syncAll(): void {
    const nodes = this.bus.used(BusHeader.nodeHigh, this.bus.nodeCount);
    for (let index = 0; index < nodes; index += 1) this.syncNode(index);
    const endpoints = this.bus.used(BusHeader.endpointHigh, this.bus.endpointCount);
    for (let index = 0; index < endpoints; index += 1) this.syncEndpoint(index);
  }

  private syncNode(index: number): void {
    const { bus } = this;
    if (index >= bus.nodeCount) return;
    const word = bus.nodeWord(index);
    const state = bus.load(word);
    const generation = bus.load(word + BusNode.generation);
    const live = (state & 255) === BusPhase.live;
    const seen = this.seenNodes[index]!;
    if (seen === (live ? generation : 0)) return;
    this.seenNodes[index] = live ? generation : 0;
    if (!live) {
      this.graphReplica.nodes.delete(index);
      return;
    }
    const at = word << 2;
    this.graphReplica.nodes.set(index, {
      key: index,
      participant: (state >>> 8) - 1,
      namespace: readText(bus, at + BusNode.namespaceBytes, bus.i32[word + BusNode.namespaceLength]!, maxNameLength),
      name: readText(bus, at + BusNode.nameBytes, bus.i32[word + BusNode.nameLength]!, maxNameLength),
    });
  }

  private syncEndpoint(index: number): void {
    const { bus } = this;
    if (index >= bus.endpointCount) return;
    const word = bus.endpointWord(index);
    const seen = this.seen[index]!;
    const phase = bus.load(word) & 255;
    const present = phase === BusPhase.live || phase === BusPhase.departed;
    const key = present ? endpointKey(index, bus.load(word + BusEndpoint.generation)) : 0;
    if (seen !== 0 && seen !== key) {
      this.dropEndpoint(seen);
      this.seen[index] = 0;
    }
    if (!present) return;
    if (seen !== key) {
      const read = readEndpoint(bus, index);
      if (read === undefined || read.record.key !== key) return;
      this.seen[index] = key;
      this.addEndpoint(read.record, read.departed);
    } else if (phase === BusPhase.departed) {
      this.forgetEndpoint(key);
    }
  }

  private addEndpoint(record: EndpointRecord, departed: boolean): void {
    if (record.participant === this.participant && !departed) this.adopt(record);
    for (const own of this.ownRelatives(record)) this.introduce(own, record, departed);
    if (!departed) this.graphReplica.add(record);
  }

  /** An endpoint of this participant: made here, or by another thread. */
  private adopt(record: EndpointRecord): void {
    const word = this.bus.endpointWord(keyIndex(record.key));
    const timing = new Timing(record, new BusCells(this.bus, word));
    const own: Own = {
      record,
      word,
      writer: writes(record.kind)
        ? new SharedWriter(this.bus, record, this.clock, timing, this.syncNow, this.pause)
        : undefined,
      reader: reads(record.kind) ? new SharedReader(this.bus, record, this.clock, this.syncNow) : undefined,
      timing,
      matched: new Set(),
      strangers: new Set(),
      incompatible: 0,
    };
    this.own.set(keyIndex(record.key), own);
    if (own.reader !== undefined) this.readers.push(own);
    this.hopeful = undefined;
    if (timing.ticks) this.statuses.ticker.follow(this.own.values());
    for (const other of this.graphReplica.named(record.name)) this.introduce(own, other, false);
  }

  private *ownRelatives(record: EndpointRecord): Iterable<Own> {
    for (const other of this.graphReplica.named(record.name)) {
      if (other.participant !== this.participant) continue;
      const own = this.own.get(keyIndex(other.key));
      if (own !== undefined && own.record.key === other.key) yield own;
    }
    for (const own of this.departed.values()) if (own.record.name === record.name) yield own;
  }

  private introduce(own: Own, other: EndpointRecord, departed: boolean): void {
    const relation = relate(own.record, other);
    switch (relation.kind) {
      case 'none':
        return;
      case 'match':
        if (departed && !metBefore(this.bus, own.word, this.bus.endpointWord(keyIndex(other.key)))) return;
        own.reader?.match(other);
        if (!departed) {
          own.writer?.match(other);
          own.matched.add(other.key);
          this.publishMatched(own, 1);
          if (own.reader !== undefined && manualLease(other) !== 0) {
            own.timing.match(other, new BusCells(this.bus, this.bus.endpointWord(keyIndex(other.key))));
            this.statuses.ticker.follow(this.own.values());
          }
        }
        return;
      case 'incompatible':
        if (departed || own.strangers.has(other.key)) return;
        own.strangers.add(other.key);
        own.incompatible += 1;
        this.bus.store(own.word + BusEndpoint.incompatiblePolicy, relation.policy);
        if (raise(this.bus, own.word + BusEndpoint.incompatibleTotal, own.incompatible)) this.statuses.note();
        return;
      case 'wrong_type':
        if (departed || own.strangers.has(other.key)) return;
        own.strangers.add(other.key);
        if (raise(this.bus, own.word + BusEndpoint.wrongTypeTotal, 1)) this.statuses.note();
        return;
    }
  }

  /** Counters in the bus only grow to what the best-informed thread has seen. */
  private publishMatched(own: Own, gained: number): void {
    const total = (this.totals.get(own.record.key) ?? 0) + gained;
    this.totals.set(own.record.key, total);
    const grew = raise(this.bus, own.word + BusEndpoint.matchedTotal, total);
    const before = this.bus.exchange(own.word + BusEndpoint.matchedCurrent, own.matched.size);
    if (grew || before !== own.matched.size) this.statuses.note();
  }

  private forgetEndpoint(key: number): void {
    const record = this.graphReplica.remove(key);
    if (record === undefined) return;
    for (const own of this.ownRelatives(record)) {
      own.writer?.unmatch(key);
      own.strangers.delete(key);
      if (!own.matched.delete(key)) continue;
      if (own.reader !== undefined) {
        own.timing.unmatch(key);
        if (own.matched.size === 0) this.alone.add(own);
      }
      this.publishMatched(own, 0);
    }
    if (record.participant !== this.participant) return;
    const index = keyIndex(key);
    const own = this.own.get(index);
    if (own === undefined || own.record.key !== key) return;
    this.own.delete(index);
    const place = this.readers.indexOf(own);
    if (place >= 0) this.readers.splice(place, 1);
    this.hopeful = undefined;
    if (own.timing.ticks) this.statuses.ticker.follow(this.own.values());
    // After the broker has ended this participant, this thread may still be writing to the endpoint: then the broker frees it.
    if (!this.ended()) this.departed.set(key, own);
  }

  private dropEndpoint(key: number): void {
    this.forgetEndpoint(key);
    this.departed.delete(key);
    this.totals.delete(key);
  }

  /** Participants that own an endpoint which this one matches, or fails to match. */
  private relatives(record: EndpointRecord): number[] {
    const out: number[] = [];
    for (const other of this.graphReplica.named(record.name)) {
      if (relate(record, other).kind !== 'none') out.push(other.participant);
    }
    return out;
  }

  private wakeConcerned(key: number): void {
    const record = this.graphReplica.endpoints.get(key);
    if (record !== undefined) this.wakeInterested(this.relatives(record));
  }

  private wakeInterested(also: readonly number[]): void {
    const { bus } = this;
    const set = new Set(also);
    for (let i = 0; i < bus.participantCount; i += 1) {
      if (bus.load(bus.participantWord(i) + BusParticipant.graphInterest) !== 0) set.add(i);
    }
    for (const participant of set) bus.bump(participant);
  }
}
