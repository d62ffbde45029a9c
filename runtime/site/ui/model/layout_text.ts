// A layout as a short JSON value, the same in site.json (`layout` of `ui`), in a link and in the browser's storage:
//   "console"                          a panel
//   {"plot": {"paths": ["/odom.x"]}}   a panel with its state
//   {"tabs": [...], "front": 2}        panels behind each other, the second one in front
//   {"row": [...], "sizes": [1, 2]}    side by side; {"column": [...]} below each other
// and "shown": "plot-2" at the outermost says which panel a narrow screen shows.
// The input may be hostile: depth, number and size are bounded, and invalid parts are skipped.

import { isRecord, member, numberMember, readJson, textMember } from './json.ts';
import type { Json } from './json.ts';
import { groupsOf, MOST_PANELS, makeGroup, makeSplit } from './layout.ts';
import type { Layout, Pane, PanelTab } from './layout.ts';

const MOST_DEPTH = 6;
const MOST_STATE = 8_192;
const MOST_TEXT = 65_536;
const MOST_CHILDREN = 12;

export interface ReadLayout {
  /** null when nothing of it can be shown. */
  readonly layout: Layout | null;
  /** Names of what was skipped, in no more than a few words each. */
  readonly leftOut: readonly string[];
}

export function readLayout(value: unknown, isKnown: (panel: string) => boolean): ReadLayout {
  const reader = new LayoutReader(isKnown);
  const root = reader.pane(value, 0);
  const front = textMember(value, 'shown');
  if (root === null) return { layout: null, leftOut: reader.leftOut };
  const groups = groupsOf(root);
  const seen = groups.some((group) => group.tabs.some((tab) => tab.key === front))
    ? front
    : (groups[0]?.front ?? '');
  return { layout: { root, front: seen }, leftOut: reader.leftOut };
}

export function parseLayout(text: string, isKnown: (panel: string) => boolean): ReadLayout {
  const broken: ReadLayout = { layout: null, leftOut: [] };
  if (text.length > MOST_TEXT) return broken;
  try {
    return readLayout(JSON.parse(text), isKnown);
  } catch {
    return broken;
  }
}

export function writeLayout(layout: Layout): Json {
  const root = writePane(layout.root);
  return isRecord(root) && !isPanel(layout.root)
    ? { ...(root as Readonly<Record<string, Json>>), shown: frontOf(layout) }
    : root;
}

class LayoutReader {
  readonly leftOut: string[] = [];
  private readonly isKnown: (panel: string) => boolean;
  private readonly counts = new Map<string, number>();
  private panels = 0;
  private panes = 0;

  constructor(isKnown: (panel: string) => boolean) {
    this.isKnown = isKnown;
  }

  pane(value: unknown, depth: number): Pane | null {
    for (const kind of ['row', 'column'] as const) {
      const children = member(value, kind);
      if (Array.isArray(children)) return this.split(kind, children, value, depth);
    }
    const tabs = member(value, 'tabs');
    const list: readonly unknown[] = Array.isArray(tabs) ? tabs : [value];
    const key = this.paneKey();
    const read = list.slice(0, MOST_PANELS).map((item) => this.tab(item));
    const front = numberMember(value, 'front', 1, MOST_PANELS, 1) - 1;
    const kept = read.filter((tab) => tab !== null);
    return kept.length === 0 ? null : makeGroup(key, kept, read[front]?.key);
  }

  private split(
    kind: 'row' | 'column',
    children: readonly unknown[],
    value: unknown,
    depth: number,
  ): Pane | null {
    if (depth >= MOST_DEPTH || children.length > MOST_CHILDREN) {
      this.omit(kind);
      return null;
    }
    const key = this.paneKey();
    const sizes = member(value, 'sizes');
    const kept = children.flatMap((child, index) => {
      const pane = this.pane(child, depth + 1);
      const size: unknown = Array.isArray(sizes) ? sizes[index] : undefined;
      return pane === null
        ? []
        : [{ pane, size: typeof size === 'number' && size > 0 && size < 1e6 ? size : 1 }];
    });
    if (kept.length === 0) return null;
    return makeSplit(
      kind,
      key,
      kept.map(({ pane }) => pane),
      kept.map(({ size }) => size),
    );
  }

  private tab(value: unknown): PanelTab | null {
    const entries = isRecord(value) ? Object.entries(value) : [];
    const name = typeof value === 'string' ? value : entries.length === 1 ? entries[0]?.[0] : null;
    if (typeof name !== 'string' || !this.isKnown(name) || this.panels >= MOST_PANELS) {
      this.omit(typeof name === 'string' ? name : '?');
      return null;
    }
    const state = readJson(entries[0]?.[1] ?? null, MOST_STATE);
    if (state === undefined) {
      this.omit(name);
      return null;
    }
    this.panels += 1;
    const count = (this.counts.get(name) ?? 0) + 1;
    this.counts.set(name, count);
    return { key: count === 1 ? name : `${name}-${count}`, panel: name, state };
  }

  private paneKey(): string {
    this.panes += 1;
    return `pane-${this.panes}`;
  }

  private omit(name: string): void {
    if (this.leftOut.length < 8) this.leftOut.push(name.slice(0, 40));
  }
}

function writePane(pane: Pane): Json {
  if (pane.kind !== 'group') {
    return {
      [pane.kind]: pane.children.map(writePane),
      sizes: pane.sizes.map((size) => Math.round(size * 1000)),
    };
  }
  const [only] = pane.tabs;
  if (pane.tabs.length === 1 && only !== undefined) return writeTab(only);
  const at = pane.tabs.findIndex((tab) => tab.key === pane.front);
  return at > 0
    ? { tabs: pane.tabs.map(writeTab), front: at + 1 }
    : { tabs: pane.tabs.map(writeTab) };
}

function writeTab(tab: PanelTab): Json {
  return tab.state === null ? tab.panel : { [tab.panel]: tab.state };
}

function isPanel(pane: Pane): boolean {
  return pane.kind === 'group' && pane.tabs.length === 1;
}

/** Keys are given out in the order of the tree when it is read again: the front tab's key in that order. */
function frontOf(layout: Layout): string {
  const counts = new Map<string, number>();
  for (const group of groupsOf(layout.root)) {
    for (const tab of group.tabs) {
      const count = (counts.get(tab.panel) ?? 0) + 1;
      counts.set(tab.panel, count);
      if (tab.key === layout.front) return count === 1 ? tab.panel : `${tab.panel}-${count}`;
    }
  }
  return '';
}
