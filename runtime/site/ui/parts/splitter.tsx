// The bar between two neighbours: drag it, use the arrow keys on it, or double-click for equal parts.

import { useRef } from 'preact/hooks';

export interface SplitterProps {
  readonly label: string;
  /** How the neighbours stand: side by side, or below each other. */
  readonly kind: 'row' | 'column';
  /** The first one's part of both, 0 to 1. */
  readonly value: number;
  readonly onChange: (value: number) => void;
}

const STEP = 16;
const LEAST = 96;

export function Splitter({ label, kind, value, onChange }: SplitterProps) {
  const drag = useRef<{ readonly at: number; readonly first: number; } | null>(null);
  const across = kind === 'row';

  /** The sizes of both neighbours in px. */
  const sizes = (bar: Element): { first: number; both: number; } => {
    const length = (element: Element | null): number => {
      const box = element?.getBoundingClientRect();
      return (across ? box?.width : box?.height) ?? 0;
    };
    const first = length(bar.previousElementSibling);
    return { first, both: first + length(bar.nextElementSibling) };
  };
  const set = (bar: Element, first: number): void => {
    const { both } = sizes(bar);
    if (both === 0) return;
    const least = Math.min(LEAST, both / 2);
    onChange(Math.min(both - least, Math.max(least, first)) / both);
  };

  const onKeyDown = (event: KeyboardEvent): void => {
    const bar = event.currentTarget;
    if (!(bar instanceof Element)) return;
    const { first, both } = sizes(bar);
    const next: Readonly<Record<string, number>> = {
      [across ? 'ArrowLeft' : 'ArrowUp']: first - STEP,
      [across ? 'ArrowRight' : 'ArrowDown']: first + STEP,
      Home: 0,
      End: both,
      Enter: both / 2,
    };
    const wanted = next[event.key];
    if (wanted === undefined) return;
    event.preventDefault();
    set(bar, wanted);
  };
  const stop = (): void => {
    drag.current = null;
  };

  return (
    <div
      class={`splitter splitter-${kind}`}
      role="separator"
      tabIndex={0}
      aria-orientation={across ? 'vertical' : 'horizontal'}
      aria-label={label}
      aria-valuenow={Math.round(value * 100)}
      aria-valuemin={0}
      aria-valuemax={100}
      onKeyDown={onKeyDown}
      onDblClick={(event) => {
        const bar = event.currentTarget;
        set(bar, sizes(bar).both / 2);
      }}
      onPointerDown={(event) => {
        const bar = event.currentTarget;
        bar.setPointerCapture(event.pointerId);
        drag.current = { at: across ? event.clientX : event.clientY, first: sizes(bar).first };
      }}
      onPointerMove={(event) => {
        const { current } = drag;
        if (current === null) return;
        const at = across ? event.clientX : event.clientY;
        set(event.currentTarget, current.first + at - current.at);
      }}
      onPointerUp={stop}
      onPointerCancel={stop}
    />
  );
}
