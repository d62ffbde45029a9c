// The head of a group: its tabs, what else can be opened, and what can be done with the tab in front: everything that
// dragging does, by keyboard.

import { useLayoutEffect, useRef } from 'preact/hooks';
import { groupsOf } from '../model/layout.ts';
import type { Group } from '../model/layout.ts';
import { offeredPanels, panelRow } from '../panels/index.ts';
import { texts } from '../texts.ts';
import { IconButton } from './button.tsx';
import { Icon } from './icon.tsx';
import { MenuButton } from './menu.tsx';
import type { MenuItem } from './menu.tsx';
import { tabTitle } from './tab_title.ts';
import type { LayoutControl } from './use_layout.ts';

export interface TabStripProps {
  readonly group: Group;
  readonly control: LayoutControl;
  readonly narrow: boolean;
  /** Tabs only. */
  readonly bare: boolean;
  readonly beginDrag: ((key: string, event: PointerEvent) => void) | null;
}

export function TabStrip({ group, control, narrow, bare, beginDrag }: TabStripProps) {
  const bar = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    // Only the strip scrolls: scrollIntoView would move the page as well.
    const strip = bar.current;
    const tab = strip?.querySelector<HTMLElement>('[aria-selected="true"]');
    if (strip === null || tab === null || tab === undefined) return;
    const [left, right] = [tab.offsetLeft, tab.offsetLeft + tab.offsetWidth];
    if (left < strip.scrollLeft) strip.scrollLeft = left;
    else if (right > strip.scrollLeft + strip.clientWidth)
      strip.scrollLeft = right - strip.clientWidth;
    showEnds(strip);
  });
  useLayoutEffect(() => {
    const strip = bar.current;
    if (strip === null) return undefined;
    const watch = new ResizeObserver(() => showEnds(strip));
    watch.observe(strip);
    return () => watch.disconnect();
  }, [group.tabs.length === 0]);
  /** A mouse has one wheel only. */
  const onWheel = (event: WheelEvent): void => {
    const strip = bar.current;
    if (strip === null || strip.scrollWidth <= strip.clientWidth || event.deltaX !== 0) return;
    event.preventDefault();
    strip.scrollLeft += event.deltaY;
  };
  const at = group.tabs.findIndex((tab) => tab.key === group.front);
  const onKeyDown = (event: KeyboardEvent): void => {
    const count = group.tabs.length;
    const targets: Readonly<Record<string, number>> = {
      ArrowLeft: (at + count - 1) % count,
      ArrowRight: (at + 1) % count,
      Home: 0,
      End: count - 1,
    };
    if (event.key === 'Delete') {
      event.preventDefault();
      if (!bare) control.close(group.front);
      return;
    }
    const target = group.tabs[targets[event.key] ?? -1];
    if (target === undefined) return;
    event.preventDefault();
    control.reveal(target.key);
    bar.current?.querySelector<HTMLElement>(`#tab-${target.key}`)?.focus();
  };
  const front = group.tabs[at];
  return (
    <div class="strip">
      {group.tabs.length === 0 ? null : (
        <div
          class="tabs"
          role="tablist"
          aria-label={texts.panelTabs}
          ref={bar}
          onKeyDown={onKeyDown}
          onWheel={onWheel}
          onScroll={(event) => showEnds(event.currentTarget)}
        >
          {group.tabs.map((tab) => (
            <button
              key={tab.key}
              type="button"
              role="tab"
              id={`tab-${tab.key}`}
              aria-selected={tab.key === group.front}
              aria-controls={tab.key === group.front ? `tab-panel-${tab.key}` : undefined}
              tabIndex={tab.key === group.front ? 0 : -1}
              onClick={() => control.reveal(tab.key)}
              onAuxClick={(event) => {
                if (event.button === 1 && !bare) control.close(tab.key);
              }}
              onPointerDown={(event) => beginDrag?.(tab.key, event)}
            >
              <Icon name={panelRow(tab.panel)?.icon ?? 'info'} />
              {tabTitle(tab)}
            </button>
          ))}
        </div>
      )}
      {bare ? null : (
        <div class="strip-tools">
          {control.large === group.key && !narrow
            ? (
              <IconButton icon="fit" pressed label={texts.layout.restore} onClick={() => control.enlarge(null)} />
            )
            : null}
          <MenuButton icon="plus" label={texts.layout.add} search={texts.layout.search} items={panelItems(group, control)} />
          {front === undefined ? null : (
            <MenuButton
              icon="more"
              label={texts.layout.more(tabTitle(front))}
              items={tabItems(group, at, control, narrow)}
            />
          )}
        </div>
      )}
    </div>
  );
}

/** Marks the ends behind which there are more tabs: they fade. */
function showEnds(strip: HTMLElement): void {
  strip.classList.toggle('tabs-before', strip.scrollLeft > 1);
  strip.classList.toggle('tabs-after', strip.scrollLeft + strip.clientWidth < strip.scrollWidth - 1);
}

function panelItems(group: Group, control: LayoutControl): readonly MenuItem[] {
  return offeredPanels(control.site).map((row) => ({
    id: row.id,
    words: row.title,
    icon: row.icon,
    group: texts.layout.groups[row.group],
    choose: () => control.add(group.key, row.id),
  }));
}

/** The menu of the tab at `at`. */
function tabItems(
  group: Group,
  at: number,
  control: LayoutControl,
  narrow: boolean,
): readonly MenuItem[] {
  const tab = group.tabs[at];
  if (tab === undefined) return [];
  const words = texts.layout;
  const close: MenuItem = {
    id: 'close',
    words: words.close(tabTitle(tab)),
    icon: 'close',
    choose: () => control.close(tab.key),
  };
  if (narrow) return [close];
  const groups = groupsOf(control.layout.root);
  const here = groups.findIndex((one) => one.key === group.key);
  const to = (id: string, name: string, apart: boolean, target: Parameters<LayoutControl['move']>[1] | null): MenuItem => ({
    id,
    words: name,
    apart,
    disabled: target === null,
    choose: () => {
      if (target !== null) control.move(tab.key, target);
    },
  });
  const within = (index: number) => ({ group: group.key, zone: 'into' as const, index });
  const beside = (zone: 'left' | 'right' | 'above' | 'below') => group.tabs.length > 1 ? { group: group.key, zone } : null;
  const other = (step: number) => {
    const found = groups[here + step];
    return found === undefined ? null : { group: found.key, zone: 'into' as const };
  };
  const large = control.large === group.key;
  return [
    close,
    {
      id: 'large',
      words: large ? words.restore : words.enlarge,
      icon: 'fit',
      disabled: groups.length < 2,
      choose: () => control.enlarge(large ? null : group.key),
    },
    to('earlier', words.moveEarlier, true, at > 0 ? within(at - 1) : null),
    to('later', words.moveLater, false, at < group.tabs.length - 1 ? within(at + 2) : null),
    to('previous', words.movePrevious, false, other(-1)),
    to('next', words.moveNext, false, other(1)),
    to('left', words.splitLeft, true, beside('left')),
    to('right', words.splitRight, false, beside('right')),
    to('above', words.splitAbove, false, beside('above')),
    to('below', words.splitBelow, false, beside('below')),
    ...groups
      .filter((one) => one.key !== group.key)
      .flatMap((one, index) => {
        const front = one.tabs.find((candidate) => candidate.key === one.front);
        if (front === undefined) return [];
        const name = tabTitle(front);
        return [
          to(`right-${one.key}`, words.besideOther(name), index === 0, {
            group: one.key,
            zone: 'right',
          }),
          to(`below-${one.key}`, words.belowOther(name), false, { group: one.key, zone: 'below' }),
        ];
      }),
  ];
}
