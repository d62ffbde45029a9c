// The graph: who sends what to whom, as a drawing. Nodes and topics, or nodes only; namespaces as groups; live rates.
// State: {mode, services, hidden, groups, text}.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { GraphView, Session } from '../../contract/session.ts';
import type { Sizes } from '../model/graph_layout.ts';
import { pictureOf } from '../model/graph_picture.ts';
import type { Picture, PictureOptions } from '../model/graph_picture.ts';
import { anew, arrange } from '../model/graph_places.ts';
import type { Arrangement } from '../model/graph_places.ts';
import { flagMember, textMember } from '../model/json.ts';
import type { Json } from '../model/json.ts';
import { formatRate } from '../model/quantities.ts';
import { download } from '../parts/download.ts';
import { GraphDetails } from '../parts/graph_details.tsx';
import { GraphDrawing, sizesOf } from '../parts/graph_drawing.tsx';
import { MenuButton } from '../parts/menu.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { savedSvg } from '../parts/saved_svg.ts';
import { SearchField } from '../parts/search_field.tsx';
import { useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { viewTexts } from '../texts_views.ts';
import type { PanelProps } from './panel_props.ts';

/** The graph is looked at this often: nodes that start make many endpoints one after the other. */
const PAUSE_MS = 150;
/** And no more of the time than one part in so many is spent on laying it out. */
const LAYOUT_PART = 5;
const MARGIN = 16;

function readOptions(state: Json): PictureOptions {
  return {
    mode: textMember(state, 'mode') === 'nodes' ? 'nodes' : 'topics',
    hidden: flagMember(state, 'hidden', false),
    services: flagMember(state, 'services', false),
    groups: flagMember(state, 'groups', true),
    text: textMember(state, 'text').slice(0, 200),
  };
}

export function GraphPanel({ session, focus, announce, state, setState, open }: PanelProps) {
  const options = useMemo(() => readOptions(state), [state]);
  const took = useRef(0);
  const graph = useCalmGraph(session, took);
  const topics = useTopics(session);
  const [selected, setSelected] = useState<string | null>(null);
  const svg = useRef<SVGSVGElement>(null);
  const [room, setRoom] = useState<HTMLDivElement | null>(null);
  const picture = useMemo(() => pictureOf(graph, options), [graph, options]);
  const { arrangement, layOutAgain } = useArrangement(picture, options, room, took);
  const change = (next: Partial<PictureOptions>): void => setState({ ...options, ...next });
  const rates = new Map(topics.map((topic) => [topic.name, topic.rateHz > 0 ? formatRate(topic.rateHz) : '']));

  const showConsole = (process: string): void => focus.set(process);
  const showTopic = (name: string): void => void open('topics', { topic: name });
  const select = (id: string): void => {
    if (id !== selected) {
      setSelected(id);
      return;
    }
    // A click on the selected item opens it.
    const name = id.slice(id.indexOf(' ') + 1);
    if (id.startsWith('topic ')) showTopic(name);
    else if (id.startsWith('action ') || id.startsWith('service ')) open('services');
    else {
      const process = graph.nodes.find((node) => node.name === name)?.process;
      if (process !== undefined) showConsole(process);
    }
  };
  const save = (): void => {
    if (svg.current === null) return;
    const { bounds } = arrangement;
    const text = savedSvg(svg.current, '.graph-all', {
      x: bounds.x - bounds.width / 2 - MARGIN,
      y: bounds.y - bounds.height / 2 - MARGIN,
      width: bounds.width + 2 * MARGIN,
      height: bounds.height + 2 * MARGIN,
    });
    download('graph.svg', new Blob([text], { type: 'image/svg+xml' }));
  };
  const nodes = picture.boxes.filter(({ kind }) => kind === 'node').length;
  const count = viewTexts.graph.count(nodes, picture.boxes.length - nodes);

  return (
    <PanelFrame
      id="graph"
      title={texts.panels.graph}
      icon="graph"
      tools={
        <>
          <select
            class="select"
            aria-label={viewTexts.graph.mode}
            value={options.mode}
            onChange={(event) => change({ mode: event.currentTarget.value === 'nodes' ? 'nodes' : 'topics' })}
          >
            <option value="topics">{viewTexts.graph.modes.topics}</option>
            <option value="nodes">{viewTexts.graph.modes.nodes}</option>
          </select>
          <Check label={viewTexts.graph.groups} checked={options.groups} onChange={(groups) => change({ groups })} />
          <Check
            label={viewTexts.graph.services}
            title={viewTexts.graph.servicesLong}
            checked={options.services}
            onChange={(services) => change({ services })}
          />
          <Check label={viewTexts.graph.hidden} title={viewTexts.graph.hiddenLong} checked={options.hidden} onChange={(hidden) => change({ hidden })} />
          <SearchField value={options.text} label={viewTexts.graph.filter} onText={(text) => change({ text })} />
          <MenuButton
            icon="more"
            label={viewTexts.graph.menu}
            items={[
              { id: 'again', icon: 'layout', words: viewTexts.graph.again, choose: layOutAgain },
              {
                id: 'save',
                icon: 'down',
                words: viewTexts.graph.save,
                disabled: picture.boxes.length === 0,
                choose: () => {
                  save();
                  announce(viewTexts.graph.saved);
                },
              },
            ]}
          />
        </>
      }
    >
      {picture.leftOut > 0 ? <p class="hint">{viewTexts.graph.leftOut(picture.leftOut)}</p> : null}
      {picture.boxes.length === 0
        ? (
          <p class="hint">{options.text === '' ? viewTexts.graph.none : viewTexts.graph.noneMatch}</p>
        )
        : null}
      <div class="graph-room" ref={setRoom}>
        {picture.boxes.length === 0 || room === null ? null : (
          <GraphDrawing
            picture={picture}
            arrangement={arrangement}
            label={viewTexts.graph.label(count)}
            rateOf={(topic) => rates.get(topic) ?? ''}
            selected={selected}
            onSelect={select}
            svg={svg}
          />
        )}
      </div>
      {selected === null ? null : (
        <GraphDetails
          session={session}
          graph={graph}
          topics={topics}
          hidden={options.hidden}
          selected={selected}
          onSelect={setSelected}
          onClose={() => setSelected(null)}
          showConsole={showConsole}
          showTopic={showTopic}
          showAction={() => open('services')}
        />
      )}
    </PanelFrame>
  );
}

interface CheckProps {
  readonly label: string;
  readonly title?: string;
  readonly checked: boolean;
  readonly onChange: (checked: boolean) => void;
}

function Check({ label, title, checked, onChange }: CheckProps) {
  return (
    <label class="check" title={title}>
      <input type="checkbox" checked={checked} onChange={(event) => onChange(event.currentTarget.checked)} />
      {label}
    </label>
  );
}

/** The graph, a moment after it changed. */
function useCalmGraph(session: Session, took: { readonly current: number; }): GraphView {
  const [graph, setGraph] = useState(() => session.graph());
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    setGraph(session.graph());
    const stop = session.onGraph(() => {
      timer ??= setTimeout(() => {
        timer = undefined;
        setGraph(session.graph());
      }, Math.max(PAUSE_MS, LAYOUT_PART * took.current));
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [session]);
  return graph;
}

const NOTHING: Picture = { boxes: [], wires: [], groups: [], leftOut: 0 };
const NO_SIZES: Sizes = { boxes: new Map(), wires: new Map() };

interface Kept {
  readonly of: string;
  readonly picture: Picture;
  readonly arrangement: Arrangement;
}

/** The arrangement of the picture: as before, as far as that can be. */
function useArrangement(
  picture: Picture,
  { mode, services, hidden, groups, text }: PictureOptions,
  room: HTMLElement | null,
  /** Is told how long the last one took, in ms. */
  took: { current: number; },
): { readonly arrangement: Arrangement; readonly layOutAgain: () => void; } {
  const kept = useRef<Kept | null>(null);
  const [, redraw] = useState(0);
  // The layout may change when the visitor changes one of these settings.
  const of = JSON.stringify([mode, services, hidden, groups, text, room === null]);
  const view = { width: room?.clientWidth ?? 0, height: room?.clientHeight ?? 0 };
  const make = (sizes: Sizes): Arrangement => {
    const before = kept.current;
    return before !== null && before.of === of
      ? arrange(before.arrangement, picture, sizes, view)
      : anew(before?.arrangement ?? null, picture, sizes, view);
  };
  if (kept.current === null || kept.current.of !== of || kept.current.picture !== picture) {
    // Nothing stands anywhere before it is known how much room there is.
    const began = performance.now();
    const arrangement = room === null ? anew(null, NOTHING, NO_SIZES, view) : make(sizesOf(picture));
    took.current = performance.now() - began;
    kept.current = { of, picture, arrangement };
  }
  const { arrangement } = kept.current;
  return {
    arrangement,
    layOutAgain: () => {
      kept.current = { of, picture, arrangement: anew(arrangement, picture, sizesOf(picture), view) };
      redraw((count) => count + 1);
    },
  };
}
