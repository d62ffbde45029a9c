// Follows /tf and /tf_static into a tree of frames.

import type { Codec } from '../../decode/codec.ts';
import type { Session, Unsubscribe } from '../../contract/session.ts';
import type { TransformTree } from '../model/transform_tree.ts';
import { texts } from '../texts.ts';
import { feed } from './message_feed.ts';

export interface TransformListener {
  /** `moved`: some frame is elsewhere now, or a new one has come. */
  readonly onTransforms: (moved: boolean) => void;
  /** Why a message could not be read. */
  readonly onProblem: (problem: string) => void;
}

export function followTransforms(
  session: Session,
  codec: Codec,
  tree: TransformTree,
  { onTransforms, onProblem }: TransformListener,
): Unsubscribe {
  const follow = (topic: string, isStatic: boolean): Unsubscribe =>
    feed(session, codec, topic, ({ decoded }) => {
      if (decoded.kind === 'failed') onProblem(texts.topics.undecodable(decoded.reason));
      else onTransforms(tree.addMessage(decoded.value, isStatic));
    });
  const stops = [follow('/tf_static', true), follow('/tf', false)];
  return () => {
    for (const stop of stops) stop();
  };
}
