// QoS in words, as the page and commands show and ask for it, and in the numbers of the bus. Pure.

import { Durability, History, Liveliness, PolicyKind, Reliability } from '../../protocol/generated/constants.ts';
import type { EndpointQosView, QosRequest } from './page_node.ts';
import { defaultQos, type EndpointQos, incompatiblePolicy } from './qos.ts';
import type { QosView } from './page_node.ts';

export function qosView(qos: EndpointQos): QosView {
  return {
    reliability: qos.reliability === Reliability.bestEffort ? 'best_effort' : 'reliable',
    durability: qos.durability === Durability.transientLocal ? 'transient_local' : 'volatile',
    history: qos.history === History.keepAll ? 'keep_all' : 'keep_last',
    depth: qos.depth,
  };
}

export function endpointQosView(qos: EndpointQos): EndpointQosView {
  return {
    ...qosView(qos),
    liveliness: qos.liveliness === Liveliness.manualByTopic ? 'manual_by_topic' : 'automatic',
    deadlineNs: Number(qos.deadline),
    lifespanNs: Number(qos.lifespan),
    leaseNs: Number(qos.lease),
  };
}

const nanoseconds = (ns: number | undefined): bigint =>
  ns === undefined || !Number.isFinite(ns) || ns <= 0 ? 0n : BigInt(Math.round(Math.min(ns, Number.MAX_SAFE_INTEGER)));

const mostDepth = 1 << 20;

export function endpointQos(asked: QosRequest): EndpointQos {
  const depth = asked.depth ?? defaultQos.depth;
  return {
    reliability: asked.reliability === 'best_effort' ? Reliability.bestEffort : Reliability.reliable,
    durability: asked.durability === 'transient_local' ? Durability.transientLocal : Durability.volatile,
    history: asked.history === 'keep_all' ? History.keepAll : History.keepLast,
    depth: Number.isFinite(depth) ? Math.min(mostDepth, Math.max(1, Math.round(depth))) : defaultQos.depth,
    liveliness: asked.liveliness === 'manual_by_topic' ? Liveliness.manualByTopic : Liveliness.automatic,
    deadline: nanoseconds(asked.deadlineNs),
    lifespan: nanoseconds(asked.lifespanNs),
    lease: nanoseconds(asked.leaseNs),
  };
}

export type MisfitPolicy = 'reliability' | 'durability' | 'deadline' | 'liveliness' | 'lease';

/** Why the one gets nothing of the other; undefined: they fit. */
export function misfitPolicy(offered: EndpointQosView, requested: EndpointQosView): MisfitPolicy | undefined {
  switch (incompatiblePolicy(endpointQos(offered), endpointQos(requested))) {
    case PolicyKind.none:
      return undefined;
    case PolicyKind.reliability:
      return 'reliability';
    case PolicyKind.durability:
      return 'durability';
    case PolicyKind.deadline:
      return 'deadline';
    case PolicyKind.liveliness:
      return 'liveliness';
    default:
      return 'lease';
  }
}
