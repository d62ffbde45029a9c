// Message channels whose messages arrive when the scene says so: in order on each, in any order between them.

import type { Generator } from './generator.ts';

type Listener = (event: { data: unknown; }) => void;

export class HandPort {
  /** The index of the owner of this end of a channel. */
  owner = -1;
  other!: HandPort;
  readonly inbox: unknown[] = [];
  private listener: Listener | undefined;
  private started = false;
  private readonly net: HandNet;
  closed = false;

  constructor(net: HandNet) {
    this.net = net;
  }

  addEventListener(_: 'message', listener: Listener): void {
    this.listener = listener;
  }

  start(): void {
    this.started = true;
    this.net.note(this);
  }

  postMessage(data: unknown): void {
    if (this.closed || this.other.closed) return;
    this.other.inbox.push(data instanceof ArrayBuffer ? data.slice(0) : data);
    this.net.note(this.other);
  }

  close(): void {
    this.closed = true;
    this.inbox.length = 0;
  }

  get due(): boolean {
    return this.started && this.inbox.length > 0;
  }

  /** Hands the oldest message over. */
  deliver(): void {
    const data = this.inbox.shift();
    const peer = (data as { peer?: { port: HandPort; }; }).peer;
    if (peer !== undefined) peer.port.owner = this.owner;
    this.listener?.({ data });
  }
}

export class HandNet {
  private readonly ports = new Set<HandPort>();
  /** Those with something to deliver, and perhaps others. */
  private readonly waiting: HandPort[] = [];

  channel(): MessageChannel {
    const [port1, port2] = [new HandPort(this), new HandPort(this)];
    port1.other = port2;
    port2.other = port1;
    this.ports.add(port1).add(port2);
    return { port1, port2 } as unknown as MessageChannel;
  }

  note(port: HandPort): void {
    if (port.due && !this.waiting.includes(port)) this.waiting.push(port);
  }

  /** Some port with a message, or undefined when all is quiet. */
  pick(random: Generator): HandPort | undefined {
    while (this.waiting.length > 0) {
      const at = random.below(this.waiting.length);
      const port = this.waiting[at]!;
      if (port.due) return port;
      this.waiting.splice(at, 1);
    }
    return undefined;
  }

  /** A participant dies: it hears nothing more, and of what it said last some is never heard. */
  kill(owner: number, random: Generator): void {
    for (const port of this.ports) {
      if (port.owner !== owner) continue;
      port.close();
      const { inbox } = port.other;
      inbox.length -= random.below(inbox.length + 1);
    }
  }

  /** Most frames of one writer on the way to one participant. */
  crowd(counts: (writer: number) => boolean): number {
    let most = 0;
    for (const { inbox } of this.ports) {
      const frames = new Map<number, number>();
      for (const data of inbox) {
        if (!(data instanceof ArrayBuffer)) continue;
        const writer = new Int32Array(data, 0, 16)[14]!;
        if (counts(writer)) frames.set(writer, (frames.get(writer) ?? 0) + 1);
      }
      most = Math.max(most, ...frames.values());
    }
    return most;
  }

  forget(): void {
    for (const port of this.ports) if (port.closed) this.ports.delete(port);
  }
}
