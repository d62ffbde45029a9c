// The author's checks: a list that changes as they are decided, and is announced once. They are evaluated elsewhere.

import { useEffect, useState } from 'preact/hooks';
import type { CheckView } from '../../contract/session.ts';
import { unreachable } from '../../contract/session.ts';
import { formatDuration } from '../model/quantities.ts';
import { IconButton } from '../parts/button.tsx';
import { CheckLine } from '../parts/check_line.tsx';
import type { CheckLook } from '../parts/check_line.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { useNow } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import type { PanelProps } from './panel_props.ts';

export function ChecksPanel({ session, announce }: PanelProps) {
  const [, setVersion] = useState(0);
  const { checks } = session;
  useEffect(() => {
    if (checks === undefined) return undefined;
    let left = waiting(checks.views());
    return checks.onChange((views) => {
      setVersion((version) => version + 1);
      const now = waiting(views);
      if (now === 0 && left > 0) announce(passedWords(views));
      left = now;
    });
  }, [checks]);
  const views = checks?.views() ?? [];
  // The values of open checks change without an event.
  useNow(waiting(views) > 0);
  return (
    <PanelFrame
      id="checks"
      title={texts.panels.checks}
      icon="check"
      note={views.length === 0 ? '' : passedWords(views)}
      tools={checks === undefined ? null : (
        <IconButton icon="restart" label={texts.checks.again} onClick={() => checks.again()} />
      )}
    >
      {views.length === 0 ? <p class="hint">{texts.checks.none}</p> : null}
      {views.length === 0 ? null : (
        <div class="checks" role="group" aria-label={texts.panels.checks} tabIndex={0}>
          <ul class="nodes" role="list">
            {views.map((view) => (
              <CheckRow view={view} />
            ))}
          </ul>
        </div>
      )}
    </PanelFrame>
  );
}

function CheckRow({ view }: { readonly view: CheckView; }) {
  return (
    <CheckLine
      kind={`node check-row check-${view.state}`}
      title={view.title}
      look={checkLook(view)}
      seen={texts.checks.seen(view.seen)}
      source={view.source}
    >
      {view.afterMs === undefined ? null : (
        <span class="node-time">{texts.checks.after(formatDuration(view.afterMs))}</span>
      )}
    </CheckLine>
  );
}

function checkLook(view: CheckView): CheckLook {
  switch (view.state) {
    case 'waiting':
      return {
        words: texts.checks.waiting(formatDuration(view.withinMs)),
        icon: 'ring',
        tone: 'idle',
      };
    case 'passed':
      return { words: texts.checks.passed, icon: 'check', tone: 'good' };
    case 'failed':
      return {
        words: texts.checks.failed(formatDuration(view.withinMs)),
        icon: 'crash',
        tone: 'bad',
      };
    default:
      return unreachable(view.state);
  }
}

function waiting(views: readonly CheckView[]): number {
  return views.filter(({ state }) => state === 'waiting').length;
}

function passedWords(views: readonly CheckView[]): string {
  return texts.checks.passedOf(views.filter(({ state }) => state === 'passed').length, views.length);
}
