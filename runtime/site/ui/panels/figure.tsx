// A window of a Python library: a figure of matplotlib with its toolbar, or a picture of Pillow. State: {topic, fill}.

import { useEffect, useRef, useState } from 'preact/hooks';
import { pngName, NO_FIGURE, readFigureControls } from '../model/figure_controls.ts';
import { figuresOf, isFigure } from '../model/figure_topics.ts';
import type { Size } from '../model/graph_layout.ts';
import { flagMember, textMember } from '../model/json.ts';
import { IconButton } from '../parts/button.tsx';
import { download } from '../parts/download.ts';
import { FigureView } from '../parts/figure_view.tsx';
import { drawImages } from '../parts/image_drawing.ts';
import { feed, useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { useTopics } from '../parts/watch.ts';
import { useWindowLink } from '../parts/window_link.ts';
import type { WindowLink } from '../parts/window_link.ts';
import type { FigureControls } from '../model/figure_controls.ts';
import { texts } from '../texts.ts';
import { figureTexts } from '../texts_figure.ts';
import type { PanelProps } from './panel_props.ts';

/** ms: files are saved only within this time after an action of the visitor. */
const PATIENCE = 10_000;
const MOST_FILE = 1 << 26;
/** ms: the figure is resized when the panel has not changed for this time. */
const SETTLED = 200;

export function FigurePanel({ session, state, setState, announce }: PanelProps) {
  const figures = figuresOf(useTopics(session));
  const chosen = textMember(state, 'topic');
  const topic = isFigure(chosen) ? chosen : (figures[0] ?? '');
  const fill = flagMember(state, 'fill', false);
  const codec = useCodec(session);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [size, setSize] = useState<Size | null>(null);
  const [problem, setProblem] = useState('');
  const acted = useRef(-Infinity);
  const link = useWindowLink(session, codec, topic, readFigureControls, NO_FIGURE);
  const { send } = link;
  const follow = useFollowedSize(fill, send);

  useEffect(() => {
    if (codec === null || typeof codec === 'string' || topic === '') return undefined;
    setSize(null);
    setProblem('');
    const drawing = drawImages(session, codec, topic, () => canvas.current, (told) => {
      setProblem(told.problem);
      if (told.problem !== '' || canvas.current === null) return;
      const { width, height } = canvas.current;
      setSize((before) => (before?.width === width && before.height === height ? before : { width, height }));
    });
    const stop = feed(session, codec, `${topic}/saved`, ({ decoded }) => {
      if (decoded.kind === 'failed' || performance.now() - acted.current > PATIENCE) return;
      const data = (decoded.value as Readonly<Record<string, unknown>>)['data'];
      if (!(data instanceof Uint8Array) || data.length > MOST_FILE) return;
      const header = (decoded.value as Readonly<Record<string, unknown>>)['header'];
      download(pngName(textMember(header, 'frame_id')), new Blob([Uint8Array.from(data)], { type: 'image/png' }));
      announce(figureTexts.saved);
    });
    return () => {
      drawing.stop();
      stop();
    };
  }, [session, codec, topic, announce]);

  const act = (): void => {
    acted.current = performance.now();
  };
  const words = topic === '' ? figureTexts.none : size === null ? figureTexts.waiting : figures.includes(topic) ? '' : figureTexts.ended;
  return (
    <PanelFrame
      id="figure"
      title={texts.panels.figure}
      icon="plot"
      note={link.controls.title}
      tools={link.controls.tools
        ? (
          <FigureTools
            {...link}
            act={act}
            fill={fill}
            setFill={(next) => {
              setState({ topic, ...(next ? { fill: true } : {}) });
              if (next) follow.now();
            }}
          />
        )
        : undefined}
    >
      {problem === '' ? null : <p class="hint">{problem}</p>}
      {words === '' ? null : <p class="hint">{words}</p>}
      <FigureView canvas={canvas} size={size} {...link} acted={act} onSize={follow.onSize} />
      {link.controls.tools ? <p class="figure-message">{link.controls.message}</p> : null}
    </PanelFrame>
  );
}

interface FigureToolsProps extends WindowLink<FigureControls> {
  readonly act: () => void;
  readonly fill: boolean;
  readonly setFill: (fill: boolean) => void;
}

/** The buttons of the program's toolbar. */
function FigureTools({ controls, send, act, fill, setFill }: FigureToolsProps) {
  const use = (tool: string) => (): void => {
    act();
    send({ tool });
  };
  return (
    <>
      <IconButton icon="home" label={figureTexts.home} onClick={use('home')} />
      <IconButton icon="left" label={figureTexts.back} disabled={!controls.back} onClick={use('back')} />
      <IconButton icon="right" label={figureTexts.forward} disabled={!controls.forward} onClick={use('forward')} />
      <IconButton icon="hand" label={figureTexts.pan} pressed={controls.mode === 'pan'} onClick={use('pan')} />
      <IconButton icon="search" label={figureTexts.zoom} pressed={controls.mode === 'zoom'} onClick={use('zoom')} />
      <IconButton icon="fit" label={figureTexts.fill} pressed={fill} onClick={() => setFill(!fill)} />
      <IconButton icon="down" label={figureTexts.save} onClick={use('save')} />
    </>
  );
}

/** Resizes the figure with the panel while `fill` is set. */
function useFollowedSize(fill: boolean, send: WindowLink<FigureControls>['send']) {
  const newest = useRef({ size: null as Size | null, fill, send, timer: 0 });
  Object.assign(newest.current, { fill, send });
  useEffect(() => () => clearTimeout(newest.current.timer), []);
  const now = (): void => {
    const { size } = newest.current;
    if (size !== null) newest.current.send({ size: [size.width, size.height] });
  };
  return {
    now,
    onSize: (size: Size): void => {
      newest.current.size = size;
      clearTimeout(newest.current.timer);
      if (newest.current.fill) newest.current.timer = window.setTimeout(now, SETTLED);
    },
  };
}
