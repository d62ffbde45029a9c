// The panels of the page, one row each, in the order of the "+" menu.

import { texts } from '../texts.ts';
import { ConsolePanel } from './console.tsx';
import { NodesPanel } from './nodes.tsx';
import type { PanelRow } from './panel_props.ts';
import { TopicsPanel } from './topics.tsx';

export const panels: readonly PanelRow[] = [
  {
    id: 'nodes',
    title: texts.panels.nodes,
    icon: 'nodes',
    source: { kind: 'ready', component: NodesPanel },
  },
  {
    id: 'console',
    title: texts.panels.console,
    icon: 'console',
    source: { kind: 'ready', component: ConsolePanel },
  },
  {
    id: 'topics',
    title: texts.panels.topics,
    icon: 'topics',
    source: { kind: 'ready', component: TopicsPanel },
  },
  {
    id: 'plot',
    title: texts.panels.plot,
    icon: 'plot',
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./plot.tsx').then((file) => file.PlotPanel) },
  },
  {
    id: 'timeline',
    title: texts.panels.timeline,
    icon: 'timeline',
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./timeline.tsx').then((file) => file.TimelinePanel) },
  },
  {
    id: 'checks',
    title: texts.panels.checks,
    icon: 'check',
    source: { kind: 'lazy', load: () => import('./checks.tsx').then((file) => file.ChecksPanel) },
  },
  {
    id: 'terminal',
    title: texts.panels.terminal,
    icon: 'console',
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
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./publish.tsx').then((file) => file.PublishPanel) },
  },
];

export function panelRow(id: string): PanelRow | undefined {
  return panels.find((row) => row.id === id);
}

/** The usual layouts, in the form of model/layout_text.ts: for a wide page, and for one with room for two columns. */
export const kUsualWide = { row: ['nodes', 'console', 'topics'], sizes: [19, 56, 25], shown: 'console' };
export const kUsualMiddling = {
  row: [{ column: ['nodes', 'topics'], sizes: [2, 3] }, 'console'],
  sizes: [2, 3],
  shown: 'console',
};
