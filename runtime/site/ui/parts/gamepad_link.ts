// Gives the visitor's gamepads to the nodes that wait for them, as long as the page shows it.

import { useEffect } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { gamepadDesk } from './gamepad_desk.ts';
import { useCodec } from './message_feed.ts';

export function GamepadLink({ session }: { readonly session: Session; }): null {
  const codec = useCodec(session);
  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    const desk = gamepadDesk(session, codec);
    return () => desk.close();
  }, [session, codec]);
  return null;
}
