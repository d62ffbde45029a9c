// The log of all nodes, from /rosout: by level, node and text, in the format of the consoles, with the place in the source
// on request. State: {level, node, text, places}, the last one 'shown' or empty.

import { useContext, useEffect, useMemo, useReducer, useRef } from 'preact/hooks';
import type { ConsoleLine } from '../../contract/session.ts';
import { isMessage } from '../../decode/yaml.ts';
import { asNumber } from '../model/field_path.ts';
import { textMember } from '../model/json.ts';
import { GrowingList } from '../model/growing_list.ts';
import { LogHistory } from '../model/log_history.ts';
import type { LogEntry } from '../model/log_history.ts';
import { LEVELS } from '../model/log_line.ts';
import { formatCount } from '../model/quantities.ts';
import { CopyButton, IconButton } from '../parts/button.tsx';
import { download } from '../parts/download.ts';
import { LineScroller } from '../parts/line_scroller.tsx';
import { feed, useCodec } from '../parts/message_feed.ts';
import { PanelFrame, PanelInSight } from '../parts/panel.tsx';
import { SearchField } from '../parts/search_field.tsx';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const TOPIC = '/rosout';
const SHOWN = 'shown';
const CAPACITY = 100_000;
/** Lines of the consoles that are read at once, and then with each turn of the page. */
const FIRST_PIECE = 2000;
const PIECE = 4000;
/** Names offered to choose from. */
const MOST_NAMES = 500;

/** As in rcl_interfaces/msg/Log. */
const WORDS_BY_NUMBER: readonly (readonly [number, string])[] = [
  [10, 'DEBUG'],
  [20, 'INFO'],
  [30, 'WARN'],
  [40, 'ERROR'],
  [50, 'FATAL'],
];

const shownLine = ({ line, place }: LogEntry, places: boolean): ConsoleLine => places && place !== '' ? { ...line, text: `${line.text}  [${place}]` } : line;

export function LogPanel({ session, state, setState, announce }: PanelProps) {
  const level = LEVELS.find((name) => name === textMember(state, 'level')) ?? null;
  const node = textMember(state, 'node');
  const text = textMember(state, 'text');
  const places = textMember(state, 'places') === SHOWN;
  const codec = useCodec(session);
  const history = useRef(new LogHistory(CAPACITY, []));
  /** Not in the list yet: with the next frame. */
  const fresh = useRef<LogEntry[]>([]);
  const names = useRef(new Set<string>());
  const [version, changed] = useReducer<number, void>((n) => n + 1, 0);
  const list = useMemo(() => new GrowingList(CAPACITY), []);
  const wanted = useRef({ node, places });
  wanted.current = { node, places };

  const inSight = useContext(PanelInSight);
  /** Puts what came into the list. Behind another tab it waits. */
  const drawing = useRef({ inSight, show: (): void => undefined });
  drawing.current.inSight = inSight;
  useEffect(() => {
    if (inSight) drawing.current.show();
  }, [inSight]);

  useMemo(() => list.setFilter({ text, level }), [list, text, level]);
  const linesOf = (entries: readonly LogEntry[]): readonly ConsoleLine[] => {
    const { node: only, places: withPlaces } = wanted.current;
    return entries.filter((entry) => only === '' || entry.node === only).map((entry) => shownLine(entry, withPlaces));
  };
  const fill = (): void => {
    fresh.current = [];
    list.clear();
    list.append(linesOf(history.current.entries), '');
    changed();
  };
  useEffect(fill, [list, node, places]);

  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    const log = new LogHistory(CAPACITY, session.nodes().map(({ id }) => session.console(id).lines()));
    history.current = log;
    let frame = 0;
    let turn: ReturnType<typeof setTimeout> | undefined;
    let completed = false;
    const meet = (entry: LogEntry): void => {
      if (names.current.size < MOST_NAMES) names.current.add(entry.node);
    };
    const readOn = (lines: number): void => {
      const older = log.older(lines);
      older.forEach(meet);
      list.prepend(linesOf(older));
      if (older.length > 0) changed();
      turn = log.done ? undefined : setTimeout(() => readOn(PIECE));
    };
    fresh.current = [];
    list.clear();
    readOn(FIRST_PIECE);
    const show = (): void => {
      frame = 0;
      if (completed) fill();
      completed = false;
      list.append(linesOf(fresh.current), '');
      fresh.current = [];
      changed();
    };
    const stop = feed(session, codec, TOPIC, ({ decoded, publishedAt }) => {
      if (decoded.kind !== 'value') return;
      const entry = entryOf(decoded.value, publishedAt);
      if (entry === null) return;
      meet(entry);
      const taken = log.take(entry);
      if (taken === 'new') fresh.current.push(entry);
      else if (taken === 'longer' || (taken === 'placed' && wanted.current.places)) completed = true;
      // No frame comes while the page is hidden.
      if (fresh.current.length > 2 * CAPACITY) fresh.current = fresh.current.slice(-CAPACITY);
      if (frame === 0 && drawing.current.inSight) frame = requestAnimationFrame(show);
    });
    drawing.current.show = show;
    return () => {
      cancelAnimationFrame(frame);
      clearTimeout(turn);
      drawing.current.show = () => undefined;
      stop();
    };
  }, [session, codec, list]);

  const change = (next: Readonly<Record<string, string>>): void => setState({ level: level ?? '', node, text, places: places ? SHOWN : '', ...next });
  const clear = (): void => {
    history.current.clear();
    fresh.current = [];
    list.clear();
    changed();
  };
  const offered = [...new Set([...names.current, ...(node === '' ? [] : [node])])].toSorted();
  // The number of lines of the chosen node, or of all nodes where that one has logged nothing.
  const count = list.allCount > 0 ? list.allCount : history.current.count;
  const empty = count > 0 ? texts.console.emptyFiltered(formatCount(count)) : panelTexts.log.empty;
  return (
    <PanelFrame
      id="log"
      title={texts.panels.log}
      icon="log"
      tools={
        <>
          <select
            class="select"
            aria-label={texts.console.level}
            value={level ?? ''}
            onChange={(event) => change({ level: event.currentTarget.value })}
          >
            <option value="">{texts.console.allLevels}</option>
            {LEVELS.slice(1).map((name) => (
              <option value={name}>{texts.console.atLeast(name)}</option>
            ))}
          </select>
          <select
            class="select"
            aria-label={panelTexts.log.node}
            value={node}
            onChange={(event) => change({ node: event.currentTarget.value })}
          >
            <option value="">{panelTexts.log.allNodes}</option>
            {offered.map((name) => (
              <option value={name}>{name}</option>
            ))}
          </select>
          <SearchField value={text} label={panelTexts.log.filter} onText={(found) => change({ text: found })} />
          <IconButton
            icon="code"
            label={panelTexts.log.places}
            pressed={places}
            onClick={() => change({ places: places ? '' : SHOWN })}
          />
          <CopyButton label={panelTexts.log.copy} text={() => list.text()} announce={announce} />
          <IconButton
            icon="down"
            label={panelTexts.log.save}
            onClick={() => download('rosout.log', new Blob([list.text()], { type: 'text/plain' }))}
          />
          <IconButton icon="clear" label={panelTexts.log.clear} onClick={clear} />
        </>
      }
    >
      <LineScroller list={list} version={version} label={texts.panels.log} empty={empty} />
    </PanelFrame>
  );
}

/** A line of `ros2 launch`'s console out of an rcl_interfaces/msg/Log. */
function entryOf(value: unknown, publishedAt: number): LogEntry | null {
  if (!isMessage(value)) return null;
  const { stamp, level, name, msg, file, function: within, line } = value;
  const number = asNumber(level);
  const word = WORDS_BY_NUMBER.find(([least]) => least === number)?.[1] ?? 'INFO';
  const { sec, nanosec } = isMessage(stamp) ? stamp : { sec: 0, nanosec: 0 };
  const nano = String(asNumber(nanosec)).padStart(9, '0');
  const node = typeof name === 'string' ? name : '';
  const text = typeof msg === 'string' ? msg : '';
  const isPlace = typeof file === 'string' && file !== '';
  const place = isPlace ? `File "${file}", line ${asNumber(line)}` : '';
  return {
    node,
    place: place !== '' && typeof within === 'string' && within !== '' ? `${place}, in ${within}` : place,
    line: {
      time: publishedAt,
      stream: 'stderr',
      text: `[${word}] [${asNumber(sec)}.${nano}] [${node}]: ${text}`,
    },
  };
}
