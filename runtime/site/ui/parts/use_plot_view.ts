// The part of a plot that is seen, by pointer and by keys, and the moment whose values are told: where the pointer is,
// or else what the keys have chosen.

import { useRef, useState } from 'preact/hooks';
import type { Extent } from '../model/plot_svg.ts';
import { momentBeside, momentNear, movedExtent, zoomedExtent } from '../model/plot_view.ts';
import type { NamedSamples } from '../model/samples.ts';

export type PlotMode = 'time' | 'xy';

/** The part of time that is drawn, in seconds since 1970. */
export interface TimeRange {
  readonly least: number;
  readonly most: number;
}

/** The meaning of x in a plot: time, or the first series. */
export interface PlotWindow {
  readonly x: Extent;
  readonly y: Extent;
}

export interface PlotViewOptions {
  readonly mode: PlotMode;
  readonly series: () => readonly NamedSamples[];
  /** The time that is drawn while nothing is held. */
  readonly following: () => TimeRange;
  /** Called when the plot must be drawn again. */
  readonly changed: () => void;
  /** A moment was chosen by keys. */
  readonly told: (moment: number) => void;
}

export interface PlotView {
  /** Time stands still there; null: it follows what comes. */
  readonly held: TimeRange | null;
  /** The zoomed part; null: all values are seen. */
  readonly x: Extent | null;
  readonly y: Extent | null;
  readonly moment: number | null;
  /** Written by who draws. */
  readonly seen: { current: PlotWindow; };
  readonly hold: (range: TimeRange | null) => void;
  readonly select: (part: { readonly x: Extent | null; readonly y: Extent | null; }) => void;
  readonly whole: () => void;
  readonly point: (moment: number | null) => void;
  readonly onKeyDown: (event: KeyboardEvent) => void;
}

const ZOOM = 1.5;
const MOVE = 0.2;
const MANY_SAMPLES = 10;

export function usePlotView({ mode, series, following, changed, told }: PlotViewOptions): PlotView {
  const [held, setHeld] = useState<TimeRange | null>(null);
  const [x, setX] = useState<Extent | null>(null);
  const [y, setY] = useState<Extent | null>(null);
  const [near, setNear] = useState<number | null>(null);
  const [chosen, setChosen] = useState<number | null>(null);
  const seen = useRef<PlotWindow>({ x: { least: 0, most: 1 }, y: { least: 0, most: 1 } });

  const hold = (range: TimeRange | null): void => {
    setHeld(range);
    if (range === null) setChosen(null);
    changed();
  };
  const select: PlotView['select'] = (part) => {
    if (part.x !== null) {
      if (mode === 'time') setHeld(part.x);
      else setX(part.x);
    }
    if (part.y !== null) setY(part.y);
    // The next key may come before it is drawn.
    seen.current = { x: part.x ?? seen.current.x, y: part.y ?? seen.current.y };
    changed();
  };
  const whole = (): void => {
    setX(null);
    setY(null);
    hold(null);
  };
  const choose = (moment: number | null): void => {
    setChosen(moment);
    setNear(null);
    changed();
    if (moment === null) return;
    // The chosen moment must stay visible: the range stops moving, and includes it.
    const range = held ?? following();
    const size = range.most - range.least;
    if (moment < range.least) setHeld({ least: moment, most: moment + size });
    else if (moment > range.most) setHeld({ least: moment - size, most: moment });
    else setHeld(range);
    told(moment);
  };
  const step = (direction: 1 | -1, count: number): void => {
    const range = held ?? following();
    let moment = chosen ?? momentNear(series(), (range.least + range.most) / 2);
    if (chosen !== null) {
      for (let i = 0; i < count && moment !== null; i += 1) {
        const next = momentBeside(series(), moment, direction);
        if (next === null) break;
        moment = next;
      }
    }
    if (moment !== null) choose(moment);
  };
  const zoomX = (factor: number): void => {
    const around = mode === 'time' ? (chosen ?? undefined) : undefined;
    select({ x: zoomedExtent(seen.current.x, factor, around), y: mode === 'time' ? null : zoomedExtent(seen.current.y, factor) });
  };
  const keys: Readonly<Record<string, () => void>> = {
    ArrowLeft: () => step(-1, 1),
    ArrowRight: () => step(1, 1),
    PageUp: () => step(-1, MANY_SAMPLES),
    PageDown: () => step(1, MANY_SAMPLES),
    ArrowUp: () => select({ x: null, y: zoomedExtent(seen.current.y, ZOOM) }),
    ArrowDown: () => select({ x: null, y: zoomedExtent(seen.current.y, 1 / ZOOM) }),
    '+': () => zoomX(ZOOM),
    '=': () => zoomX(ZOOM),
    '-': () => zoomX(1 / ZOOM),
    '0': whole,
    Escape: () => choose(null),
  };
  const shifted: Readonly<Record<string, () => void>> = {
    ArrowLeft: () => select({ x: movedExtent(seen.current.x, -MOVE), y: null }),
    ArrowRight: () => select({ x: movedExtent(seen.current.x, MOVE), y: null }),
    ArrowUp: () => select({ x: null, y: movedExtent(seen.current.y, MOVE) }),
    ArrowDown: () => select({ x: null, y: movedExtent(seen.current.y, -MOVE) }),
  };
  return {
    held,
    x,
    y,
    moment: near ?? chosen,
    seen,
    hold,
    select,
    whole,
    point(moment) {
      if (moment === near) return;
      setNear(moment);
      changed();
    },
    onKeyDown(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === 'Escape' && chosen === null) return;
      const act = (event.shiftKey ? shifted[event.key] : undefined) ?? keys[event.key];
      if (act === undefined) return;
      event.preventDefault();
      act();
    },
  };
}
