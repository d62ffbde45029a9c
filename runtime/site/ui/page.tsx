// The page of a running site: header, the dock with its panels, and one announcer.

import { useCallback, useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Session } from '../contract/session.ts';
import type { AboutDialogProps } from './parts/about_dialog.tsx';
import { Boundary } from './parts/boundary.tsx';
import { IconButton } from './parts/button.tsx';
import { Dock } from './parts/dock.tsx';
import { tabTitle } from './parts/tab_title.ts';
import { watchDrops } from './parts/dropped_files.ts';
import { PageHeader } from './parts/header.tsx';
import { useLayoutItems } from './parts/layout_menu.tsx';
import { LazyPanel } from './parts/lazy_panel.tsx';
import { OpenPanel } from './parts/panel.tsx';
import { EmbedFoot, useEmbedHost, useEmbedTheme } from './parts/embed_foot.tsx';
import { SourceLinksContext, sourceLinks } from './parts/source_links.ts';
import { useFocus } from './parts/use_focus.ts';
import { useLoaded } from './parts/use_loaded.ts';
import { useLayout } from './parts/use_layout.ts';
import { useVisitorTopics } from './parts/use_visitor_topics.ts';
import type { VisitorLinksProps } from './parts/visitor_links.tsx';
import { useNodes, useMedia } from './parts/watch.ts';
import type { EmbedView } from './model/embed_link.ts';
import { tabsOf } from './model/layout.ts';
import type { PanelTab } from './model/layout.ts';
import type { Store } from './model/preferences.ts';
import { panelRow } from './panels/index.ts';
import type { NodeFocus } from './panels/panel_props.ts';
import { texts } from './texts.ts';

export interface PageProps {
  readonly offline: boolean | null;
  readonly session: Session;
  readonly store: Store | null;
  /** null: a page of its own. */
  readonly embed: EmbedView | null;
}

export function Page({ session, store, offline, embed }: PageProps) {
  const wide = useMedia('(min-width: 78rem)');
  const narrow = !useMedia('(min-width: 46rem)');
  const [focusId, setFocusId] = useState<string | null>(null);
  const [aboutOpen, setAboutOpen] = useState(false);
  const [said, setSaid] = useState('');
  const announce = useCallback((text: string) => setSaid(text), []);
  const giveFocus = useFocus();
  const control = useLayout(session, embed === null ? store : null, wide || narrow, narrow, announce, embed);
  useEmbedHost(embed, session, store);
  useEmbedTheme(embed, store, session.site.ui['theme']);
  useNodeNews(session, announce);
  useTaskNews(session, store, announce);
  const tabs = useMemo(() => tabsOf(control.layout.root), [control.layout]);

  const { open } = control;
  const newestOpen = useRef(open);
  newestOpen.current = open;
  useEffect(
    () => (embed === null ? watchDrops(() => newestOpen.current(null, 'bag')) : undefined),
    [embed],
  );
  const focus = useMemo<NodeFocus>(
    () => ({
      id: focusId,
      set: (id) => {
        setFocusId(id);
        if (id !== null) open(null, 'console');
      },
    }),
    [focusId, open],
  );
  const sources = useMemo(() => sourceLinks(session, (panel, state) => open(null, panel, state)), [session, open]);
  const layoutItems = useLayoutItems(control, store, announce);
  const show = (tab: PanelTab) => {
    const row = panelRow(tab.panel);
    if (row === undefined) return null;
    const title = tabTitle(tab);
    return (
      <Boundary title={title} announce={announce}>
        <OpenPanel.Provider value={{ key: tab.key, title }}>
          <LazyPanel
            row={row}
            panel={{
              session,
              focus,
              store,
              announce,
              instance: tab.key,
              state: tab.state,
              justAdded: control.justAdded(tab.key),
              setState: (state) => control.setState(tab.key, state),
              open: (panel, state) => control.open(tab.key, panel, state),
            }}
          />
        </OpenPanel.Provider>
      </Boundary>
    );
  };
  const toConsole = (event: Event): void => {
    event.preventDefault();
    open(null, 'console');
    giveFocus('panel-console');
  };

  return (
    <div class={embed === null ? 'page' : 'page page-embedded'}>
      {embed === null
        ? (
          <>
            <a class="skip" href="#content" onClick={toConsole}>
              {texts.skipToConsole}
            </a>
            <PageHeader
              session={session}
              store={store}
              narrow={narrow}
              layoutItems={layoutItems}
              onAbout={() => setAboutOpen(true)}
            />
          </>
        )
        : null}
      {control.notice === '' ? null : (
        <div class="notice" role="region" aria-label={texts.layout.notice}>
          <p>{control.notice}</p>
          <IconButton icon="close" label={texts.layout.dismiss} onClick={control.dismiss} />
        </div>
      )}
      <Visitor session={session} tabs={tabs} open={embed === null ? (panel, state) => void control.open(null, panel, state) : null} />
      <SourceLinksContext.Provider value={sources}>
        <Dock control={control} narrow={narrow} bare={embed !== null} show={show} />
      </SourceLinksContext.Provider>
      {embed === null ? null : <EmbedFoot site={session.site} whole={control.whole} />}
      <About
        session={session}
        open={aboutOpen}
        offline={offline}
        onClose={() => setAboutOpen(false)}
        announce={announce}
      />
      <div class="visually-hidden" role="status">
        {said}
      </div>
    </div>
  );
}

/** Says aloud when a node crashes or fails: what a sighted visitor notices by its colour. */
function useNodeNews(session: Session, announce: (text: string) => void): void {
  const nodes = useNodes(session);
  const known = useRef(new Map<string, string>());
  useEffect(() => {
    for (const node of nodes) {
      const before = known.current.get(node.id);
      known.current.set(node.id, node.state.kind);
      if (before === undefined || before === node.state.kind) continue;
      if (node.state.kind === 'crashed')
        announce(texts.state.announceCrash(node.label, node.state.message));
      if (node.state.kind === 'exited' && node.state.code !== 0)
        announce(texts.state.announceExit(node.label, node.state.code));
    }
  }, [nodes, announce]);
}

/** Keeps what is done of the tasks, and says it aloud, also while their panel is closed. The code comes with tasks only. */
function useTaskNews(session: Session, store: Store | null, announce: (text: string) => void): void {
  useEffect(() => {
    if (session.tasks === undefined) return undefined;
    let stop: (() => void) | null = () => undefined;
    void import('./parts/task_desk.ts').then(({ taskDesk }) => {
      if (stop !== null) stop = taskDesk(session, store).onNews(announce);
    });
    return () => {
      stop?.();
      stop = null;
    };
  }, [session, store, announce]);
}

/** The links of nodes with the visitor. The code comes with the first topic for it. */
function Visitor(props: VisitorLinksProps) {
  const code = useLoaded(useVisitorTopics(props.session), () => import('./parts/visitor_links.tsx'));
  return code === null ? null : <code.VisitorLinks {...props} />;
}

/** Its code comes when it is first opened. */
function About(props: AboutDialogProps) {
  const code = useLoaded(props.open, () => import('./parts/about_dialog.tsx'));
  return code === null ? null : <code.AboutDialog {...props} />;
}
