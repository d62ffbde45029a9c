// Plays a bag on the graph of a site: publishers of the page's node with the recorded QoS, each message when its time in
// the bag has come, by the site's time: it waits while that is held, and is as fast or slow.

import type { PagePublisher, PageTimer, Session } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import type { Bag, BagChannel, BagMessage } from './bag_file.ts';
import { offerFor } from './qos_profiles.ts';

export const slowestRate = 0.01;
export const fastestRate = 100;
/** Between the first publisher and the first message, so that subscriptions find each other. */
const discoveryMs = 50;
/** The longest time for which the player occupies the page without a pause, in ms. */
const longestTurnMs = 8;
const clockTopic = '/clock';
/** Upper bound of the bytes of latched messages from before the start place. */
const mostHeldBytes = 64 << 20;

export interface PlayOptions {
  readonly rate?: number;
  readonly loop?: boolean;
  /** How often the bag's time is published on /clock, by the site's time; 0: never. */
  readonly clockHz?: number;
  /** Topics of the bag; all when omitted. */
  readonly topics?: readonly string[];
  /** From a topic of the bag to the name that it is published under. */
  readonly names?: ReadonlyMap<string, string>;
  /** The part that is played, in ns since 1970; all of the bag when omitted. */
  readonly from?: bigint;
  readonly to?: bigint;
}

export type PlayState = 'paused' | 'playing' | 'ended';

export class BagPlayer {
  readonly bag: Bag;
  private readonly session: Session;
  private readonly changed: () => void;
  private options: Required<PlayOptions>;
  /** The place in the bag at a time of the site, from which the present one follows. */
  private anchor: { readonly siteMs: number; readonly ns: bigint; };
  /** When the next message is to be sent: the place is never beyond it, so that a pause loses none. */
  private due = 0n;
  private publishers = new Map<number, PagePublisher>();
  private running: AbortController | undefined;
  private clock: { readonly publisher: PagePublisher; readonly timer: PageTimer; } | undefined;
  /** Ends a wait before its time. */
  private hurry: (() => void) | undefined;
  state: PlayState = 'paused';
  /** The error that ended it, or that keeps a topic from being published. */
  problem: SiteError | undefined;
  sent = 0;
  /** Messages that could not be sent: a subscription had no room, or the page has none for all that was latched. */
  unsent = 0;

  /** `changed` is called when anything but place() and the counts is another. */
  constructor(session: Session, bag: Bag, changed: () => void, options: PlayOptions = {}) {
    this.session = session;
    this.bag = bag;
    this.changed = changed;
    this.options = {
      rate: 1,
      loop: false,
      clockHz: 0,
      topics: playable(bag),
      names: new Map(),
      from: bag.start,
      to: bag.end,
      ...options,
    };
    this.anchor = { siteMs: 0, ns: this.options.from };
  }

  /** ns since 1970, within the bag. */
  place(): bigint {
    const { anchor } = this;
    if (this.state !== 'playing') return anchor.ns;
    const past = (this.session.time.view().now - anchor.siteMs) * 1e6 * this.options.rate;
    const now = anchor.ns + BigInt(Math.max(0, Math.round(past)));
    return now > this.due ? this.due : now;
  }

  play(): void {
    if (this.state === 'playing') return;
    if (this.state === 'ended') this.anchor = { siteMs: 0, ns: this.options.from };
    this.begin();
  }

  pause(): void {
    if (this.state !== 'playing') return;
    this.halt();
    this.state = 'paused';
    this.changed();
  }

  /** Bounded by the bag. */
  seek(to: bigint): void {
    const { from, to: last } = this.options;
    const ns = to < from ? from : to > last ? last : to;
    const goesOn = this.state === 'playing';
    this.halt();
    this.state = 'paused';
    this.anchor = { siteMs: 0, ns };
    if (goesOn) this.begin();
    else this.changed();
  }

  set(options: PlayOptions): void {
    const goesOn = this.state === 'playing';
    const publishesOthers = options.topics !== undefined || options.names !== undefined || options.clockHz !== undefined;
    this.keepPlace();
    this.options = { ...this.options, ...options };
    if (publishesOthers) {
      this.halt();
      this.state = goesOn ? 'paused' : this.state;
      this.closePublishers();
      if (goesOn) {
        this.begin();
        return;
      }
    }
    this.hurry?.();
    this.changed();
  }

  close(): void {
    this.halt();
    this.state = 'paused';
    this.closePublishers();
  }

  private begin(): void {
    const abort = new AbortController();
    this.running = abort;
    this.state = 'playing';
    this.problem = undefined;
    this.anchor = { siteMs: this.session.time.view().now, ns: this.anchor.ns };
    this.due = this.anchor.ns;
    this.changed();
    this.run(abort.signal).catch((error: unknown) => {
      if (abort.signal.aborted) return;
      this.halt();
      this.state = 'paused';
      this.problem = error instanceof SiteError
        ? error
        : new SiteError('R2W0741', `the bag \`${this.bag.name}\` is damaged`, { why: error instanceof Error ? error.message : String(error) });
      this.changed();
    });
  }

  private async run(signal: AbortSignal): Promise<void> {
    if (this.openPublishers()) await this.wait(discoveryMs, signal);
    for (;;) {
      if (signal.aborted) return;
      const from = this.anchor.ns;
      if (from > this.bag.start) await this.sendLatched(from, signal);
      if (signal.aborted) return;
      this.anchor = { siteMs: this.session.time.view().now, ns: from };
      await this.sendFrom(from, signal);
      if (signal.aborted) return;
      this.due = this.options.to;
      await this.until(this.options.to, signal);
      if (signal.aborted) return;
      if (!this.options.loop || this.bag.messages === 0) break;
      this.anchor = { siteMs: this.session.time.view().now, ns: this.options.from };
      this.due = this.options.from;
      // A bag of one moment would go round for ever within one turn.
      await this.wait(1, signal);
    }
    this.halt();
    this.anchor = { siteMs: 0, ns: this.options.to };
    this.state = 'ended';
    this.changed();
  }

  private async sendFrom(from: bigint, signal: AbortSignal): Promise<void> {
    let turn = performance.now();
    for await (const message of this.bag.read(from, this.options.topics)) {
      if (signal.aborted || message.logTime > this.options.to) return;
      this.due = message.logTime;
      if (await this.until(message.logTime, signal)) turn = performance.now();
      if (signal.aborted) return;
      this.send(message);
      if (performance.now() - turn > longestTurnMs) {
        await nextTurn();
        turn = performance.now();
      }
    }
  }

  /** Publishes the messages that latched topics held at that place, as late subscriptions would get them. */
  private async sendLatched(before: bigint, signal: AbortSignal): Promise<void> {
    const isLatched = ({ topic, offered }: BagChannel): boolean => this.options.topics.includes(topic) && offerFor(offered).durability === 'transient_local';
    const latched = new Map(
      this.bag.channels.filter(isLatched).map((
        { id, topic, offered },
      ) => [id, { topic, depth: offerFor(offered).depth ?? 10, count: 0, last: [] as BagMessage[] }]),
    );
    if (latched.size === 0) return;
    let held = 0;
    const drop = (last: BagMessage[]): void => {
      held -= last.shift()?.data.length ?? 0;
    };
    let turn = performance.now();
    for await (const message of this.bag.read(this.bag.start, [...new Set([...latched.values()].map(({ topic }) => topic))])) {
      if (signal.aborted || message.logTime >= before) break;
      const channel = latched.get(message.channel);
      if (channel !== undefined) {
        channel.count += 1;
        channel.last.push(message);
        held += message.data.length;
        if (channel.last.length > channel.depth) drop(channel.last);
      }
      while (held > mostHeldBytes) drop(oldest([...latched.values()].map(({ last }) => last)));
      if (performance.now() - turn > longestTurnMs) {
        await nextTurn();
        turn = performance.now();
      }
    }
    if (signal.aborted) return;
    for (const { last, depth, count } of latched.values()) {
      this.unsent += Math.min(depth, count) - last.length;
      for (const message of last) this.send(message);
    }
  }

  private send({ channel, data }: BagMessage): void {
    const publisher = this.publishers.get(channel);
    if (publisher === undefined) return;
    if (publisher.publish(data) === undefined) this.sent += 1;
    else this.unsent += 1;
  }

  /** Has the place been waited for? */
  private async until(ns: bigint, signal: AbortSignal): Promise<boolean> {
    let waited = false;
    while (!signal.aborted) {
      const { anchor, options } = this;
      // In ms of the site, without rounding: place() may be behind by a hair for ever.
      const left = Number(ns - anchor.ns) / 1e6 / options.rate - (this.session.time.view().now - anchor.siteMs);
      if (left <= 0.001) break;
      waited = true;
      await this.wait(Math.min(left, 1000), signal);
    }
    return waited;
  }

  /** Waits for `ms` of site time; less when the speed changes. */
  private wait(ms: number, signal: AbortSignal): Promise<void> {
    return new Promise((resolve) => {
      const done = (): void => {
        timer.close();
        signal.removeEventListener('abort', done);
        this.hurry = undefined;
        resolve();
      };
      const timer = this.session.node().timer(ms, done);
      signal.addEventListener('abort', done, { once: true });
      this.hurry = done;
    });
  }

  private halt(): void {
    this.keepPlace();
    this.running?.abort();
    this.running = undefined;
  }

  private keepPlace(): void {
    if (this.state === 'playing') this.anchor = { siteMs: this.session.time.view().now, ns: this.place() };
  }

  /** Were some made? */
  private openPublishers(): boolean {
    const node = this.session.node();
    const { topics, names, clockHz } = this.options;
    let made = false;
    for (const { id, topic, type, encoding, offered } of this.bag.channels) {
      const hasOwnClock = topic === clockTopic && clockHz > 0;
      if (this.publishers.has(id) || hasOwnClock || encoding !== 'cdr' || !topics.includes(topic)) continue;
      const publisher = node.publisher(names.get(topic) ?? topic, type, offerFor(offered));
      this.problem ??= publisher.problem;
      this.publishers.set(id, publisher);
      made = true;
    }
    if (clockHz > 0 && this.clock === undefined) {
      const publisher = node.publisher(clockTopic, 'rosgraph_msgs/msg/Clock', { reliability: 'best_effort', depth: 1 });
      const timer = node.timer(1000 / clockHz, () => {
        if (this.state === 'playing') publisher.publish(clockBytes(this.place()));
      });
      this.clock = { publisher, timer };
      made = true;
    }
    return made;
  }

  private closePublishers(): void {
    for (const publisher of this.publishers.values()) publisher.close();
    this.publishers.clear();
    this.clock?.timer.close();
    this.clock?.publisher.close();
    this.clock = undefined;
  }
}

/** Topics that can be played. */
export function playable({ channels }: Bag): string[] {
  return [...new Set(channels.filter(({ encoding, type }) => encoding === 'cdr' && type !== '').map(({ topic }) => topic))];
}

/** The list that begins first; each list is in order, and at least one is not empty. */
function oldest(lists: readonly BagMessage[][]): BagMessage[] {
  return lists.filter(({ length }) => length > 0).reduce((first, list) => (list[0]!.logTime < first[0]!.logTime ? list : first));
}

/** rosgraph_msgs/msg/Clock. */
function clockBytes(ns: bigint): Uint8Array {
  const view = new DataView(new ArrayBuffer(12));
  view.setUint8(1, 1);
  view.setInt32(4, Number(ns / 1_000_000_000n), true);
  view.setUint32(8, Number(ns % 1_000_000_000n), true);
  return new Uint8Array(view.buffer);
}

function nextTurn(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, 0);
  });
}
