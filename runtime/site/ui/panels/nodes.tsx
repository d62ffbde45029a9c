// The nodes of the workspace in launch order: state, run control, where each was declared.

import type { ComponentType } from 'preact';
import { useContext, useEffect, useState } from 'preact/hooks';
import type { LaunchView, NodeView } from '../../contract/session.ts';
import { placeText } from '../model/problem.ts';
import { formatDuration } from '../model/quantities.ts';
import { IconButton } from '../parts/button.tsx';
import { isAlive, StateBadge } from '../parts/node_state.tsx';
import { Name } from '../parts/name.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { SourceLinksContext } from '../parts/source_links.ts';
import { ProblemView } from '../parts/problem_view.tsx';
import { useNodes, useNow } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import type { PanelProps } from './panel_props.ts';

export function NodesPanel({ session, focus, announce }: PanelProps) {
  const nodes = useNodes(session);
  const running = nodes.filter((node) => node.state.kind === 'running').length;
  const now = useNow(running > 0);
  const { launch } = session.site;
  return (
    <PanelFrame
      id="nodes"
      title={texts.panels.nodes}
      icon="nodes"
      note={texts.runningOf(running, nodes.length)}
    >
      {launch === undefined || launch.arguments.length === 0 ? null : (
        <LaunchBox launch={launch} />
      )}
      {nodes.length === 0 || session.link === 'port' ? null : <SeedBox seed={session.stepped?.seed} />}
      {nodes.length === 0 ? <p class="hint">{texts.nodes.none}</p> : null}
      <ul class="nodes" role="list">
        {nodes.map((node) => (
          <NodeRow
            key={node.id}
            node={node}
            now={now}
            focused={focus.id === node.id}
            onFocus={() => focus.set(focus.id === node.id ? null : node.id)}
            session={session}
            announce={announce}
          />
        ))}
      </ul>
    </PanelFrame>
  );
}

/** Few sites have a launch form, so it is loaded later and is not part of the first view. */
function LaunchBox({ launch }: { readonly launch: LaunchView; }) {
  const [Form, setForm] = useState<ComponentType<{ launch: LaunchView; }> | null>(null);
  useEffect(() => {
    void import('../parts/launch_form.tsx').then(({ LaunchForm }) => setForm(() => LaunchForm));
  }, []);
  return Form === null ? null : <Form launch={launch} />;
}

/** The form comes when it is opened. */
function SeedBox({ seed }: { readonly seed: number | undefined; }) {
  const [Form, setForm] = useState<ComponentType<{ seed: number | undefined; }> | null>(null);
  const load = (): void => void import('../parts/seed_form.tsx').then(({ SeedForm }) => setForm(() => SeedForm));
  return (
    <details class="launch" open={seed !== undefined} onToggle={load}>
      <summary class="launch-title">{texts.seed}</summary>
      {Form === null ? null : <Form seed={seed} />}
    </details>
  );
}

interface NodeRowProps extends Pick<PanelProps, 'session' | 'announce'> {
  readonly node: NodeView;
  readonly now: number;
  readonly focused: boolean;
  readonly onFocus: () => void;
}

function NodeRow({ node, now, focused, onFocus, session, announce }: NodeRowProps) {
  const alive = isAlive(node.state);
  const upTime = node.state.kind === 'running' && node.startedAt !== undefined
    ? formatDuration(now - node.startedAt)
    : null;
  const links = useContext(SourceLinksContext);
  const filesOf = (paths: readonly string[] = []): string[] => paths.flatMap((path) => links?.fileOf(path) ?? []);
  // The file of a package as a whole is not the one that people want to see.
  const main = filesOf(node.usedSources).find((file) => !file.endsWith('/__init__.py'));
  const changed = filesOf(node.changedSources);
  return (
    <li class={`node ${focused ? 'node-focused' : ''}`}>
      <div class="node-head">
        <button
          type="button"
          class="node-name"
          aria-pressed={focused}
          title={focused ? texts.nodes.showAll : texts.nodes.showConsole(node.label)}
          onClick={onFocus}
        >
          <Name text={node.label} />
        </button>
        <div class="node-tools">
          {alive
            ? (
              <IconButton
                icon="stop"
                label={texts.nodes.stop(node.label)}
                onClick={() => session.stop(node.id)}
              />
            )
            : (
              <IconButton
                icon="play"
                label={texts.nodes.start(node.label)}
                onClick={() => session.start(node.id)}
              />
            )}
          <IconButton
            icon="restart"
            label={texts.nodes.restart(node.label)}
            onClick={() => session.restart(node.id)}
          />
          {main === undefined ? null : (
            <IconButton icon="code" label={texts.nodes.source(node.label)} onClick={() => links?.open(main)} />
          )}
        </div>
      </div>
      <p class="node-state">
        <StateBadge node={node} />
        {changed[0] === undefined ? null : (
          <button
            type="button"
            class="node-changed"
            title={texts.nodes.changedLong(changed)}
            onClick={() => links?.open(changed[0] ?? '')}
          >
            {texts.nodes.changed}
          </button>
        )}
        {node.elsewhere === undefined || node.elsewhere.length === 0 ? null : (
          <span class="node-time">{texts.tabs.elsewhere(node.elsewhere)}</span>
        )}
        {upTime === null ? null : <span class="node-time">{texts.nodes.upSince(upTime)}</span>}
      </p>
      <p class="node-facts">
        {node.command === true
          ? (
            <span title={texts.nodes.command}>{node.id}</span>
          )
          : (
            <span title={texts.nodes.program}>
              <Name text={node.package} /> <span class="node-program">{node.executable}</span>
            </span>
          )}
        {node.source === undefined ? null : (
          <span class="node-place" title={texts.nodes.declared}>
            {placeText(node.source)}
          </span>
        )}
      </p>
      {node.state.kind === 'crashed'
        ? (
          <ProblemView
            announce={announce}
            problem={{
              code: node.state.code,
              what: node.state.message,
              place: node.source === undefined ? null : placeText(node.source),
              why: [],
              fix: [],
            }}
            hint={texts.problem.nodeHint}
          >
            <button type="button" class="button" onClick={() => session.restart(node.id)}>
              {texts.restart}
            </button>
          </ProblemView>
        )
        : null}
    </li>
  );
}
