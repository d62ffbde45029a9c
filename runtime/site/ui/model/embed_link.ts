// The page inside another one: `?embed=1&panel=plot&panel=console` in its address, with what the panels show behind its "#"
// as in any link to a view. Pure: what is asked for, and the way back to the whole page.

import { addTab, closeTab, freshKey, groupsOf, tabsOf } from './layout.ts';
import { readLayout } from './layout_text.ts';
import type { ReadLayout } from './layout_text.ts';
import { changedFragment } from './link.ts';

const MOST_PANELS = 12;

export interface EmbedView {
  /** As they are asked for; empty: the layout that the link has, or the usual one. */
  readonly panels: readonly string[];
}

/** null: the whole page is asked for. `search`: as in an address. */
export function readEmbed(search: string): EmbedView | null {
  const fields = new URLSearchParams(search);
  if (fields.get('embed') !== '1') return null;
  const panels = fields.getAll('panel').flatMap((names) => names.split(','));
  return { panels: panels.filter((name) => name !== '').slice(0, MOST_PANELS) };
}

/** The layout of the requested panels: those in the link's layout keep their places, the others are put beside them. */
export function embeddedLayout(
  { panels }: EmbedView,
  linked: ReadLayout,
  isKnown: (panel: string) => boolean,
): ReadLayout {
  if (panels.length === 0) return linked;
  const fresh = readLayout({ row: [...new Set(panels)] }, isKnown);
  const leftOut = [...linked.leftOut, ...fresh.leftOut];
  if (linked.layout === null || fresh.layout === null) return { layout: fresh.layout ?? linked.layout, leftOut };
  const wanted = tabsOf(fresh.layout.root);
  let { layout } = linked;
  const there = tabsOf(layout.root).filter((tab) => wanted.some(({ panel }) => panel === tab.panel));
  if (there.length === 0) return { layout: fresh.layout, leftOut };
  for (const tab of tabsOf(layout.root)) if (!there.includes(tab)) layout = closeTab(layout, tab.key);
  const shown = layout.front;
  for (const { panel } of wanted) {
    const last = groupsOf(layout.root).at(-1);
    if (last === undefined || there.some((tab) => tab.panel === panel)) continue;
    const key = freshKey(layout, panel);
    layout = addTab(layout, { key, panel, state: null }, { group: last.key, zone: 'right' });
  }
  return { layout: { ...layout, front: shown }, leftOut };
}

/** The address of the same view as a page of its own. `layout`: as a link carries it; null: what the address has. */
export function wholeAddress(address: string, layout: string | null): string {
  const url = new URL(address);
  // `?name:=value` of launch arguments stays as it is written.
  const words = url.search.slice(1).split('&');
  url.search = words.filter((word) => word !== '' && !/^(embed|panel)(=|$)/.test(word)).join('&');
  if (layout !== null) url.hash = changedFragment(url.hash, { layout });
  return url.href;
}
