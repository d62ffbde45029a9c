// The statuses of a participant's endpoints on the shared bus: how they are read, and when one changes.

import { BusEndpoint, BusParticipant, type StatusKind } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { SiteClock } from './clock.ts';
import type { EndpointRecord } from './graph.ts';
import type { EndpointStatus } from './link.ts';
import { type DerivedCount, type EventCount, readStatus, type StatusCounts } from './statuses.ts';
import { Ticker } from './ticker.ts';
import type { Timing } from './timing.ts';

/** The inputs from which the statuses of an endpoint are computed. */
export interface StatusSource {
  readonly record: EndpointRecord;
  readonly word: number;
  readonly timing: Timing;
  readonly matched: ReadonlySet<number>;
}

/** Words of the counts, and of what they were when they were last read. */
const countWords: Readonly<Record<EventCount, number>> = {
  matched: BusEndpoint.matchedTotal,
  incompatible: BusEndpoint.incompatibleTotal,
  wrongType: BusEndpoint.wrongTypeTotal,
  lost: BusEndpoint.lostTotal,
};
const readWords: Readonly<Record<EventCount | DerivedCount, number>> = {
  matched: BusEndpoint.matchedTotalRead,
  matchedNow: BusEndpoint.matchedCurrentRead,
  incompatible: BusEndpoint.incompatibleRead,
  wrongType: BusEndpoint.wrongTypeRead,
  lost: BusEndpoint.lostRead,
  deadline: BusEndpoint.deadlineRead,
  liveliness: BusEndpoint.livelinessRead,
  alive: BusEndpoint.aliveRead,
};

/** The counts in an endpoint's entry. */
class SharedCounts implements StatusCounts {
  private readonly bus: Bus;
  private readonly word: number;

  constructor(bus: Bus, word: number) {
    this.bus = bus;
    this.word = word;
  }

  now(count: EventCount): number {
    return this.bus.load(this.word + countWords[count]);
  }

  gained(count: EventCount | DerivedCount, now: number): number {
    return (now - this.bus.exchange(this.word + readWords[count], now)) | 0;
  }

  policy(): number {
    return this.bus.load(this.word + BusEndpoint.incompatiblePolicy);
  }

  takeDied(): number {
    return this.bus.exchange(this.word + BusEndpoint.died, 0);
  }
}

export class SharedStatuses {
  private readonly bus: Bus;
  private readonly participant: number;
  private readonly clock: SiteClock;
  readonly ticker: Ticker;

  constructor(bus: Bus, participant: number, clock: SiteClock) {
    this.clock = clock;
    this.ticker = new Ticker(clock);
    this.bus = bus;
    this.participant = participant;
  }

  /** undefined for a status that the endpoint has not. */
  read({ record, word, timing, matched }: StatusSource, kind: StatusKind): EndpointStatus | undefined {
    return readStatus(record.kind, kind, new SharedCounts(this.bus, word), timing, matched.size, this.clock.steadyNs());
  }

  /** Changes with every status of the participant. */
  version(): number {
    this.tick();
    return this.bus.load(this.bus.participantWord(this.participant) + BusParticipant.status);
  }

  note(): void {
    this.bus.noteStatus(this.participant);
  }

  /** True when time has changed a status that somebody reads. */
  tick(): boolean {
    const changed = this.ticker.tick();
    if (changed) this.note();
    return changed;
  }
}
