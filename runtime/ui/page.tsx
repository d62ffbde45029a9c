// The page of a running site: header, columns of panels, and one announcer. Chooses how panels are laid
// out for the room there is: three columns, two, or one with tabs.

import { useCallback, useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Session } from '../wasm_js/session.ts';
import { AboutDialog } from './parts/about_dialog.tsx';
import { Boundary } from './parts/boundary.tsx';
import { PageHeader } from './parts/header.tsx';
import { Icon } from './parts/icon.tsx';
import { LazyPanel } from './parts/lazy_panel.tsx';
import { Splitter } from './parts/splitter.tsx';
import { useNodes, useMedia } from './parts/watch.ts';
import { readNumber, writePreference } from './model/preferences.ts';
import type { Store } from './model/preferences.ts';
import { panels } from './panels/index.ts';
import type { NodeFocus, PanelProps, PanelRow } from './panels/panel_props.ts';
import { texts } from './texts.ts';

const kLeft = { minimum: 208, maximum: 480, usual: 240 };
const kRight = { minimum: 256, maximum: 640, usual: 320 };

export interface PageProps {
  readonly offline: boolean | null;
  readonly session: Session;
  readonly store: Store | null;
}

export function Page({ session, store, offline }: PageProps) {
  const wide = useMedia('(min-width: 78rem)');
  const middling = useMedia('(min-width: 46rem)');
  const [focusId, setFocusId] = useState<string | null>(null);
  const [tab, setTab] = useState('console');
  const [aboutOpen, setAboutOpen] = useState(false);
  const [said, setSaid] = useState('');
  const announce = useCallback((text: string) => setSaid(text), []);
  useNodeNews(session, announce);
  // Also while no panel shows them: a topic opened later has its last message.
  useEffect(() => session.onTopics(() => undefined), [session]);

  const narrow = !middling;
  const focus = useMemo<NodeFocus>(
    () => ({
      id: focusId,
      set: (id) => {
        setFocusId(id);
        if (id !== null && narrow) setTab('console');
      },
    }),
    [focusId, narrow],
  );
  const shared: PanelProps = { session, focus, store, announce };
  const show = (row: PanelRow) => (
    <Boundary key={row.id} title={row.title} announce={announce}>
      <LazyPanel row={row} panel={shared} />
    </Boundary>
  );
  const at = (place: PanelRow['place']) => panels.filter((row) => row.place === place).map(show);
  const toConsole = (event: Event): void => {
    event.preventDefault();
    if (narrow) setTab('console');
    requestAnimationFrame(() => document.getElementById('panel-console')?.focus());
  };

  return (
    <div class="page">
      <a class="skip" href="#content" onClick={toConsole}>
        {texts.skipToConsole}
      </a>
      <PageHeader session={session} store={store} onAbout={() => setAboutOpen(true)} />
      {narrow ? (
        <Tabs tab={tab} onTab={setTab} show={show} />
      ) : (
        <Columns
          wide={wide}
          store={store}
          left={at('left')}
          middle={at('middle')}
          right={at('right')}
        />
      )}
      <AboutDialog
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

interface ColumnsProps {
  readonly wide: boolean;
  readonly store: Store | null;
  readonly left: preact.ComponentChildren;
  readonly middle: preact.ComponentChildren;
  readonly right: preact.ComponentChildren;
}

function Columns({ wide, store, left, middle, right }: ColumnsProps) {
  const [leftWidth, setLeftWidth] = useState(() =>
    readNumber(store, 'leftWidth', kLeft.minimum, kLeft.maximum, kLeft.usual),
  );
  const [rightWidth, setRightWidth] = useState(() =>
    readNumber(store, 'rightWidth', kRight.minimum, kRight.maximum, kRight.usual),
  );
  const changeLeft = (width: number): void => {
    setLeftWidth(width);
    writePreference(store, 'leftWidth', String(width));
  };
  const changeRight = (width: number): void => {
    setRightWidth(width);
    writePreference(store, 'rightWidth', String(width));
  };
  const leftBar = (
    <Splitter
      label={texts.resizeLeft}
      value={leftWidth}
      {...kLeft}
      side="left"
      onChange={changeLeft}
    />
  );
  if (!wide) {
    return (
      <main id="content" class="columns columns-two" style={{ '--left': `${leftWidth}px` }}>
        <div class="column">
          {left}
          {right}
        </div>
        {leftBar}
        <div class="column">{middle}</div>
      </main>
    );
  }
  return (
    <main
      id="content"
      class="columns columns-three"
      style={{ '--left': `${leftWidth}px`, '--right': `${rightWidth}px` }}
    >
      <div class="column">{left}</div>
      {leftBar}
      <div class="column">{middle}</div>
      <Splitter
        label={texts.resizeRight}
        value={rightWidth}
        {...kRight}
        side="right"
        onChange={changeRight}
      />
      <div class="column">{right}</div>
    </main>
  );
}

interface TabsProps {
  readonly tab: string;
  readonly onTab: (id: string) => void;
  readonly show: (row: PanelRow) => preact.ComponentChildren;
}

function Tabs({ tab, onTab, show }: TabsProps) {
  const bar = useRef<HTMLDivElement>(null);
  const current = panels.find((row) => row.id === tab) ?? panels[0];
  const onKeyDown = (event: KeyboardEvent): void => {
    const index = panels.findIndex((row) => row.id === current?.id);
    const targets: Readonly<Record<string, number>> = {
      ArrowLeft: (index + panels.length - 1) % panels.length,
      ArrowRight: (index + 1) % panels.length,
      Home: 0,
      End: panels.length - 1,
    };
    const target = panels[targets[event.key] ?? -1];
    if (target !== undefined) {
      event.preventDefault();
      onTab(target.id);
      bar.current?.querySelector<HTMLElement>(`#tab-${target.id}`)?.focus();
    }
  };
  return (
    <main id="content" class="tab-main">
      <div class="tabs" role="tablist" aria-label={texts.panelTabs} ref={bar} onKeyDown={onKeyDown}>
        {panels.map((row) => (
          <button
            type="button"
            role="tab"
            id={`tab-${row.id}`}
            aria-selected={row.id === current?.id}
            aria-controls="tab-panel"
            tabIndex={row.id === current?.id ? 0 : -1}
            onClick={() => onTab(row.id)}
          >
            <Icon name={row.icon} />
            {row.title}
          </button>
        ))}
      </div>
      <div
        class="tab-panel"
        role="tabpanel"
        id="tab-panel"
        aria-labelledby={`tab-${current?.id ?? ''}`}
      >
        {current === undefined ? null : show(current)}
      </div>
    </main>
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
