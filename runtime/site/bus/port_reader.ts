// The reading half of an endpoint on the port link: a queue that keep_last bounds.

import { EndpointKind, ErrorCode, frameHeaderSize, History } from '../../protocol/generated/constants.ts';
import type { SiteClock } from './clock.ts';
import type { EndpointRecord } from './graph.ts';
import type { Heap } from './link.ts';

interface Queued {
  readonly writer: number;
  readonly sequence: number;
  readonly buffer: ArrayBuffer;
  /** ns since 1970; Infinity without a lifespan. */
  readonly expires: number;
}

interface Source {
  readonly lifespanNs: number;
  /** Sequence of the newest frame that came, or that this reader is too late for. */
  newest: number | undefined;
}

/** Frames that came from one writer and were not acknowledged yet. */
export interface Arrivals {
  readonly participant: number;
  newest: number;
  frames: number;
  bytes: number;
  acknowledged: number;
}

export class PortReader {
  readonly record: EndpointRecord;
  /** Wants every sample: the writer is told when one is taken, not when it comes. */
  readonly all: boolean;
  private readonly clock: SiteClock;
  private readonly depth: number;
  private readonly queue: Queued[] = [];
  private readonly sources = new Map<number, Source>();
  private readonly taken: (writer: number) => void;
  lost = 0;

  /** `taken` is called when a sample of that writer has left the queue, if the reader wants all. */
  constructor(record: EndpointRecord, clock: SiteClock, taken: (writer: number) => void) {
    this.clock = clock;
    this.record = record;
    this.taken = taken;
    const service = record.kind !== EndpointKind.subscription;
    this.all = service || record.qos.history === History.keepAll;
    this.depth = this.all ? Infinity : Math.max(1, record.qos.depth);
  }

  /** Frames of a writer count from here on; `after`: when their sequence is above it. */
  open(writer: EndpointRecord, after: number | undefined): void {
    if (this.sources.has(writer.key)) return;
    this.sources.set(writer.key, { lifespanNs: Number(writer.qos.lifespan), newest: after });
  }

  /** Samples that have arrived stay in the queue. */
  shut(writer: number): void {
    this.sources.delete(writer);
  }

  /** True when the frame went into the queue. */
  accept(writer: number, buffer: ArrayBuffer): boolean {
    const source = this.sources.get(writer);
    if (source === undefined) return false;
    const words = new Int32Array(buffer, 0, 16);
    const sequence = words[2]!;
    if (source.newest !== undefined) {
      const step = (sequence - source.newest) | 0;
      if (step <= 0) return false;
      if (this.record.kind === EndpointKind.subscription && this.all) this.lost += step - 1;
    }
    source.newest = sequence;
    if (this.record.kind === EndpointKind.client && words[10] !== this.record.key) return false;
    const { lifespanNs } = source;
    const expires = lifespanNs === 0 ? Infinity : (words[4]! >>> 0) + words[5]! * 2 ** 32 + lifespanNs;
    if (expires !== Infinity && expires < this.clock.systemNs()) return false;
    this.queue.push({ writer, sequence, buffer, expires });
    if (this.queue.length > this.depth) this.queue.shift();
    return true;
  }

  get hasData(): boolean {
    return this.queue.length > 0;
  }

  /** The oldest sequence of a writer that still waits here, or undefined. */
  oldest(writer: number): number | undefined {
    return this.queue.find((entry) => entry.writer === writer)?.sequence;
  }

  take(heap: Heap, address: number, capacity: number, info: number): number {
    for (;;) {
      const next = this.queue[0];
      if (next === undefined) return ErrorCode.nothing;
      const expired = next.expires !== Infinity && next.expires < this.clock.systemNs();
      const length = next.buffer.byteLength - frameHeaderSize;
      if (!expired && length > capacity) return length;
      this.queue.shift();
      if (this.all) this.taken(next.writer);
      if (expired) continue;
      heap.i32.set(new Int32Array(next.buffer, 0, 16), info >> 2);
      heap.u8.set(new Uint8Array(next.buffer, frameHeaderSize), address);
      return length;
    }
  }
}
