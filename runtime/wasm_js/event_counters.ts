// Counts of an endpoint's events on the port link: ever, now, and since they were last read.

import { type EndpointKind, StatusKind } from '../protocol/generated/constants.ts';
import type { SiteClock } from './clock.ts';
import type { EndpointStatus } from './link.ts';
import { hasStatus } from './statuses.ts';
import type { Timing } from './timing.ts';

class EventCounter {
  total = 0;
  policy = 0;
  private totalRead = 0;
  private currentRead = 0;

  read(currentCount: number): EndpointStatus {
    const status = {
      totalCount: this.total,
      totalChange: this.total - this.totalRead,
      currentCount,
      currentChange: currentCount - this.currentRead,
      lastPolicy: this.policy,
    };
    this.totalRead = this.total;
    this.currentRead = currentCount;
    return status;
  }

  readTotal(total: number): EndpointStatus {
    this.total = total;
    return this.read(0);
  }
}

export class EventCounters {
  readonly matched = new EventCounter();
  readonly incompatible = new EventCounter();
  readonly type = new EventCounter();
  readonly lost = new EventCounter();
  /** Matched writers that ended without taking leave, since this was last read. */
  died = 0;
  private readonly deadline = new EventCounter();
  private readonly liveliness = new EventCounter();
  private readonly timing: Timing;
  private readonly clock: SiteClock;

  constructor(timing: Timing, clock: SiteClock) {
    this.clock = clock;
    this.timing = timing;
  }

  /** undefined for a status that the endpoint has not. */
  read(endpoint: EndpointKind, kind: StatusKind, matchedNow: number): EndpointStatus | undefined {
    if (!hasStatus(endpoint, kind)) return undefined;
    this.timing.watch(kind);
    switch (kind) {
      case StatusKind.publicationMatched:
      case StatusKind.subscriptionMatched:
        return this.matched.read(matchedNow);
      case StatusKind.offeredQosIncompatible:
      case StatusKind.requestedQosIncompatible:
        return this.incompatible.read(0);
      case StatusKind.publisherIncompatibleType:
      case StatusKind.subscriptionIncompatibleType:
        return this.type.read(0);
      case StatusKind.messageLost:
        return this.lost.read(0);
      case StatusKind.offeredDeadlineMissed:
      case StatusKind.requestedDeadlineMissed:
        return this.deadline.readTotal(this.timing.deadlinesMissed(this.clock.steadyNs()));
      case StatusKind.livelinessLost:
        return this.liveliness.readTotal(this.timing.livelinessLost(this.clock.steadyNs()));
      case StatusKind.livelinessChanged: {
        const lapsed = this.timing.lapsedWriters(this.clock.steadyNs());
        this.liveliness.total = lapsed;
        const status = this.liveliness.read(matchedNow - lapsed);
        // Those who died are told once: then nobody counts them any more.
        const { died } = this;
        this.died = 0;
        return { ...status, totalCount: lapsed + died, totalChange: status.totalChange + died };
      }
    }
  }
}
