// The managed nodes: in which state each is, and a button for each transition that it takes now.

import { useEffect, useRef } from 'preact/hooks';
import { LifecycleStore } from '../parts/lifecycle_store.ts';
import type { ManagedNode } from '../parts/lifecycle_store.ts';
import { Icon } from '../parts/icon.tsx';
import type { IconName } from '../parts/icon.tsx';
import { Name } from '../parts/name.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { useStore } from '../parts/use_store.ts';
import { useTime } from '../parts/watch.ts';
import { WorkProblem } from '../parts/work_problem.tsx';
import { texts } from '../texts.ts';
import { viewTexts } from '../texts_views.ts';
import type { PanelProps } from './panel_props.ts';

/** By lifecycle_msgs/msg/State. */
const LOOKS: Readonly<Record<number, { readonly icon: IconName; readonly tone: string; }>> = {
  1: { icon: 'ring', tone: 'idle' },
  2: { icon: 'pause', tone: 'idle' },
  3: { icon: 'disc', tone: 'good' },
  4: { icon: 'stop', tone: 'done' },
  15: { icon: 'warning', tone: 'bad' },
};
const BUSY = { icon: 'arc', tone: 'busy' } as const;

export function LifecyclePanel({ session, announce }: PanelProps) {
  const { store, codec } = useStore(session, LifecycleStore);
  const time = useTime(session);
  const ready = codec !== null && typeof codec !== 'string';

  const nodes = store?.nodes() ?? [];
  return (
    <PanelFrame id="lifecycle" title={texts.panels.lifecycle} icon="lifecycle">
      {typeof codec === 'string' ? <p class="hint">{codec}</p> : null}
      {time.state === 'running' || nodes.length === 0 ? null : <p class="hint">{viewTexts.lifecycle.held}</p>}
      {ready && nodes.length === 0 ? <p class="hint">{viewTexts.lifecycle.none}</p> : null}
      <ul class="nodes" role="list">
        {nodes.map((node) => (
          <NodeRow
            key={node.name}
            node={node}
            onChange={(transition) =>
              void store?.change(node.name, transition).then((words) => {
                if (words !== '') announce(viewTexts.lifecycle.told(node.name, words));
              })}
          />
        ))}
      </ul>
    </PanelFrame>
  );
}

interface NodeRowProps {
  readonly node: ManagedNode;
  readonly onChange: (transition: ManagedNode['transitions'][number]) => void;
}

function NodeRow({ node: { name, here, state, transitions, asked, answer, problem, unread }, onChange }: NodeRowProps) {
  const row = useRef<HTMLLIElement>(null);
  const pressed = useRef(false);
  // The button that was pressed goes with its transition: the keyboard stays in the row.
  useEffect(() => {
    if (!pressed.current || document.activeElement !== document.body) return;
    row.current?.querySelector('button')?.focus();
    pressed.current = asked !== null;
  }, [transitions, asked]);
  return (
    <li class="node" ref={row}>
      <div class="node-head">
        <h3 class="lifecycle-name">
          <Name text={name} />
        </h3>
        {here ? <StateWords state={state} /> : <span class="hint">{viewTexts.lifecycle.gone}</span>}
      </div>
      <div class="work-row">
        {transitions.map((transition) => (
          <button
            key={transition.id}
            type="button"
            class="button"
            aria-label={viewTexts.lifecycle.ask(transition.label, name)}
            aria-disabled={asked === null ? undefined : 'true'}
            onClick={() => {
              if (asked !== null) return;
              pressed.current = true;
              onChange(transition);
            }}
          >
            {transition.label}
          </button>
        ))}
      </div>
      {asked === null ? null : <p class="hint">{viewTexts.lifecycle.asking(asked.label)}</p>}
      {answer === '' ? null : <p class="hint">{answer}</p>}
      <WorkProblem text={problem} />
      <WorkProblem text={unread} />
    </li>
  );
}

function StateWords({ state }: { readonly state: ManagedNode['state']; }) {
  if (state === null) return <span class="hint">{viewTexts.lifecycle.reading}</span>;
  const { icon, tone } = LOOKS[state.id] ?? BUSY;
  return (
    <span class={`state state-${tone}`}>
      <Icon name={icon} class={tone === 'busy' ? 'turning' : ''} />
      {state.label}
    </span>
  );
}
