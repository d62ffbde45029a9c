// Joins this tab's graph with that of one other tab. Works in a worker of its own, so that no message passes the page.
// The frames are those of the port link; the queues of the mirrors bound the frames that wait for credit.

import { Durability, EndpointKind, ErrorCode, flagIgnoreLocal, flagMirror, frameHeaderSize, History } from '../../protocol/generated/constants.ts';
import type { Bridge, BridgeChannel, BridgeLink } from './bridge.ts';
import { nextEvent } from './event_wait.ts';
import type { BridgeMessage, ExportedEndpoint, ExportedNode } from './bridge_messages.ts';
import { type EndpointRecord, hiddenNamespace, reads, relate } from './graph.ts';
import type { Heap } from './link.ts';
import { type LinkTicket, openLink } from './open_link.ts';

/** Frames and bytes of one group (a name of one kind) that are under way; one frame always may be. */
const windowFrames = 32;
const windowBytes = 8 << 20;
/** A writer's end is told when all of its name has crossed, or after this: others may write without a pause. */
const farewellMs = 1000;
/** Requests that a mirrored client remembers. */
const mostCalls = 16384;

/** An endpoint in this tab that represents one of the other tab. */
interface Mirror {
  readonly remote: ExportedEndpoint;
  readonly handle: number;
  readonly record: EndpointRecord;
  readonly group: Group | undefined;
  /** For a client: the sequence number of a request here -> the two words of the caller's number. */
  readonly calls: Map<number, readonly [number, number]>;
  /** Came from over there, not yet written here. */
  readonly waiting: { readonly frame: ArrayBuffer; readonly group: string; }[];
  /** Gone over there; it stays until it has written what waits. */
  ending: boolean;
}

/** The mirrors that read one name: what several of them get crosses once. */
interface Group {
  readonly id: string;
  /** The one that wants most first. */
  mirrors: Mirror[];
  /** The newest sequence that crossed, by writer. */
  readonly crossed: Map<number, number>;
  flyingFrames: number;
  flyingBytes: number;
}

/** The bridges of two tabs meet on a broadcast channel that nobody else knows. */
export function tabChannel(channel: BroadcastChannel): BridgeChannel {
  return {
    post: (message) => channel.postMessage(message),
    listen: (listener) => {
      channel.onmessage = ({ data }: MessageEvent<unknown>) => listener(data);
    },
    close: () => channel.close(),
  };
}

/** Carries until the worker is terminated. */
export async function bridgeTabs(ticket: LinkTicket, channel: BroadcastChannel): Promise<void> {
  await new TabBridge(openLink(ticket, false), tabChannel(channel)).run();
}

export class TabBridge implements Bridge {
  private readonly link: BridgeLink;
  private readonly channel: BridgeChannel;
  private greeted = false;
  private closed = false;
  /** The graph that the other tab was last sent: its version, nodes and endpoints. */
  private toldVersion: number | undefined;
  private readonly toldNodes = new Set<string>();
  private readonly told = new Map<number, EndpointRecord>();
  /** When endpoints that are told of went, ms. */
  private readonly goneSince = new Map<number, number>();
  /** ExportedNode.id of the other tab -> our node. */
  private readonly nodes = new Map<string, number>();
  private readonly endingNodes = new Set<string>();
  private readonly mirrors = new Map<number, Mirror>();
  private readonly byHandle = new Map<number, Mirror>();
  private readonly groups = new Map<string, Group>();
  private readonly inbox: BridgeMessage[] = [];
  private heap = scratch(1 << 16);

  constructor(link: BridgeLink, channel: BridgeChannel) {
    this.link = link;
    this.channel = channel;
    channel.listen((message) => {
      this.inbox.push(message as BridgeMessage);
      link.wake();
    });
    this.post({ t: 'hello' });
  }

  async run(): Promise<void> {
    while (!this.closed) {
      const token = this.link.wakeToken();
      for (const message of this.inbox.splice(0)) this.onMessage(message);
      for (const mirror of this.mirrors.values()) await this.deliver(mirror);
      if (this.endingNodes.size > 0 || [...this.mirrors.values()].some(({ ending }) => ending)) this.tidy();
      if (this.greeted) {
        this.announce();
        this.forward();
      }
      if (this.inbox.length === 0) await nextEvent(this.link, token, this.blocked());
    }
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    this.post({ t: 'bye' });
    this.channel.close();
    this.link.close();
  }

  private post(message: BridgeMessage): void {
    this.channel.post(message);
  }

  private onMessage(message: BridgeMessage): void {
    switch (message.t) {
      case 'hello':
        if (this.greeted) return;
        this.greeted = true;
        this.post({ t: 'hello' });
        return;
      case 'graph':
        for (const key of message.goneEndpoints) {
          const mirror = this.mirrors.get(key);
          if (mirror !== undefined) mirror.ending = true;
        }
        for (const id of message.goneNodes) this.endingNodes.add(id);
        this.tidy();
        for (const node of message.nodes) this.nodes.set(node.id, this.link.nodeCreate(node.name, node.namespace));
        for (const endpoint of message.endpoints) this.addMirror(endpoint);
        return;
      case 'frame': {
        const mirror = this.mirrors.get(message.writer);
        if (mirror === undefined) this.acknowledge(message.group, message.frame);
        else mirror.waiting.push(message);
        return;
      }
      case 'ack': {
        const group = this.groups.get(message.group);
        if (group === undefined) return;
        group.flyingFrames = Math.max(0, group.flyingFrames - message.frames);
        group.flyingBytes = Math.max(0, group.flyingBytes - message.bytes);
        return;
      }
      case 'forget':
        for (const key of message.writers) this.renewMirror(key);
        return;
      case 'bye':
        for (const key of [...this.mirrors.keys()]) this.removeMirror(key);
        for (const id of [...this.nodes.keys()]) this.removeNode(id);
        return;
    }
  }

  /** Removes what has ended and has nothing left to do. */
  private tidy(): void {
    const busy = new Set<string>();
    for (const [key, { ending, waiting, remote }] of this.mirrors) {
      if (ending && waiting.length === 0) this.removeMirror(key);
      else busy.add(remote.node);
    }
    for (const id of this.endingNodes) {
      if (busy.has(id)) continue;
      this.endingNodes.delete(id);
      this.removeNode(id);
    }
  }

  private removeNode(id: string): void {
    const node = this.nodes.get(id);
    if (node === undefined) return;
    this.nodes.delete(id);
    this.link.nodeDestroy(node);
  }

  private addMirror(remote: ExportedEndpoint): void {
    const node = this.nodes.get(remote.node);
    if (node === undefined || this.mirrors.has(remote.key)) return;
    const { kind, name, type, hash, qos } = remote;
    const flags = (remote.flags & flagIgnoreLocal) | flagMirror;
    const handle = this.link.endpointCreate({ kind, node, name, type, hash, qos, flags });
    const gid = this.link.gid(handle);
    if (handle < 0 || gid === undefined) return;
    const record: EndpointRecord = {
      key: gid[2]!,
      participant: this.link.participant,
      nodeKey: node,
      kind,
      name,
      type,
      hash,
      qos,
      flags,
      gid,
    };
    // Replies are for one client alone.
    const groupId = kind === EndpointKind.client ? `${kind} ${name} ${remote.key}` : `${kind} ${name} ${type}`;
    const group = reads(kind) ? this.groupOf(groupId) : undefined;
    const mirror: Mirror = { remote, handle, record, group, calls: new Map(), waiting: [], ending: false };
    this.mirrors.set(remote.key, mirror);
    this.byHandle.set(handle, mirror);
    if (group === undefined) return;
    group.mirrors.push(mirror);
    group.mirrors.sort((a, b) => wants(b) - wants(a));
  }

  private groupOf(id: string): Group {
    let group = this.groups.get(id);
    if (group === undefined) {
      group = { id, mirrors: [], crossed: new Map(), flyingFrames: 0, flyingBytes: 0 };
      this.groups.set(id, group);
    }
    return group;
  }

  private removeMirror(key: number): void {
    const mirror = this.mirrors.get(key);
    if (mirror === undefined) return;
    this.mirrors.delete(key);
    this.byHandle.delete(mirror.handle);
    for (const { frame, group } of mirror.waiting) this.acknowledge(group, frame);
    this.link.endpointDestroy(mirror.handle);
    const { group } = mirror;
    if (group === undefined) return;
    group.mirrors = group.mirrors.filter((other) => other !== mirror);
    if (group.mirrors.length > 0) return;
    this.groups.delete(group.id);
    if (group.crossed.size > 0) this.post({ t: 'forget', writers: [...group.crossed.keys()] });
  }

  /** Recreates the mirror of a writer, without stored samples. */
  private renewMirror(key: number): void {
    const mirror = this.mirrors.get(key);
    if (mirror === undefined || mirror.remote.qos.durability !== Durability.transientLocal) return;
    if (mirror.remote.kind !== EndpointKind.publisher) return;
    this.removeMirror(key);
    this.addMirror(mirror.remote);
  }

  /** Tells the other tab what changed in the graph here. Mirrors are not told: nothing goes round. */
  private announce(): void {
    const version = this.link.graphVersion();
    if (version === this.toldVersion) return;
    this.toldVersion = version;
    const now = new Map<number, EndpointRecord>();
    for (const record of this.link.records()) if ((record.flags & flagMirror) === 0) now.set(record.key, record);
    // Nodes are told by what they have: those of the other bridges here have mirrors only.
    const nodeIds = new Set<string>();
    const nodes: ExportedNode[] = [];
    const endpoints: ExportedEndpoint[] = [];
    for (const [key, record] of now) {
      const node = this.link.graphReplica.nodes.get(record.nodeKey);
      if (node === undefined || node.namespace === hiddenNamespace) continue;
      const id = `${node.key} ${node.namespace} ${node.name}`;
      if (!nodeIds.has(id) && !this.toldNodes.has(id)) nodes.push({ id, namespace: node.namespace, name: node.name });
      nodeIds.add(id);
      if (this.told.has(key)) continue;
      const { kind, name, type, hash, qos, flags, gid } = record;
      endpoints.push({ key, node: id, kind, name, type, hash, qos, flags, gid });
      this.told.set(key, record);
    }
    const gone = [...this.told].filter(([key]) => !now.has(key));
    // The remaining samples of a writer cross before its end.
    if (gone.length > 0) this.forward();
    const unread = new Set(this.link.ready().map((handle) => this.byHandle.get(handle)?.record.name));
    const nowMs = performance.now();
    const goneEndpoints = gone.filter(([key, { name }]) => {
      const since = this.goneSince.get(key) ?? nowMs;
      this.goneSince.set(key, since);
      return !unread.has(name) || nowMs - since > farewellMs;
    }).map(([key]) => key);
    const all = goneEndpoints.length === gone.length;
    if (!all) this.toldVersion = undefined;
    const goneNodes = all ? [...this.toldNodes].filter((id) => !nodeIds.has(id)) : [];
    for (const key of goneEndpoints) {
      this.told.delete(key);
      this.goneSince.delete(key);
    }
    for (const id of goneNodes) this.toldNodes.delete(id);
    for (const { id } of nodes) this.toldNodes.add(id);
    if (nodes.length + endpoints.length + goneEndpoints.length + goneNodes.length === 0) return;
    this.post({ t: 'graph', nodes, endpoints, goneEndpoints, goneNodes });
  }

  /** Sends what has come to the mirrors, as far as the credit goes. */
  private forward(): void {
    for (const handle of this.link.ready()) {
      const mirror = this.byHandle.get(handle);
      if (mirror?.group === undefined) continue;
      while (hasCredit(mirror.group) && this.forwardOne(mirror, mirror.group)) {
        // One frame after the other.
      }
    }
  }

  private forwardOne(mirror: Mirror, group: Group): boolean {
    const { link } = this;
    let length = link.take(mirror.handle, this.heap, frameHeaderSize, this.heap.u8.length - frameHeaderSize, 0);
    if (length > this.heap.u8.length - frameHeaderSize) {
      this.heap = scratch(length + frameHeaderSize);
      length = link.take(mirror.handle, this.heap, frameHeaderSize, length, 0);
    }
    if (length < 0) return false;
    const frame = this.heap.u8.slice(0, (frameHeaderSize + length + 3) & -4).buffer;
    const header = new Int32Array(frame, 0, 16);
    const writer = header[14]!;
    if (this.carrier(group, writer) !== mirror) return true;
    const newest = group.crossed.get(writer);
    if (newest !== undefined && ((header[2]! - newest) | 0) <= 0) return true;
    group.crossed.set(writer, header[2]!);
    if (mirror.remote.kind === EndpointKind.client) {
      const call = mirror.calls.get(header[6]!);
      if (call === undefined) return true;
      header.set(call, 6);
      header.set(mirror.remote.gid, 8);
    }
    group.flyingFrames += 1;
    group.flyingBytes += frame.byteLength;
    this.post({ t: 'frame', writer, group: group.id, frame });
    return true;
  }

  /** The mirror that wants most, among those that the writer matches; replies go to the mirror that asked. */
  private carrier(group: Group, writer: number): Mirror | undefined {
    const record = this.told.get(writer);
    if (record === undefined) return group.mirrors[0];
    return group.mirrors.find((mirror) => relate(mirror.record, record).kind === 'match');
  }

  /** Writes what has come for a writer's mirror, until it must wait. */
  private async deliver(mirror: Mirror): Promise<void> {
    for (let next = mirror.waiting[0]; next !== undefined; next = mirror.waiting[0]) {
      const heap: Heap = { u8: new Uint8Array(next.frame), i32: new Int32Array(next.frame) };
      const asked = [heap.i32[6]!, heap.i32[7]!] as const;
      const result = await this.link.write(mirror.handle, heap, frameHeaderSize, heap.i32[0]!, 0);
      if (result === ErrorCode.wouldBlock) return;
      if (mirror.remote.kind === EndpointKind.client) {
        mirror.calls.set(heap.i32[2]!, asked);
        if (mirror.calls.size > mostCalls) mirror.calls.delete(mirror.calls.keys().next().value!);
      }
      mirror.waiting.shift();
      this.acknowledge(next.group, next.frame);
    }
  }

  private acknowledge(group: string, frame: ArrayBuffer): void {
    this.post({ t: 'ack', group, frames: 1, bytes: frame.byteLength });
  }

  /** Must something be tried again though nothing happens? */
  private blocked(): boolean {
    for (const { waiting } of this.mirrors.values()) if (waiting.length > 0) return true;
    return false;
  }
}

function hasCredit({ flyingFrames, flyingBytes }: Group): boolean {
  return flyingFrames === 0 || (flyingFrames < windowFrames && flyingBytes < windowBytes);
}

function wants({ remote: { kind, qos } }: Mirror): number {
  return kind !== EndpointKind.subscription || qos.history === History.keepAll ? Infinity : qos.depth;
}

function scratch(bytes: number): Heap {
  const buffer = new ArrayBuffer((bytes + 3) & -4);
  return { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
}
