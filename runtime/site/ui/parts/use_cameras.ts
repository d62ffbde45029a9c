// The numbers of the cameras that programs request at present.

import { useEffect, useState } from 'preact/hooks';
import type { Session, TopicView } from '../../contract/session.ts';
import { wantedCameras } from '../model/camera_wishes.ts';

export function useCameras(session: Session): readonly number[] {
  const [numbers, setNumbers] = useState<readonly number[]>([]);
  useEffect(() => {
    const follow = (topics: readonly TopicView[]): void => {
      const wanted = wantedCameras(topics);
      setNumbers((before) => (before.join() === wanted.join() ? before : wanted));
    };
    follow(session.topics());
    return session.onTopics(follow);
  }, [session]);
  return numbers;
}
