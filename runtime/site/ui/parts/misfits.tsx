// The pairs of a topic that get nothing of each other, and for which policy.

import type { Misfit } from '../model/topic_qos.ts';
import { topicTexts } from '../texts_topics.ts';
import { Icon } from './icon.tsx';

export function Misfits({ list }: { readonly list: readonly Misfit[]; }) {
  return (
    <>
      {list.map(({ publisher, subscription, policy }, index) => (
        <p class="topic-misfit" key={index}>
          <Icon name="warning" />
          <span>{topicTexts.misfit(subscription.node, publisher.node, topicTexts.policies[policy])}</span>
        </p>
      ))}
    </>
  );
}
