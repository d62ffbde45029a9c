// Whether a node asks something of the visitor (visitor_links.tsx). Apart from that code, because the page needs these lines at its start.

import { useEffect, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';

const TOPIC = /^\/(cv2|figures|_gamepad)\//;

/** true for good once there was such a topic. Topics are followed all the time: one that is opened later has its last message. */
export function useVisitorTopics(session: Session): boolean {
  const [isWanted, setWanted] = useState(false);
  useEffect(
    () =>
      session.onTopics((topics) => {
        if (topics.some(({ name }) => TOPIC.test(name))) setWanted(true);
      }),
    [session],
  );
  return isWanted;
}
