// Whether nodes wait for the visitor's gamepads.

import { useEffect, useState } from 'preact/hooks';
import type { Session, TopicView } from '../../contract/session.ts';
import { wantedGamepads } from '../model/gamepads.ts';

export function useGamepadWish(session: Session): boolean {
  const [isWanted, setWanted] = useState(false);
  useEffect(() => {
    const follow = (topics: readonly TopicView[]): void => setWanted(wantedGamepads(topics).length > 0);
    follow(session.topics());
    return session.onTopics(follow);
  }, [session]);
  return isWanted;
}
