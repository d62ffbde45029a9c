// The panels of the page, one row each, in their order on a narrow screen.

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
    place: 'left',
    source: { kind: 'ready', component: NodesPanel },
  },
  {
    id: 'console',
    title: texts.panels.console,
    icon: 'console',
    place: 'middle',
    source: { kind: 'ready', component: ConsolePanel },
  },
  {
    id: 'topics',
    title: texts.panels.topics,
    icon: 'topics',
    place: 'right',
    source: { kind: 'ready', component: TopicsPanel },
  },
];
