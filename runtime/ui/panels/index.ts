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
    id: 'graph',
    title: texts.panels.graph,
    icon: 'graph',
    source: { kind: 'lazy', load: () => import('./graph.tsx').then((file) => file.GraphPanel) },
  },
  {
    id: 'frames',
    title: texts.panels.frames,
    icon: 'frames',
    source: { kind: 'lazy', load: () => import('./frames.tsx').then((file) => file.FramesPanel) },
  },
  {
    id: 'diagnostics',
    title: texts.panels.diagnostics,
    icon: 'health',
    keeps: true,
    source: { kind: 'lazy', load: () => import('./diagnostics.tsx').then((file) => file.DiagnosticsPanel) },
  },
  {
    id: 'lifecycle',
    title: texts.panels.lifecycle,
    icon: 'lifecycle',
    source: { kind: 'lazy', load: () => import('./lifecycle.tsx').then((file) => file.LifecyclePanel) },
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
  {
    id: 'teleop',
    title: texts.panels.teleop,
    icon: 'drive',
    many: true,
    source: { kind: 'lazy', load: () => import('./teleop.tsx').then((file) => file.TeleopPanel) },
  },
  {
    id: 'text',
    title: texts.panels.text,
    icon: 'text',
    source: { kind: 'lazy', load: () => import('./text.tsx').then((file) => file.TextPanel) },
  },
  {
    id: 'log',
    title: texts.panels.log,
    icon: 'log',
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./log.tsx').then((file) => file.LogPanel) },
  },
  {
    id: 'image',
    title: texts.panels.image,
    icon: 'image',
    many: true,
    source: { kind: 'lazy', load: () => import('./image.tsx').then((file) => file.ImagePanel) },
  },
  {
    id: 'scene',
    title: texts.panels.scene,
    icon: 'scene',
    many: true,
    keeps: true,
    source: { kind: 'lazy', load: () => import('./scene.tsx').then((file) => file.ScenePanel) },
  },
  {
    id: 'services',
    title: texts.panels.services,
    icon: 'call',
    keeps: true,
    source: { kind: 'lazy', load: () => import('./services.tsx').then((file) => file.ServicesPanel) },
  },
  {
    id: 'parameters',
    title: texts.panels.parameters,
    icon: 'sliders',
    keeps: true,
    source: { kind: 'lazy', load: () => import('./parameters.tsx').then((file) => file.ParametersPanel) },
  },
  {
    id: 'turtlesim',
    title: texts.panels.turtlesim,
    icon: 'turtle',
    many: true,
    source: { kind: 'lazy', load: () => import('./turtlesim.tsx').then((file) => file.TurtlesimPanel) },
  },
];

export function panelRow(id: string): PanelRow | undefined {
  return panels.find((row) => row.id === id);
}

/** The usual layout, in the form of model/layout_text.ts: for a wide page, or one with room for two columns. */
export function usualLayout(wide: boolean, hasText: boolean): unknown {
  if (!wide)
    return {
      row: [{ column: [...(hasText ? ['text'] : []), 'nodes', 'topics'] }, 'console'],
      sizes: [2, 3],
      shown: hasText ? 'text' : 'console',
    };
  if (hasText)
    return {
      row: ['text', { column: ['nodes', 'console'], sizes: [1, 2] }, 'topics'],
      sizes: [33, 42, 25],
      shown: 'text',
    };
  return { row: ['nodes', 'console', 'topics'], sizes: [19, 56, 25], shown: 'console' };
}
