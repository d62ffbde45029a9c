// The link over message ports, for pages without shared memory. Every worker has a port to every other and a replica
// of the graph. Nothing arrives while a program computes: it must wait or sleep, which suspends it and lets the event
// loop run. Used within one thread.

import { EndpointKind, ErrorCode, flagHidden, frameHeaderSize, maxSampleLength, type StatusKind, WaitResult } from '../../protocol/generated/constants.ts';
import { SiteClock } from './clock.ts';
import type { TimeLaw } from './time_law.ts';
import { LocalCredit } from './console_sender.ts';
import { checkDescription, checkNode } from './description_check.ts';
import { fillHeader } from './frame_header.ts';
import { type EndpointRecord, Graph, reads, relate, writes } from './graph.ts';
import type { EndpointDescription, EndpointStatus, GraphSnapshot, Heap, Link } from './link.ts';
import { EventCounters } from './event_counters.ts';
import { readPeer } from './peer_reader.ts';
import type { ControlMessage, PeerMessage, PeerPort, PeerRecords, PortTicket, WriterSample } from './port_messages.ts';
import { PortSamples } from './port_samples.ts';
import { type Arrivals, PortReader } from './port_reader.ts';
import { PortWaits, unref } from './port_waits.ts';
import { type Frame, PortWriter, windowBytes, windowFrames } from './port_writer.ts';
import { readStatus } from './statuses.ts';
import { Ticker } from './ticker.ts';
import { LocalCells, manualLease, Timing } from './timing.ts';

interface Own {
  readonly record: EndpointRecord;
  readonly writer: PortWriter | undefined;
  readonly reader: PortReader | undefined;
  /** Peers' endpoints that know this one. */
  readonly matched: Set<number>;
  readonly strangers: Set<number>;
  readonly timing: Timing;
  readonly counters: EventCounters;
}

export class PortLink implements Link {
  readonly kind = 'port';
  readonly participant: number;
  private readonly session: readonly [number, number];
  private readonly control: MessagePort;
  readonly consoleCredit = new LocalCredit();
  /** Called when a peer sent what is not a message of the link; it is not heard any more. */
  strange: (participant: number) => void = () => undefined;
  private readonly peers = new Map<number, MessagePort>();
  readonly graphReplica = new Graph();
  private readonly own = new Map<number, Own>();
  private readonly arrivals = new Map<number, Arrivals>();
  readonly samples = new PortSamples();
  /** Signs of life of the writers here and elsewhere that have to give them. */
  private readonly lives = new Map<number, LocalCells>();
  readonly clock = new SiteClock();
  private readonly ticker = new Ticker(this.clock);
  private statuses = 0;
  private nextKey = 1;
  private version = 0;
  private readonly waits = new PortWaits(this.clock);
  private readonly taken = (writer: number): void => this.acknowledge(writer, true);
  private closed = false;

  constructor({ participant, session, time, control, peers, known }: PortTicket) {
    this.clock.set(time);
    this.participant = participant;
    this.session = session;
    this.control = control;
    control.addEventListener('message', (event) => this.onControl((event as MessageEvent<ControlMessage>).data));
    control.start();
    unref(control);
    for (const node of known.nodes) this.graphReplica.nodes.set(node.key, node);
    for (const record of known.endpoints) this.graphReplica.add(record);
    for (const peer of peers) this.addPeer(peer);
  }

  /** The nodes and endpoints that this participant has created so far. */
  made(): PeerRecords {
    const nodes = [...this.graphReplica.nodes.values()].filter((node) => node.participant === this.participant);
    return { nodes, endpoints: [...this.own.values()].map(({ record }) => record) };
  }

  /**
   * Numbers of participants come again: what an earlier one left ends here, and its late words are not heard.
   * `told`: it knows already what was made here.
   */
  addPeer({ participant, port }: PeerPort, told = false): void {
    if (this.peers.has(participant)) this.dropPeer(participant, false);
    this.peers.set(participant, port);
    port.addEventListener('message', (event) => {
      if (this.peers.get(participant) === port) this.onPeer(participant, (event as MessageEvent<unknown>).data);
    });
    port.start();
    unref(port);
    if (told) return;
    const { nodes, endpoints } = this.made();
    for (const node of nodes) this.post(participant, { t: 'node+', node });
    for (const record of endpoints) this.post(participant, { t: 'ep+', record });
  }

  /** A peer that ended; `died`: without taking leave. */
  dropPeer(participant: number, died: boolean): void {
    this.peers.get(participant)?.close();
    this.peers.delete(participant);
    for (const record of [...this.graphReplica.endpoints.values()]) {
      if (record.participant === participant) this.removeRemote(record.key, died);
    }
    for (const node of [...this.graphReplica.nodes.values()]) {
      if (node.participant === participant) this.graphReplica.nodes.delete(node.key);
    }
    this.changed();
  }

  nodeCreate(name: string, namespace: string): number {
    const wrong = checkNode(name, namespace);
    if (wrong < 0) return wrong;
    const handle = this.newHandle();
    const node = { key: this.keyOf(handle), participant: this.participant, namespace, name };
    this.graphReplica.nodes.set(node.key, node);
    this.broadcast({ t: 'node+', node });
    this.changed();
    return handle;
  }

  nodeDestroy(node: number): void {
    if (!this.graphReplica.nodes.delete(this.keyOf(node))) return;
    this.broadcast({ t: 'node-', key: this.keyOf(node) });
    this.changed();
  }

  private newHandle(): number {
    const handle = this.nextKey;
    this.nextKey += 1;
    return handle;
  }

  private keyOf(handle: number): number {
    return (this.participant << 20) | handle;
  }

  endpointCreate(description: EndpointDescription): number {
    // No publisher holds anything here for those who come later, but for latched ones.
    const { node, past: _past, ...rest } = description;
    const wrong = checkDescription(description);
    if (wrong < 0) return wrong;
    if (!this.graphReplica.nodes.has(this.keyOf(node))) return ErrorCode.badHandle;
    if (this.nextKey > 0xfffff) return ErrorCode.tableFull;
    const handle = this.newHandle();
    const key = this.keyOf(handle);
    const gid = new Int32Array([...this.session, key, this.participant + 1]);
    const record: EndpointRecord = { ...rest, key, gid, participant: this.participant, nodeKey: this.keyOf(node) };
    const timing = new Timing(record, this.lifeOf(record));
    const own: Own = {
      record,
      writer: writes(record.kind) ? new PortWriter(record, (to, frame) => this.send(to, record.key, frame)) : undefined,
      reader: reads(record.kind) ? new PortReader(record, this.clock, this.taken) : undefined,
      matched: new Set(),
      strangers: new Set(),
      timing,
      counters: new EventCounters(),
    };
    this.own.set(handle, own);
    if (timing.ticks) this.ticker.follow(this.own.values());
    this.graphReplica.add(record);
    this.broadcast({ t: 'ep+', record });
    for (const other of [...this.graphReplica.named(record.name)]) {
      if (other.key === key) continue;
      this.introduce(own, other);
      const local = this.ownOf(other.key);
      if (local !== undefined) this.introduce(local, record);
    }
    this.changed();
    return handle;
  }

  /** A local pair is matched at once; a remote one when the peer has said that it knows us. */
  private introduce(own: Own, other: EndpointRecord): void {
    const relation = relate(own.record, other);
    switch (relation.kind) {
      case 'none':
        return;
      case 'match': {
        const { late, after } = own.writer?.match(other) ?? { late: [], after: 0 };
        if (other.participant === this.participant) {
          own.reader?.open(other, undefined);
          this.addMatch(own, other);
          const local = this.ownOf(other.key);
          if (late.length > 0) local?.reader?.open(own.record, undefined);
          for (const frame of late) if (local !== undefined) this.receive(local, own.record.key, frame);
          return;
        }
        this.post(other.participant, { t: 'match', mine: own.record.key, yours: other.key, after });
        if (late.length > 0) this.post(other.participant, { t: 'late', reader: other.key, frames: late });
        return;
      }
      case 'incompatible':
        if (own.strangers.has(other.key)) return;
        own.strangers.add(other.key);
        own.counters.counts.incompatible += 1;
        own.counters.lastPolicy = relation.policy;
        this.noteStatus();
        return;
      case 'wrong_type':
        if (own.strangers.has(other.key)) return;
        own.strangers.add(other.key);
        own.counters.counts.wrongType = 1;
        this.noteStatus();
        return;
    }
  }

  private addMatch(own: Own, other: EndpointRecord): void {
    if (own.matched.has(other.key)) return;
    own.matched.add(other.key);
    own.counters.counts.matched += 1;
    this.noteStatus();
    if (own.reader === undefined || manualLease(other) === 0) return;
    own.timing.match(other, this.lifeOf(other));
    this.ticker.follow(this.own.values());
  }

  /** Where the times of an endpoint are kept; a writer counts as alive from when it was first heard of. */
  private lifeOf(record: EndpointRecord): LocalCells {
    let cells = this.lives.get(record.key);
    if (cells === undefined) {
      cells = new LocalCells(this.clock.steadyNs());
      if (manualLease(record) !== 0) this.lives.set(record.key, cells);
    }
    return cells;
  }

  private ownOf(key: number): Own | undefined {
    return key >>> 20 === this.participant ? this.own.get(key & 0xfffff) : undefined;
  }

  endpointDestroy(endpoint: number): void {
    const own = this.own.get(endpoint);
    if (own === undefined) return;
    own.writer?.farewell();
    this.own.delete(endpoint);
    const { key } = own.record;
    const last = own.writer?.sample(false);
    // Participant 0 is the page, which shows what was published.
    for (const to of this.peers.keys()) this.post(to, { t: 'ep-', key, ...(to === 0 ? { last } : {}) });
    this.removeRemote(key, false);
    // A reader that wanted all may have held up its writers.
    if (own.reader?.all === true) { for (const { key } of this.graphReplica.named(own.record.name)) this.acknowledge(key, false); }
    if (own.timing.ticks) this.ticker.follow(this.own.values());
    this.changed();
  }

  /** Takes an endpoint, also an own one, out of the replica and of all lists. */
  private removeRemote(key: number, died: boolean): EndpointRecord | undefined {
    const record = this.graphReplica.remove(key);
    if (record === undefined) return undefined;
    for (const other of this.graphReplica.named(record.name)) {
      const own = this.ownOf(other.key);
      if (own === undefined) continue;
      own.writer?.unmatch(record);
      own.reader?.shut(key);
      own.strangers.delete(key);
      if (!own.matched.delete(key)) continue;
      if (own.reader !== undefined) {
        own.timing.unmatch(key);
        if (own.matched.size === 0) own.timing.pause(this.clock.steadyNs());
      }
      if (died) own.counters.died += 1;
      this.noteStatus();
    }
    this.lives.delete(key);
    this.arrivals.delete(key);
    this.samples.forget(key);
    return record;
  }

  gid(endpoint: number): Int32Array | undefined {
    return this.own.get(endpoint)?.record.gid;
  }

  write(endpoint: number, heap: Heap, address: number, length: number, info: number): number | Promise<number> {
    const own = this.own.get(endpoint);
    const writer = own?.writer;
    if (own === undefined || writer === undefined) return ErrorCode.badHandle;
    if (length > maxSampleLength) return ErrorCode.tooLarge;
    let buffer: ArrayBuffer;
    try {
      buffer = new ArrayBuffer(frameHeaderSize + length);
    } catch {
      return ErrorCode.outOfMemory;
    }
    new Uint8Array(buffer).set(heap.u8.subarray(address, address + length), frameHeaderSize);
    const sequence = writer.sequence + 1;
    const target = fillHeader(own.record, this.clock, new Int32Array(buffer, 0, 16), heap.i32, info >> 2, sequence, length);
    const frame: Frame = { buffer, sequence, target };
    if (writer.full()) return this.writeLater(own, writer, frame);
    if (own.timing.ticks) own.timing.wrote(this.clock.steadyNs());
    writer.push(frame);
    return 0;
  }

  private async writeLater(own: Own, writer: PortWriter, frame: Frame): Promise<number> {
    while (writer.full()) {
      if (this.closed || (await this.wait(this.waits.token, -1)) === WaitResult.stop) return ErrorCode.stopped;
    }
    if (own.timing.ticks) own.timing.wrote(this.clock.steadyNs());
    writer.push(frame);
    return 0;
  }

  private send(participant: number, writer: number, frame: Frame): void {
    if (participant === this.participant) this.deliver(participant, writer, frame.buffer);
    else this.peers.get(participant)?.postMessage(frame.buffer);
  }

  take(endpoint: number, heap: Heap, address: number, capacity: number, info: number): number {
    const reader = this.own.get(endpoint)?.reader;
    if (reader === undefined) return ErrorCode.badHandle;
    return reader.take(heap, address, capacity, info);
  }

  ready(): readonly number[] {
    const out: number[] = [];
    for (const [handle, own] of this.own) if (own.reader?.hasData === true) out.push(handle);
    return out;
  }

  wakeToken(): number {
    return this.waits.token;
  }

  async wait(token: number, timeoutMs: number): Promise<WaitResult> {
    if (this.ticker.idle) return await this.waits.wait(token, timeoutMs);
    const end = timeoutMs < 0 ? Infinity : this.clock.steadyNs() + timeoutMs * 1e6;
    for (;;) {
      if (this.tick()) return WaitResult.woken;
      const next = Math.min(end, this.ticker.due());
      const result = await this.waits.wait(token, next === Infinity ? -1 : Math.max(0, next - this.clock.steadyNs()) / 1e6);
      if (result !== WaitResult.timeout || this.clock.steadyNs() >= end) return result;
    }
  }

  wake(): void {
    this.waits.wake();
  }

  sleep(durationMs: number): Promise<WaitResult> {
    return this.waits.sleep(durationMs);
  }

  setTime(law: TimeLaw): void {
    this.clock.set(law);
    this.waits.timeChanged();
  }

  stops(): number {
    return this.waits.stops;
  }

  stopRequested(): boolean {
    return this.waits.stops > 0;
  }

  matched(endpoint: number): number {
    return this.own.get(endpoint)?.matched.size ?? ErrorCode.badHandle;
  }

  status(endpoint: number, kind: StatusKind): EndpointStatus | undefined {
    const own = this.own.get(endpoint);
    if (own === undefined) return undefined;
    own.counters.counts.lost = own.reader?.lost ?? 0;
    return readStatus(own.record.kind, kind, own.counters, own.timing, own.matched.size, this.clock.steadyNs());
  }

  statusVersion(): number {
    this.tick();
    return this.statuses;
  }

  assertLiveliness(endpoint: number): number {
    const own = this.own.get(endpoint);
    if (own?.writer === undefined) return ErrorCode.badHandle;
    const { record } = own;
    if (manualLease(record) === 0) return 0;
    if (own.timing.assert(this.clock.steadyNs())) this.wake();
    this.broadcast({ t: 'alive', writer: record.key });
    return 0;
  }

  private noteStatus(): void {
    this.statuses = (this.statuses + 1) | 0;
  }

  /** True when time has changed a status that somebody reads. */
  private tick(): boolean {
    const changed = this.ticker.tick();
    if (changed) this.noteStatus();
    return changed;
  }

  graphVersion(): number {
    return this.version;
  }

  graph(): GraphSnapshot {
    return this.graphReplica.snapshot();
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    for (const handle of [...this.own.keys()]) this.endpointDestroy(handle);
    this.broadcast({ t: 'bye' });
    for (const port of this.peers.values()) port.close();
    this.peers.clear();
    this.control.close();
    this.waits.close();
  }

  /** Asks all peers for what their writers did; the answers are in `sampled` later. */
  requestSamples(topics: readonly string[]): void {
    this.samples.look();
    this.broadcast({ t: 'sample', topics });
  }

  sampled(): ReadonlyMap<number, WriterSample> {
    for (const sample of this.samplesOf([])) this.samples.note(sample);
    return this.samples.samples;
  }

  records(): readonly EndpointRecord[] {
    return [...this.graphReplica.endpoints.values()].filter((record) => (record.flags & flagHidden) === 0);
  }

  private samplesOf(topics: readonly string[]): WriterSample[] {
    const out: WriterSample[] = [];
    for (const { record, writer } of this.own.values()) {
      if (writer === undefined || record.kind !== EndpointKind.publisher) continue;
      const sample = writer.sample(topics.includes(record.name));
      if (sample !== undefined) out.push(sample);
    }
    return out;
  }

  private onControl(message: ControlMessage): void {
    switch (message.t) {
      case 'peer':
        this.addPeer(message.peer);
        return;
      case 'gone':
        this.dropPeer(message.participant, true);
        return;
      case 'stop':
        this.waits.stop();
        return;
      case 'seen':
        this.consoleCredit.seen();
        return;
      case 'time':
        this.setTime(message.law);
        return;
    }
  }

  private onPeer(participant: number, data: unknown): void {
    const message = readPeer(participant, data);
    if (message === undefined) {
      this.dropPeer(participant, true);
      this.strange(participant);
      return;
    }
    if (message instanceof ArrayBuffer) {
      this.deliver(participant, new Int32Array(message, 0, 16)[14]!, message);
      return;
    }
    switch (message.t) {
      case 'node+':
        this.graphReplica.nodes.set(message.node.key, message.node);
        this.changed();
        return;
      case 'node-':
        this.graphReplica.nodes.delete(message.key);
        this.changed();
        return;
      case 'ep+':
        this.graphReplica.add(message.record);
        for (const other of this.graphReplica.named(message.record.name)) {
          const own = this.ownOf(other.key);
          if (own !== undefined) this.introduce(own, message.record);
        }
        this.changed();
        return;
      case 'ep-':
        this.samples.leave(this.removeRemote(message.key, false), message.last);
        this.changed();
        return;
      case 'match': {
        const own = this.ownOf(message.yours);
        const other = this.graphReplica.endpoints.get(message.mine);
        if (own === undefined || other === undefined) return;
        own.reader?.open(other, message.after | 0);
        this.addMatch(own, other);
        this.changed();
        return;
      }
      case 'late': {
        const reader = this.ownOf(message.reader);
        if (reader === undefined) return;
        for (const frame of message.frames) this.receive(reader, new Int32Array(frame, 0, 16)[14]!, frame);
        this.wake();
        return;
      }
      case 'ack':
        this.ownOf(message.writer)?.writer?.acknowledge(participant, message.sequence);
        this.wake();
        return;
      case 'sample':
        this.post(participant, { t: 'samples', writers: this.samplesOf(message.topics) });
        return;
      case 'samples':
        for (const sample of message.writers) this.samples.note(sample);
        return;
      case 'bye':
        this.dropPeer(participant, false);
        return;
      case 'alive':
        this.lives.get(message.writer)?.exchangeAsserted(this.clock.steadyNs());
        this.wake();
        return;
    }
  }

  /** True when the frame is for the endpoint. */
  private receive({ reader, timing }: Own, writer: number, buffer: ArrayBuffer): boolean {
    if (reader === undefined) return false;
    const { lost } = reader;
    const accepted = reader.accept(writer, buffer);
    if (reader.lost !== lost) this.noteStatus();
    if (accepted && timing.ticks) timing.received(this.clock.steadyNs());
    return accepted;
  }

  private deliver(participant: number, writer: number, buffer: ArrayBuffer): void {
    const record = this.graphReplica.endpoints.get(writer);
    if (record === undefined) return;
    let came = false;
    for (const other of this.graphReplica.named(record.name)) {
      const own = this.ownOf(other.key);
      if (own !== undefined && this.receive(own, writer, buffer)) came = true;
    }
    this.lives.get(writer)?.exchangeAsserted(this.clock.steadyNs());
    if (participant !== this.participant) {
      let arrivals = this.arrivals.get(writer);
      if (arrivals === undefined) {
        arrivals = { participant, newest: 0, frames: 0, bytes: 0, acknowledged: 0 };
        this.arrivals.set(writer, arrivals);
      }
      arrivals.newest = new Int32Array(buffer, 0, 16)[2]!;
      arrivals.frames += 1;
      arrivals.bytes += buffer.byteLength;
      this.acknowledge(writer, false);
    }
    if (came) this.wake();
  }

  /** Tells the writer how far all readers here are, in strides, so that acknowledgements stay few. */
  private acknowledge(writer: number, taken: boolean): void {
    const arrivals = this.arrivals.get(writer);
    const record = this.graphReplica.endpoints.get(writer);
    if (arrivals === undefined || record === undefined) return;
    if (arrivals.frames < windowFrames / 4 && arrivals.bytes < windowBytes / 4) return;
    let done = arrivals.newest;
    for (const other of this.graphReplica.named(record.name)) {
      const reader = this.ownOf(other.key)?.reader;
      if (reader === undefined || !reader.all) continue;
      const oldest = reader.oldest(writer);
      if (oldest !== undefined && ((oldest - 1 - done) | 0) < 0) done = (oldest - 1) | 0;
    }
    const step = (done - arrivals.acknowledged) | 0;
    if (step <= 0 || (taken && step < windowFrames / 4 && done !== arrivals.newest)) return;
    arrivals.acknowledged = done;
    if (done === arrivals.newest) {
      arrivals.frames = 0;
      arrivals.bytes = 0;
    }
    this.post(arrivals.participant, { t: 'ack', writer, sequence: done });
  }

  private changed(): void {
    this.version = (this.version + 1) | 0;
    this.wake();
  }

  private broadcast(message: PeerMessage): void {
    for (const port of this.peers.values()) port.postMessage(message);
  }

  private post(participant: number, message: PeerMessage): void {
    this.peers.get(participant)?.postMessage(message);
  }
}
