// Opens an Image panel for each window of cv2 when a node first shows it; the visitor may close it for good.

import { useEffect, useRef } from 'preact/hooks';
import type { TopicView } from '../../contract/session.ts';
import { windowsOf } from '../model/cv_window_topics.ts';
import type { Json } from '../model/json.ts';

/** `open` null: no panel is opened. */
export function useCvWindows(topics: readonly TopicView[], open: ((panel: string, state: Json) => void) | null): void {
  const seen = useRef(new Set<string>());
  useEffect(() => {
    for (const topic of windowsOf(topics)) {
      if (seen.current.has(topic)) continue;
      seen.current.add(topic);
      open?.('image', { topic });
    }
  }, [topics]);
}
