// The numbers of the cameras that programs request at present.

import { useEffect, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { wantedCameras } from '../model/camera_wishes.ts';

export function useCameras(session: Session): readonly number[] {
  const [numbers, setNumbers] = useState<readonly number[]>([]);
  useEffect(
    () =>
      session.onTopics((topics) => {
        const wanted = wantedCameras(topics);
        setNumbers((before) => (before.join() === wanted.join() ? before : wanted));
      }),
    [session],
  );
  return numbers;
}
