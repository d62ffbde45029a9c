// A window of cv2 in an Image panel, besides its picture: the trackbars, and the way of keys and the mouse to the program.

import { useEffect, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { isWindow } from '../model/cv_window_topics.ts';
import { NO_CONTROLS, readControls } from '../model/cv_windows.ts';
import type { WindowControls } from '../model/cv_windows.ts';
import { useWindowLink } from './window_link.ts';
import type { WindowLink } from './window_link.ts';

export type CvWindow = WindowLink<WindowControls>;

export function useCvWindow(session: Session, codec: Codec | string | null, topic: string): CvWindow {
  return useWindowLink(session, codec, isWindow(topic) ? topic : '', readControls, NO_CONTROLS);
}

/** Sliders. A slider stays where the visitor has moved it: the program does not answer. */
export function CvTrackbars({ controls, send }: CvWindow) {
  const [moved, setMoved] = useState<Readonly<Record<string, number>>>({});
  // The program has moved one itself, or made another one.
  useEffect(() => setMoved({}), [controls]);
  if (controls.trackbars.length === 0) return null;
  return (
    <div class="image-trackbars">
      {controls.trackbars.map(({ name, value, count }) => {
        const now = moved[name] ?? value;
        return (
          <label key={name} class="image-trackbar">
            <span>{name}</span>
            <input
              type="range"
              min={0}
              max={count}
              value={now}
              onInput={(event) => {
                const next = event.currentTarget.valueAsNumber;
                setMoved((before) => ({ ...before, [name]: next }));
                send({ trackbar: name, value: next });
              }}
            />
            <output>{now}</output>
          </label>
        );
      })}
    </div>
  );
}
