// Opens a Figure panel for each new figure. When the visitor closes the panel, the figure is closed in its program, too.

import { useEffect, useRef } from 'preact/hooks';
import type { Session, TopicView } from '../../contract/session.ts';
import { figuresOf } from '../model/figure_topics.ts';
import { textMember } from '../model/json.ts';
import type { Json } from '../model/json.ts';
import type { PanelTab } from '../model/layout.ts';
import { codecOf } from './message_feed.ts';

const PANEL = 'figure';

/** `open` null: no panel is opened. */
export function useFigures(
  session: Session,
  topics: readonly TopicView[],
  tabs: readonly PanelTab[],
  open: ((panel: string, state: Json) => void) | null,
): void {
  const before = useRef<readonly string[]>([]);
  const shown = useRef<readonly string[]>([]);
  useEffect(() => {
    const now = figuresOf(topics);
    for (const topic of now) if (!before.current.includes(topic)) open?.(PANEL, { topic });
    before.current = now;
  }, [topics]);
  useEffect(() => {
    const now = tabs.filter(({ panel }) => panel === PANEL).map(({ state }) => textMember(state, 'topic'));
    const closed = shown.current.filter((topic) => !now.includes(topic));
    shown.current = now;
    if (closed.length === 0) return;
    const alive = figuresOf(session.topics());
    for (const topic of closed) if (alive.includes(topic)) void close(session, topic);
  }, [session, tabs]);
}

async function close(session: Session, topic: string): Promise<void> {
  const [codec, { sendOnce }] = await Promise.all([codecOf(session), import('./window_link.ts')]);
  sendOnce(session, codec, topic, { close: true });
}
