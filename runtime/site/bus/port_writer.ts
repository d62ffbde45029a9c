// The writing half of an endpoint on the port link: sends frames to the peers that have matched readers, as far as
// their credit goes, and keeps the rest: the newest `depth` for keep_last, all for keep_all up to the limit.

import { Durability, EndpointKind, frameHeaderSize, History, keepAllLimit, Reliability, serviceLimit } from '../../protocol/generated/constants.ts';
import type { EndpointRecord } from './graph.ts';
import type { WriterSample } from './port_messages.ts';

/** Frames and bytes on the way to one peer. A peer acknowledges from a quarter of either; below it another frame may
 * always go, however large. */
export const windowFrames = 64;
export const windowBytes = 16 << 20;

const smallPayload = 64 << 10;

export interface Frame {
  readonly buffer: ArrayBuffer;
  readonly sequence: number;
  /** Reader key that alone gets it; 0: all. */
  readonly target: number;
}

interface PeerQueue {
  readonly readers: Map<number, EndpointRecord>;
  /** Not sent yet. */
  waiting: Frame[];
  /** Sent, not acknowledged: sequence and size. */
  flying: { readonly sequence: number; readonly bytes: number; }[];
  flyingBytes: number;
}

export class PortWriter {
  readonly record: EndpointRecord;
  sequence = 0;
  private bytes = 0;
  private last: Frame | undefined;
  private readonly kept: Frame[] = [];
  private readonly keep: number;
  private readonly service: boolean;
  private readonly keepAll: boolean;
  private readonly peers = new Map<number, PeerQueue>();
  private readonly send: (participant: number, frame: Frame) => void;

  constructor(record: EndpointRecord, send: (participant: number, frame: Frame) => void) {
    this.record = record;
    this.send = send;
    this.service = record.kind !== EndpointKind.publisher;
    const { qos } = record;
    this.keepAll = qos.history === History.keepAll && qos.reliability === Reliability.reliable && !this.service;
    const transient = qos.durability === Durability.transientLocal && !this.service;
    this.keep = !transient ? 0 : qos.history === History.keepAll ? keepAllLimit : Math.max(1, qos.depth);
  }

  /** `late` is what a reader is to get first; frames count for it when they come after `after`. */
  match(reader: EndpointRecord): { readonly late: readonly ArrayBuffer[]; readonly after: number; } {
    let peer = this.peers.get(reader.participant);
    if (peer === undefined) {
      peer = { readers: new Map(), waiting: [], flying: [], flyingBytes: 0 };
      this.peers.set(reader.participant, peer);
    }
    peer.readers.set(reader.key, reader);
    const late = reader.qos.durability === Durability.transientLocal && reader.kind === EndpointKind.subscription;
    const count = reader.qos.history === History.keepAll ? keepAllLimit : Math.max(1, reader.qos.depth);
    const frames = late ? this.kept.slice(-Math.min(count, this.keep || 1)) : [];
    return { late: frames.map((frame) => frame.buffer), after: this.sequence - frames.length };
  }

  unmatch(reader: EndpointRecord): void {
    const peer = this.peers.get(reader.participant);
    if (peer === undefined) return;
    peer.readers.delete(reader.key);
    if (peer.readers.size === 0) this.peers.delete(reader.participant);
  }

  /** True when a reliable keep_all reader is so far behind that the writer must wait. */
  full(): boolean {
    if (!this.keepAll) return false;
    for (const [participant, peer] of this.peers) {
      if (participant !== this.record.participant && this.waitsFor(peer) && peer.waiting.length >= keepAllLimit) {
        return true;
      }
    }
    return false;
  }

  push(frame: Frame): void {
    this.sequence = frame.sequence;
    this.bytes += frame.buffer.byteLength - frameHeaderSize;
    this.last = frame;
    if (this.keep > 0) {
      this.kept.push(frame);
      if (this.kept.length > this.keep) this.kept.shift();
    }
    for (const [participant, peer] of this.peers) {
      if (frame.target !== 0 && !peer.readers.has(frame.target)) continue;
      peer.waiting.push(frame);
      if (peer.waiting.length > this.limit(peer)) peer.waiting.shift();
      this.flush(participant, peer);
    }
  }

  acknowledge(participant: number, sequence: number): void {
    const peer = this.peers.get(participant);
    if (peer === undefined) return;
    while (peer.flying.length > 0 && ((sequence - peer.flying[0]!.sequence) | 0) >= 0) {
      peer.flyingBytes -= peer.flying.shift()!.bytes;
    }
    this.flush(participant, peer);
  }

  /** The writer ends: nobody would send later what waits, so it goes beyond the credit. */
  farewell(): void {
    for (const [participant, peer] of this.peers) for (const frame of peer.waiting.splice(0)) this.send(participant, frame);
  }

  private flush(participant: number, peer: PeerQueue): void {
    while (peer.waiting.length > 0) {
      const next = peer.waiting[0]!;
      const bytes = next.buffer.byteLength;
      const fits = peer.flyingBytes < windowBytes / 4 || peer.flyingBytes + bytes <= windowBytes;
      if (peer.flying.length >= windowFrames || !fits) return;
      peer.waiting.shift();
      if (participant !== this.record.participant) {
        peer.flying.push({ sequence: next.sequence | 0, bytes });
        peer.flyingBytes += bytes;
      }
      this.send(participant, next);
    }
  }

  /** The totals so far; with the last payload when it is `wanted` or small. */
  sample(wanted: boolean): WriterSample | undefined {
    if (this.last === undefined) return undefined;
    const { buffer } = this.last;
    const words = new Int32Array(buffer, 0, 16);
    return {
      key: this.record.key,
      count: this.sequence,
      bytes: this.bytes,
      time: ((words[4]! >>> 0) + words[5]! * 2 ** 32) / 1e6,
      payload: wanted || buffer.byteLength <= smallPayload ? new Uint8Array(buffer, frameHeaderSize) : undefined,
    };
  }

  private waitsFor(peer: PeerQueue): boolean {
    for (const { qos } of peer.readers.values()) {
      if (qos.history === History.keepAll && qos.reliability === Reliability.reliable) return true;
    }
    return false;
  }

  private limit(peer: PeerQueue): number {
    if (this.service) return serviceLimit;
    let depth = 1;
    for (const reader of peer.readers.values()) {
      if (reader.qos.history === History.keepAll) return keepAllLimit;
      depth = Math.max(depth, reader.qos.depth);
    }
    return depth;
  }
}
