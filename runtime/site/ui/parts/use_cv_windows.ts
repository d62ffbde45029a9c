// Opens an Image panel for each window of cv2 when a node first shows it; the visitor may close it for good.

import { useEffect, useRef } from 'preact/hooks';
import type { Session, TopicView } from '../../contract/session.ts';
import { windowsOf } from '../model/cv_window_topics.ts';
import type { Json } from '../model/json.ts';

/** `open` null: no panel is opened. */
export function useCvWindows(session: Session, open: ((panel: string, state: Json) => void) | null): void {
  const newest = useRef(open);
  newest.current = open;
  useEffect(() => {
    const seen = new Set<string>();
    const follow = (topics: readonly TopicView[]): void => {
      for (const topic of windowsOf(topics)) {
        if (seen.has(topic)) continue;
        seen.add(topic);
        newest.current?.('image', { topic });
      }
    };
    follow(session.topics());
    return session.onTopics(follow);
  }, [session]);
}
