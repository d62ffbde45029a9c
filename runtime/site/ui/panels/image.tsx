// The newest image of a topic, raw or compressed: zoomed and moved, what was measured at a pixel, the range of depth
// images, saved as PNG. State: {topic, least, most}; a bound that is missing is taken of each image.

import { useEffect, useReducer, useRef, useState } from 'preact/hooks';
import type { Size } from '../model/graph_layout.ts';
import { pixelWords } from '../model/image_encodings.ts';
import { keyCode, mouseEvent } from '../model/cv_windows.ts';
import type { PointerKeys, PointerKind } from '../model/cv_windows.ts';
import type { RawImage } from '../model/image_encodings.ts';
import { readRange } from '../model/image_pixels.ts';
import type { ImageRange, WantedRange } from '../model/image_pixels.ts';
import { textMember } from '../model/json.ts';
import { IconButton } from '../parts/button.tsx';
import { CvTrackbars, useCvWindow } from '../parts/cv_window.tsx';
import { download } from '../parts/download.ts';
import { drawImages, isImage } from '../parts/image_drawing.ts';
import type { ImageDrawing } from '../parts/image_drawing.ts';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { PictureView } from '../parts/picture_view.tsx';
import { useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { imageTexts } from '../texts_image.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

export function ImagePanel({ session, state, setState, announce }: PanelProps) {
  const topics = useTopics(session)
    .filter((topic) => isImage(topic.type))
    .map((topic) => topic.name)
    .toSorted();
  const chosen = textMember(state, 'topic');
  const topic = chosen === '' ? (topics[0] ?? '') : chosen;
  const wanted = readRange(state);
  const codec = useCodec(session);
  const canvas = useRef<HTMLCanvasElement>(null);
  const raw = useRef<RawImage | null>(null);
  const drawing = useRef<ImageDrawing | null>(null);
  const range = useRef(wanted);
  range.current = wanted;
  const [facts, setFacts] = useState('');
  const [problem, setProblem] = useState('');
  const [size, setSize] = useState<Size | null>(null);
  const [spread, setSpread] = useState<ImageRange | null>(null);
  // The value at a pixel changes with each image.
  const [, redraw] = useReducer<number, void>((n) => n + 1, 0);

  useEffect(() => {
    if (codec === null || typeof codec === 'string' || topic === '') return undefined;
    setFacts('');
    setProblem('');
    setSize(null);
    setSpread(null);
    const made = drawImages(session, codec, topic, () => canvas.current, (told) => {
      setProblem(told.problem);
      if (told.problem !== '' || canvas.current === null) return;
      raw.current = told.raw;
      setFacts(told.facts);
      const { width, height } = canvas.current;
      setSize((before) => (before?.width === width && before.height === height ? before : { width, height }));
      setSpread((before) => (before?.least === told.range?.least && before?.most === told.range?.most ? before : told.range));
      redraw();
    }, () => range.current);
    drawing.current = made;
    return () => {
      drawing.current = null;
      made.stop();
    };
  }, [session, codec, topic]);
  useEffect(() => drawing.current?.again(), [wanted.least, wanted.most]);

  const change = (next: { readonly topic?: string; } & Partial<WantedRange>): void => {
    const { topic: name, least, most } = { topic, ...wanted, ...next };
    setState({ topic: name, ...(least === undefined ? {} : { least }), ...(most === undefined ? {} : { most }) });
  };
  const wordsAt = (x: number, y: number): string => raw.current === null ? drawnWords(canvas.current, x, y) : pixelWords(raw.current, x, y);
  const cvWindow = useCvWindow(session, codec, topic);
  /** Tab leaves the picture, as everywhere. */
  const takesKey = (key: string): boolean => {
    const code = key === 'Tab' ? undefined : keyCode(key);
    return code !== undefined && cvWindow.send({ key: code });
  };
  const takesPointer = (kind: PointerKind, x: number, y: number, event: PointerKeys): boolean => {
    const mouse = cvWindow.controls.mouse ? mouseEvent(kind, x, y, event) : undefined;
    return mouse !== undefined && cvWindow.send({ mouse });
  };
  const save = (): void =>
    canvas.current?.toBlob((blob) => {
      if (blob === null) return;
      download(`${topic.replace(/^\//, '').replaceAll('/', '_')}.png`, blob);
      announce(imageTexts.saved);
    });

  return (
    <PanelFrame
      id="image"
      title={texts.panels.image}
      icon="image"
      note={facts}
      tools={
        <>
          <select
            class="select image-topic"
            aria-label={imageTexts.topic}
            value={topic}
            onChange={(event) => change({ topic: event.currentTarget.value, least: undefined, most: undefined })}
          >
            {topic === '' ? <option value="">{imageTexts.none}</option> : null}
            {[...new Set([...topics, ...(topic === '' ? [] : [topic])])].map((name) => (
              <option value={name}>{name}</option>
            ))}
          </select>
          <IconButton icon="down" label={imageTexts.save} disabled={size === null} onClick={save} />
        </>
      }
    >
      {spread === null ? null : <RangeRow wanted={wanted} range={spread} change={change} />}
      <CvTrackbars {...cvWindow} />
      {problem === '' ? null : <p class="hint">{problem}</p>}
      {size === null && problem === ''
        ? (
          <p class="hint">{topic === '' ? imageTexts.noTopic : panelTexts.paths.waiting}</p>
        )
        : null}
      <PictureView
        canvas={canvas}
        size={size}
        label={imageTexts.of(topic, facts)}
        wordsAt={wordsAt}
        announce={announce}
        takesKey={takesKey}
        takesPointer={takesPointer}
      />
    </PanelFrame>
  );
}

interface RangeRowProps {
  readonly wanted: WantedRange;
  /** The range with which the image is drawn. */
  readonly range: ImageRange;
  readonly change: (next: Partial<WantedRange>) => void;
}

function RangeRow({ wanted, range, change }: RangeRowProps) {
  const automatic = wanted.least === undefined && wanted.most === undefined;
  const bound = (name: 'least' | 'most') => (
    <label class="image-bound">
      {imageTexts[name]}
      <input
        class="field"
        type="number"
        step="any"
        placeholder={String(Number(range[name].toPrecision(5)))}
        value={wanted[name] ?? ''}
        onChange={(event) => {
          const { valueAsNumber } = event.currentTarget;
          change({ [name]: Number.isNaN(valueAsNumber) ? undefined : valueAsNumber });
        }}
      />
    </label>
  );
  return (
    <div class="image-range" role="group" aria-label={imageTexts.range}>
      {bound('least')}
      {bound('most')}
      <label class="check" title={imageTexts.automaticLong}>
        <input
          type="checkbox"
          checked={automatic}
          onChange={(event) => change(event.currentTarget.checked ? { least: undefined, most: undefined } : range)}
        />
        {imageTexts.automatic}
      </label>
    </div>
  );
}

/** The value at a pixel of a compressed picture: its colours as the browser has decoded them. */
function drawnWords(canvas: HTMLCanvasElement | null, x: number, y: number): string {
  if (canvas === null || !(x >= 0 && y >= 0 && x < canvas.width && y < canvas.height)) return '';
  // A canvas that is read stays out of the graphics card: not the one that is drawn for each message.
  const one = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  one?.drawImage(canvas, -x, -y);
  const [red, green, blue] = one?.getImageData(0, 0, 1, 1).data ?? [];
  return `R ${red ?? 0} G ${green ?? 0} B ${blue ?? 0}`;
}
