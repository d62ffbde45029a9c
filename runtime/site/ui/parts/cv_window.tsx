// A window of cv2 in an Image panel, besides its picture: the trackbars, and the way of keys and the mouse to the program.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { PagePublisher, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { isWindow } from '../model/cv_window_topics.ts';
import { NO_CONTROLS, readControls } from '../model/cv_windows.ts';
import type { WindowControls } from '../model/cv_windows.ts';
import { textMember } from '../model/json.ts';
import { feedFromPast } from './message_feed.ts';

const TEXT = 'std_msgs/msg/String';

export interface CvWindow {
  readonly controls: WindowControls;
  /** Sends an event to the program. False: the panel shows no window. */
  readonly send: (event: Readonly<Record<string, unknown>>) => boolean;
}

export function useCvWindow(session: Session, codec: Codec | string | null, topic: string): CvWindow {
  const [controls, setControls] = useState(NO_CONTROLS);
  const publisher = useRef<PagePublisher | null>(null);
  useEffect(() => {
    if (!isWindow(topic) || codec === null || typeof codec === 'string') return undefined;
    const made = session.node().publisher(`${topic}/input`, TEXT);
    publisher.current = made.problem === undefined ? made : null;
    const stop = feedFromPast(session, codec, `${topic}/controls`, ({ decoded }) => {
      if (decoded.kind !== 'failed') setControls(readControls(textMember(decoded.value, 'data')));
    });
    return () => {
      stop();
      made.close();
      publisher.current = null;
      setControls(NO_CONTROLS);
    };
  }, [session, codec, topic]);
  return {
    controls,
    send: (event) => {
      if (publisher.current === null || codec === null || typeof codec === 'string') return false;
      const encoded = codec.encode(TEXT, { data: JSON.stringify(event) });
      if (encoded.kind !== 'bytes') return false;
      publisher.current.publish(encoded.bytes);
      return true;
    },
  };
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
