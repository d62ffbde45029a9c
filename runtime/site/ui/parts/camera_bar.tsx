// Asks the visitor whether a program may use the camera, and shows when it is in use.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { cameraTexts } from '../texts_camera.ts';
import { cameraDesk } from './camera_desk.ts';
import type { CameraDesk, CameraState } from './camera_desk.ts';
import { useCodec } from './message_feed.ts';

const WORDS: Readonly<Record<CameraState, string>> = { asks: cameraTexts.asks, opening: cameraTexts.opening, open: cameraTexts.runs, refused: '' };

export function CameraBar({ session, number }: { readonly session: Session; readonly number: number; }) {
  const codec = useCodec(session);
  const [state, setState] = useState<CameraState>('asks');
  const desk = useRef<CameraDesk | null>(null);
  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    const made = cameraDesk(session, codec, number, setState);
    desk.current = made;
    return () => {
      made.close();
      desk.current = null;
    };
  }, [session, codec, number]);
  if (state === 'refused') return null;
  return (
    <div class="notice" role="region" aria-label={cameraTexts.region}>
      <p role="status">{WORDS[state]}</p>
      {state === 'asks'
        ? (
          <>
            <button type="button" class="button" onClick={() => desk.current?.allow()}>
              {cameraTexts.use}
            </button>
            <button type="button" class="button" onClick={() => desk.current?.refuse()}>
              {cameraTexts.refuse}
            </button>
          </>
        )
        : null}
      {state === 'open'
        ? (
          <button type="button" class="button" onClick={() => desk.current?.refuse()}>
            {cameraTexts.stop}
          </button>
        )
        : null}
    </div>
  );
}
