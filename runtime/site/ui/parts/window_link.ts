// Connects a panel with a window of a program: receives its state on TOPIC/controls, publishes events on TOPIC/input. Both
// are JSON in std_msgs/msg/String.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { PagePublisher, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { textMember } from '../model/json.ts';
import { feedFromPast } from './message_feed.ts';

const TEXT = 'std_msgs/msg/String';

export type WindowEvent = Readonly<Record<string, unknown>>;

export interface WindowLink<Controls> {
  readonly controls: Controls;
  /** Sends an event to the program. False: the panel shows no window. */
  readonly send: (event: WindowEvent) => boolean;
}

function publish(codec: Codec, publisher: PagePublisher, event: WindowEvent): boolean {
  const encoded = codec.encode(TEXT, { data: JSON.stringify(event) });
  if (encoded.kind !== 'bytes') return false;
  publisher.publish(encoded.bytes);
  return true;
}

/** `topic`: empty if the panel shows no window. `read` must be the same function at each call. */
export function useWindowLink<Controls>(
  session: Session,
  codec: Codec | string | null,
  topic: string,
  read: (text: string) => Controls,
  none: Controls,
): WindowLink<Controls> {
  const [controls, setControls] = useState(none);
  const publisher = useRef<PagePublisher | null>(null);
  useEffect(() => {
    if (topic === '' || codec === null || typeof codec === 'string') return undefined;
    const made = session.node().publisher(`${topic}/input`, TEXT);
    publisher.current = made.problem === undefined ? made : null;
    const stop = feedFromPast(session, codec, `${topic}/controls`, ({ decoded }) => {
      if (decoded.kind !== 'failed') setControls(() => read(textMember(decoded.value, 'data')));
    });
    return () => {
      stop();
      made.close();
      publisher.current = null;
      setControls(() => none);
    };
  }, [session, codec, topic, read, none]);
  return {
    controls,
    send: (event) => publisher.current !== null && codec !== null && typeof codec !== 'string' && publish(codec, publisher.current, event),
  };
}

/** ms: upper bound on the wait for the program's subscription, and the time that a message has to leave the page. */
const PATIENCE = 2000;

/** Sends one event to a window without a panel. */
export function sendOnce(session: Session, codec: Codec, topic: string, event: WindowEvent): void {
  const made = session.node().publisher(`${topic}/input`, TEXT);
  const end = performance.now() + PATIENCE;
  const send = (): void => {
    if (made.problem === undefined && made.matched() === 0 && performance.now() < end) {
      setTimeout(send, 20);
      return;
    }
    if (made.problem === undefined) publish(codec, made, event);
    setTimeout(() => made.close(), PATIENCE);
  };
  send();
}
