// The page's layout: from a link, else as the visitor left it here, else the author's, else the usual one for the
// room there is. Kept in the browser once the visitor changed it.

import { useCallback, useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Session, SiteDescription } from '../../contract/session.ts';
import { setParameters } from '../../ros2cli/set_parameters.ts';
import { embeddedLayout, wholeAddress } from '../model/embed_link.ts';
import type { EmbedView } from '../model/embed_link.ts';
import { readJson } from '../model/json.ts';
import type { Json } from '../model/json.ts';
import * as layouts from '../model/layout.ts';
import type { DropTarget, Layout, PanelTab } from '../model/layout.ts';
import { parseLayout, readLayout, writeLayout } from '../model/layout_text.ts';
import type { ReadLayout } from '../model/layout_text.ts';
import { autorunField, changedFragment, readFragment, siteHash } from '../model/link.ts';
import { readText, writePreference } from '../model/preferences.ts';
import type { Store } from '../model/preferences.ts';
import { panelRow, usualLayout } from '../panels/index.ts';
import { texts } from '../texts.ts';
import { changedFiles } from './source_links.ts';
import { useFocus } from './use_focus.ts';

export interface LayoutControl {
  readonly site: SiteDescription;
  readonly layout: Layout;
  readonly reveal: (key: string) => void;
  readonly close: (key: string) => void;
  readonly move: (key: string, target: DropTarget) => void;
  readonly resize: (split: string, index: number, first: number) => void;
  /** Opens a panel in that group; one that is open once only is shown instead. */
  readonly add: (group: string, panel: string) => void;
  /** Whether the visitor has just opened that tab by `add`, and expects to use it at once. */
  readonly justAdded: (key: string) => boolean;
  readonly setState: (key: string, state: Json) => void;
  /** As PanelProps.open, asked by the panel of that key. */
  readonly open: (caller: string | null, panel: string, state?: Json) => boolean;
  readonly reset: () => void;
  /** The address with the layout in it, also put where the address stands. */
  readonly link: () => Promise<string>;
  /** The layout as the lines of a manifest. */
  readonly yaml: () => string;
  /** The group that fills the page for now. */
  readonly large: string | null;
  readonly enlarge: (group: string | null) => void;
  /** The address of the whole page with this layout. */
  readonly whole: () => string;
  /** A notice about the link that was followed; empty: there is none. */
  readonly notice: string;
  readonly dismiss: () => void;
}

const MOST_STATE = 8_192;
const MOST_NAMED = 200;
const MOST_NOTICE = 2000;
const NO_VIEW = { layout: null, site: null, changed: null, params: null, autorun: null };

export function useLayout(
  session: Session,
  store: Store | null,
  /** The usual layout is the one of three columns, or their order on a phone. */
  wide: boolean,
  /** All panels stand behind each other: showing one always covers another. */
  narrow: boolean,
  announce: (text: string) => void,
  /** The page stands in another one: the layout is what its address says, and leaves no trace. */
  embed: EmbedView | null = null,
): LayoutControl {
  const name = useMemo(() => `layout.${new URL('.', document.baseURI).pathname}`, []);
  const usual = useMemo((): Layout => {
    const author = readLayout(session.site.ui['layout'], isKnown).layout;
    return author ?? readLayout(usualLayout(wide, session.site), isKnown).layout ?? NOTHING;
  }, [session, wide]);
  // null: the visitor has changed nothing, so the usual layout follows the width.
  const [chosen, setChosen] = useState<Layout | null>(
    () => linked(embed).layout ?? parseLayout(readText(store, name) ?? '', isKnown).layout,
  );
  const [front, setFront] = useState<string | null>(null);
  const layout = useMemo(
    () => chosen ?? { ...usual, front: front ?? usual.front },
    [chosen, usual, front],
  );
  const [large, setLarge] = useState<string | null>(null);
  const added = useRef('');
  const latest = useRef(layout);
  latest.current = layout;
  const { notice, dismiss } = useLinkNotice(session, embed, setChosen);
  const focus = useFocus();

  const change = useCallback(
    (next: (layout: Layout) => Layout): void => {
      const changed = next(latest.current);
      if (changed === latest.current) return;
      const onlyFront = changed.root === latest.current.root;
      latest.current = changed;
      setFront(changed.front);
      // Looking at another tab of the usual layout is not a layout of one's own.
      if (onlyFront) setChosen((before) => (before === null ? null : changed));
      if (onlyFront) return;
      setChosen(changed);
      writePreference(store, name, JSON.stringify(writeLayout(changed)));
      // From now on a reload shows the visitor's layout, not the link's.
      if (embed === null && readFragment(location.hash).has('layout')) setFragment(NO_VIEW);
    },
    [store, name, embed],
  );

  return useMemo<LayoutControl>(() => {
    const focusTab = (key: string): void => focus(`tab-${key}`);
    const reveal = (key: string): void => change((now) => layouts.reveal(now, key));
    return {
      site: session.site,
      layout,
      notice,
      dismiss,
      reveal,
      close: (key) => {
        change((now) => layouts.closeTab(now, key));
        announce(texts.layout.closed);
        focusTab(latest.current.front);
      },
      move: (key, target) => {
        change((now) => layouts.moveTab(now, key, target));
        announce(texts.layout.moved);
        focusTab(key);
      },
      resize: (split, index, first) => change((now) => layouts.resizePair(now, split, index, first)),
      add: (group, panel) => {
        const row = panelRow(panel);
        const opened = layouts.tabsOf(latest.current.root).find((tab) => tab.panel === panel);
        if (row === undefined) return;
        if (opened !== undefined && row.many !== true) {
          reveal(opened.key);
          focusTab(opened.key);
          return;
        }
        const key = layouts.freshKey(latest.current, panel);
        change((now) => layouts.addTab(now, { key, panel, state: null }, { group, zone: 'into' }));
        added.current = key;
        focusTab(key);
      },
      justAdded: (key) => added.current === key,
      setState: (key, state) => {
        const kept = readJson(state, MOST_STATE);
        if (kept !== undefined) change((now) => layouts.setPanelState(now, key, kept));
      },
      open: (caller, panel, state) => {
        const row = panelRow(panel);
        if (row === undefined) return false;
        const wanted = state === undefined ? undefined : JSON.stringify(state);
        const open = layouts.tabsOf(latest.current.root).filter((tab) => tab.panel === panel);
        const same = open.find((tab) => wanted === undefined || JSON.stringify(tab.state) === wanted);
        const only = row.many === true ? same : (same ?? open[0]);
        const target = layouts.placeBeside(latest.current, caller, mayCover);
        if (target === undefined) return false;
        if (only !== undefined) {
          if (state !== undefined && only !== same)
            change((now) => layouts.setPanelState(now, only.key, state));
          const covers = !narrow && layouts.wouldCover(latest.current, only.key, caller, mayCover);
          if (covers) change((now) => layouts.moveTab(now, only.key, target));
          reveal(only.key);
          return true;
        }
        const kept = readJson(state ?? null, MOST_STATE);
        if (kept === undefined) return false;
        const key = layouts.freshKey(latest.current, panel);
        change((now) => layouts.addTab(now, { key, panel, state: kept }, target));
        return true;
      },
      reset: () => {
        setChosen(null);
        writePreference(store, name, '');
        setFragment(NO_VIEW);
      },
      link: async () => {
        const site = await siteHash();
        const files = changedFiles(session);
        const changed = files.length === 0 ? null : files.join('\n');
        const running = session.nodes().some(({ state }) => state.kind !== 'stopped');
        const autorun = session.nodes().length === 0 ? null : autorunField(running, session.site.ui['autostart'] !== false);
        const params = setParameters(session).size === 0 ? null : await (await import('./linked_parameters.ts')).linkedParameters(session);
        setFragment({ site, changed, autorun, params, layout: JSON.stringify(writeLayout(latest.current)) });
        return location.href;
      },
      yaml: () => `ui:\n  layout: ${JSON.stringify(writeLayout(latest.current))}\n`,
      large: layouts.groupsOf(layout.root).some(({ key }) => key === large) ? large : null,
      enlarge: (group) => {
        setLarge(group);
        announce(group === null ? texts.layout.restored : texts.layout.enlarged);
        focusTab(latest.current.front);
      },
      whole: () => wholeAddress(location.href, JSON.stringify(writeLayout(latest.current))),
    };
  }, [session, layout, notice, large, narrow, change, announce, focus]);
}

const NOTHING: Layout = { root: layouts.makeGroup('pane-1', []), front: '' };

function mayCover(tab: PanelTab): boolean {
  return panelRow(tab.panel)?.watched !== true;
}

function isKnown(panel: string): boolean {
  return panelRow(panel) !== undefined;
}

function linked(embed: EmbedView | null): ReadLayout {
  const found = parseLayout(readFragment(location.hash).get('layout') ?? '', isKnown);
  return embed === null ? found : embeddedLayout(embed, found, isKnown);
}

function setFragment(fields: Readonly<Record<string, string | null>>): void {
  const fragment = changedFragment(location.hash, fields);
  history.replaceState(history.state, '', `${location.pathname}${location.search}${fragment}`);
}

/** Follows the address: a link that is opened in this very tab changes its fragment only. */
function useLinkNotice(
  session: Session,
  embed: EmbedView | null,
  apply: (layout: Layout) => void,
): {
  readonly notice: string;
  readonly dismiss: () => void;
} {
  const [notice, setNotice] = useState('');
  useEffect(() => {
    let current = true;
    let applied = '';
    let endParameters: () => void = () => undefined;
    /** They are set as their nodes come, also when the node is started later. */
    const parameters = async (text: string): Promise<void> => {
      if (text === applied) return;
      applied = text;
      endParameters();
      const { applyParameters, readLinkedParameters } = await import('./linked_parameters.ts');
      const all = readLinkedParameters(text);
      if (!current || text !== applied) return;
      const told = all.length === 0 ? texts.layout.linkNoParameters : texts.layout.linkParameters(all.length);
      setNotice((before) => [before, told].filter((part) => part !== '').join(' '));
      endParameters = applyParameters(session, all,
        ({ node, name }, reason) => setNotice((before) => `${before} ${texts.layout.linkRefused(name, node, reason)}`.trim().slice(0, MOST_NOTICE)));
    };
    const read = (): void => {
      const fields = readFragment(location.hash);
      const found = linked(embed);
      const parts: string[] = [];
      if (fields.has('layout') && found.layout === null) parts.push(texts.layout.linkBroken);
      if (found.leftOut.length > 0) parts.push(texts.layout.linkLeftOut(found.leftOut));
      const own = new Set(changedFiles(session));
      const foreign = (fields.get('changed') ?? '').split('\n').filter((file) => file !== '' && !own.has(file));
      if (foreign.length > 0) parts.push(texts.layout.linkChanged(foreign.join(', ').slice(0, MOST_NAMED)));
      setNotice(parts.join(' '));
      const params = fields.get('params');
      if (params !== null) void parameters(params);
      const site = fields.get('site');
      if (site === null) return;
      void siteHash().then((hash) => {
        if (!current || hash === null || hash === site) return;
        setNotice((before) => [texts.layout.linkOther, before].join(' ').trim());
      });
    };
    const follow = (): void => {
      const found = linked(embed);
      if (found.layout !== null) apply(found.layout);
      read();
    };
    read();
    addEventListener('hashchange', follow);
    return () => {
      current = false;
      endParameters();
      removeEventListener('hashchange', follow);
    };
  }, []);
  return { notice, dismiss: () => setNotice('') };
}
