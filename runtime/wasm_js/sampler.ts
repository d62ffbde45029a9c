// What the page shows of the topics: rates and last messages, read from beside the data path.

import { BusEndpoint, BusHeader, BusSizes, Durability, EndpointKind, History, Reliability } from '../protocol/generated/constants.ts';
import type { Broker } from './broker.ts';
import type { EndpointRecord } from './graph.ts';
import type { PortLink } from './port_link.ts';
import { RateWindow } from './rate_window.ts';
import type { LastMessage, QosView, TopicView } from './session.ts';
import type { SharedLink } from './shared_link.ts';
import { keyIndex, slotWord, unit } from './shared_ring.ts';

interface WriterCount {
  readonly count: number;
  readonly bytes: number;
}

const wantedMs = 2000;
/** A time further off than this is not of the clock that `now` is of. */
const otherClockMs = 60_000;

export class Sampler {
  private readonly broker: Broker;
  private readonly rates = new Map<string, RateWindow>();
  private readonly wanted = new Map<string, number>();
  private views: readonly TopicView[] = [];

  constructor(broker: Broker) {
    this.broker = broker;
  }

  topics(): readonly TopicView[] {
    return this.views;
  }

  /** Looks at all topics now. `now` in ms. */
  sample(now: number): readonly TopicView[] {
    const { link } = this.broker;
    if (link.kind === 'port') {
      for (const [topic, until] of this.wanted) if (until < now) this.wanted.delete(topic);
      link.requestSamples([...this.wanted.keys()]);
    }
    const topics = new Map<string, EndpointRecord[]>();
    for (const record of link.records()) {
      if (record.kind !== EndpointKind.publisher && record.kind !== EndpointKind.subscription) continue;
      const list = topics.get(record.name);
      if (list === undefined) topics.set(record.name, [record]);
      else list.push(record);
    }
    const views: TopicView[] = [];
    for (const name of [...topics.keys()].sort()) views.push(this.view(name, topics.get(name) ?? [], now));
    for (const name of this.rates.keys()) if (!topics.has(name)) this.rates.delete(name);
    this.views = views;
    return views;
  }

  private view(name: string, records: readonly EndpointRecord[], now: number): TopicView {
    const publishers = records.filter((record) => record.kind === EndpointKind.publisher);
    let count = 0;
    let bytes = 0;
    let newest = 0;
    for (const publisher of publishers) {
      newest = Math.max(newest, this.timeOf(publisher) ?? 0);
      const of = this.countOf(publisher);
      count += of.count;
      bytes += of.bytes;
    }
    const window = this.rates.get(name) ?? new RateWindow();
    this.rates.set(name, window);
    window.add(count, bytes, Math.abs(now - newest) < otherClockMs ? newest : now);
    const rate = window.rate(now);
    return {
      name,
      type: records[0]?.type ?? '',
      publishers: publishers.length,
      subscriptions: records.length - publishers.length,
      rateHz: rate.hz,
      bytesPerSecond: rate.bytesPerSecond,
      count,
      qos: qosViews(publishers),
    };
  }

  private countOf(record: EndpointRecord): WriterCount {
    const { link } = this.broker;
    if (link.kind === 'port') return link.sampled().get(record.key) ?? { count: 0, bytes: 0 };
    const { i32 } = link.bus;
    const word = link.bus.endpointWord(keyIndex(record.key));
    const wide = (low: number, high: number): number =>
      (Atomics.load(i32, word + low) >>> 0) + Atomics.load(i32, word + high) * 2 ** 32;
    return {
      count: wide(BusEndpoint.head, BusEndpoint.headHigh),
      bytes: wide(BusEndpoint.bytesLow, BusEndpoint.bytesHigh),
    };
  }

  /** When a writer's newest message was published, ms since 1970. */
  private timeOf(record: EndpointRecord): number | undefined {
    const { link } = this.broker;
    return link.kind === 'port' ? link.sampled().get(record.key)?.time : readNewest(link, record, (at) => timeAt(link, at));
  }

  /** The newest message on a topic, whichever publisher it came from. */
  lastMessage(topic: string, now: number): LastMessage | undefined {
    const { link } = this.broker;
    let newest: LastMessage | undefined;
    let count = 0;
    if (link.kind === 'port') this.wanted.set(topic, now + wantedMs);
    for (const record of link.records()) {
      if (record.name !== topic || record.kind !== EndpointKind.publisher) continue;
      const last = link.kind === 'port' ? portLast(link, record) : sharedLast(link, record);
      count += this.countOf(record).count;
      if (last !== undefined && (newest === undefined || last.receivedAt >= newest.receivedAt)) newest = last;
    }
    return newest === undefined ? undefined : { ...newest, count };
  }
}

function portLast(link: PortLink, record: EndpointRecord): LastMessage | undefined {
  const sample = link.sampled().get(record.key);
  if (sample?.payload === undefined) return undefined;
  return { bytes: sample.payload.slice(), receivedAt: sample.time, count: sample.count };
}

function sharedLast(link: SharedLink, record: EndpointRecord): LastMessage | undefined {
  return readNewest(link, record, (offset, length, count) => ({
    bytes: link.bus.u8.slice(offset + BusSizes.align, offset + BusSizes.align + length),
    receivedAt: timeAt(link, offset),
    count,
  }));
}

function timeAt(link: SharedLink, offset: number): number {
  const words = link.bus.i32;
  return ((words[(offset >> 2) + 4]! >>> 0) + words[(offset >> 2) + 5]! * 2 ** 32) / 1e6;
}

/** Looks at the newest frame of a writer in place, under an observer's hazard word. `offset` and `length` in bytes. */
function readNewest<T>(
  link: SharedLink, record: EndpointRecord, look: (offset: number, length: number, count: number) => T,
): T | undefined {
  const { bus } = link;
  const word = bus.endpointWord(keyIndex(record.key));
  const hazard = BusHeader.observers;
  for (let attempt = 0; attempt < 8; attempt += 1) {
    const head = Atomics.load(bus.i32, word + BusEndpoint.head);
    const ring = Atomics.load(bus.i32, word + BusEndpoint.ring);
    if (ring === 0) return undefined;
    const slot = slotWord(bus, ring, head);
    bus.reach((slot << 2) + BusSizes.slot);
    const frame = Atomics.load(bus.i32, slot + 1);
    const length = Atomics.load(bus.i32, slot + 2);
    const holds = (): boolean => Atomics.load(bus.i32, slot) === head
      && Atomics.load(bus.i32, word + BusEndpoint.ring) === ring
      && Atomics.load(bus.i32, word + BusEndpoint.generation) === record.key >>> 13;
    if (!holds()) continue;
    Atomics.store(bus.i32, hazard, frame);
    const held = holds();
    if (held) {
      const offset = frame * unit;
      bus.reach(offset + BusSizes.align + length);
      const seen = look(offset, length, head >>> 0);
      Atomics.store(bus.i32, hazard, 0);
      return seen;
    }
    Atomics.store(bus.i32, hazard, 0);
  }
  return undefined;
}

function qosViews(publishers: readonly EndpointRecord[]): QosView[] {
  const views = new Map<string, QosView>();
  for (const { qos } of publishers) {
    const view: QosView = {
      reliability: qos.reliability === Reliability.bestEffort ? 'best_effort' : 'reliable',
      durability: qos.durability === Durability.transientLocal ? 'transient_local' : 'volatile',
      history: qos.history === History.keepAll ? 'keep_all' : 'keep_last',
      depth: qos.depth,
    };
    views.set(JSON.stringify(view), view);
  }
  return [...views.values()];
}
