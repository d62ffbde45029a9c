// Numbers of messages over time, or against each other: every message counts, not every frame. Pause, zoom, the values
// at a moment, CSV, SVG and PNG. State: {paths, mode, seconds}.

import { useEffect, useMemo, useReducer, useRef } from 'preact/hooks';
import { asNumber } from '../model/field_path.ts';
import { numberMember, textMember, textsMember } from '../model/json.ts';
import type { Json } from '../model/json.ts';
import { plotSvg } from '../model/plot_svg.ts';
import { Samples, toCsv } from '../model/samples.ts';
import { IconButton } from '../parts/button.tsx';
import { download } from '../parts/download.ts';
import { followPaths } from '../parts/follow_paths.ts';
import { MenuButton } from '../parts/menu.tsx';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { PathList } from '../parts/path_list.tsx';
import { PlotCanvas, pairsOf } from '../parts/plot_canvas.tsx';
import type { PlotSource } from '../parts/plot_canvas.tsx';
import type { PlotMode, TimeRange } from '../parts/use_plot_view.ts';
import { usePlotView } from '../parts/use_plot_view.ts';
import { useTheme } from '../parts/watch.ts';
import { useEvery } from '../parts/while_in_sight.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const CAPACITY = 50_000;
const MOST_PATHS = 16;
const SMALL = 1e-3;
const WORDS_MS = 250;
/** Values of one moment that are written out. */
const MOST_TOGETHER = 8;
const SECONDS = [5, 10, 30, 60, 300, 3600] as const;
const USUAL_SECONDS = 30;

interface PlotOptions {
  readonly paths: readonly string[];
  readonly mode: PlotMode;
  readonly seconds: number;
}

function readOptions(state: Json): PlotOptions {
  return {
    paths: [...new Set(textsMember(state, 'paths', MOST_PATHS))],
    mode: textMember(state, 'mode') === 'xy' ? 'xy' : 'time',
    seconds: numberMember(state, 'seconds', 1, 86_400, USUAL_SECONDS),
  };
}

interface Track {
  readonly samples: Samples;
  problem: string;
}

export function PlotPanel({ session, state, setState, instance, announce }: PanelProps) {
  const options = useMemo(() => readOptions(state), [state]);
  const { paths, mode, seconds } = options;
  const codec = useCodec(session);
  const theme = useTheme();
  const [, redraw] = useReducer<number, void>((n) => n + 1, 0);
  const tracks = useRef(new Map<string, Track>());
  const version = useRef(0);
  const origin = useRef(Number.NaN);
  const canvas = useRef<HTMLCanvasElement | null>(null);

  const change = (next: Partial<PlotOptions>): void => {
    const { paths: list, ...rest } = { ...options, ...next };
    setState({ paths: [...list], ...rest });
    version.current += 1;
  };
  for (const path of tracks.current.keys()) if (!paths.includes(path)) tracks.current.delete(path);
  for (const path of paths)
    if (!tracks.current.has(path))
      tracks.current.set(path, { samples: new Samples(CAPACITY), problem: '' });

  useEffect(() => {
    if (codec === null || typeof codec === 'string') return undefined;
    return followPaths(session, codec, paths, {
      onValue(path, time, value) {
        const track = tracks.current.get(path);
        if (track === undefined) return;
        const number = asNumber(value);
        track.problem = Number.isNaN(number) && typeof value !== 'number' ? panelTexts.paths.noNumber : '';
        if (!(time >= origin.current)) origin.current = time;
        track.samples.add(time, number);
        version.current += 1;
      },
      onProblem(path, problem) {
        const track = tracks.current.get(path);
        if (track !== undefined) track.problem = problem;
      },
      isNew: (path) => tracks.current.get(path)?.samples.length === 0,
    });
  }, [session, codec, paths.join('\n')]);

  // The words beside the names follow at a pace that can be read.
  useEvery(WORDS_MS, redraw);

  const named = paths.flatMap((path) => {
    const track = tracks.current.get(path);
    return track === undefined ? [] : [{ name: path, samples: track.samples }];
  });
  const newest = (): number =>
    Math.max(
      ...named.map(({ samples }) => (samples.length > 0 ? samples.time(samples.length - 1) : -Infinity)),
    );
  const zero = (): number => (Number.isNaN(origin.current) ? 0 : origin.current);
  const following = (): TimeRange => {
    const end = newest();
    // There is nothing before the beginning: the room that is left is for what comes.
    const least = Math.max(zero(), (Number.isFinite(end) ? end : 0) - seconds);
    return { least, most: least + seconds };
  };
  const view = usePlotView({
    mode,
    series: () => named,
    following,
    changed: () => {
      version.current += 1;
    },
    told: (moment) => announce(panelTexts.plot.values(moment - zero(), named.map(({ name, samples }) => [name, momentWords(samples, moment)]))),
  });
  const { held, hold, moment } = view;
  const source = (): PlotSource => ({
    version: version.current,
    series: named,
    range: held ?? following(),
    x: mode === 'xy' ? view.x : null,
    y: view.y,
    origin: zero(),
    moment,
  });
  const save = {
    csv: (): void => download('plot.csv', new Blob([toCsv(named)], { type: 'text/csv' })),
    svg: (): void => download('plot.svg', new Blob([svgOf(source(), mode)], { type: 'image/svg+xml' })),
    png: (): void => {
      if (canvas.current !== null) savePng(canvas.current);
    },
  };
  const longest = SECONDS.some((one) => one === seconds) ? SECONDS : [...SECONDS, seconds];

  return (
    <PanelFrame
      id="plot"
      title={texts.panels.plot}
      icon="plot"
      tools={
        <>
          <IconButton
            icon={held === null ? 'pause' : 'play'}
            label={held === null ? panelTexts.plot.pause : panelTexts.plot.follow}
            onClick={() => hold(held === null ? source().range : null)}
          />
          <IconButton
            icon="fit"
            label={panelTexts.plot.whole}
            disabled={held === null && view.x === null && view.y === null}
            onClick={view.whole}
          />
          <select
            class="select"
            aria-label={panelTexts.plot.range}
            value={String(seconds)}
            onChange={(event) => {
              hold(null);
              change({ seconds: Number(event.currentTarget.value) });
            }}
          >
            {longest.map((one) => (
              <option value={String(one)}>{panelTexts.plot.last(one)}</option>
            ))}
          </select>
          <select
            class="select"
            aria-label={panelTexts.plot.mode}
            value={mode}
            onChange={(event) => change({ mode: event.currentTarget.value === 'xy' ? 'xy' : 'time' })}
          >
            <option value="time">{panelTexts.plot.time}</option>
            <option value="xy">{panelTexts.plot.xy}</option>
          </select>
          <MenuButton
            icon="down"
            label={panelTexts.plot.save}
            items={[
              { id: 'csv', words: panelTexts.plot.csv, choose: save.csv },
              { id: 'svg', words: panelTexts.plot.svg, choose: save.svg },
              { id: 'png', words: panelTexts.plot.png, choose: save.png },
            ]}
          />
        </>
      }
    >
      <PathList
        session={session}
        codec={codec}
        kind="number"
        instance={instance}
        entries={paths.map((path, index) => ({
          path,
          words: wordsOf(tracks.current.get(path), moment),
          color: (index % 8) + 1,
        }))}
        onChange={(next) => change({ paths: next })}
      />
      {typeof codec === 'string' ? <p class="hint">{texts.topics.undecodable(codec)}</p> : null}
      {paths.length === 0 ? <p class="hint">{panelTexts.plot.none}</p> : null}
      {mode === 'xy' && paths.length === 1 ? <p class="hint">{panelTexts.plot.needsTwo}</p> : null}
      <div class="plot">
        <PlotCanvas
          mode={mode}
          count={paths.length}
          theme={theme}
          label={panelTexts.plot.of(paths)}
          source={source}
          view={view}
          canvas={canvas}
        />
        {moment === null ? null : <p class="plot-moment">{panelTexts.plot.at(moment - zero())}</p>}
      </div>
    </PanelFrame>
  );
}

/** The words for the newest sample, or for the one that holds at that moment. */
function wordsOf(track: Track | undefined, moment: number | null): string {
  if (track === undefined) return '';
  if (track.problem !== '') return track.problem;
  const { length } = track.samples;
  if (length === 0) return panelTexts.paths.waiting;
  return moment === null ? numberWords(track.samples.value(length - 1)) : momentWords(track.samples, moment);
}

/** All values of one moment: a burst of messages may have the same time. */
function momentWords(samples: Samples, moment: number): string {
  const values = samples.valuesAt(moment);
  if (values.length === 0) return numberWords(Number.NaN);
  const shown = values.slice(-MOST_TOGETHER).map(numberWords).join(' ');
  return values.length > MOST_TOGETHER ? `\u2026 ${shown}` : shown;
}

function numberWords(value: number): string {
  if (Number.isNaN(value)) return '-';
  // Six digits behind many zeros would be as long as two numbers.
  return value !== 0 && Math.abs(value) < SMALL ? value.toExponential(3) : String(Number(value.toPrecision(6)));
}

/** Colours that stay apart in print and for colour-blind people; those of the light theme. */
const INK = ['#2450b2', '#b3261e', '#12703b', '#8a5a00', '#7b3fb5', '#00707a', '#a02a6a', '#4a5563'];

function svgOf(source: PlotSource, mode: PlotMode): string {
  const color = (index: number): string => INK[index % INK.length] ?? '#000000';
  if (mode === 'xy') {
    const [first, ...others] = source.series;
    const pairs = pairsOf(source);
    const lines = others.map(({ name }, index) => ({
      name,
      color: color(index + 1),
      points: pairs[index] ?? [],
    }));
    return plotSvg(lines, first?.name ?? '', source);
  }
  const lines = source.series.map(({ name, samples }, index) => {
    const points: [number, number][] = [];
    for (let i = samples.from(source.range.least); i < samples.length; i += 1) {
      if (samples.time(i) > source.range.most) break;
      points.push([samples.time(i) - source.origin, samples.value(i)]);
    }
    return { name, color: color(index), points };
  });
  return plotSvg(lines, panelTexts.plot.seconds, source);
}

/** The drawing on the page's ground: by itself it is transparent. */
function savePng(drawing: HTMLCanvasElement): void {
  const whole = document.createElement('canvas');
  whole.width = drawing.width;
  whole.height = drawing.height;
  const context = whole.getContext('2d');
  if (context === null) return;
  const panel = drawing.closest('.group');
  context.fillStyle = panel === null ? '#ffffff' : getComputedStyle(panel).backgroundColor;
  context.fillRect(0, 0, whole.width, whole.height);
  context.drawImage(drawing, 0, 0);
  whole.toBlob((blob) => {
    if (blob !== null) download('plot.png', blob);
  });
}
