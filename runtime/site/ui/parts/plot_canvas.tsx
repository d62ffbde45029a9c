// Draws samples with uPlot: over time, or the first series against the others. It asks for the samples when it draws,
// at most 20 times per second.

import uPlot from 'uplot';
import { useEffect, useRef } from 'preact/hooks';
import { extentOf, padded } from '../model/plot_svg.ts';
import type { Extent } from '../model/plot_svg.ts';
import { aligned } from '../model/samples.ts';
import { pairsWith } from '../model/plot_view.ts';
import type { NamedSamples } from '../model/samples.ts';
import type { PlotMode, PlotView, PlotWindow, TimeRange } from './use_plot_view.ts';

export interface PlotSource {
  /** Changes when there is something new to draw. */
  readonly version: number;
  readonly series: readonly NamedSamples[];
  readonly range: TimeRange;
  /** The range of the values that was chosen; null: all of them are visible. */
  readonly x: Extent | null;
  readonly y: Extent | null;
  /** Second zero of the time axis. */
  readonly origin: number;
  /** The values of that time are marked. */
  readonly moment: number | null;
}

export interface PlotCanvasProps {
  readonly mode: PlotMode;
  readonly count: number;
  readonly label: string;
  /** Changes with the colours of the page. */
  readonly theme: string;
  readonly source: () => PlotSource;
  /** The functions that pointer and keys call. */
  readonly view: PlotView;
  /** Receives a function that gives the drawing's canvas. */
  readonly canvas: { current: HTMLCanvasElement | null; };
}

const LEAST_PAUSE_MS = 50;
/** Pixels. A drag that goes less far up and down chooses time alone, and the other way round. */
const ACROSS = 40;
/** Pixels from the pointer to a point of an x-y plot that is meant. */
const NEAR = 40;
const DOT = 3.5;

export function PlotCanvas({ mode, count, label, theme, source, view, canvas }: PlotCanvasProps) {
  const host = useRef<HTMLDivElement>(null);
  const latest = useRef({ source, view });
  latest.current = { source, view };

  useEffect(() => {
    const box = host.current;
    if (box === null || count === 0) return undefined;
    const colors = colorsOf(box);
    let shown: PlotSource = latest.current.source();
    let extents: PlotWindow = { x: { least: 0, most: 1 }, y: { least: 0, most: 1 } };
    const plot = new uPlot(
      {
        width: Math.max(80, box.clientWidth),
        height: Math.max(60, box.clientHeight),
        legend: { show: false },
        cursor: { drag: { x: true, y: true, uni: ACROSS, setScale: false }, y: mode === 'xy', points: { show: false } },
        scales: {
          x: { time: false, range: () => [extents.x.least, extents.x.most] },
          y: { range: () => [extents.y.least, extents.y.most] },
        },
        axes: [0, 1].map((index) => ({
          stroke: colors.text,
          grid: { stroke: colors.line, width: 1 },
          ticks: { stroke: colors.line, width: 1 },
          font: '12px system-ui, sans-serif',
          ...(index === 1 ? { size: 64 } : {}),
        })),
        series: [
          {},
          ...Array.from({ length: mode === 'time' ? count : 1 }, (_, index) => ({
            stroke: colors.lines[index % colors.lines.length] ?? colors.text,
            width: 1.5,
            spanGaps: true,
            show: mode === 'time',
            points: { show: false },
          })),
        ],
        hooks: {
          setSelect: [
            (self) => {
              const { left, top, width, height } = self.select;
              const whole = { width: self.over.clientWidth, height: self.over.clientHeight };
              const shift = mode === 'time' ? shown.origin : 0;
              // A selection along one axis has the whole of the other.
              const x = width < 4 || width >= whole.width ? null : span(self.posToVal(left, 'x') + shift, self.posToVal(left + width, 'x') + shift);
              const y = height < 4 || height >= whole.height ? null : span(self.posToVal(top + height, 'y'), self.posToVal(top, 'y'));
              self.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
              if (x !== null || y !== null) latest.current.view.select({ x, y });
            },
          ],
          setCursor: [
            (self) => {
              const { left = -1, top = -1, idx } = self.cursor;
              const time = left < 0 || idx === null || idx === undefined ? undefined : self.data[0][idx];
              latest.current.view.point(
                left < 0
                  ? null
                  : mode === 'xy'
                  ? nearestMoment(self, shown, left, top)
                  : time === undefined
                  ? null
                  : time + shown.origin,
              );
            },
          ],
          draw: [
            (self) => {
              if (mode === 'xy') drawPairs(self, shown, colors.lines);
              drawMoment(self, shown, mode, colors);
            },
          ],
        },
      },
      [[0], ...Array.from({ length: mode === 'time' ? count : 1 }, () => [null])],
      box,
    );
    canvas.current = plot.ctx.canvas;

    const redraw = (): void => {
      shown = latest.current.source();
      if (mode === 'time') {
        const { times, columns } = aligned(shown.series, shown.range.least);
        extents = {
          x: { least: shown.range.least - shown.origin, most: shown.range.most - shown.origin },
          y: shown.y ?? padded(extentOf(seen(times, columns, shown.range.most))),
        };
        latest.current.view.seen.current = { x: shown.range, y: extents.y };
        plot.setData([times.map((time) => time - shown.origin), ...columns.map((column) => [...column])]);
      } else {
        const pairs = pairsOf(shown).flat();
        extents = {
          x: shown.x ?? padded(extentOf(pairs.map(([x]) => x))),
          y: shown.y ?? padded(extentOf(pairs.map(([, y]) => y))),
        };
        latest.current.view.seen.current = extents;
        plot.setData([[extents.x.least, extents.x.most], [null, null]]);
      }
    };

    let version = Number.NaN;
    let drawnAt = 0;
    let frame = 0;
    const tick = (now: number): void => {
      frame = requestAnimationFrame(tick);
      const next = latest.current.source().version;
      if (next === version || now - drawnAt < LEAST_PAUSE_MS) return;
      version = next;
      drawnAt = now;
      redraw();
    };
    // Behind another tab it has no size, and costs nothing.
    const resized = new ResizeObserver(() => {
      cancelAnimationFrame(frame);
      if (box.clientWidth === 0) return;
      plot.setSize({ width: box.clientWidth, height: Math.max(60, box.clientHeight) });
      frame = requestAnimationFrame(tick);
    });
    resized.observe(box);
    return () => {
      cancelAnimationFrame(frame);
      resized.disconnect();
      canvas.current = null;
      plot.destroy();
    };
  }, [mode, count, theme]);

  return (
    <div
      class="plot-canvas"
      role="application"
      aria-label={label}
      tabIndex={0}
      ref={host}
      onKeyDown={(event) => latest.current.view.onKeyDown(event)}
    />
  );
}

/** Points of each series against the first one, whose value holds until its next. */
export function pairsOf({ series, range }: PlotSource): readonly (readonly [number, number])[][] {
  const [first, ...others] = series;
  if (first === undefined) return [];
  return others.map(({ samples }) => pairsWith(first.samples, samples, range));
}

function drawPairs(plot: uPlot, shown: PlotSource, colors: readonly string[]): void {
  const { ctx } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
  ctx.clip();
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.lineJoin = 'round';
  pairsOf(shown).forEach((points, index) => {
    ctx.strokeStyle = colors[(index + 1) % colors.length] ?? '';
    ctx.beginPath();
    let pen = false;
    for (const [x, y] of points) {
      const good = Number.isFinite(x) && Number.isFinite(y);
      if (good) {
        const at = [plot.valToPos(x, 'x', true), plot.valToPos(y, 'y', true)] as const;
        if (pen) ctx.lineTo(...at);
        else ctx.moveTo(...at);
      }
      pen = good;
    }
    ctx.stroke();
  });
  ctx.restore();
}

function span(least: number, most: number): Extent | null {
  return most > least ? { least, most } : null;
}

/** Where the values of a moment stand, with the number of their series. */
function marksOf(shown: PlotSource, mode: PlotMode, moment: number): readonly { readonly x: number; readonly y: number; readonly series: number; }[] {
  const [first] = shown.series;
  return shown.series.flatMap(({ samples }, series) => {
    if (mode === 'time') return samples.valuesAt(moment).map((y) => ({ x: moment - shown.origin, y, series }));
    if (series === 0 || first === undefined) return [];
    const points = pairsWith(first.samples, samples, { least: moment, most: moment });
    return (points.length > 0 ? points : [[first.samples.valueAt(moment), samples.valueAt(moment)] as const]).map(([x, y]) => ({ x, y, series }));
  });
}

function drawMoment(plot: uPlot, shown: PlotSource, mode: PlotMode, colors: { readonly text: string; readonly lines: readonly string[]; }): void {
  const { moment } = shown;
  if (moment === null) return;
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  if (mode === 'time') {
    const at = plot.valToPos(moment - shown.origin, 'x', true);
    ctx.strokeStyle = colors.text;
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
    ctx.stroke();
  }
  for (const { x, y, series } of marksOf(shown, mode, moment)) {
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    ctx.fillStyle = colors.lines[series % colors.lines.length] ?? colors.text;
    ctx.beginPath();
    ctx.arc(plot.valToPos(x, 'x', true), plot.valToPos(y, 'y', true), DOT * devicePixelRatio, 0, 2 * Math.PI);
    ctx.fill();
  }
  ctx.restore();
}

/** The moment of the point of an x-y plot that is nearest to the pointer; null: none is near. */
function nearestMoment(plot: uPlot, shown: PlotSource, left: number, top: number): number | null {
  const [first, ...others] = shown.series;
  if (first === undefined) return null;
  let [found, best] = [null as number | null, NEAR];
  for (const { samples } of others) {
    const begin = samples.from(shown.range.least);
    pairsWith(first.samples, samples, shown.range).forEach(([x, y], index) => {
      const away = Math.hypot(plot.valToPos(x, 'x') - left, plot.valToPos(y, 'y') - top);
      if (away < best) [found, best] = [samples.time(begin + index), away];
    });
  }
  return found;
}

function seen(
  times: Float64Array,
  columns: readonly (readonly (number | null)[])[],
  most: number,
): readonly number[] {
  const values: number[] = [];
  for (const column of columns) {
    for (let i = 0; i < column.length && (times[i] ?? 0) <= most; i += 1) {
      const value = column[i];
      if (value !== null && value !== undefined) values.push(value);
    }
  }
  return values;
}

/** The colours of the page's theme, as a canvas can use them. */
function colorsOf(box: HTMLElement): { text: string; line: string; lines: readonly string[]; } {
  const probe = document.createElement('span');
  box.append(probe);
  const read = (name: string): string => {
    probe.style.color = `var(${name})`;
    return getComputedStyle(probe).color;
  };
  const colors = {
    text: read('--text-soft'),
    line: read('--line'),
    lines: Array.from({ length: 8 }, (_, index) => read(`--plot-${index + 1}`)),
  };
  probe.remove();
  return colors;
}
