// The health of a robot's parts, as /diagnostics tells it: by level, the worst first; what is silent for 5 s of the site's
// time is stale. State: {level, text}.

import { useEffect, useMemo, useReducer, useState } from 'preact/hooks';
import { countLevels, Diagnostics, LEVELS } from '../model/diagnostics.ts';
import type { DiagnosticLevel, DiagnosticRow } from '../model/diagnostics.ts';
import { textMember } from '../model/json.ts';
import { formatAge } from '../model/quantities.ts';
import { IconButton } from '../parts/button.tsx';
import { GraphRow } from '../parts/graph_row.tsx';
import { Icon } from '../parts/icon.tsx';
import type { IconName } from '../parts/icon.tsx';
import { feedFromPast, useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { useOpened } from '../parts/use_opened.ts';
import { useEvery } from '../parts/while_in_sight.ts';
import { texts } from '../texts.ts';
import { viewTexts } from '../texts_views.ts';
import type { PanelProps } from './panel_props.ts';

const TOPIC = '/diagnostics';
const MOST_ROWS = 300;
const REDRAW_MS = 500;

const LOOKS: Readonly<Record<DiagnosticLevel, { readonly icon: IconName; readonly tone: string; }>> = {
  error: { icon: 'crash', tone: 'state-bad' },
  warn: { icon: 'warning', tone: 'state-busy' },
  stale: { icon: 'ring', tone: 'state-idle' },
  ok: { icon: 'check', tone: 'state-good' },
};

export function DiagnosticsPanel({ session, state, setState, instance }: PanelProps) {
  const wanted = LEVELS.find((level) => level === textMember(state, 'level')) ?? null;
  const text = textMember(state, 'text').slice(0, 200);
  const codec = useCodec(session);
  const board = useMemo(() => new Diagnostics(), [session]);
  const [, redraw] = useReducer<number, void>((n) => n + 1, 0);
  const [problem, setProblem] = useState('');
  const [opened, toggle] = useOpened();

  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    return feedFromPast(session, codec, TOPIC, ({ decoded, publishedAt }) => {
      if (decoded.kind === 'value') board.add(decoded.value, publishedAt / 1000);
      setProblem(decoded.kind === 'value' ? '' : texts.topics.undecodable(decoded.reason));
    });
  }, [session, codec, board]);
  // A silent part becomes stale with time.
  useEvery(REDRAW_MS, redraw);

  const now = session.time.view().now / 1000;
  const rows = board.rows(now);
  const counts = countLevels(rows);
  const has = (value: string): boolean => value.toLowerCase().includes(text.trim().toLowerCase());
  const found = rows.filter(
    ({ level, name, message, hardwareId }) => (wanted === null || level === wanted) && [name, message, hardwareId].some(has),
  );
  const change = (level: DiagnosticLevel | null, filter: string): void => setState({ level, text: filter });

  return (
    <PanelFrame
      id="diagnostics"
      title={texts.panels.diagnostics}
      icon="health"
      tools={
        <>
          <div class="choice diagnostics-levels" role="group" aria-label={viewTexts.diagnostics.levels}>
            <LevelButton words={viewTexts.diagnostics.all} count={rows.length} pressed={wanted === null} onClick={() => change(null, text)} />
            {LEVELS.map((level) => (
              <LevelButton
                key={level}
                level={level}
                words={viewTexts.diagnostics.level[level]}
                count={counts[level]}
                pressed={wanted === level}
                onClick={() => change(level, text)}
              />
            ))}
          </div>
          <SearchField value={text} label={viewTexts.diagnostics.filter} onText={(typed) => change(wanted, typed)} />
          <IconButton
            icon="clear"
            label={viewTexts.diagnostics.forget}
            onClick={() => {
              board.clear();
              redraw();
            }}
          />
        </>
      }
    >
      {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
      {problem === '' ? null : <p class="hint">{problem}</p>}
      {rows.length === 0 && problem === '' && typeof codec !== 'string' ? <p class="hint">{viewTexts.diagnostics.none}</p> : null}
      {rows.length > 0 && found.length === 0 ? <p class="hint">{viewTexts.diagnostics.noneMatch}</p> : null}
      {board.leftOut > 0 ? <p class="hint">{viewTexts.diagnostics.leftOut(board.leftOut)}</p> : null}
      <ul class="topics" role="list">
        {found.slice(0, MOST_ROWS).map((row) => (
          <GraphRow
            key={row.name}
            id={`diagnostic-${instance}-${encodeURIComponent(row.name.toWellFormed())}`}
            name={row.name === '' ? viewTexts.diagnostics.unnamed : row.name}
            type={row.message}
            flow={<Level row={row} now={now} />}
            open={opened.has(row.name)}
            onToggle={() => toggle(row.name)}
            inside={() => <Details row={row} />}
          />
        ))}
      </ul>
      {found.length > MOST_ROWS ? <p class="hint">{viewTexts.diagnostics.more(found.length - MOST_ROWS)}</p> : null}
    </PanelFrame>
  );
}

interface LevelButtonProps {
  readonly level?: DiagnosticLevel;
  readonly words: string;
  readonly count: number;
  readonly pressed: boolean;
  readonly onClick: () => void;
}

function LevelButton({ level, words, count, pressed, onClick }: LevelButtonProps) {
  return (
    <button type="button" aria-pressed={pressed} onClick={onClick}>
      {level === undefined ? null : (
        <span class={LOOKS[level].tone}>
          <Icon name={LOOKS[level].icon} />
        </span>
      )}
      {`${words} ${count}`}
    </button>
  );
}

function Level({ row: { level, told, at }, now }: { readonly row: DiagnosticRow; readonly now: number; }) {
  const { icon, tone } = LOOKS[level];
  const words = viewTexts.diagnostics.level;
  return (
    <>
      <span class={`diagnostics-level ${tone}`}>
        <Icon name={icon} />
        {level === told ? words[level] : viewTexts.diagnostics.was(words[level], words[told])}
      </span>
      <span class="topic-ends">{viewTexts.frames.age(formatAge(now - at))}</span>
    </>
  );
}

function Details({ row: { hardwareId, message, values, more } }: { readonly row: DiagnosticRow; }) {
  const facts: readonly (readonly [string, string])[] = [
    [viewTexts.diagnostics.message, message],
    [viewTexts.diagnostics.hardware, hardwareId],
    ...values.map(({ key, value }) => [key, value] as const),
  ];
  return (
    <>
      <dl class="facts diagnostics-facts">
        {facts.map(([key, value], index) => (
          <div key={`${index} ${key}`}>
            <dt>{key === '' ? viewTexts.diagnostics.unnamed : key}</dt>
            <dd>{value === '' ? '\u2013' : value}</dd>
          </div>
        ))}
      </dl>
      {more > 0 ? <p class="hint">{viewTexts.diagnostics.moreValues(more)}</p> : null}
    </>
  );
}
