// Requests of nodes to the visitor and the page, by topics: windows and figures of Python libraries, cameras, gamepads. This code is
// loaded when the first such topic is there.

import type { Session } from '../../contract/session.ts';
import type { Json } from '../model/json.ts';
import type { PanelTab } from '../model/layout.ts';
import { useCameras } from './use_cameras.ts';
import { useCvWindows } from './use_cv_windows.ts';
import { useFigures } from './use_figures.ts';
import { useGamepadWish } from './use_gamepad_wish.ts';
import { useLoaded } from './use_loaded.ts';

export interface VisitorLinksProps {
  readonly session: Session;
  readonly tabs: readonly PanelTab[];
  /** null: the page opens no panels, as it is embedded. */
  readonly open: ((panel: string, state: Json) => void) | null;
}

export function VisitorLinks({ session, tabs, open }: VisitorLinksProps) {
  useCvWindows(session, open);
  useFigures(session, tabs, open);
  return (
    <>
      <Cameras session={session} />
      <Gamepads session={session} />
    </>
  );
}

/** Asks for the visitor's camera when a program requests it. */
function Cameras({ session }: { readonly session: Session; }) {
  const numbers = useCameras(session);
  const code = useLoaded(numbers.length > 0, () => import('./camera_bar.tsx'));
  return code === null ? null : numbers.map((number) => <code.CameraBar key={number} session={session} number={number} />);
}

/** Reads the visitor's gamepads while nodes wait for them. */
function Gamepads({ session }: { readonly session: Session; }) {
  const isWanted = useGamepadWish(session);
  const code = useLoaded(isWanted, () => import('./gamepad_link.ts'));
  return code === null ? null : <code.GamepadLink session={session} />;
}
