// The participants of a topic with their QoS, and the pairs whose QoS do not match. Pure.

import type { EndpointQosView, GraphView } from '../../contract/session.ts';
import { misfitPolicy } from '../../contract/qos_view.ts';
import type { MisfitPolicy } from '../../contract/qos_view.ts';

export interface TopicEnd {
  readonly does: 'publishes' | 'subscribes';
  /** Full name of its node. */
  readonly node: string;
  readonly type: string;
  readonly qos: EndpointQosView;
}

/** A publisher whose messages a subscription of the same topic does not get. */
export interface Misfit {
  readonly publisher: TopicEnd;
  readonly subscription: TopicEnd;
  /** The first one in ROS 2's order of blame. */
  readonly policy: MisfitPolicy | 'type';
}

/** By topic: the publishers first, then the subscriptions, each in the order of their nodes. */
export function topicEndsOf(graph: GraphView): ReadonlyMap<string, readonly TopicEnd[]> {
  const all = new Map<string, TopicEnd[]>();
  const add = (does: TopicEnd['does']): void => {
    for (const node of graph.nodes) {
      for (const { name, type, qos } of does === 'publishes' ? node.publishers : node.subscriptions) {
        const end: TopicEnd = { does, node: node.name, type, qos };
        const known = all.get(name);
        if (known === undefined) all.set(name, [end]);
        else known.push(end);
      }
    }
  };
  add('publishes');
  add('subscribes');
  return all;
}

export function misfitsOf(ends: readonly TopicEnd[]): readonly Misfit[] {
  const subscriptions = ends.filter(({ does }) => does === 'subscribes');
  return ends.filter(({ does }) => does === 'publishes').flatMap((publisher) =>
    subscriptions.flatMap((subscription) => {
      const policy = misfit(publisher, subscription);
      return policy === undefined ? [] : [{ publisher, subscription, policy }];
    })
  );
}

function misfit(publisher: TopicEnd, subscription: TopicEnd): Misfit['policy'] | undefined {
  // Somebody who takes any type names none.
  if (publisher.type !== subscription.type && publisher.type !== '' && subscription.type !== '') return 'type';
  return misfitPolicy(publisher.qos, subscription.qos);
}
