// A store with a panel's data from the nodes' services: made when messages can be read, closed with the panel.

import { useEffect, useReducer, useRef } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { useCodec } from './message_feed.ts';

export interface Store {
  close(): void;
}

/** `make` gives one that calls `changed` whenever it is to be drawn. null while messages cannot be read yet, or not at all. */
export function useStore<T extends Store>(
  session: Session,
  make: new(session: Session, codec: Codec, changed: () => void) => T,
): { readonly store: T | null; readonly codec: Codec | string | null; } {
  const codec = useCodec(session);
  const [, redraw] = useReducer<number, void>((n) => n + 1, 0);
  const store = useRef<T | null>(null);
  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    const made = new make(session, codec, () => redraw());
    store.current = made;
    redraw();
    return () => {
      store.current = null;
      made.close();
    };
  }, [session, codec]);
  return { store: store.current, codec };
}
