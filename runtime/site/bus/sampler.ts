// The data about topics that the page shows: rates and last messages, read without touching the data path.

import { BusEndpoint, BusHeader, BusSizes, BusSlot, EndpointKind } from '../../protocol/generated/constants.ts';
import type { Broker } from './broker.ts';
import { departedPublishers } from './bus_tables.ts';
import type { EndpointRecord } from './graph.ts';
import type { PortLink } from './port_link.ts';
import { qosView } from '../contract/qos_view.ts';
import { noRate, type Rate, RateWindow } from '../contract/rate_window.ts';
import type { LastMessage, QosView, TopicView } from '../contract/session.ts';
import type { SharedLink } from './shared_link.ts';
import { frameFits, keyIndex, ringFits, slotWord, unit } from './shared_ring.ts';

interface WriterCount {
  readonly count: number;
  readonly bytes: number;
}

/** The data of a topic for as long as the session lives, even when its publishers have left. */
interface Known {
  readonly type: string;
  qos: readonly QosView[];
  /** The totals of each publisher at the last look, by the key of its endpoint. */
  readonly writers: Map<number, WriterCount>;
  /** The sum of the totals of publishers that have left. */
  left: WriterCount;
  last: LastMessage | undefined;
}

const wantedMs = 2000;
/** A time further off than this is not of the clock that `now` is of. */
const otherClockMs = 60_000;
/** Larger messages are copied only while somebody looks at them, bytes. */
const keptUnseen = 64 << 10;
const nothing: WriterCount = { count: 0, bytes: 0 };

export class Sampler {
  private readonly broker: Broker;
  private readonly rates = new Map<string, RateWindow>();
  private readonly wanted = new Map<string, number>();
  private readonly known = new Map<string, Known>();
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
    for (const [topic, until] of this.wanted) if (until < now) this.wanted.delete(topic);
    if (link.kind === 'port') link.requestSamples([...this.wanted.keys()]);
    const topics = new Map<string, EndpointRecord[]>();
    const departed = this.departed();
    for (const name of [...this.known.keys(), ...departed.map((record) => record.name)]) topics.set(name, []);
    for (const record of link.records()) {
      if (record.kind !== EndpointKind.publisher && record.kind !== EndpointKind.subscription) continue;
      const list = topics.get(record.name);
      if (list === undefined) topics.set(record.name, [record]);
      else list.push(record);
    }
    const views: TopicView[] = [];
    for (const [name, records] of topics) {
      const view = this.view(name, records, departed.filter((record) => record.name === name), now);
      if (records.length > 0 || view.count > 0) views.push(view);
      else this.known.delete(name);
    }
    this.views = views.sort((a, b) => (a.name < b.name ? -1 : 1));
    return this.views;
  }

  /** Publishers that left, whose messages can still be read. */
  private departed(): readonly EndpointRecord[] {
    const { link } = this.broker;
    return link.kind === 'shared' ? departedPublishers(link.bus) : link.samples.departed();
  }

  private view(
    name: string,
    records: readonly EndpointRecord[],
    departed: readonly EndpointRecord[],
    now: number,
  ): TopicView {
    const publishers = records.filter((record) => record.kind === EndpointKind.publisher);
    const known = this.knownOf(name, (publishers[0] ?? records[0] ?? departed.at(-1))?.type);
    if (publishers.length > 0) known.qos = qosViews(publishers);
    const writers = [...publishers, ...departed.filter((record) => record.type === known.type)];
    const { count, bytes } = this.tally(known, writers);
    if (known.last?.count !== count) this.keepNewest(known, writers, count, this.wanted.has(name));
    const rate = this.rateOf(name, publishers, { count, bytes }, now);
    return {
      name,
      type: known.type,
      publishers: publishers.length,
      subscriptions: records.length - publishers.length,
      rateHz: rate.hz,
      bytesPerSecond: rate.bytesPerSecond,
      count,
      qos: known.qos,
    };
  }

  /** A topic that comes again with another type is another topic: the kept message would not be of its type. */
  private knownOf(name: string, type: string | undefined): Known {
    const before = this.known.get(name);
    if (before !== undefined && (type === undefined || type === before.type)) return before;
    const known: Known = { type: type ?? '', qos: [], writers: new Map(), left: nothing, last: undefined };
    this.known.set(name, known);
    return known;
  }

  /** All that was published on a topic. */
  private tally(known: Known, publishers: readonly EndpointRecord[]): WriterCount {
    const now = new Map(publishers.map((publisher) => [publisher.key, this.countOf(publisher)]));
    for (const [key, seen] of known.writers) {
      // A key comes again, too, with a writer that begins at nothing.
      if ((now.get(key)?.count ?? -1) >= seen.count) continue;
      known.left = sum(known.left, seen);
      known.writers.delete(key);
    }
    for (const [key, of] of now) known.writers.set(key, of);
    return [...now.values()].reduce(sum, known.left);
  }

  /** Copies the newest message of the publishers; `count` is what is published in all. */
  private keepNewest(known: Known, publishers: readonly EndpointRecord[], count: number, wanted: boolean): void {
    const { link } = this.broker;
    let newest: EndpointRecord | undefined;
    let newestTime = -Infinity;
    for (const publisher of publishers) {
      const time = this.timeOf(publisher);
      if (time === undefined || time < newestTime) continue;
      newest = publisher;
      newestTime = time;
    }
    if (newest === undefined) return;
    const last = link.kind === 'port' ? portLast(link, newest) : sharedLast(link, newest, wanted ? Infinity : keptUnseen);
    // Rather none than an older one that passes for the last.
    known.last = last === undefined ? undefined : { ...last, count };
  }

  private rateOf(name: string, publishers: readonly EndpointRecord[], all: WriterCount, now: number): Rate {
    const times = publishers.map((publisher) => this.timeOf(publisher)).filter((time) => time !== undefined);
    if (times.length === 0) {
      this.rates.delete(name);
      return noRate;
    }
    const window = this.rates.get(name) ?? new RateWindow();
    this.rates.set(name, window);
    const newest = Math.max(...times);
    window.add(all.count, all.bytes, Math.abs(now - newest) < otherClockMs ? newest : now);
    return window.rate(now);
  }

  private countOf(record: EndpointRecord): WriterCount {
    const { link } = this.broker;
    if (link.kind === 'port') return link.sampled().get(record.key) ?? nothing;
    const { bus } = link;
    const word = link.bus.endpointWord(keyIndex(record.key));
    if (bus.load(word + BusEndpoint.generation) !== record.key >>> 13) return nothing;
    const wide = (low: number, high: number): number => (bus.load(word + low) >>> 0) + bus.load(word + high) * 2 ** 32;
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
    this.wanted.set(topic, now + wantedMs);
    const known = this.known.get(topic);
    if (known === undefined) return undefined;
    const writers = [
      ...[...this.broker.link.records()].filter((record) => record.name === topic && record.kind === EndpointKind.publisher),
      ...this.departed().filter((record) => record.name === topic && record.type === known.type),
    ];
    const { count } = this.tally(known, writers);
    if (known.last?.count !== count) this.keepNewest(known, writers, count, true);
    return known.last;
  }
}

function sum(a: WriterCount, b: WriterCount): WriterCount {
  return { count: a.count + b.count, bytes: a.bytes + b.bytes };
}

function portLast(link: PortLink, record: EndpointRecord): Omit<LastMessage, 'count'> | undefined {
  const sample = link.sampled().get(record.key);
  if (sample?.payload === undefined) return undefined;
  return { bytes: sample.payload.slice(), receivedAt: sample.time };
}

function sharedLast(link: SharedLink, record: EndpointRecord, most: number): Omit<LastMessage, 'count'> | undefined {
  return readNewest(link, record, (offset, length) =>
    length > most ? undefined : {
      bytes: link.bus.u8.slice(offset + BusSizes.align, offset + BusSizes.align + length),
      receivedAt: timeAt(link, offset),
    });
}

function timeAt(link: SharedLink, offset: number): number {
  const words = link.bus.i32;
  return ((words[(offset >> 2) + 4]! >>> 0) + words[(offset >> 2) + 5]! * 2 ** 32) / 1e6;
}

/** Looks at the newest frame of a writer in place, under an observer's hazard word. `offset` and `length` in bytes. */
function readNewest<T>(
  link: SharedLink,
  record: EndpointRecord,
  look: (offset: number, length: number) => T,
): T | undefined {
  const { bus } = link;
  const word = bus.endpointWord(keyIndex(record.key));
  const hazard = BusHeader.observers;
  for (let attempt = 0; attempt < 8; attempt += 1) {
    const head = bus.load(word + BusEndpoint.head);
    const ring = bus.load(word + BusEndpoint.ring);
    if (ring === 0 || !ringFits(bus, ring)) return undefined;
    const slot = slotWord(bus, ring, head);
    const frame = bus.load(slot + BusSlot.frameUnit);
    const length = bus.load(slot + BusSlot.length);
    const holds = (): boolean =>
      bus.load(slot) === head
      && bus.load(word + BusEndpoint.ring) === ring
      && bus.load(word + BusEndpoint.generation) === record.key >>> 13;
    if (!holds()) continue;
    bus.add(BusHeader.observing, 1);
    bus.store(hazard, frame);
    const held = holds();
    const offset = frame * unit;
    const seen = held && frameFits(bus, frame, length) ? look(offset, length) : undefined;
    bus.store(hazard, 0);
    bus.sub(BusHeader.observing, 1);
    if (bus.load(word + BusEndpoint.blocked) !== 0) bus.bump(record.participant);
    // The pages of a writer that departed may have been given to another one meanwhile.
    if (held && bus.load(word + BusEndpoint.generation) === record.key >>> 13) return seen;
  }
  return undefined;
}

function qosViews(publishers: readonly EndpointRecord[]): QosView[] {
  const views = new Map<string, QosView>();
  for (const { qos } of publishers) {
    const view = qosView(qos);
    views.set(JSON.stringify(view), view);
  }
  return [...views.values()];
}
