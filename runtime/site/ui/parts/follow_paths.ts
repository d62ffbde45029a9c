// Follows field paths: subscribes to each topic once, and tells the value of each path as messages come.

import type { Session, Unsubscribe } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { parseFieldPath, valueAt } from '../model/field_path.ts';
import type { FieldPath } from '../model/field_path.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import { feed, feedFromPast } from './message_feed.ts';

export interface PathListener {
  /** `time`: seconds since 1970, by the site's time, when the message was published. */
  readonly onValue: (path: string, time: number, value: unknown) => void;
  /** Why there is no value. */
  readonly onProblem: (path: string, problem: string) => void;
  /** Nothing is known of it yet: what its publishers still hold is wanted too. */
  readonly isNew: (path: string) => boolean;
}

export function followPaths(
  session: Session,
  codec: Codec,
  paths: readonly string[],
  { onValue, onProblem, isNew }: PathListener,
): Unsubscribe {
  const topics = new Map<string, { readonly text: string; readonly path: FieldPath; }[]>();
  for (const text of paths) {
    const path = parseFieldPath(text);
    if (path === null) {
      onProblem(text, panelTexts.paths.wrong);
      continue;
    }
    topics.set(path.topic, [...(topics.get(path.topic) ?? []), { text, path }]);
  }
  const stops = [...topics].map(([topic, followed]) => {
    const begin = followed.every(({ text }) => isNew(text)) ? feedFromPast : feed;
    return begin(session, codec, topic, ({ decoded, publishedAt }) => {
      for (const { text, path } of followed) {
        if (decoded.kind === 'failed') {
          onProblem(text, texts.topics.undecodable(decoded.reason));
          continue;
        }
        const value = valueAt(decoded.value, path.steps);
        if (value === undefined) onProblem(text, panelTexts.paths.noField);
        else onValue(text, publishedAt / 1000, value);
      }
    });
  });
  return () => {
    for (const stop of stops) stop();
  };
}
