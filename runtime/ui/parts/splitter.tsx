// The bar between two columns: drag it, use the arrow keys on it, or double-click for the usual width.

import { useRef } from 'preact/hooks';

export interface SplitterProps {
  readonly label: string;
  /** Width of the column it belongs to, in px. */
  readonly value: number;
  readonly minimum: number;
  readonly maximum: number;
  readonly usual: number;
  /** On which side of the bar that column is. */
  readonly side: 'left' | 'right';
  readonly onChange: (value: number) => void;
}

const kStep = 16;

export function Splitter({ label, value, minimum, maximum, usual, side, onChange }: SplitterProps) {
  const drag = useRef<{ readonly x: number; readonly value: number } | null>(null);
  const sign = side === 'left' ? 1 : -1;
  const set = (next: number): void =>
    onChange(Math.round(Math.min(maximum, Math.max(minimum, next))));

  const onKeyDown = (event: KeyboardEvent): void => {
    const next: Readonly<Record<string, number>> = {
      ArrowLeft: value - sign * kStep,
      ArrowRight: value + sign * kStep,
      Home: minimum,
      End: maximum,
      Enter: usual,
    };
    const wanted = next[event.key];
    if (wanted !== undefined) {
      event.preventDefault();
      set(wanted);
    }
  };

  return (
    <div
      class="splitter"
      role="separator"
      tabIndex={0}
      aria-orientation="vertical"
      aria-label={label}
      aria-valuenow={value}
      aria-valuemin={minimum}
      aria-valuemax={maximum}
      onKeyDown={onKeyDown}
      onDblClick={() => set(usual)}
      onPointerDown={(event) => {
        if (event.currentTarget instanceof Element)
          event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { x: event.clientX, value };
      }}
      onPointerMove={(event) => {
        if (drag.current !== null)
          set(drag.current.value + sign * (event.clientX - drag.current.x));
      }}
      onPointerUp={() => {
        drag.current = null;
      }}
      onPointerCancel={() => {
        drag.current = null;
      }}
    />
  );
}
