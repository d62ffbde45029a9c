// Counts of an endpoint's events on the port link: ever, now, and since they were last read.

import { StatusKind } from '../protocol/generated/constants.ts';
import type { EndpointStatus } from './link.ts';

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
}

export class EventCounters {
  readonly matched = new EventCounter();
  readonly incompatible = new EventCounter();
  readonly type = new EventCounter();
  readonly lost = new EventCounter();

  /** undefined for a status that is not counted. */
  read(kind: StatusKind, matchedNow: number): EndpointStatus | undefined {
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
      default:
        return undefined;
    }
  }
}
