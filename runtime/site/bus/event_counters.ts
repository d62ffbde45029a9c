// Counts of an endpoint's events on the port link.

import type { DerivedCount, EventCount, StatusCounts } from './statuses.ts';

export class EventCounters implements StatusCounts {
  readonly counts: Record<EventCount, number> = { matched: 0, incompatible: 0, wrongType: 0, lost: 0 };
  lastPolicy = 0;
  /** Matched writers that ended without taking leave, since this was last read. */
  died = 0;
  private readonly read: Record<EventCount | DerivedCount, number> = {
    matched: 0,
    matchedNow: 0,
    incompatible: 0,
    wrongType: 0,
    lost: 0,
    deadline: 0,
    liveliness: 0,
    alive: 0,
  };

  now(count: EventCount): number {
    return this.counts[count];
  }

  gained(count: EventCount | DerivedCount, now: number): number {
    const before = this.read[count];
    this.read[count] = now;
    return now - before;
  }

  policy(): number {
    return this.lastPolicy;
  }

  takeDied(): number {
    const { died } = this;
    this.died = 0;
    return died;
  }
}
