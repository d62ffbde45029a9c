// One console: the lines of one node, or of all nodes merged as `ros2 launch` prints them, with its tools
// and a line for standard input.

import { useEffect, useMemo, useReducer, useState } from 'preact/hooks';
import type { ConsoleLine, ConsoleLog, NodeView, Session } from '../../contract/session.ts';
import { afterSnapshot } from '../model/line_feed.ts';
import { LineList } from '../model/line_list.ts';
import type { LineFilter } from '../model/line_list.ts';
import { formatCount } from '../model/quantities.ts';
import { texts } from '../texts.ts';
import { CopyButton, IconButton } from './button.tsx';
import type { InputLine, InputLineProps } from './input_line.tsx';
import { LineScroller } from './line_scroller.tsx';
import { isAlive, StateBadge } from './node_state.tsx';

/** Lines kept per view; older ones fall off. */
const CAPACITY = 100_000;

/** Stands for the launch's own lines where ids of nodes stand; these end with a number. */
const LAUNCH = 'launch';

export interface ConsoleTileProps {
  readonly session: Session;
  /** The nodes whose lines it shows; more than one: merged. */
  readonly nodes: readonly NodeView[];
  readonly merged: boolean;
  /** Whether the launch's own lines are among them. */
  readonly launch?: boolean;
  readonly filter: LineFilter;
  readonly announce: (text: string) => void;
  /** Set when this node is shown alone: back to all. */
  readonly onClose?: () => void;
}

export function ConsoleTile({
  session,
  nodes,
  merged,
  launch = false,
  filter,
  announce,
  onClose,
}: ConsoleTileProps) {
  const ids = [...(launch ? [LAUNCH] : []), ...nodes.map((node) => node.id)].join('\n');
  const { list, version, changed } = useLines(session, ids, merged);
  /** 'shown': nobody asked, but the node began to read keys, and may read lines again. */
  const [asked, setAsking] = useState<boolean | 'shown'>(false);
  const [met, setMet] = useState(false);

  useMemo(() => list.setFilter(filter), [list, filter]);

  const only = merged ? undefined : nodes[0];
  const mode = only?.terminal;
  const asking = asked !== false;
  useEffect(() => {
    // A node that waits for keys shows where they go, once.
    if (mode === undefined || met) return;
    setMet(true);
    if (asked === false) setAsking('shown');
  }, [mode]);
  const alone = nodes.length === 0;
  const label = only?.label ?? (alone ? texts.console.launch : texts.console.allNodes);
  const title = only === undefined && !alone ? texts.console.mergedLabel : texts.console.of(label);
  const heading = alone ? texts.console.launchTitle : texts.console.allTitle;
  const clear = (): void => {
    for (const node of nodes) session.console(node.id).clear();
    if (launch) session.launchLog.clear();
    list.clear();
    changed();
  };
  const save = (): void => {
    const name = only?.id ?? (alone ? LAUNCH : 'all_nodes');
    const content = new Blob([list.text()], { type: 'text/plain' });
    void import('./download.ts').then(({ download }) => download(`${name}.log`, content));
  };
  return (
    <article class="tile" aria-label={title}>
      <header class="tile-head">
        <h3 class="tile-title">{only === undefined ? heading : label}</h3>
        {only === undefined ? null : <StateBadge node={only} />}
        <div class="tile-tools">
          {only === undefined || only.command === true ? null : (
            <IconButton
              icon="input"
              label={texts.console.input(label)}
              pressed={asking}
              onClick={() => setAsking(!asking)}
            />
          )}
          <CopyButton
            label={texts.console.copy(label)}
            text={() => list.text()}
            announce={announce}
          />
          <IconButton icon="down" label={texts.console.save(label)} onClick={save} />
          <IconButton icon="clear" label={texts.console.clear(label)} onClick={clear} />
          {onClose === undefined ? null : (
            <IconButton icon="close" label={texts.console.showAll} onClick={onClose} />
          )}
        </div>
      </header>
      <LineScroller
        list={list}
        version={version}
        label={title}
        empty={emptyWords(list.allCount, nodes)}
      />
      {asking && only !== undefined
        ? (
          <LazyInput
            label={label}
            mode={mode}
            focused={asked === true}
            send={(text) => session.sendInput(only.id, text)}
            interrupt={() => session.interrupt(only.id)}
          />
        )
        : null}
    </article>
  );
}

function emptyWords(lines: number, nodes: readonly NodeView[]): string {
  if (lines > 0) return texts.console.emptyFiltered(formatCount(lines));
  const alive = nodes.filter((node) => isAlive(node.state));
  if (alive.length > 0 && alive.every(({ loading }) => loading === true)) return texts.console.loading;
  return alive.length > 0 ? texts.console.empty : texts.console.emptyForGood;
}

interface Lines {
  readonly list: LineList;
  readonly version: number;
  readonly changed: () => void;
}

/** Follows the consoles of some nodes. `ids` holds one node id per line, or LAUNCH. */
function useLines(session: Session, ids: string, merged: boolean): Lines {
  const [version, changed] = useReducer<number, void>((n) => n + 1, 0);
  const list = useMemo(() => new LineList(CAPACITY), [session, ids, merged]);
  useEffect(() => {
    const names = ids === '' ? [] : ids.split('\n');
    const prefixOf = (id: string): string => (merged && id !== LAUNCH ? `[${id}] ` : '');
    const logOf = (id: string): ConsoleLog => (id === LAUNCH ? session.launchLog : session.console(id));
    list.clear();
    const past: { readonly line: ConsoleLine; readonly prefix: string; }[] = [];
    const stops = names.map((id) => {
      const prefix = prefixOf(id);
      const snapshot = logOf(id).lines();
      for (const line of snapshot) past.push({ line, prefix });
      const fresh = afterSnapshot(snapshot);
      return logOf(id).onLines((batch) => {
        list.append(fresh(batch), prefix);
        changed();
      });
    });
    // Stable: lines of one node keep their order.
    if (names.length > 1) past.sort((a, b) => a.line.time - b.line.time);
    for (const { line, prefix } of past.slice(-CAPACITY)) list.append([line], prefix);
    changed();
    return () => {
      for (const stop of stops) stop();
    };
  }, [session, list]);
  return { list, version, changed: () => changed() };
}

/** The line for standard input comes when it is asked for. */
function LazyInput(props: InputLineProps) {
  const [Line, setLine] = useState<typeof InputLine | null>(null);
  useEffect(() => {
    void import('./input_line.tsx').then((found) => setLine(() => found.InputLine));
  }, []);
  return Line === null ? null : <Line {...props} />;
}
