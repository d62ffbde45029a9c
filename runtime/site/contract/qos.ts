// Quality of service: which publisher and subscription fit each other. Pure.

import { Durability, History, Liveliness, PolicyKind, Reliability } from '../../protocol/generated/constants.ts';

/** Durations in ns; 0 means none. */
export interface EndpointQos {
  readonly reliability: number;
  readonly durability: number;
  readonly history: number;
  readonly depth: number;
  readonly liveliness: number;
  readonly deadline: bigint;
  readonly lifespan: bigint;
  readonly lease: bigint;
}

export const defaultQos: EndpointQos = {
  reliability: Reliability.reliable,
  durability: Durability.volatile,
  history: History.keepLast,
  depth: 10,
  liveliness: Liveliness.automatic,
  deadline: 0n,
  lifespan: 0n,
  lease: 0n,
};

/** True when a period that is offered is longer than the one asked for. 0 is endless. */
function tooLong(offered: bigint, requested: bigint): boolean {
  return requested !== 0n && (offered === 0n || offered > requested);
}

/** The first policy (in ROS 2's order of blame) that stands between the two; PolicyKind.none when they fit. */
export function incompatiblePolicy(offered: EndpointQos, requested: EndpointQos): PolicyKind {
  if (offered.reliability === Reliability.bestEffort && requested.reliability === Reliability.reliable) {
    return PolicyKind.reliability;
  }
  if (offered.durability === Durability.volatile && requested.durability === Durability.transientLocal) {
    return PolicyKind.durability;
  }
  if (tooLong(offered.deadline, requested.deadline)) return PolicyKind.deadline;
  if (offered.liveliness === Liveliness.automatic && requested.liveliness === Liveliness.manualByTopic) {
    return PolicyKind.liveliness;
  }
  if (tooLong(offered.lease, requested.lease)) return PolicyKind.livelinessLease;
  return PolicyKind.none;
}
