// Draws a layout: rows and columns with bars between them, and groups of tabs. On a narrow screen all tabs stand in
// one group. Panels behind another are not there, but those that go on (PanelRow.keeps) once they were seen, and those
// that gather what comes (PanelRow.collects) once the first view is drawn.

import { Fragment } from 'preact';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { whenIdle } from '../../contract/idle.ts';
import { groupsOf, makeGroup, tabsOf } from '../model/layout.ts';
import type { Group, Layout, Pane, PanelTab, Split } from '../model/layout.ts';
import { panelRow } from '../panels/index.ts';
import { texts } from '../texts.ts';
import { PanelInSight } from './panel.tsx';
import { Splitter } from './splitter.tsx';
import { TabStrip } from './tab_strip.tsx';
import { tabTitle } from './tab_title.ts';
import { useTabDrag } from './tab_drag.ts';
import type { LayoutControl } from './use_layout.ts';

export interface DockProps {
  readonly control: LayoutControl;
  readonly narrow: boolean;
  /** Panels only: tabs where there are several in one place, and nothing to change them. */
  readonly bare?: boolean;
  readonly show: (tab: PanelTab) => ComponentChildren;
}

export function Dock({ control, narrow, bare = false, show }: DockProps) {
  const { layout } = control;
  const drag = useTabDrag(control.move);
  const collects = useFirstViewDrawn();
  const shared = { control, show, narrow, bare, collects, beginDrag: narrow || bare ? null : drag.begin };
  return (
    <main id="content" class={`dock ${narrow ? 'dock-narrow' : control.large === null ? '' : 'dock-large'}`}>
      {narrow
        ? (
          <GroupView {...shared} group={oneGroup(layout)} />
        )
        : (
          <PaneView {...shared} pane={layout.root} />
        )}
      {drag.view?.target == null ? null : (
        <div
          class="dock-drop"
          style={{
            left: `${drag.view.box.left}px`,
            top: `${drag.view.box.top}px`,
            width: `${drag.view.box.width}px`,
            height: `${drag.view.box.height}px`,
          }}
        />
      )}
    </main>
  );
}

/** Has the first view been drawn, and the page nothing more urgent to do? */
function useFirstViewDrawn(): boolean {
  const [drawn, setDrawn] = useState(false);
  useEffect(() => {
    let current = true;
    const wait = (): void => whenIdle(() => current && setDrawn(true));
    if (document.readyState === 'complete') wait();
    else addEventListener('load', wait, { once: true });
    return () => {
      current = false;
      removeEventListener('load', wait);
    };
  }, []);
  return drawn;
}

interface ViewProps {
  readonly control: LayoutControl;
  readonly narrow: boolean;
  readonly bare: boolean;
  /** Panels that gather what comes are there by now. */
  readonly collects: boolean;
  readonly show: (tab: PanelTab) => ComponentChildren;
  readonly beginDrag: ((key: string, event: PointerEvent) => void) | null;
}

function PaneView({ pane, ...shared }: ViewProps & { readonly pane: Pane; }) {
  return pane.kind === 'group'
    ? (
      <GroupView {...shared} group={pane} />
    )
    : (
      <SplitView {...shared} split={pane} />
    );
}

function SplitView({ split, ...shared }: ViewProps & { readonly split: Split; }) {
  return (
    <div class={`split split-${split.kind}`}>
      {split.children.map((child, index) => {
        const size = split.sizes[index] ?? 0;
        const before = split.children[index - 1];
        const both = size + (split.sizes[index - 1] ?? 0);
        return (
          <Fragment key={child.key}>
            {before === undefined ? null : (
              <Splitter
                label={texts.layout.border(paneTitle(before), paneTitle(child))}
                kind={split.kind}
                value={1 - size / both}
                onChange={(first) => shared.control.resize(split.key, index - 1, first)}
              />
            )}
            <div class="split-part" style={{ flexGrow: String(size * 1000) }}>
              <PaneView {...shared} pane={child} />
            </div>
          </Fragment>
        );
      })}
    </div>
  );
}

function GroupView({ group, control, narrow, bare, collects, show, beginDrag }: ViewProps & { readonly group: Group; }) {
  const seen = useRef(new Set<string>());
  seen.current.add(group.front);
  const drawn = group.tabs.filter((tab) => {
    const row = panelRow(tab.panel);
    return tab.key === group.front || (row?.keeps === true && seen.current.has(tab.key)) || (collects && row?.collects?.(tab.state) === true);
  });
  const strip = !bare || group.tabs.length > 1;
  return (
    <div class={`group ${control.large === group.key && !narrow ? 'group-large' : ''}`} data-group={group.key}>
      {strip
        ? (
          <TabStrip group={group} control={control} narrow={narrow} bare={bare} beginDrag={beginDrag} />
        )
        : null}
      {group.tabs.length === 0 ? <p class="hint group-empty">{texts.layout.empty}</p> : null}
      {drawn.map((tab) => (
        <div
          key={tab.key}
          class="tab-panel"
          role={strip ? 'tabpanel' : undefined}
          id={`tab-panel-${tab.key}`}
          aria-labelledby={strip ? `tab-${tab.key}` : undefined}
          hidden={tab.key !== group.front}
        >
          <PanelInSight.Provider value={tab.key === group.front}>{show(tab)}</PanelInSight.Provider>
        </div>
      ))}
    </div>
  );
}

/** All tabs behind each other, for a narrow screen. New ones go where there is the most room. */
function oneGroup(layout: Layout): Group {
  const key = groupsOf(layout.root)[0]?.key ?? '';
  return makeGroup(key, tabsOf(layout.root), layout.front);
}

function paneTitle(pane: Pane): string {
  const titles = groupsOf(pane).map((group) => {
    const front = group.tabs.find((tab) => tab.key === group.front);
    return front === undefined ? texts.layout.nothing : tabTitle(front);
  });
  return titles.join(', ');
}
