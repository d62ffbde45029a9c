// Opens an Image panel for each window of cv2 when a node first shows it; the visitor may close it for good.

import { useEffect, useRef } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { windowsOf } from '../model/cv_window_topics.ts';
import type { Json } from '../model/json.ts';

export function useCvWindows(session: Session, wanted: boolean, open: (panel: string, state: Json) => void): void {
  const newest = useRef(open);
  newest.current = open;
  useEffect(() => {
    if (!wanted) return undefined;
    const seen = new Set<string>();
    return session.onTopics((topics) => {
      for (const topic of windowsOf(topics)) {
        if (seen.has(topic)) continue;
        seen.add(topic);
        newest.current('image', { topic });
      }
    });
  }, [session, wanted]);
}
