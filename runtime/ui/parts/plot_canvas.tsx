// Draws samples with uPlot: over time, or the first series against the others. It asks for the samples when it draws,
// at most 20 times per second.

import uPlot from 'uplot';
import { useEffect, useRef } from 'preact/hooks';
import { extentOf, padded } from '../model/plot_svg.ts';
import { aligned } from '../model/samples.ts';
import type { NamedSamples } from '../model/samples.ts';

export type PlotMode = 'time' | 'xy';

/** What part of time is drawn, in seconds since 1970. */
export interface TimeRange {
  readonly least: number;
  readonly most: number;
}

export interface PlotSource {
  /** Changes when there is something new to draw. */
  readonly version: number;
  readonly series: readonly NamedSamples[];
  readonly range: TimeRange;
  /** Second zero of the time axis. */
  readonly origin: number;
}

export interface PlotCanvasProps {
  readonly mode: PlotMode;
  readonly count: number;
  readonly label: string;
  /** Changes with the colours of the page. */
  readonly theme: string;
  readonly source: () => PlotSource;
  readonly onZoom: (range: TimeRange) => void;
  /** Receives a function that gives the drawing's canvas. */
  readonly canvas: { current: HTMLCanvasElement | null };
}

const kLeastPauseMs = 50;

export function PlotCanvas({ mode, count, label, theme, source, onZoom, canvas }: PlotCanvasProps) {
  const host = useRef<HTMLDivElement>(null);
  const latest = useRef({ source, onZoom });
  latest.current = { source, onZoom };

  useEffect(() => {
    const box = host.current;
    if (box === null || count === 0) return undefined;
    const colors = colorsOf(box);
    let shown: PlotSource = latest.current.source();
    let extents = { x: { least: 0, most: 1 }, y: { least: 0, most: 1 } };
    const plot = new uPlot(
      {
        width: Math.max(80, box.clientWidth),
        height: Math.max(60, box.clientHeight),
        legend: { show: false },
        cursor: { drag: { x: mode === 'time', y: false, setScale: false }, y: mode === 'xy' },
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
              const { left, width } = self.select;
              if (width < 4) return;
              const least = self.posToVal(left, 'x') + shown.origin;
              const most = self.posToVal(left + width, 'x') + shown.origin;
              self.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
              latest.current.onZoom({ least, most });
            },
          ],
          draw: mode === 'xy' ? [(self) => drawPairs(self, shown, colors.lines)] : [],
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
          y: padded(extentOf(seen(times, columns, shown.range.most))),
        };
        plot.setData([times.map((time) => time - shown.origin), ...columns.map((column) => [...column])]);
      } else {
        const pairs = pairsOf(shown).flat();
        extents = {
          x: padded(extentOf(pairs.map(([x]) => x))),
          y: padded(extentOf(pairs.map(([, y]) => y))),
        };
        plot.setData([[extents.x.least, extents.x.most], [null, null]]);
      }
    };

    let version = Number.NaN;
    let drawnAt = 0;
    let frame = 0;
    const tick = (now: number): void => {
      frame = requestAnimationFrame(tick);
      const next = latest.current.source().version;
      if (next === version || now - drawnAt < kLeastPauseMs || box.clientWidth === 0) return;
      version = next;
      drawnAt = now;
      redraw();
    };
    frame = requestAnimationFrame(tick);
    const resized = new ResizeObserver(() => {
      if (box.clientWidth > 0)
        plot.setSize({ width: box.clientWidth, height: Math.max(60, box.clientHeight) });
    });
    resized.observe(box);
    return () => {
      cancelAnimationFrame(frame);
      resized.disconnect();
      canvas.current = null;
      plot.destroy();
    };
  }, [mode, count, theme]);

  return <div class="plot-canvas" role="img" aria-label={label} ref={host} />;
}

/** Points of each series against the first one, whose value holds until its next. */
export function pairsOf({ series, range }: PlotSource): readonly (readonly [number, number])[][] {
  const [first, ...others] = series;
  if (first === undefined) return [];
  return others.map(({ samples }) => {
    const points: [number, number][] = [];
    for (let i = samples.from(range.least); i < samples.length; i += 1) {
      const time = samples.time(i);
      if (time > range.most) break;
      points.push([first.samples.valueAt(time), samples.value(i)]);
    }
    return points;
  });
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
function colorsOf(box: HTMLElement): { text: string; line: string; lines: readonly string[] } {
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
