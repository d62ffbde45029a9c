// Every message of a topic, as values: subscribes as the page's node once the topic is there, with what its publishers
// offer, and again when that changes. One codec per session, loaded when the first message is looked at.

import { useEffect, useState } from 'preact/hooks';
import type { MessageInfo, Session, TopicView, Unsubscribe } from '../../contract/session.ts';
import type { Codec, Decoded } from '../../decode/codec.ts';
import { problemOf } from '../model/problem.ts';

const DEPTH = 200;

const codecs = new WeakMap<Session, Promise<Codec>>();

export function codecOf(session: Session): Promise<Codec> {
  const known = codecs.get(session);
  if (known !== undefined) return known;
  const made = Promise.all([import('../../decode/codec.ts'), session.interfaces()]).then(
    ([{ createCodec }, interfaces]) => createCodec(interfaces),
  );
  codecs.set(session, made);
  // A failure is told, and the next one who asks tries again.
  made.catch(() => codecs.delete(session));
  return made;
}

/** null while it comes, a text when it failed. */
export function useCodec(session: Session): Codec | string | null {
  const [codec, setCodec] = useState<Codec | string | null>(null);
  useEffect(() => {
    let current = true;
    codecOf(session).then(
      (made) => {
        if (current) setCodec(made);
      },
      (error: unknown) => {
        if (current) setCodec(problemOf(error).what);
      },
    );
    return () => {
      current = false;
    };
  }, [session]);
  return codec;
}

export interface FeedMessage {
  readonly decoded: Decoded;
  readonly type: string;
  /** ms since 1970, by the site's time. */
  readonly publishedAt: number;
  /** The publisher's gid; 32 hexadecimal digits. */
  readonly gid: string;
}

/** Calls the listener with each message of the topic from now on, until the returned function is called. */
export function feed(
  session: Session,
  codec: Codec,
  topic: string,
  listener: (message: FeedMessage) => void,
): Unsubscribe {
  return feedBytes(session, topic, decoding(codec, listener));
}

/** The same, beginning with the messages that their publishers still hold, as far as the link between the nodes has them. */
export function feedFromPast(
  session: Session,
  codec: Codec,
  topic: string,
  listener: (message: FeedMessage) => void,
): Unsubscribe {
  return feedBytes(session, topic, decoding(codec, listener), true);
}

function decoding(codec: Codec, listener: (message: FeedMessage) => void): ByteListener {
  return (bytes, type, info) =>
    listener({
      decoded: codec.decode(type, bytes),
      type,
      publishedAt: info.publishedAt,
      gid: info.gid,
    });
}

type ByteListener = (bytes: Uint8Array, type: string, info: MessageInfo) => void;

/** The same, not read yet. */
export function feedBytes(
  session: Session,
  topic: string,
  listener: ByteListener,
  fromPast = false,
): Unsubscribe {
  let close: Unsubscribe = () => undefined;
  let followed = '';
  const follow = (topics: readonly TopicView[]): void => {
    const view = topics.find((one) => one.name === topic);
    if (view === undefined || view.type === '') return;
    const latched = view.qos.length > 0 && view.qos.every((qos) => qos.durability === 'transient_local');
    const reliable = view.qos.length > 0 && view.qos.every((qos) => qos.reliability === 'reliable');
    const wanted = `${view.type} ${latched} ${reliable}`;
    if (wanted === followed) return;
    // A message that was heard already does not come again.
    const past = fromPast && followed === '';
    followed = wanted;
    close();
    const { type } = view;
    const subscription = session.node().subscription(
      topic,
      type,
      {
        reliability: reliable ? 'reliable' : 'best_effort',
        durability: latched ? 'transient_local' : 'volatile',
        depth: DEPTH,
        past,
      },
      (bytes, info) => listener(bytes, type, info),
    );
    close = () => subscription.close();
  };
  follow(session.topics());
  const stop = session.onTopics(follow);
  return () => {
    stop();
    close();
  };
}
