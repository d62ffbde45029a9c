// How the panels of the page stand: a tree of rows and columns whose leaves are groups of tabs. Pure: every
// change makes a new tree. Empty groups and splits of one child never stay, but for one last empty group.

import type { Json } from './json.ts';

/** One open panel. `key` is its panel's id, or that with a number when it is open more than once. */
export interface PanelTab {
  readonly key: string;
  readonly panel: string;
  readonly state: Json;
}

export interface Group {
  readonly kind: 'group';
  readonly key: string;
  readonly tabs: readonly PanelTab[];
  /** Key of the tab that is seen. */
  readonly front: string;
}

export interface Split {
  readonly kind: 'row' | 'column';
  readonly key: string;
  readonly children: readonly Pane[];
  /** Shares of the room, one per child; they add up to 1. */
  readonly sizes: readonly number[];
}

export type Pane = Group | Split;

export interface Layout {
  readonly root: Pane;
  /** The tab that was chosen last: what a narrow screen shows. */
  readonly front: string;
}

export type Zone = 'into' | 'left' | 'right' | 'above' | 'below';

export interface DropTarget {
  readonly group: string;
  readonly zone: Zone;
  /** Before which tab, for zone "into"; else behind the last. */
  readonly index?: number;
}

export const MOST_PANELS = 32;

export function groupsOf(pane: Pane): readonly Group[] {
  return pane.kind === 'group' ? [pane] : pane.children.flatMap(groupsOf);
}

export function tabsOf(pane: Pane): readonly PanelTab[] {
  return groupsOf(pane).flatMap((group) => group.tabs);
}

export function findTab(layout: Layout, key: string): PanelTab | undefined {
  return tabsOf(layout.root).find((tab) => tab.key === key);
}

export function groupOf(layout: Layout, key: string): Group | undefined {
  return groupsOf(layout.root).find((group) => group.tabs.some((tab) => tab.key === key));
}

/** A key for one more open panel of that id. */
export function freshKey(layout: Layout, panel: string): string {
  const used = new Set(tabsOf(layout.root).map((tab) => tab.key));
  let key = panel;
  for (let number = 2; used.has(key); number += 1) key = `${panel}-${number}`;
  return key;
}

/** The number in a tab's key: 1 for the first of its panel. */
export function numberOf(tab: PanelTab): number {
  const number = Number(tab.key.slice(tab.panel.length + 1));
  return Number.isInteger(number) && number > 1 ? number : 1;
}

export function makeGroup(key: string, tabs: readonly PanelTab[], front = ''): Group {
  const seen = tabs.some((tab) => tab.key === front) ? front : (tabs[0]?.key ?? '');
  return { kind: 'group', key, tabs, front: seen };
}

export function makeSplit(
  kind: Split['kind'],
  key: string,
  children: readonly Pane[],
  sizes: readonly number[],
): Pane {
  const flat: { pane: Pane; size: number; }[] = [];
  const given = children.map((_, index) => {
    const size = sizes[index] ?? 0;
    return Number.isFinite(size) && size > 0 ? size : 1 / children.length;
  });
  const total = given.reduce((a, b) => a + b, 0);
  children.forEach((pane, index) => {
    const size = (given[index] ?? 0) / total;
    if (pane.kind === kind)
      pane.children.forEach((child, at) => flat.push({ pane: child, size: size * (pane.sizes[at] ?? 0) }));
    else flat.push({ pane, size });
  });
  const [only] = flat;
  if (flat.length === 1 && only !== undefined) return only.pane;
  return {
    kind,
    key,
    children: flat.map(({ pane }) => pane),
    sizes: flat.map(({ size }) => size),
  };
}

export function reveal(layout: Layout, key: string): Layout {
  if (findTab(layout, key) === undefined) return layout;
  const root = mapGroups(layout.root, (group) =>
    group.front !== key && group.tabs.some((tab) => tab.key === key)
      ? { ...group, front: key }
      : group);
  return { root, front: key };
}

export function closeTab(layout: Layout, key: string): Layout {
  const group = groupOf(layout, key);
  if (group === undefined) return layout;
  const at = group.tabs.findIndex((tab) => tab.key === key);
  const tabs = group.tabs.filter((tab) => tab.key !== key);
  const next = tabs[Math.min(at, tabs.length - 1)]?.key ?? '';
  const changed = makeGroup(group.key, tabs, group.front === key ? next : group.front);
  const root = withoutEmpty(mapGroups(layout.root, (one) => (one === group ? changed : one)));
  const order = tabsOf(layout.root).map((tab) => tab.key);
  const place = order.indexOf(key);
  const beside = order[place + 1] ?? order[place - 1] ?? '';
  const front = layout.front === key ? next || beside : layout.front;
  return { root, front };
}

/** Puts a new panel where the target says, and shows it. */
export function addTab(layout: Layout, tab: PanelTab, target: DropTarget): Layout {
  if (tabsOf(layout.root).length >= MOST_PANELS) return layout;
  const root = mapGroups(layout.root, (group) => {
    if (group.key !== target.group) return group;
    if (target.zone === 'into' || group.tabs.length === 0) {
      const index = target.index ?? group.tabs.length;
      return makeGroup(group.key, group.tabs.toSpliced(index, 0, tab), tab.key);
    }
    const added = makeGroup(freshPaneKey(layout.root, 0), [tab]);
    const kind = target.zone === 'left' || target.zone === 'right' ? 'row' : 'column';
    const first = target.zone === 'left' || target.zone === 'above';
    const pair = first ? [added, group] : [group, added];
    return makeSplit(kind, freshPaneKey(layout.root, 1), pair, [0.5, 0.5]);
  });
  return findTab({ root, front: '' }, tab.key) === undefined ? layout : { root, front: tab.key };
}

export function moveTab(layout: Layout, key: string, target: DropTarget): Layout {
  const tab = findTab(layout, key);
  const from = groupOf(layout, key);
  if (tab === undefined || from === undefined) return layout;
  const same = from.key === target.group;
  // A group of one tab cannot be split by that tab.
  if (same && target.zone !== 'into' && from.tabs.length === 1) return layout;
  const at = from.tabs.indexOf(tab);
  const index = target.index !== undefined && same && at < target.index ? target.index - 1 : target.index;
  const left = makeGroup(
    from.key,
    from.tabs.filter((one) => one !== tab),
    from.front === key ? (from.tabs[at + 1] ?? from.tabs[at - 1])?.key : from.front,
  );
  const without = {
    root: mapGroups(layout.root, (group) => (group === from ? left : group)),
    front: layout.front,
  };
  const added = addTab(without, tab, {
    group: target.group,
    zone: target.zone,
    ...(index === undefined ? {} : { index }),
  });
  if (added === without) return layout;
  return { root: withoutEmpty(added.root), front: key };
}

/** Divides the room of two neighbours again: `first` is the part of both that the first one gets. */
export function resizePair(layout: Layout, split: string, index: number, first: number): Layout {
  const root = mapSplits(layout.root, (pane) => {
    const a = pane.sizes[index];
    const b = pane.sizes[index + 1];
    if (pane.key !== split || a === undefined || b === undefined) return pane;
    const part = (a + b) * Math.min(0.98, Math.max(0.02, first));
    return { ...pane, sizes: pane.sizes.toSpliced(index, 2, part, a + b - part) };
  });
  return { ...layout, root };
}

export function setPanelState(layout: Layout, key: string, state: Json): Layout {
  const root = mapGroups(layout.root, (group) =>
    group.tabs.some((tab) => tab.key === key)
      ? { ...group, tabs: group.tabs.map((tab) => (tab.key === key ? { ...tab, state } : tab)) }
      : group);
  return { ...layout, root };
}

/**
 * Where a panel that `caller` asks for goes without covering what a visitor looks at: behind the tabs of the largest other
 * group whose front tab may be covered, else below the largest other group, else into the only one.
 */
export function placeBeside(
  layout: Layout,
  caller: string | null,
  mayCover: (tab: PanelTab) => boolean,
): DropTarget | undefined {
  const rooms = areas(layout.root, 1).toSorted((a, b) => b.area - a.area);
  const others = rooms.filter(
    ({ group }) => caller === null || !group.tabs.some((tab) => tab.key === caller),
  );
  const coverable = others.find(({ group }) => {
    const front = group.tabs.find((tab) => tab.key === group.front);
    return front === undefined || mayCover(front);
  });
  if (coverable !== undefined) return { group: coverable.group.key, zone: 'into' };
  const [largest] = others.length > 0 ? others : rooms;
  return largest === undefined ? undefined : { group: largest.group.key, zone: 'below' };
}

/** Whether showing the tab would hide the tab that asks for it, or one that a visitor looks at. */
export function wouldCover(
  layout: Layout,
  key: string,
  caller: string | null,
  mayCover: (tab: PanelTab) => boolean,
): boolean {
  const group = groupOf(layout, key);
  if (group === undefined || group.front === key) return false;
  const front = group.tabs.find((tab) => tab.key === group.front);
  return group.front === caller || (front !== undefined && !mayCover(front));
}

/** Which part of a box a point is over: near an edge it means the half beside that edge. */
export function zoneAt(
  box: { readonly left: number; readonly top: number; readonly width: number; readonly height: number; },
  x: number,
  y: number,
): Zone {
  const across = (x - box.left) / box.width;
  const down = (y - box.top) / box.height;
  const edges: readonly (readonly [Zone, number])[] = [
    ['left', across],
    ['right', 1 - across],
    ['above', down],
    ['below', 1 - down],
  ];
  const [nearest] = edges.toSorted((a, b) => a[1] - b[1]);
  return nearest !== undefined && nearest[1] < 0.25 ? nearest[0] : 'into';
}

function areas(pane: Pane, area: number): readonly { group: Group; area: number; }[] {
  if (pane.kind === 'group') return [{ group: pane, area }];
  return pane.children.flatMap((child, index) => areas(child, area * (pane.sizes[index] ?? 0)));
}

function mapGroups(pane: Pane, change: (group: Group) => Pane): Pane {
  if (pane.kind === 'group') return change(pane);
  const children = pane.children.map((child) => mapGroups(child, change));
  if (children.every((child, index) => child === pane.children[index])) return pane;
  return makeSplit(pane.kind, pane.key, children, pane.sizes);
}

function mapSplits(pane: Pane, change: (split: Split) => Split): Pane {
  if (pane.kind === 'group') return pane;
  return change({ ...pane, children: pane.children.map((child) => mapSplits(child, change)) });
}

function withoutEmpty(pane: Pane): Pane {
  return pruned(pane) ?? makeGroup(freshPaneKey(pane, 0), []);
}

function pruned(pane: Pane): Pane | null {
  if (pane.kind === 'group') return pane.tabs.length === 0 ? null : pane;
  const kept = pane.children.flatMap((child, index) => {
    const rest = pruned(child);
    return rest === null ? [] : [{ rest, size: pane.sizes[index] ?? 0 }];
  });
  if (kept.length === 0) return null;
  return makeSplit(
    pane.kind,
    pane.key,
    kept.map(({ rest }) => rest),
    kept.map(({ size }) => size),
  );
}

/** A key that no pane of the tree has; `more` for the second one of the same change. */
function freshPaneKey(root: Pane, more: number): string {
  return `pane-${largestPane(root) + 1 + more}`;
}

function largestPane(pane: Pane): number {
  const own = Number(pane.key.slice('pane-'.length));
  const inside = pane.kind === 'group' ? [] : pane.children.map(largestPane);
  return Math.max(Number.isInteger(own) ? own : 0, ...inside);
}
