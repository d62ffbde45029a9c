// The page as a participant of the graph: endpoints on its own place on the bus, read without blocking.

import { EndpointKind, ErrorCode, flagHidden, frameHeaderSize } from '../../protocol/generated/constants.ts';
import { checkFullName, expandName } from '../decode/ros_names.ts';
import type { Broker } from '../bus/broker.ts';
import { nextEvent, turn } from '../bus/event_wait.ts';
import type { Heap } from '../bus/link.ts';
import { ActionClient } from './page_actions.ts';
import { Client, Publisher, Subscription } from './page_endpoints.ts';
import { closedError, guarded, type Made, type PageReader, type Participant, type Taken, type Watcher } from './participant.ts';
import type {
  MessageListener,
  PageActionClient,
  PageClient,
  PageNode,
  PagePublisher,
  PageSubscription,
  PageTimer,
  QosRequest,
  SubscriptionRequest,
} from '../contract/page_node.ts';
import { endpointQos } from '../contract/qos_view.ts';
import { SiteError } from '../contract/site_error.ts';
import { SiteTimers } from '../bus/site_timers.ts';

const nodeName = '_ros2wasm_page';
/** After so many samples the page gets its turn. */
const samplesPerTurn = 256;
const firstBytes = 1 << 14;

export class PageParticipant implements PageNode, Participant {
  readonly name = `/${nodeName}`;
  readonly broker: Broker;
  readonly timers: SiteTimers;
  private node: number | undefined;
  private readonly readers = new Map<number, PageReader>();
  /** Called at each event, before and after samples are taken. */
  private readonly watchers = new Set<Watcher>();
  private readonly open = new Set<{ close(): void; }>();
  private pumping = false;
  private closed = false;
  private readonly heap = scratch(firstBytes);

  constructor(broker: Broker) {
    this.broker = broker;
    this.timers = new SiteTimers(broker.link.clock, broker.conductor);
    broker.onRest(() => this.takeRest());
  }

  publisher(topic: string, type: string, qos: QosRequest = {}): PagePublisher {
    return this.keep(new Publisher(this, this.make(EndpointKind.publisher, topic, type, qos)));
  }

  subscription(topic: string, type: string, { past = false, ...qos }: SubscriptionRequest, listener: MessageListener): PageSubscription {
    return this.keep(new Subscription(this, this.make(EndpointKind.subscription, topic, type, qos, past), listener));
  }

  client(service: string, type: string): PageClient {
    return this.keep(this.newClient(service, type));
  }

  newClient(service: string, type: string): Client {
    const name = expandName(service, nodeName);
    return new Client(this, this.make(EndpointKind.client, name, type, {}), name, type);
  }

  actionClient(action: string, type: string): PageActionClient {
    return this.keep(new ActionClient(this, expandName(action, nodeName), type));
  }

  timer(periodMs: number, ring: () => void): PageTimer {
    const period = Math.max(1, Number.isFinite(periodMs) ? periodMs : 1);
    const { clock } = this.broker.link;
    let next = clock.steadyNs();
    let takeBack = (): void => undefined;
    const arm = (): void => {
      const now = clock.steadyNs();
      next += period * 1e6;
      // Periods that passed while the page was busy are not made up for.
      if (next <= now) next += Math.ceil((now - next + 1) / (period * 1e6)) * period * 1e6;
      takeBack = this.timers.after((next - now) / 1e6, () => {
        arm();
        guarded(ring);
      });
    };
    if (!this.closed) arm();
    const timer = {
      close: () => {
        takeBack();
        this.open.delete(timer);
      },
    };
    return this.keep(timer);
  }

  /** Forgets it when it is closed; one that could not be made is nothing to close. */
  private keep<T extends { close(): void; readonly problem?: SiteError | undefined; }>(made: T): T {
    if (made.problem === undefined) this.open.add(made);
    return made;
  }

  forget(closed: { close(): void; }): void {
    this.open.delete(closed);
  }

  private make(kind: EndpointKind, given: string, type: string, qos: QosRequest, past = false): Made {
    const { link } = this.broker;
    const name = expandName(given, nodeName);
    if (this.closed) return { problem: closedError(name) };
    const wrong = checkFullName(name);
    if (wrong !== undefined) {
      return { problem: new SiteError('R2W0715', `\`${given}\` is not a valid name: ${wrong.what}`) };
    }
    // A look at whatever is published there is nobody's subscription.
    const anyType = kind === EndpointKind.subscription && type === '';
    if (!anyType && !/^[A-Za-z]\w*\/(?:msg|srv|action)\/[A-Za-z]\w*$/.test(type)) {
      return { problem: new SiteError('R2W0715', `\`${type}\` is not a valid type`, { why: 'types are written as `std_msgs/msg/String`' }) };
    }
    this.node ??= link.nodeCreate(nodeName, '/');
    const handle = this.node < 0
      ? this.node
      : link.endpointCreate({ kind, node: this.node, name, type, hash: '', qos: endpointQos(qos), flags: anyType ? flagHidden : 0, past });
    if (handle >= 0) return { handle };
    if (this.node < 0) this.node = undefined;
    const why = handle === ErrorCode.tableFull ? 'the site has no place left for one more endpoint' : `the bus refused it, error ${handle}`;
    return { problem: new SiteError('R2W0715', `the page cannot have \`${name}\``, { why }) };
  }

  /** The endpoint is read from now on. */
  read(reader: PageReader): void {
    this.readers.set(reader.handle, reader);
    this.pump();
  }

  unread(handle: number): void {
    this.readers.delete(handle);
  }

  watch(watcher: Watcher): () => void {
    this.watchers.add(watcher);
    this.pump();
    return () => void this.watchers.delete(watcher);
  }

  /** One sample of an own endpoint. */
  take(handle: number): Taken | undefined {
    const { link } = this.broker;
    const length = link.take(handle, this.heap, frameHeaderSize, this.heap.u8.length - frameHeaderSize, 0);
    if (length > this.heap.u8.length - frameHeaderSize) {
      const large = scratch(length + frameHeaderSize);
      const taken = link.take(handle, large, frameHeaderSize, length, 0);
      if (taken < 0 || taken > length) return undefined;
      return { bytes: new Uint8Array(large.u8.buffer as ArrayBuffer, frameHeaderSize, taken), words: large.i32.slice(0, 16) };
    }
    if (length < 0) return undefined;
    return { bytes: this.heap.u8.slice(frameHeaderSize, frameHeaderSize + length), words: this.heap.i32.slice(0, 16) };
  }

  /** Sends one sample; its sequence number (low word), what kept it, or a promise of what will: it waits for room. */
  write(handle: number, bytes: Uint8Array, name: string): number | SiteError | Promise<SiteError | undefined> {
    const { link } = this.broker;
    const heap = scratch(frameHeaderSize + bytes.length);
    heap.u8.set(bytes, frameHeaderSize);
    const result = link.write(handle, heap, frameHeaderSize, bytes.length, 0);
    if (typeof result !== 'number') return result.then((code) => code >= 0 ? undefined : refused(code, bytes.length, name));
    this.broker.wrote();
    return result >= 0 ? heap.i32[2]! : refused(result, bytes.length, name);
  }

  /** The session ends: nobody answers any more. */
  get ending(): boolean {
    return this.closed;
  }

  timeChanged(): void {
    this.timers.timeChanged();
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    for (const each of [...this.open]) each.close();
    this.open.clear();
    this.timers.close();
    this.watchers.clear();
    this.readers.clear();
    if (this.node !== undefined && this.node >= 0) this.broker.link.nodeDestroy(this.node);
    this.broker.link.wake();
  }

  private pump(): void {
    if (this.closed) return;
    if (this.pumping) {
      // There may be something for a new one already, which no event tells.
      this.broker.link.wake();
      return;
    }
    this.pumping = true;
    void this.run().finally(() => {
      this.pumping = false;
      if (this.readers.size + this.watchers.size > 0) this.pump();
    });
  }

  /** As long as there is somebody to read or watch for. */
  private async run(): Promise<void> {
    // Not within the call that made the endpoint.
    await turn();
    while (!this.closed && this.readers.size + this.watchers.size > 0) {
      const { link } = this.broker;
      const token = link.wakeToken();
      for (const watcher of [...this.watchers]) guarded(() => watcher.before?.());
      const more = this.takeAll();
      for (const watcher of [...this.watchers]) guarded(() => watcher.after());
      if (more) await turn();
      else await nextEvent(link, token, false);
    }
  }

  /** In a stepped run: what a node has sent or made is seen before the next one has its turn, so that all runs see the same. */
  private takeRest(): void {
    if (this.closed) return;
    for (const watcher of [...this.watchers]) guarded(() => watcher.before?.());
    while (!this.closed && this.readers.size > 0 && this.takeAll());
    for (const watcher of [...this.watchers]) guarded(() => watcher.after());
  }

  /** True when there may be more. */
  private takeAll(): boolean {
    let left = samplesPerTurn;
    for (const handle of this.broker.link.ready()) {
      const reader = this.readers.get(handle);
      while (left > 0 && reader !== undefined && this.readers.has(handle)) {
        let taken = false;
        guarded(() => {
          taken = true;
          taken = reader.takeOne();
        });
        if (!taken) break;
        left -= 1;
      }
    }
    return left === 0;
  }
}

function refused(code: number, size: number, name: string): SiteError {
  switch (code) {
    case ErrorCode.wouldBlock:
      return new SiteError('R2W0718', `\`${name}\` cannot take more now`, { why: 'a subscription that wants every message has not read the last ones' });
    case ErrorCode.outOfMemory:
    case ErrorCode.tooLarge:
      return new SiteError('R2W0718', `the message for \`${name}\` (${size} bytes) does not fit into the memory of the bus`);
    default:
      return closedError(name);
  }
}

function scratch(bytes: number): Heap {
  const buffer = new ArrayBuffer((bytes + 3) & -4);
  return { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
}
