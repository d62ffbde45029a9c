// The worker side of a conformance scene: carries out one command after another on a link of its own.
// Runs in Node worker threads and in browser workers.

import { EndpointKind, ErrorCode, SampleInfoLayout, StatusKind, WaitResult } from '../../../runtime/protocol/generated/constants.ts';
import type { EndpointStatus, GraphSnapshot, Heap, Link } from '../../../runtime/site/bus/link.ts';
import { type LinkTicket, openLink } from '../../../runtime/site/bus/open_link.ts';
import { defaultQos, type EndpointQos } from '../../../runtime/site/contract/qos.ts';

export interface EndpointOptions {
  readonly node: number;
  readonly name: string;
  readonly type?: string;
  readonly hash?: string;
  readonly qos?: Partial<EndpointQos>;
  readonly flags?: number;
}

export interface Sample {
  readonly bytes: Uint8Array;
  readonly sequence: number;
  readonly relatedSequence: number;
  readonly relatedGid: Uint8Array;
  readonly writerGid: Uint8Array;
  readonly sourceTimestamp: bigint;
}

export interface WriteOptions {
  readonly relatedSequence?: number;
  readonly relatedGid?: Uint8Array;
}

const scratchSize = 1 << 16;

/** A program's memory, for programs without one. */
export class Scratch implements Heap {
  u8: Uint8Array;
  i32: Int32Array;

  constructor(bytes = scratchSize) {
    const buffer = new ArrayBuffer(bytes);
    this.u8 = new Uint8Array(buffer);
    this.i32 = new Int32Array(buffer);
  }
}

/** The calls that a scene may send to a worker. Every method ends before the next begins. */
export class Peer {
  private readonly link: Link;
  private heap: Scratch = new Scratch();

  constructor(link: Link) {
    this.link = link;
  }

  node(name: string, namespace = '/'): number {
    return this.link.nodeCreate(name, namespace);
  }

  destroyNode(node: number): void {
    this.link.nodeDestroy(node);
  }

  private endpoint(kind: number, options: EndpointOptions): number {
    return this.link.endpointCreate({
      kind,
      node: options.node,
      name: options.name,
      type: options.type ?? 'test_msgs/msg/Any',
      hash: options.hash ?? '',
      qos: { ...defaultQos, ...options.qos },
      flags: options.flags ?? 0,
    });
  }

  publisher(options: EndpointOptions): number {
    return this.endpoint(EndpointKind.publisher, options);
  }

  subscription(options: EndpointOptions): number {
    return this.endpoint(EndpointKind.subscription, options);
  }

  client(options: EndpointOptions): number {
    return this.endpoint(EndpointKind.client, options);
  }

  server(options: EndpointOptions): number {
    return this.endpoint(EndpointKind.server, options);
  }

  destroy(endpoint: number): void {
    this.link.endpointDestroy(endpoint);
  }

  gid(endpoint: number): Uint8Array {
    const gid = this.link.gid(endpoint);
    if (gid === undefined) throw new Error('no gid');
    return new Uint8Array(gid.slice().buffer);
  }

  private room(length: number): void {
    if (this.heap.u8.length < length + 64) this.heap = new Scratch((length + 64 + 4095) & -4096);
  }

  /** Result of write; with success the sequence number instead of 0. */
  async write(endpoint: number, bytes: Uint8Array, options: WriteOptions = {}): Promise<number> {
    this.room(bytes.length);
    const { heap } = this;
    heap.i32.fill(0, 0, 16);
    heap.i32[SampleInfoLayout.relatedSequence >> 2] = options.relatedSequence ?? 0;
    if (options.relatedGid !== undefined) heap.u8.set(options.relatedGid, SampleInfoLayout.relatedGid);
    heap.u8.set(bytes, 64);
    const result = await this.link.write(endpoint, heap, 64, bytes.length, 0);
    return result < 0 ? result : heap.i32[SampleInfoLayout.sequence >> 2]!;
  }

  /** Writes `count` samples of `size` bytes that begin with their number (little endian), from `first` on. */
  async writeMany(endpoint: number, first: number, count: number, size = 4): Promise<number> {
    const bytes = new Uint8Array(size);
    const view = new DataView(bytes.buffer);
    for (let i = 0; i < count; i += 1) {
      view.setInt32(0, first + i, true);
      const result = await this.write(endpoint, bytes);
      if (result < 0) return result;
    }
    return count;
  }

  /** Writes for ever: every sample is filled with the low byte of its number, in sizes that vary up to `largest`. */
  async flood(endpoint: number, largest: number): Promise<never> {
    for (let i = 1;; i += 1) {
      const result = await this.write(endpoint, new Uint8Array(1 + (i * 7919) % largest).fill(i & 255));
      if (result < 0) throw new Error(`write: ${result}`);
    }
  }

  /** Makes a node with a publisher that writes, and destroys them, for ever. */
  async makeForEver(name: string): Promise<never> {
    for (;;) {
      const node = this.node('maker');
      const pub = this.publisher({ node, name });
      if (pub >= 0) await this.write(pub, new Uint8Array(3000).fill(255));
      this.destroy(pub);
      this.destroyNode(node);
    }
  }

  /** Computes for ever, and neither waits nor sleeps. */
  spin(): never {
    for (;;) {
      // Only a terminate ends this.
    }
  }

  /** Takes `count` samples of floods; an error when one is torn, comes twice or out of order. */
  async verify(endpoint: number, count: number): Promise<number> {
    const newest = new Map<string, number>();
    for (let i = 0; i < count; i += 1) {
      const { bytes, sequence, writerGid } = await this.takeNext(endpoint);
      const writer = writerGid.join();
      if (sequence <= (newest.get(writer) ?? 0)) throw new Error(`${sequence} after ${newest.get(writer)}`);
      newest.set(writer, sequence);
      if (bytes.some((byte) => byte !== (sequence & 255))) throw new Error(`sample ${sequence} is torn`);
    }
    return newest.size;
  }

  take(endpoint: number): Sample | undefined {
    for (;;) {
      const { heap } = this;
      const length = this.link.take(endpoint, heap, 64, heap.u8.length - 64, 0);
      if (length === ErrorCode.nothing) return undefined;
      if (length < 0) throw new Error(`take: ${length}`);
      if (length > heap.u8.length - 64) {
        this.room(length);
        continue;
      }
      const view = new DataView(heap.u8.buffer);
      return {
        bytes: heap.u8.slice(64, 64 + length),
        sequence: Number(view.getBigInt64(SampleInfoLayout.sequence, true)),
        relatedSequence: Number(view.getBigInt64(SampleInfoLayout.relatedSequence, true)),
        relatedGid: heap.u8.slice(SampleInfoLayout.relatedGid, SampleInfoLayout.relatedGid + 16),
        writerGid: heap.u8.slice(SampleInfoLayout.writerGid, SampleInfoLayout.writerGid + 16),
        sourceTimestamp: view.getBigInt64(SampleInfoLayout.sourceTimestampNs, true),
      };
    }
  }

  /** Blocks as a program does until the endpoint has a sample. */
  async takeNext(endpoint: number): Promise<Sample> {
    for (;;) {
      const token = this.link.wakeToken();
      if (this.link.ready().includes(endpoint)) {
        const sample = this.take(endpoint);
        if (sample !== undefined) return sample;
      }
      await this.link.wait(token, -1);
    }
  }

  /** The numbers that writeMany put in front of the samples, until `last` was seen. */
  async takeUntil(endpoint: number, last: number): Promise<number[]> {
    const numbers: number[] = [];
    for (;;) {
      const { bytes } = await this.takeNext(endpoint);
      const number = new DataView(bytes.buffer).getInt32(0, true);
      numbers.push(number);
      if (number === last) return numbers;
    }
  }

  /** All that is there now, by number. */
  takeNumbers(endpoint: number): number[] {
    const numbers: number[] = [];
    for (;;) {
      const sample = this.take(endpoint);
      if (sample === undefined) return numbers;
      numbers.push(new DataView(sample.bytes.buffer).getInt32(0, true));
    }
  }

  ready(): number[] {
    return [...this.link.ready()];
  }

  /** Serves until a request begins with byte 255: the answer is the request with every byte one more. */
  async serve(endpoint: number): Promise<number> {
    for (let served = 0;; served += 1) {
      const request = await this.takeNext(endpoint);
      const { relatedSequence, relatedGid } = request;
      await this.write(endpoint, request.bytes.map((byte) => byte + 1), { relatedSequence, relatedGid });
      if (request.bytes[0] === 255) return served;
    }
  }

  /** Takes `count` requests before it answers them as serve() does, the last first. Returns the results of the writes. */
  async serveReversed(endpoint: number, count: number): Promise<number[]> {
    const requests: Sample[] = [];
    while (requests.length < count) requests.push(await this.takeNext(endpoint));
    const results: number[] = [];
    for (const { bytes, relatedSequence, relatedGid } of requests.reverse()) {
      results.push(await this.write(endpoint, bytes.map((byte) => byte + 1), { relatedSequence, relatedGid }));
    }
    return results;
  }

  matched(endpoint: number): number {
    return this.link.matched(endpoint);
  }

  async waitMatched(endpoint: number, count: number): Promise<number> {
    for (;;) {
      const token = this.link.wakeToken();
      if (this.link.matched(endpoint) === count) return count;
      await this.link.wait(token, -1);
    }
  }

  status(endpoint: number, kind: StatusKind): EndpointStatus | undefined {
    return this.link.status(endpoint, kind);
  }

  /** Waits until the counter of a status has reached `count`. */
  async waitStatus(endpoint: number, kind: StatusKind, count: number): Promise<EndpointStatus> {
    for (let change = 0;;) {
      const token = this.link.wakeToken();
      const status = this.link.status(endpoint, kind);
      change += status?.totalChange ?? 0;
      if (status !== undefined && status.totalCount >= count) return { ...status, totalChange: change };
      await this.link.wait(token, -1);
    }
  }

  /** Waits until `count` of a subscription's writers are alive. */
  async waitAlive(endpoint: number, count: number): Promise<EndpointStatus> {
    let [alive, dead] = [0, 0];
    for (;;) {
      const token = this.link.wakeToken();
      const status = this.link.status(endpoint, StatusKind.livelinessChanged);
      alive += status?.currentChange ?? 0;
      dead += status?.totalChange ?? 0;
      if (status?.currentCount === count) return { ...status, currentChange: alive, totalChange: dead };
      await this.link.wait(token, -1);
    }
  }

  /** Waits until a status of any own endpoint has changed since `version`. */
  async waitStatusVersion(version: number): Promise<number> {
    for (;;) {
      const token = this.link.wakeToken();
      const now = this.link.statusVersion();
      if (now !== version) return now;
      await this.link.wait(token, -1);
    }
  }

  statusVersion(): number {
    return this.link.statusVersion();
  }

  assertLiveliness(endpoint: number): number {
    return this.link.assertLiveliness(endpoint);
  }

  graph(): GraphSnapshot {
    return this.link.graph();
  }

  /** Until there are so many endpoints and, when given, so many nodes: those of a worker that dies leave one after the other. */
  async waitGraph(endpoints: number, nodes = -1): Promise<GraphSnapshot> {
    for (;;) {
      const token = this.link.wakeToken();
      this.link.graphVersion();
      const graph = this.link.graph();
      if (graph.endpoints.length === endpoints && (nodes < 0 || graph.nodes.length === nodes)) return graph;
      await this.link.wait(token, -1);
    }
  }

  async wait(timeoutMs: number): Promise<number> {
    return await this.link.wait(this.link.wakeToken(), timeoutMs);
  }

  /** A wait that only a stop or its time ends. */
  async waitOut(timeoutMs: number): Promise<number> {
    const { clock } = this.link;
    const end = clock.steadyNs() + timeoutMs * 1e6;
    for (;;) {
      const result = await this.link.wait(this.link.wakeToken(), Math.max(0, end - clock.steadyNs()) / 1e6);
      if (result !== WaitResult.woken) return result;
    }
  }

  steadyMs(): number {
    return this.link.clock.steadyNs() / 1e6;
  }

  /** The time once this worker knows that it is held: on the port link it has to let messages in for that. */
  async heldMs(): Promise<number> {
    while (this.link.clock.law().limitNs === Infinity) await this.link.wait(this.link.wakeToken(), 0);
    return this.steadyMs();
  }

  async untilNs(steadyNs: number): Promise<void> {
    while (this.link.clock.steadyNs() < steadyNs) await this.link.wait(this.link.wakeToken(), 0);
  }

  async sleep(durationMs: number): Promise<number> {
    return await this.link.sleep(durationMs);
  }

  stopRequested(): boolean {
    return this.link.stopRequested();
  }

  /** Ends the worker's part in the graph; true tells the broker that it did so itself. */
  close(): boolean {
    this.link.close();
    return true;
  }
}

export type PeerCall = { [K in keyof Peer]: Peer[K] extends (...args: never[]) => unknown ? K : never; }[keyof Peer];

/** Connects a Peer with the scene: `{call, args}` in, `{value}` or `{error}` out. */
export function servePeer(post: (message: unknown) => void): (message: unknown) => Promise<void> {
  let peer: Peer | undefined;
  let tail = Promise.resolve();
  const run = async (message: unknown): Promise<void> => {
    const request = message as { ticket?: LinkTicket; call?: PeerCall; args?: unknown[]; };
    try {
      if (request.ticket !== undefined) {
        peer = new Peer(openLink(request.ticket, true));
        post({ value: 'open' });
        return;
      }
      if (peer === undefined || request.call === undefined) throw new Error('not open');
      const method = peer[request.call] as (...args: unknown[]) => unknown;
      // `blocking` tells the scene that the call has begun.
      post({ begun: request.call });
      post({ value: await method.apply(peer, request.args ?? []) });
    } catch (error) {
      post({ error: error instanceof Error ? (error.stack ?? error.message) : String(error) });
    }
  };
  return (message) => {
    tail = tail.then(() => run(message));
    return tail;
  };
}
