// The parameters of all nodes: read, followed, set; a node's refusal stands beside the value that it keeps.
// State: {text, closed}.

import { useState } from 'preact/hooks';
import { dumpText } from '../../ros2cli/parameters.ts';
import { textMember, textsMember } from '../model/json.ts';
import { CopyButton, IconButton } from '../parts/button.tsx';
import { Icon } from '../parts/icon.tsx';
import { Name } from '../parts/name.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { ParameterRow } from '../parts/parameter_row.tsx';
import { ParameterStore } from '../parts/parameter_store.ts';
import type { KnownParameter, NodeParameters } from '../parts/parameter_store.ts';
import { SearchField } from '../parts/search_field.tsx';
import { useStore } from '../parts/use_store.ts';
import { useTime } from '../parts/watch.ts';
import { WorkProblem } from '../parts/work_problem.tsx';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

/** Rows of one node that are drawn: the filter finds the others. */
const MOST_ROWS = 200;
const MOST_CLOSED = 100;
const LONGEST_TEXT = 200;
/** Every node has them: shown on request, or when the filter asks for them. */
const OF_EVERY_NODE = /^(use_sim_time$|start_type_description_service$|qos_overrides\.)/;

export function ParametersPanel({ session, state, setState, announce, instance }: PanelProps) {
  const text = textMember(state, 'text').slice(0, LONGEST_TEXT);
  const closed = textsMember(state, 'closed', MOST_CLOSED);
  const { store, codec } = useStore(session, ParameterStore);
  const time = useTime(session);
  const [hidden, setHidden] = useState(false);
  const ready = codec !== null && typeof codec !== 'string';

  const change = (next: { text?: string; closed?: readonly string[]; }): void => {
    const { text: wanted, closed: names } = { text, closed, ...next };
    setState({ text: wanted, closed: [...names] });
  };
  const nodes = store?.nodes(hidden) ?? [];
  const wanted = text.trim().toLowerCase();
  const found = nodes.flatMap((node) => {
    const all = [...node.parameters];
    const own = all.filter(([name]) => !OF_EVERY_NODE.test(name));
    const usual = all.filter(([name]) => OF_EVERY_NODE.test(name));
    if (wanted === '' || node.name.toLowerCase().includes(wanted)) return [{ node, rows: own, usual }];
    const some = [...own, ...usual].filter(([name]) => name.toLowerCase().includes(wanted));
    return some.length === 0 ? [] : [{ node, rows: some, usual: [] }];
  });
  const tools = (
    <>
      <label class="check">
        <input type="checkbox" checked={hidden} onChange={(event) => setHidden(event.currentTarget.checked)} />
        {panelTexts.parameters.hidden}
      </label>
      <SearchField value={text} label={panelTexts.parameters.filter} onText={(typed) => change({ text: typed })} />
    </>
  );
  return (
    <PanelFrame id="parameters" title={texts.panels.parameters} icon="sliders" tools={tools}>
      {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
      {codec === null ? <p class="hint">{texts.starting}</p> : null}
      {time.state === 'running' ? null : <p class="hint">{panelTexts.parameters.held}</p>}
      {ready && nodes.length === 0 ? <p class="hint">{panelTexts.parameters.none}</p> : null}
      {nodes.length > 0 && found.length === 0 ? <p class="hint">{panelTexts.parameters.noneMatch}</p> : null}
      <ul class="topics" role="list">
        {found.map(({ node, rows, usual }) => (
          <NodeSection
            key={node.name}
            node={node}
            rows={rows}
            usual={usual}
            open={wanted !== '' || !closed.includes(node.name)}
            onToggle={() =>
              change({
                closed: closed.includes(node.name)
                  ? closed.filter((name) => name !== node.name)
                  : [...closed, node.name].slice(-MOST_CLOSED),
              })}
            store={store}
            announce={announce}
            instance={instance}
          />
        ))}
      </ul>
    </PanelFrame>
  );
}

interface NodeSectionProps extends Pick<PanelProps, 'announce' | 'instance'> {
  readonly node: NodeParameters;
  readonly rows: readonly (readonly [string, KnownParameter])[];
  /** Parameters that every node has; behind "more". */
  readonly usual: readonly (readonly [string, KnownParameter])[];
  readonly open: boolean;
  readonly onToggle: () => void;
  readonly store: ParameterStore | null;
}

function NodeSection({ node, rows: own, usual, open, onToggle, store, announce, instance }: NodeSectionProps) {
  const [all, setAll] = useState(false);
  const rows = all ? [...own, ...usual] : own;
  const inside = `parameters-${instance}-${encodeURIComponent(node.name)}`;
  const values = (): Map<string, KnownParameter['value']> => new Map([...node.parameters].map(([name, { value }]) => [name, value]));
  return (
    <li class={`topic ${open ? 'topic-open' : ''}`}>
      <div class="parameters-head">
        <button
          type="button"
          class="topic-head"
          aria-expanded={open}
          aria-controls={open ? inside : undefined}
          onClick={onToggle}
        >
          <Icon name="chevron" class="topic-turn" />
          <span class="topic-names">
            <span class="topic-name">
              <Name text={node.name} />
            </span>
            <span class="topic-type">
              {!node.here
                ? node.parameters.size === 0
                  ? panelTexts.parameters.gone
                  : panelTexts.parameters.goneWith
                : node.reading
                ? panelTexts.parameters.reading
                : panelTexts.parameters.count(node.parameters.size)}
            </span>
          </span>
        </button>
        <CopyButton
          label={panelTexts.parameters.copy(node.name)}
          text={() => `${dumpText(node.name, values())}\n`}
          announce={announce}
        />
        <IconButton
          icon="restart"
          label={panelTexts.parameters.reload(node.name)}
          disabled={!node.here || node.reading}
          onClick={() => store?.reload(node.name)}
        />
      </div>
      {open
        ? (
          <div class="parameters-inside" id={inside}>
            <WorkProblem text={node.here && !node.reading && node.problem !== '' ? panelTexts.parameters.unread(node.problem) : ''} />
            {rows.length > 0
              ? (
                <ul class="parameters" role="list">
                  {rows.slice(0, MOST_ROWS).map(([name, parameter]) => (
                    <ParameterRow
                      key={name}
                      node={node.name}
                      name={name}
                      parameter={parameter}
                      here={node.here}
                      set={(value) => store?.set(node.name, name, value) ?? Promise.reject(new Error(panelTexts.parameters.gone))}
                      announce={announce}
                    />
                  ))}
                </ul>
              )
              : null}
            {usual.length > 0
              ? (
                <button type="button" class="button parameters-more" aria-expanded={all} onClick={() => setAll(!all)}>
                  {all ? panelTexts.parameters.hideUsual : panelTexts.parameters.showUsual(usual.length)}
                </button>
              )
              : null}
            {rows.length > MOST_ROWS ? <p class="hint">{panelTexts.parameters.more(MOST_ROWS, rows.length)}</p> : null}
          </div>
        )
        : null}
    </li>
  );
}
