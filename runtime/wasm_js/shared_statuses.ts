// The statuses of a participant's endpoints on the shared bus: how they are read, and when one changes.

import { BusEndpoint, BusParticipant, StatusKind } from '../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { SiteClock } from './clock.ts';
import type { EndpointRecord } from './graph.ts';
import type { EndpointStatus } from './link.ts';
import { hasStatus } from './statuses.ts';
import { Ticker } from './ticker.ts';
import type { Timing } from './timing.ts';

/** What the statuses of an endpoint are made of. */
export interface StatusSource {
  readonly record: EndpointRecord;
  readonly word: number;
  readonly timing: Timing;
  readonly matched: ReadonlySet<number>;
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
  read(own: StatusSource, kind: StatusKind): EndpointStatus | undefined {
    if (!hasStatus(own.record.kind, kind)) return undefined;
    const { i32 } = this.bus;
    own.timing.watch(kind);
    /** The total now, and what it gained since it was last read. */
    const gained = (now: number, mark: number): [number, number] =>
      [now, (now - Atomics.exchange(i32, own.word + mark, now)) | 0];
    const reading = (counter: number, mark: number): [number, number] =>
      gained(Atomics.load(i32, own.word + counter), mark);
    const plain = ([totalCount, totalChange]: [number, number]): EndpointStatus =>
      ({ totalCount, totalChange, currentCount: 0, currentChange: 0, lastPolicy: 0 });
    switch (kind) {
      case StatusKind.publicationMatched:
      case StatusKind.subscriptionMatched: {
        const [currentCount, currentChange] = reading(BusEndpoint.matchedCurrent, BusEndpoint.matchedCurrentRead);
        return { ...plain(reading(BusEndpoint.matchedTotal, BusEndpoint.matchedTotalRead)), currentCount, currentChange };
      }
      case StatusKind.offeredQosIncompatible:
      case StatusKind.requestedQosIncompatible: {
        const lastPolicy = Atomics.load(i32, own.word + BusEndpoint.incompatiblePolicy);
        return { ...plain(reading(BusEndpoint.incompatibleTotal, BusEndpoint.incompatibleRead)), lastPolicy };
      }
      case StatusKind.publisherIncompatibleType:
      case StatusKind.subscriptionIncompatibleType:
        return plain(reading(BusEndpoint.wrongTypeTotal, BusEndpoint.wrongTypeRead));
      case StatusKind.messageLost:
        return plain(reading(BusEndpoint.lostTotal, BusEndpoint.lostRead));
      case StatusKind.offeredDeadlineMissed:
      case StatusKind.requestedDeadlineMissed:
        return plain(gained(own.timing.deadlinesMissed(this.clock.steadyNs()), BusEndpoint.deadlineRead));
      case StatusKind.livelinessLost:
        return plain(gained(own.timing.livelinessLost(this.clock.steadyNs()), BusEndpoint.livelinessRead));
      case StatusKind.livelinessChanged: {
        const lapsed = own.timing.lapsedWriters(this.clock.steadyNs());
        const [currentCount, currentChange] = gained(own.matched.size - lapsed, BusEndpoint.aliveRead);
        const [, change] = gained(lapsed, BusEndpoint.livelinessRead);
        // Those who died are told once: then nobody counts them any more.
        const died = Atomics.exchange(i32, own.word + BusEndpoint.died, 0);
        return { totalCount: lapsed + died, totalChange: change + died, currentCount, currentChange, lastPolicy: 0 };
      }
    }
  }

  /** Changes with every status of the participant. */
  version(): number {
    this.tick();
    return Atomics.load(this.bus.i32, this.bus.participantWord(this.participant) + BusParticipant.status);
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
