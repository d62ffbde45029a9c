// States over time: of each path a row of bars, one for as long as its value stayed the same. For modes, flags, texts
// and numbers that change seldom. State: {paths, seconds}.

import { useEffect, useMemo, useReducer, useRef, useState } from 'preact/hooks';
import { asState } from '../model/field_path.ts';
import { numberMember, textsMember } from '../model/json.ts';
import { StateTrack } from '../model/state_track.ts';
import { IconButton } from '../parts/button.tsx';
import { followPaths } from '../parts/follow_paths.ts';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { PathList } from '../parts/path_list.tsx';
import { useEvery } from '../parts/while_in_sight.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const MOST_PATHS = 16;
const REDRAW_MS = 100;
const SECONDS = [5, 10, 30, 60, 300, 3600] as const;

interface Row {
  readonly track: StateTrack;
  problem: string;
}

export function TimelinePanel({ session, state, setState, instance }: PanelProps) {
  const paths = useMemo(() => [...new Set(textsMember(state, 'paths', MOST_PATHS))], [state]);
  const seconds = numberMember(state, 'seconds', 1, 86_400, 30);
  const codec = useCodec(session);
  const rows = useRef(new Map<string, Row>());
  const [, redraw] = useReducer<number, void>((n) => n + 1, 0);
  const [held, setHeld] = useState<number | null>(null);
  /** When the first state was told. */
  const begin = useRef(Number.NaN);
  const rowOf = (path: string): Row => {
    const known = rows.current.get(path) ?? { track: new StateTrack(), problem: '' };
    rows.current.set(path, known);
    return known;
  };

  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    return followPaths(session, codec, paths, {
      onValue(path, time, value) {
        const row = rowOf(path);
        const text = asState(value);
        row.problem = text === undefined ? panelTexts.timeline.noState : '';
        if (text === undefined) return;
        if (!(time >= begin.current)) begin.current = time;
        row.track.add(time, text);
      },
      onProblem(path, problem) {
        rowOf(path).problem = problem;
      },
      isNew: (path) => rowOf(path).track.last === '',
    });
  }, [session, codec, paths.join('\n')]);
  useEvery(REDRAW_MS, redraw);

  const end = held ?? session.time.view().now / 1000;
  const least = Number.isNaN(begin.current) ? end - seconds : Math.max(begin.current, end - seconds);
  return (
    <PanelFrame
      id="timeline"
      title={texts.panels.timeline}
      icon="timeline"
      tools={
        <>
          <IconButton
            icon={held === null ? 'pause' : 'play'}
            label={held === null ? panelTexts.plot.pause : panelTexts.plot.follow}
            onClick={() => setHeld(held === null ? end : null)}
          />
          <select
            class="select"
            aria-label={panelTexts.plot.range}
            value={String(seconds)}
            onChange={(event) => setState({ paths: [...paths], seconds: Number(event.currentTarget.value) })}
          >
            {(SECONDS.some((one) => one === seconds) ? SECONDS : [...SECONDS, seconds]).map(
              (one) => (
                <option value={String(one)}>{panelTexts.plot.last(one)}</option>
              ),
            )}
          </select>
        </>
      }
    >
      <PathList
        session={session}
        codec={codec}
        kind="state"
        instance={instance}
        entries={paths.map((path) => {
          const { problem, track } = rowOf(path);
          return { path, color: 0, words: problem || track.last || panelTexts.paths.waiting };
        })}
        onChange={(next) => setState({ paths: [...next], seconds })}
      />
      {paths.length === 0 ? <p class="hint">{panelTexts.timeline.none}</p> : null}
      {paths.map((path) => (
        <div
          key={path}
          class="states"
          role="img"
          aria-label={panelTexts.timeline.of(path, rowOf(path).track.last)}
        >
          {rowOf(path)
            .track.spans(least, end)
            .map((span, index) => (
              <span
                // Several may begin at one moment.
                key={`${span.from} ${index}`}
                class={`state-span plot-ground-${span.color}`}
                title={span.text}
                style={{
                  left: `${((span.from - least) / seconds) * 100}%`,
                  width: `${((span.to - span.from) / seconds) * 100}%`,
                }}
              >
                {span.text}
              </span>
            ))}
        </div>
      ))}
    </PanelFrame>
  );
}
