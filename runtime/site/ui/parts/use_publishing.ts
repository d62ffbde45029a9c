// A publisher of the page that sends one draft: once, or at a rate in the site's time.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { PagePublisher, PageTimer, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { draftBytes, refusal } from '../model/draft_value.ts';
import type { DraftText } from '../model/draft_value.ts';
import { problemOf } from '../model/problem.ts';

/** A publisher of one topic and type, and what publishes on it: all ends together. */
interface Outlet {
  readonly publisher: PagePublisher;
  timer: PageTimer | undefined;
}

export interface Publishing {
  /** Messages that went out since the topic or the type changed. */
  readonly sent: number;
  readonly isRepeating: boolean;
  readonly problem: string;
  setProblem(problem: string): void;
  once(): void;
  /** Begins to repeat, or ends that. */
  toggle(rate: number): void;
  /** Takes the new rate, in 1/s, when it repeats. */
  setRate(rate: number): void;
}

/** `draft`: a text says why there is none, and then nothing is sent. */
export function usePublishing(
  session: Session,
  codec: Codec | null,
  topic: string,
  type: string,
  draft: DraftText | string,
): Publishing {
  const [problem, setProblem] = useState('');
  const [sent, setSent] = useState(0);
  const [isRepeating, setRepeating] = useState(false);
  const outlet = useRef<Outlet | null>(null);
  const newest = useRef(draft);
  newest.current = draft;

  // Nothing goes on on a topic or type that is not shown any more.
  useEffect(() => {
    setSent(0);
    setProblem('');
    return () => {
      outlet.current?.timer?.close();
      outlet.current?.publisher.close();
      outlet.current = null;
      setRepeating(false);
    };
  }, [session, topic, type]);

  const send = async (through: Outlet): Promise<void> => {
    const message = newest.current;
    if (codec === null || typeof message === 'string') return;
    const made = await draftBytes(codec, type, message, session.time.view().now);
    if (outlet.current !== through) return;
    const refused = made.kind === 'failed' ? refusal(made) : through.publisher.publish(made.bytes)?.message;
    setProblem(refused ?? '');
    if (refused === undefined) setSent((count) => count + 1);
  };
  const publish = (through: Outlet): void => {
    send(through).catch((error: unknown) => setProblem(problemOf(error).what));
  };
  const opened = (): Outlet | null => {
    if (outlet.current !== null) return outlet.current;
    const publisher = session.node().publisher(topic, type);
    if (publisher.problem !== undefined) {
      setProblem(publisher.problem.message);
      return null;
    }
    outlet.current = { publisher, timer: undefined };
    return outlet.current;
  };
  const repeat = (through: Outlet, rate: number): void => {
    through.timer?.close();
    through.timer = session.node().timer(1000 / rate, () => publish(through));
    setRepeating(true);
  };

  return {
    sent,
    isRepeating,
    problem,
    setProblem,
    once: () => {
      const through = opened();
      if (through !== null) publish(through);
    },
    toggle: (rate) => {
      if (outlet.current?.timer !== undefined) {
        outlet.current.timer.close();
        outlet.current.timer = undefined;
        setRepeating(false);
        return;
      }
      const through = opened();
      if (through !== null) repeat(through, rate);
    },
    setRate: (rate) => {
      if (outlet.current?.timer !== undefined) repeat(outlet.current, rate);
    },
  };
}
