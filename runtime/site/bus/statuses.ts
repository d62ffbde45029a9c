// Which endpoint has which status, and of which counts it is made. The links differ in where the counts lie.

import { EndpointKind, StatusKind } from '../../protocol/generated/constants.ts';
import type { EndpointStatus } from './link.ts';
import type { Timing } from './timing.ts';

/** Counts that only events change. */
export type EventCount = 'matched' | 'incompatible' | 'wrongType' | 'lost';
/** Counts of which only that is kept what they were when they were last read. */
export type DerivedCount = 'matchedNow' | 'deadline' | 'liveliness' | 'alive';

/** The counts of an endpoint. */
export interface StatusCounts {
  now(count: EventCount): number;
  /** How much more `now` is than at the last call for this count. */
  gained(count: EventCount | DerivedCount, now: number): number;
  /** PolicyKind of the newest endpoint whose QoS did not fit. */
  policy(): number;
  /** Matched writers that ended without taking leave; each is told once. */
  takeDied(): number;
}

/** Publishers offer, subscriptions request; clients and servers do both. */
function hasStatus(endpoint: number, status: StatusKind): boolean {
  if (status < StatusKind.livelinessChanged || status > StatusKind.publicationMatched) return false;
  const ofReader = status <= StatusKind.subscriptionMatched;
  return endpoint !== (ofReader ? EndpointKind.publisher : EndpointKind.subscription);
}

/** Reads a status at the steady time `now`, in ns; undefined for one that the endpoint has not. `matched`: peers now. */
export function readStatus(
  endpoint: number,
  kind: StatusKind,
  counts: StatusCounts,
  timing: Timing,
  matched: number,
  now: number,
): EndpointStatus | undefined {
  if (!hasStatus(endpoint, kind)) return undefined;
  timing.watch(kind);
  const status = { totalCount: 0, totalChange: 0, currentCount: 0, currentChange: 0, lastPolicy: 0 };
  const total = (of: EventCount | DerivedCount, count: number): EndpointStatus => ({ ...status, totalCount: count, totalChange: counts.gained(of, count) });
  switch (kind) {
    case StatusKind.publicationMatched:
    case StatusKind.subscriptionMatched:
      return {
        ...total('matched', counts.now('matched')),
        currentCount: matched,
        currentChange: counts.gained('matchedNow', matched),
      };
    case StatusKind.offeredQosIncompatible:
    case StatusKind.requestedQosIncompatible:
      return { ...total('incompatible', counts.now('incompatible')), lastPolicy: counts.policy() };
    case StatusKind.publisherIncompatibleType:
    case StatusKind.subscriptionIncompatibleType:
      return total('wrongType', counts.now('wrongType'));
    case StatusKind.messageLost:
      return total('lost', counts.now('lost'));
    case StatusKind.offeredDeadlineMissed:
    case StatusKind.requestedDeadlineMissed:
      return total('deadline', timing.deadlinesMissed(now));
    case StatusKind.livelinessLost:
      return total('liveliness', timing.livelinessLost(now));
    case StatusKind.livelinessChanged: {
      const lapsed = timing.lapsedWriters(now);
      const currentCount = matched - lapsed;
      const { totalChange } = total('liveliness', lapsed);
      const died = counts.takeDied();
      return {
        totalCount: lapsed + died,
        totalChange: totalChange + died,
        currentCount,
        currentChange: counts.gained('alive', currentCount),
        lastPolicy: 0,
      };
    }
  }
}
