// Dragging a tab: where it would fall is shown while the pointer moves, and told to `drop` when it is let go.
// Escape lets it be.

import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import { zoneAt } from '../model/layout.ts';
import type { DropTarget } from '../model/layout.ts';

export interface DragView {
  readonly key: string;
  readonly target: DropTarget | null;
  /** The area that the tab would cover, in px of the window. */
  readonly box: { readonly left: number; readonly top: number; readonly width: number; readonly height: number; };
}

const THRESHOLD = 6;

export interface TabDrag {
  readonly view: DragView | null;
  readonly begin: (key: string, event: PointerEvent) => void;
}

export function useTabDrag(drop: (key: string, target: DropTarget) => void): TabDrag {
  const [view, setView] = useState<DragView | null>(null);
  const end = useRef<() => void>(() => undefined);
  const latest = useRef(drop);
  latest.current = drop;
  useEffect(() => () => end.current(), []);

  const begin = useCallback((key: string, start: PointerEvent): void => {
    if (start.button !== 0) return;
    end.current();
    let seen: DragView | null = null;
    const move = (event: PointerEvent): void => {
      const far = Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY);
      if (seen === null && far < THRESHOLD) return;
      seen = viewAt(key, event.clientX, event.clientY);
      setView(seen);
    };
    const up = (): void => {
      const target = seen?.target ?? null;
      stop();
      if (target !== null) latest.current(key, target);
    };
    const escape = (event: KeyboardEvent): void => {
      if (event.key === 'Escape') stop();
    };
    const stop = (): void => {
      removeEventListener('pointermove', move);
      removeEventListener('pointerup', up);
      removeEventListener('pointercancel', stop);
      removeEventListener('keydown', escape);
      end.current = () => undefined;
      setView(null);
    };
    end.current = stop;
    addEventListener('pointermove', move);
    addEventListener('pointerup', up);
    addEventListener('pointercancel', stop);
    addEventListener('keydown', escape);
  }, []);
  return { view, begin };
}

function viewAt(key: string, x: number, y: number): DragView {
  const none: DragView = { key, target: null, box: { left: x, top: y, width: 0, height: 0 } };
  const element = document.elementFromPoint(x, y)?.closest<HTMLElement>('[data-group]');
  const group = element?.dataset['group'];
  if (element === null || element === undefined || group === undefined) return none;
  const strip = element.querySelector('.strip')?.getBoundingClientRect();
  const box = element.getBoundingClientRect();
  if (strip !== undefined && y < strip.bottom) {
    const tabs = [...element.querySelectorAll('[role="tab"]')].map((tab) => tab.getBoundingClientRect());
    const found = tabs.findIndex((tab) => x < tab.left + tab.width / 2);
    const index = found === -1 ? tabs.length : found;
    const left = tabs[index]?.left ?? tabs.at(-1)?.right ?? strip.left;
    return {
      key,
      target: { group, zone: 'into', index },
      box: { left: left - 2, top: strip.top + 4, width: 4, height: strip.height - 8 },
    };
  }
  const zone = zoneAt(box, x, y);
  const halfWide = zone === 'left' || zone === 'right';
  const halfHigh = zone === 'above' || zone === 'below';
  const width = halfWide ? box.width / 2 : box.width;
  const height = halfHigh ? box.height / 2 : box.height;
  return {
    key,
    target: { group, zone },
    box: {
      left: zone === 'right' ? box.left + width : box.left,
      top: zone === 'below' ? box.top + height : box.top,
      width,
      height,
    },
  };
}
