// The title of a panel's tab, with a number where a panel is open several times.

import { numberOf } from '../model/layout.ts';
import type { PanelTab } from '../model/layout.ts';
import { panelRow } from '../panels/index.ts';
import { texts } from '../texts.ts';

export function tabTitle(tab: PanelTab): string {
  const title = panelRow(tab.panel)?.title ?? tab.panel;
  const number = numberOf(tab);
  return number === 1 ? title : texts.layout.numbered(title, number);
}
