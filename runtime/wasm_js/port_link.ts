// The link over message ports, for pages without shared memory. Every worker has a port to every other and a replica
// of the graph. Nothing arrives while a program computes: it must wait or sleep, which suspends it and lets the event
// loop run. Used within one thread.

import {
  EndpointKind, ErrorCode, flagHidden, frameHeaderSize, maxHashLength, maxNameLength, maxSampleLength, type StatusKind,
  WaitResult,
} from '../protocol/generated/constants.ts';
import { putNanoseconds, systemNanoseconds } from './clock.ts';
import { type ConsoleCredit, LocalCredit } from './console_sender.ts';
import { type EndpointRecord, Graph, relate } from './graph.ts';
import type { EndpointDescription, EndpointStatus, GraphSnapshot, Heap, Link } from './link.ts';
import { EventCounters } from './event_counters.ts';
import type { ControlMessage, PeerMessage, PeerPort, WriterSample } from './port_messages.ts';
import { PortReader } from './port_reader.ts';
import { type Frame, PortWriter, windowBytes, windowFrames } from './port_writer.ts';

export interface PortTicket {
  readonly participant: number;
  readonly session: readonly [number, number];
  readonly control: MessagePort;
  readonly peers: readonly PeerPort[];
}

interface Own {
  readonly record: EndpointRecord;
  readonly writer: PortWriter | undefined;
  readonly reader: PortReader | undefined;
  /** Peers' endpoints that know this one. */
  readonly matched: Set<number>;
  /** They fit, but have not said yet that they know this one. */
  readonly expected: Set<number>;
  readonly strangers: Set<number>;
  readonly counters: EventCounters;
}

/** Frames that came from one writer and were not acknowledged yet. */
interface Arrivals {
  readonly participant: number;
  newest: number;
  frames: number;
  bytes: number;
  acknowledged: number;
}

const smallPayload = 64 << 10;
/** A program that never waits long must still let messages in. */
const longestRunMs = 4;
/** A timer that is set for longer fires at once. */
const longestTimerMs = 2 ** 31 - 1;
const encoder = new TextEncoder();

export class PortLink implements Link {
  readonly kind = 'port';
  readonly participant: number;
  private readonly session: readonly [number, number];
  private readonly control: MessagePort;
  private readonly peers = new Map<number, MessagePort>();
  private readonly graphReplica = new Graph();
  private readonly own = new Map<number, Own>();
  private readonly arrivals = new Map<number, Arrivals>();
  private readonly samples = new Map<number, WriterSample>();
  private nextKey = 1;
  private version = 0;
  private token = 0;
  private stops = 0;
  private stopsTold = 0;
  private lastYield = performance.now();
  private readonly waiters = new Set<() => void>();
  private readonly sleepers = new Set<() => void>();
  private readonly turn = new MessageChannel();
  private turns: (() => void)[] = [];
  private closed = false;

  constructor({ participant, session, control, peers }: PortTicket) {
    this.participant = participant;
    this.session = session;
    this.control = control;
    control.addEventListener('message', (event) => this.onControl((event as MessageEvent<ControlMessage>).data));
    control.start();
    this.turn.port1.addEventListener('message', () => this.turns.shift()?.());
    this.turn.port1.start();
    // Under Node.js an idle port must not hold the process.
    for (const port of [control, this.turn.port1]) unref(port);
    for (const peer of peers) this.addPeer(peer);
  }

  /** Numbers of participants come again: what an earlier one left ends here, and its late words are not heard. */
  addPeer({ participant, port }: PeerPort): void {
    if (this.peers.has(participant)) this.dropPeer(participant);
    this.peers.set(participant, port);
    port.addEventListener('message', (event) => {
      if (this.peers.get(participant) === port) this.onPeer(participant, (event as MessageEvent<unknown>).data);
    });
    port.start();
    unref(port);
    for (const node of this.graphReplica.nodes.values()) {
      if (node.participant === this.participant) this.post(participant, { t: 'node+', node });
    }
    for (const { record } of this.own.values()) this.post(participant, { t: 'ep+', record });
  }

  /** A peer that ended without taking leave. */
  dropPeer(participant: number): void {
    this.peers.get(participant)?.close();
    this.peers.delete(participant);
    for (const record of [...this.graphReplica.endpoints.values()]) {
      if (record.participant === participant) this.removeRemote(record.key);
    }
    for (const node of [...this.graphReplica.nodes.values()]) {
      if (node.participant === participant) this.graphReplica.nodes.delete(node.key);
    }
    this.changed();
  }

  nodeCreate(name: string, namespace: string): number {
    const length = encoder.encode(name).length;
    if (length === 0 || length > maxNameLength || encoder.encode(namespace).length > maxNameLength) {
      return ErrorCode.invalidName;
    }
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
    const { node, ...rest } = description;
    const length = (text: string): number => encoder.encode(text).length;
    const name = length(description.name);
    if (name === 0 || name > maxNameLength || length(description.type) > maxNameLength) return ErrorCode.invalidName;
    if (length(description.hash) > maxHashLength) return ErrorCode.invalidArgument;
    if (rest.kind < EndpointKind.publisher || rest.kind > EndpointKind.server) return ErrorCode.invalidArgument;
    if (!this.graphReplica.nodes.has(this.keyOf(node))) return ErrorCode.badHandle;
    if (this.nextKey > 0xfffff) return ErrorCode.tableFull;
    const handle = this.newHandle();
    const key = this.keyOf(handle);
    const gid = new Int32Array([...this.session, key, this.participant + 1]);
    const record: EndpointRecord = { ...rest, key, gid, participant: this.participant, nodeKey: this.keyOf(node) };
    const writes = record.kind !== EndpointKind.subscription;
    const own: Own = {
      record,
      writer: writes ? new PortWriter(record, (to, frame) => this.send(to, record.key, frame)) : undefined,
      reader: record.kind !== EndpointKind.publisher ? new PortReader(record) : undefined,
      matched: new Set(),
      expected: new Set(),
      strangers: new Set(),
      counters: new EventCounters(),
    };
    this.own.set(handle, own);
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
        const late = own.writer?.match(other) ?? [];
        if (other.participant === this.participant) {
          own.reader?.open(other);
          this.addMatch(own, other.key);
          const local = this.ownOf(other.key)?.reader;
          if (late.length > 0) local?.open(own.record);
          for (const frame of late) local?.accept(own.record.key, frame);
          return;
        }
        own.expected.add(other.key);
        this.post(other.participant, { t: 'match', mine: own.record.key, yours: other.key });
        if (late.length > 0) this.post(other.participant, { t: 'late', reader: other.key, frames: late });
        return;
      }
      case 'incompatible':
        if (own.strangers.has(other.key)) return;
        own.strangers.add(other.key);
        own.counters.incompatible.total += 1;
        own.counters.incompatible.policy = relation.policy;
        return;
      case 'wrong_type':
        if (own.strangers.has(other.key)) return;
        own.strangers.add(other.key);
        own.counters.type.total = 1;
        return;
    }
  }

  private addMatch(own: Own, key: number): void {
    if (own.matched.has(key)) return;
    own.matched.add(key);
    own.counters.matched.total += 1;
  }

  private ownOf(key: number): Own | undefined {
    return key >>> 20 === this.participant ? this.own.get(key & 0xfffff) : undefined;
  }

  endpointDestroy(endpoint: number): void {
    const own = this.own.get(endpoint);
    if (own === undefined) return;
    this.own.delete(endpoint);
    this.broadcast({ t: 'ep-', key: own.record.key });
    this.removeRemote(own.record.key);
    this.changed();
  }

  /** Takes an endpoint, also an own one, out of the replica and of all lists. */
  private removeRemote(key: number): void {
    const record = this.graphReplica.remove(key);
    if (record === undefined) return;
    for (const other of this.graphReplica.named(record.name)) {
      const own = this.ownOf(other.key);
      if (own === undefined) continue;
      own.writer?.unmatch(record);
      own.reader?.shut(key);
      own.expected.delete(key);
      own.matched.delete(key);
      own.strangers.delete(key);
    }
    this.arrivals.delete(key);
    this.samples.delete(key);
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
    const target = this.fillHeader(own.record, new Int32Array(buffer, 0, 16), heap.i32, info >> 2, sequence, length);
    const frame: Frame = { buffer, sequence, target };
    if (writer.full()) return this.writeLater(writer, frame);
    writer.push(frame);
    return 0;
  }

  private async writeLater(writer: PortWriter, frame: Frame): Promise<number> {
    while (writer.full()) {
      if (this.closed || (await this.wait(this.token, -1)) === WaitResult.stop) return ErrorCode.stopped;
    }
    writer.push(frame);
    return 0;
  }

  private fillHeader(
    record: EndpointRecord, header: Int32Array, given: Int32Array, at: number, sequence: number, length: number,
  ): number {
    const client = record.kind === EndpointKind.client;
    header[0] = length;
    putNanoseconds(header, 2, sequence);
    if (given[at + 4] === 0 && given[at + 5] === 0) putNanoseconds(header, 4, systemNanoseconds());
    else header.set(given.subarray(at + 4, at + 6), 4);
    if (client) {
      putNanoseconds(header, 6, sequence);
      header.set(record.gid, 8);
    } else {
      header.set(given.subarray(at + 6, at + 12), 6);
    }
    header.set(record.gid, 12);
    given.set(header, at);
    return record.kind === EndpointKind.server ? header[10]! : 0;
  }

  private send(participant: number, writer: number, frame: Frame): void {
    if (participant === this.participant) this.deliver(participant, writer, frame.buffer);
    else this.peers.get(participant)?.postMessage(frame.buffer);
  }

  take(endpoint: number, heap: Heap, address: number, capacity: number, info: number): number {
    const reader = this.own.get(endpoint)?.reader;
    if (reader === undefined) return ErrorCode.badHandle;
    const { result, writer } = reader.take(heap, address, capacity, info);
    if (writer !== 0 && reader.all) this.acknowledge(writer, true);
    return result;
  }

  ready(): readonly number[] {
    const out: number[] = [];
    for (const [handle, own] of this.own) if (own.reader?.hasData === true) out.push(handle);
    return out;
  }

  wakeToken(): number {
    return this.token;
  }

  private tellStop(): boolean {
    if (this.stops === this.stopsTold) return false;
    this.stopsTold = this.stops;
    return true;
  }

  async wait(token: number, timeoutMs: number): Promise<WaitResult> {
    if (this.tellStop()) return WaitResult.stop;
    if (this.token !== token) {
      if (performance.now() - this.lastYield > longestRunMs) await this.yieldTurn();
    } else if (timeoutMs === 0) {
      await this.yieldTurn();
    } else {
      await rest(this.waiters, timeoutMs);
      this.lastYield = performance.now();
    }
    if (this.token === token) return WaitResult.timeout;
    return this.tellStop() ? WaitResult.stop : WaitResult.woken;
  }

  /** One turn of the event loop, without the clamping of timers. */
  private yieldTurn(): Promise<void> {
    return new Promise((resolve) => {
      this.turns.push(() => {
        this.lastYield = performance.now();
        resolve();
      });
      this.turn.port2.postMessage(0);
    });
  }

  wake(): void {
    this.token = (this.token + 1) | 0;
    for (const end of [...this.waiters]) end();
  }

  async sleep(durationMs: number): Promise<WaitResult> {
    if (this.tellStop()) return WaitResult.stop;
    if (durationMs <= 0) {
      await this.yieldTurn();
    } else {
      await rest(this.sleepers, durationMs);
    }
    this.lastYield = performance.now();
    return this.tellStop() ? WaitResult.stop : WaitResult.woken;
  }

  stopRequested(): boolean {
    return this.stops > 0;
  }

  matched(endpoint: number): number {
    return this.own.get(endpoint)?.matched.size ?? ErrorCode.badHandle;
  }

  status(endpoint: number, kind: StatusKind): EndpointStatus | undefined {
    const own = this.own.get(endpoint);
    if (own === undefined) return undefined;
    own.counters.lost.total = own.reader?.lost ?? 0;
    return own.counters.read(kind, own.matched.size);
  }

  graphVersion(): number {
    return this.version;
  }

  graph(): GraphSnapshot {
    return this.graphReplica.snapshot();
  }

  consoleCredit(): ConsoleCredit {
    return new LocalCredit();
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    for (const handle of [...this.own.keys()]) this.endpointDestroy(handle);
    this.broadcast({ t: 'bye' });
    for (const port of this.peers.values()) port.close();
    this.peers.clear();
    this.control.close();
    this.turn.port1.close();
    this.wake();
  }

  /** Asks all peers for what their writers did; the answers are in `sampled` later. */
  requestSamples(topics: readonly string[]): void {
    this.broadcast({ t: 'sample', topics });
  }

  sampled(): ReadonlyMap<number, WriterSample> {
    for (const sample of this.samplesOf([])) this.samples.set(sample.key, sample);
    return this.samples;
  }

  records(): readonly EndpointRecord[] {
    return [...this.graphReplica.endpoints.values()].filter((record) => (record.flags & flagHidden) === 0);
  }

  private samplesOf(topics: readonly string[]): WriterSample[] {
    const out: WriterSample[] = [];
    for (const { record, writer } of this.own.values()) {
      if (writer === undefined || record.kind !== EndpointKind.publisher || writer.last === undefined) continue;
      const { buffer } = writer.last;
      const words = new Int32Array(buffer, 0, 16);
      const show = buffer.byteLength <= smallPayload || topics.includes(record.name);
      out.push({
        key: record.key,
        count: writer.sequence,
        bytes: writer.bytes,
        time: ((words[4]! >>> 0) + words[5]! * 2 ** 32) / 1e6,
        payload: show ? new Uint8Array(buffer, frameHeaderSize) : undefined,
      });
    }
    return out;
  }

  private onControl(message: ControlMessage): void {
    switch (message.t) {
      case 'peer':
        this.addPeer(message.peer);
        return;
      case 'gone':
        this.dropPeer(message.participant);
        return;
      case 'stop': {
        this.stops += 1;
        for (const end of [...this.sleepers]) end();
        this.wake();
        return;
      }
    }
  }

  private onPeer(participant: number, data: unknown): void {
    if (data instanceof ArrayBuffer) {
      if (data.byteLength >= frameHeaderSize) this.deliver(participant, new Int32Array(data, 0, 16)[14]!, data);
      return;
    }
    const message = data as PeerMessage;
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
        this.removeRemote(message.key);
        this.changed();
        return;
      case 'match': {
        const own = this.ownOf(message.yours);
        const other = this.graphReplica.endpoints.get(message.mine);
        if (own === undefined || other === undefined) return;
        own.expected.delete(message.mine);
        own.reader?.open(other);
        this.addMatch(own, message.mine);
        this.changed();
        return;
      }
      case 'late': {
        const reader = this.ownOf(message.reader)?.reader;
        for (const frame of message.frames) reader?.accept(new Int32Array(frame, 0, 16)[14]!, frame);
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
        for (const sample of message.writers) this.samples.set(sample.key, sample);
        return;
      case 'bye':
        this.dropPeer(participant);
        return;
    }
  }

  private deliver(participant: number, writer: number, buffer: ArrayBuffer): void {
    const record = this.graphReplica.endpoints.get(writer);
    if (record === undefined) return;
    let came = false;
    for (const other of this.graphReplica.named(record.name)) {
      if (this.ownOf(other.key)?.reader?.accept(writer, buffer) === true) came = true;
    }
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

/** Until the time is over (negative: never) or somebody calls what stands in `ends` meanwhile. */
function rest(ends: Set<() => void>, durationMs: number): Promise<void> {
  return new Promise((resolve) => {
    const deadline = performance.now() + durationMs;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const end = (): void => {
      clearTimeout(timer);
      ends.delete(end);
      resolve();
    };
    const check = (): void => {
      const left = deadline - performance.now();
      if (left <= 0) end();
      else timer = setTimeout(check, Math.min(left, longestTimerMs));
    };
    ends.add(end);
    if (durationMs >= 0) check();
  });
}

function unref(port: MessagePort): void {
  if ('unref' in port && typeof port.unref === 'function') port.unref();
}
