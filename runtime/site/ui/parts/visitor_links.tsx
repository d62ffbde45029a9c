// Requests of nodes to the visitor and the page, by topics: windows and figures of Python libraries, cameras, gamepads. This code is
// loaded when the first such topic is there.

import type { Session, TopicView } from '../../contract/session.ts';
import { wantedCameras } from '../model/camera_wishes.ts';
import { wantedGamepads } from '../model/gamepads.ts';
import type { Json } from '../model/json.ts';
import type { PanelTab } from '../model/layout.ts';
import { useCvWindows } from './use_cv_windows.ts';
import { useFigures } from './use_figures.ts';
import { useLoaded } from './use_loaded.ts';
import { useTopics } from './watch.ts';

export interface VisitorLinksProps {
  readonly session: Session;
  readonly tabs: readonly PanelTab[];
  /** null: the page opens no panels, as it is embedded. */
  readonly open: ((panel: string, state: Json) => void) | null;
}

interface LinkProps {
  readonly session: Session;
  readonly topics: readonly TopicView[];
}

export function VisitorLinks({ session, tabs, open }: VisitorLinksProps) {
  const topics = useTopics(session);
  useCvWindows(topics, open);
  useFigures(session, topics, tabs, open);
  return (
    <>
      <Cameras session={session} topics={topics} />
      <Gamepads session={session} topics={topics} />
    </>
  );
}

/** Asks for the visitor's camera when a program requests it. */
function Cameras({ session, topics }: LinkProps) {
  const numbers = wantedCameras(topics);
  const code = useLoaded(numbers.length > 0, () => import('./camera_bar.tsx'));
  return code === null ? null : numbers.map((number) => <code.CameraBar key={number} session={session} number={number} />);
}

/** Reads the visitor's gamepads while nodes wait for them. */
function Gamepads({ session, topics }: LinkProps) {
  const code = useLoaded(wantedGamepads(topics).length > 0, () => import('./gamepad_link.ts'));
  return code === null ? null : <code.GamepadLink session={session} />;
}
