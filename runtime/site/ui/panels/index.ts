// The panels of the page, one row each, in the order of their groups in the "+" menu.

import type { SiteDescription } from '../../contract/session.ts';
import { member, textMember } from '../model/json.ts';
import type { Json } from '../model/json.ts';
import { texts } from '../texts.ts';
import { ConsolePanel } from './console.tsx';
import { NodesPanel } from './nodes.tsx';
import type { PanelGroup, PanelRow } from './panel_props.ts';
import { TopicsPanel } from './topics.tsx';

const MOST_OPENED = 4;
const GROUPS: readonly PanelGroup[] = ['run', 'see', 'act', 'files'];

/** Without a field it would wait for nothing. */
function hasPaths(state: Json): boolean {
  const paths = member(state, 'paths');
  return Array.isArray(paths) && paths.length > 0;
}

export const panels: readonly PanelRow[] = [
  {
    id: 'nodes',
    title: texts.panels.nodes,
    icon: 'nodes',
    group: 'run',
    source: { kind: 'ready', component: NodesPanel },
  },
  {
    id: 'console',
    title: texts.panels.console,
    icon: 'console',
    group: 'run',
    source: { kind: 'ready', component: ConsolePanel },
  },
  {
    id: 'topics',
    title: texts.panels.topics,
    icon: 'topics',
    group: 'see',
    source: { kind: 'ready', component: TopicsPanel },
  },
  {
    id: 'plot',
    title: texts.panels.plot,
    icon: 'plot',
    group: 'see',
    watched: true,
    many: true,
    keeps: true,
    collects: hasPaths,
    source: { kind: 'lazy', load: () => import('./plot.tsx').then((file) => file.PlotPanel) },
  },
  {
    id: 'graph',
    title: texts.panels.graph,
    icon: 'graph',
    group: 'see',
    source: { kind: 'lazy', load: () => import('./graph.tsx').then((file) => file.GraphPanel) },
  },
  {
    id: 'frames',
    title: texts.panels.frames,
    icon: 'frames',
    group: 'see',
    source: { kind: 'lazy', load: () => import('./frames.tsx').then((file) => file.FramesPanel) },
  },
  {
    id: 'diagnostics',
    title: texts.panels.diagnostics,
    icon: 'health',
    group: 'run',
    keeps: true,
    collects: () => true,
    source: { kind: 'lazy', load: () => import('./diagnostics.tsx').then((file) => file.DiagnosticsPanel) },
  },
  {
    id: 'lifecycle',
    title: texts.panels.lifecycle,
    icon: 'lifecycle',
    group: 'run',
    source: { kind: 'lazy', load: () => import('./lifecycle.tsx').then((file) => file.LifecyclePanel) },
  },
  {
    id: 'timeline',
    title: texts.panels.timeline,
    icon: 'timeline',
    group: 'see',
    many: true,
    keeps: true,
    collects: hasPaths,
    source: { kind: 'lazy', load: () => import('./timeline.tsx').then((file) => file.TimelinePanel) },
  },
  {
    id: 'checks',
    title: texts.panels.checks,
    icon: 'check',
    group: 'run',
    watched: true,
    fits: (site) => site.checks.length > 0,
    // Where there are tasks, what a student sees pass is the student's own doing.
    usual: { place: 'list', when: (site) => site.checks.length > 0 && site.tasks.length === 0 },
    source: { kind: 'lazy', plain: true, load: () => import('./checks.tsx').then((file) => file.ChecksPanel) },
  },
  {
    id: 'terminal',
    title: texts.panels.terminal,
    icon: 'console',
    group: 'act',
    watched: true,
    many: true,
    keeps: true,
    source: {
      kind: 'lazy',
      load: async () => (await import('./terminal.tsx')).TerminalPanel,
    },
  },
  {
    id: 'publish',
    title: texts.panels.publish,
    icon: 'publish',
    group: 'act',
    watched: true,
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./publish.tsx').then((file) => file.PublishPanel) },
  },
  {
    id: 'teleop',
    title: texts.panels.teleop,
    icon: 'drive',
    group: 'act',
    watched: true,
    many: true,
    source: { kind: 'lazy', load: () => import('./teleop.tsx').then((file) => file.TeleopPanel) },
  },
  {
    id: 'source',
    title: texts.panels.source,
    icon: 'code',
    group: 'files',
    watched: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./source.tsx').then((file) => file.SourcePanel) },
  },
  {
    id: 'text',
    title: texts.panels.text,
    icon: 'text',
    group: 'files',
    watched: true,
    fits: (site) => typeof site.ui['text'] === 'string',
    usual: { place: 'guide', when: (site) => typeof site.ui['text'] === 'string' },
    source: { kind: 'lazy', load: () => import('./text.tsx').then((file) => file.TextPanel) },
  },
  {
    id: 'tasks',
    title: texts.panels.tasks,
    icon: 'check',
    group: 'files',
    watched: true,
    fits: (site) => site.tasks.length > 0,
    usual: { place: 'guide', when: (site) => site.tasks.length > 0 },
    source: { kind: 'lazy', load: () => import('./tasks.tsx').then((file) => file.TasksPanel) },
  },
  {
    id: 'notebook',
    title: texts.panels.notebook,
    icon: 'notebook',
    group: 'files',
    watched: true,
    fits: (site) => site.notebook !== undefined,
    usual: { place: 'guide', when: (site) => site.notebook !== undefined },
    source: { kind: 'lazy', load: () => import('./notebook.tsx').then((file) => file.NotebookPanel) },
  },
  {
    id: 'log',
    title: texts.panels.log,
    icon: 'log',
    group: 'run',
    many: true,
    keeps: true,
    collects: () => true,
    source: { kind: 'lazy', load: () => import('./log.tsx').then((file) => file.LogPanel) },
  },
  {
    id: 'image',
    title: texts.panels.image,
    icon: 'image',
    group: 'see',
    watched: true,
    many: true,
    source: { kind: 'lazy', load: () => import('./image.tsx').then((file) => file.ImagePanel) },
  },
  {
    id: 'figure',
    title: texts.panels.figure,
    icon: 'plot',
    group: 'see',
    watched: true,
    many: true,
    fits: (site) => site.packages.includes('ros2wasm_figures'),
    source: { kind: 'lazy', load: () => import('./figure.tsx').then((file) => file.FigurePanel) },
  },
  {
    id: 'scene',
    title: texts.panels.scene,
    icon: 'scene',
    group: 'see',
    watched: true,
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./scene.tsx').then((file) => file.ScenePanel) },
  },
  {
    id: 'simulation',
    title: texts.panels.simulation,
    icon: 'simulation',
    group: 'see',
    watched: true,
    fits: (site) => site.nodes.some((node) => node.package === 'ros2wasm_sim' || node.package === 'ros2wasm_sim_control'),
    source: { kind: 'lazy', load: () => import('./simulation.tsx').then((file) => file.SimulationPanel) },
  },
  {
    id: 'joints',
    title: texts.panels.joints,
    icon: 'sliders',
    group: 'act',
    watched: true,
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./joints.tsx').then((file) => file.JointsPanel) },
  },
  {
    id: 'services',
    title: texts.panels.services,
    icon: 'call',
    group: 'act',
    keeps: true,
    source: { kind: 'lazy', load: () => import('./services.tsx').then((file) => file.ServicesPanel) },
  },
  {
    id: 'parameters',
    title: texts.panels.parameters,
    icon: 'sliders',
    group: 'act',
    keeps: true,
    source: { kind: 'lazy', load: () => import('./parameters.tsx').then((file) => file.ParametersPanel) },
  },
  {
    id: 'bag',
    title: texts.panels.bag,
    icon: 'bag',
    group: 'files',
    keeps: true,
    source: { kind: 'lazy', load: () => import('./bag.tsx').then((file) => file.BagPanel) },
  },
  {
    id: 'turtlesim',
    title: texts.panels.turtlesim,
    icon: 'turtle',
    group: 'see',
    watched: true,
    many: true,
    fits: (site) => site.packages.includes('turtlesim'),
    usual: {
      place: 'stage',
      when: (site) => site.nodes.some((node) => node.package === 'turtlesim' && node.executable === 'turtlesim_node'),
    },
    source: { kind: 'lazy', load: () => import('./turtlesim.tsx').then((file) => file.TurtlesimPanel) },
  },
];

/** The panels in the "+" menu of a site, group by group. */
export function offeredPanels(site: SiteDescription): readonly PanelRow[] {
  return GROUPS.flatMap((group) => panels.filter((row) => row.group === group && row.fits?.(site) !== false));
}

export function panelRow(id: string): PanelRow | undefined {
  return panels.find((row) => row.id === id);
}

/** The usual layout of a site, in the form of model/layout_text.ts: for a wide page, or one with room for two columns. */
export function usualLayout(wide: boolean, site: SiteDescription): unknown {
  const placed = (place: 'guide' | 'stage' | 'list'): readonly Pane[] =>
    panels
      .filter(({ usual }) => usual?.place === place && usual.when(site))
      .map(({ id }) => id);
  const guide = placed('guide');
  const stage = [...placed('stage'), ...opened(site)];
  const list: readonly Pane[] = ['nodes', ...placed('list')];
  const seen = column([...stage, 'console'], 3, 2);
  if (!wide)
    return {
      row: [column([...guide, ...list, 'topics']), seen],
      sizes: [2, 3],
      shown: nameOf(guide[0] ?? stage[0] ?? 'console'),
    };
  const shown = nameOf(stage[0] ?? guide[0] ?? 'console');
  if (guide.length === 0) return { row: [column(list), seen, 'topics'], sizes: [19, 56, 25], shown };
  const middle = stage.length === 0 ? column([...list, 'console'], 1, 2) : seen;
  const right = stage.length === 0 ? 'topics' : column([...list, 'topics']);
  return { row: [column(guide), middle, right], sizes: [33, 42, 25], shown };
}

/** The id of a panel, with its state or without. */
type Pane = string | Readonly<Record<string, unknown>>;

function nameOf(pane: Pane): string {
  return typeof pane === 'string' ? pane : (Object.keys(pane)[0] ?? '');
}

/** The panels that replace programs of the launch file that are skipped, such as rviz2. */
function opened(site: SiteDescription): readonly Pane[] {
  const { opens } = site.ui;
  if (!Array.isArray(opens)) return [];
  return (opens as readonly unknown[]).slice(0, MOST_OPENED).flatMap((one): readonly Pane[] => {
    const [panel, file] = [textMember(one, 'panel'), textMember(one, 'file')];
    if (panelRow(panel) === undefined) return [];
    return [file === '' ? panel : { [panel]: { file } }];
  });
}

/** Below each other, each of that size and the last one of its own. */
function column(panes: readonly Pane[], each = 1, last = 1): unknown {
  return panes.length === 1
    ? panes[0]
    : { column: panes, sizes: panes.map((_, index) => (index === panes.length - 1 ? last : each)) };
}
