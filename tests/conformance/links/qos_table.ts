// Which offer fits which request, policy by policy, as ROS 2 documents it. Written out, so that it can disagree with
// the runtime.

import { Durability, Liveliness, PolicyKind, Reliability } from '../../../runtime/protocol/generated/constants.ts';
import type { EndpointQos } from '../../../runtime/site/contract/qos.ts';

export interface QosCell {
  readonly offer: Partial<EndpointQos>;
  readonly ask: Partial<EndpointQos>;
  readonly fits: boolean;
}

export interface QosPolicy {
  readonly name: string;
  readonly kind: PolicyKind;
  readonly cells: readonly QosCell[];
}

const second = 1_000_000_000n;
const [reliable, bestEffort] = [{ reliability: Reliability.reliable }, { reliability: Reliability.bestEffort }];
const [transient, volatile] = [{ durability: Durability.transientLocal }, { durability: Durability.volatile }];
const [automatic, manual] = [{ liveliness: Liveliness.automatic }, { liveliness: Liveliness.manualByTopic }];

function periods(of: (ns: bigint) => Partial<EndpointQos>): QosCell[] {
  const [none, short, long] = [of(0n), of(second), of(2n * second)] as const;
  return [
    { offer: none, ask: none, fits: true },
    { offer: none, ask: short, fits: false },
    { offer: none, ask: long, fits: false },
    { offer: short, ask: none, fits: true },
    { offer: short, ask: short, fits: true },
    { offer: short, ask: long, fits: true },
    { offer: long, ask: none, fits: true },
    { offer: long, ask: short, fits: false },
    { offer: long, ask: long, fits: true },
  ];
}

/** In the order in which the first that does not fit is reported. */
export const qosTable: readonly QosPolicy[] = [
  {
    name: 'reliability',
    kind: PolicyKind.reliability,
    cells: [
      { offer: reliable, ask: reliable, fits: true },
      { offer: reliable, ask: bestEffort, fits: true },
      { offer: bestEffort, ask: reliable, fits: false },
      { offer: bestEffort, ask: bestEffort, fits: true },
    ],
  },
  {
    name: 'durability',
    kind: PolicyKind.durability,
    cells: [
      { offer: transient, ask: transient, fits: true },
      { offer: transient, ask: volatile, fits: true },
      { offer: volatile, ask: transient, fits: false },
      { offer: volatile, ask: volatile, fits: true },
    ],
  },
  { name: 'deadline', kind: PolicyKind.deadline, cells: periods((deadline) => ({ deadline })) },
  {
    name: 'liveliness',
    kind: PolicyKind.liveliness,
    cells: [
      { offer: manual, ask: manual, fits: true },
      { offer: manual, ask: automatic, fits: true },
      { offer: automatic, ask: manual, fits: false },
      { offer: automatic, ask: automatic, fits: true },
    ],
  },
  { name: 'lease', kind: PolicyKind.livelinessLease, cells: periods((lease) => ({ lease })) },
];

/** One cell of every policy at once: all that there are. */
export function* qosCombinations(
  policies: readonly QosPolicy[] = qosTable,
): Generator<{ offer: Partial<EndpointQos>; ask: Partial<EndpointQos>; blamed: PolicyKind; }> {
  const [first, ...others] = policies;
  if (first === undefined) {
    yield { offer: {}, ask: {}, blamed: PolicyKind.none };
    return;
  }
  for (const { offer, ask, fits } of first.cells) {
    for (const rest of qosCombinations(others)) {
      yield {
        offer: { ...rest.offer, ...offer },
        ask: { ...rest.ask, ...ask },
        blamed: fits ? rest.blamed : first.kind,
      };
    }
  }
}
