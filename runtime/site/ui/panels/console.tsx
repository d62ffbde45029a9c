// The consoles: one per node side by side, all merged as `ros2 launch` prints them, or one node alone.
// State: {text, level}, the filter.

import { useMemo, useState } from 'preact/hooks';
import { LEVELS } from '../model/log_line.ts';
import type { Level } from '../model/log_line.ts';
import type { LineFilter } from '../model/line_list.ts';
import { textMember } from '../model/json.ts';
import { readPreference, writePreference } from '../model/preferences.ts';
import { ConsoleTile } from '../parts/console_tile.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { useNodes } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import type { PanelProps } from './panel_props.ts';

type View = 'each' | 'merged';

const VIEWS: readonly View[] = ['each', 'merged'];

export function ConsolePanel({ session, focus, store, announce, state, setState }: PanelProps) {
  const nodes = useNodes(session);
  const [view, setView] = useState<View>(() => readPreference(store, 'consoles', VIEWS, 'each'));
  const text = textMember(state, 'text');
  const level: Level | null = LEVELS.find((name) => name === textMember(state, 'level')) ?? null;
  const filter = useMemo<LineFilter>(() => ({ text, level }), [text, level]);

  const change = (next: LineFilter): void => setState(next.text === '' && next.level === null ? null : { text: next.text, level: next.level ?? '' });
  const choose = (next: View): void => {
    setView(next);
    focus.set(null);
    writePreference(store, 'consoles', next);
  };
  const focused = nodes.find((node) => node.id === focus.id);
  const shared = { session, filter, announce };
  const speaks = session.site.launchSteps.length > 0;
  const tiles = focused !== undefined
    ? (
      <ConsoleTile
        key={focused.id}
        {...shared}
        nodes={[focused]}
        merged={false}
        onClose={() => focus.set(null)}
      />
    )
    : view === 'merged'
    ? (
      <ConsoleTile key="merged" {...shared} nodes={nodes} merged launch={speaks} />
    )
    : [
      ...(speaks
        ? [<ConsoleTile key="launch" {...shared} nodes={[]} merged={false} launch />]
        : []),
      ...nodes.map((node) => (
        <ConsoleTile key={node.id} {...shared} nodes={[node]} merged={false} />
      )),
    ];

  const tools = (
    <>
      <div class="choice" role="group" aria-label={texts.console.view}>
        {VIEWS.map((name) => (
          <button
            type="button"
            aria-pressed={focused === undefined && view === name}
            onClick={() => choose(name)}
          >
            {texts.console[name]}
          </button>
        ))}
      </div>
      <select
        class="select"
        aria-label={texts.console.level}
        value={level ?? ''}
        onChange={(event) => change({ text, level: LEVELS.find((name) => name === event.currentTarget.value) ?? null })}
      >
        <option value="">{texts.console.allLevels}</option>
        {LEVELS.slice(1).map((name) => (
          <option value={name}>{texts.console.atLeast(name)}</option>
        ))}
      </select>
      <SearchField value={text} label={texts.console.filter} onText={(next) => change({ text: next, level })} />
    </>
  );
  return (
    <PanelFrame id="console" title={texts.panels.console} icon="console" tools={tools}>
      {nodes.length === 0
        ? (
          <p class="hint">{texts.nodes.none}</p>
        )
        : (
          <div class="tiles">{tiles}</div>
        )}
    </PanelFrame>
  );
}
