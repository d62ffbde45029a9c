// The newest image of a topic, raw or compressed, and what was measured under the pointer. State: {topic}.

import { useEffect, useRef, useState } from 'preact/hooks';
import { isMessage } from '../../decode/yaml.ts';
import { asNumber } from '../model/field_path.ts';
import { pixelWords, pixelsOf } from '../model/image_pixels.ts';
import type { RawImage } from '../model/image_pixels.ts';
import { textMember } from '../model/json.ts';
import { feed, useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const kRaw = 'sensor_msgs/msg/Image';
const kCompressed = 'sensor_msgs/msg/CompressedImage';
const kMostCompressed = 1 << 26;

export function ImagePanel({ session, state, setState }: PanelProps) {
  const topics = useTopics(session)
    .filter((topic) => topic.type === kRaw || topic.type === kCompressed)
    .map((topic) => topic.name)
    .toSorted();
  const chosen = textMember(state, 'topic');
  const topic = chosen === '' ? (topics[0] ?? '') : chosen;
  const codec = useCodec(session);
  const canvas = useRef<HTMLCanvasElement>(null);
  const raw = useRef<RawImage | null>(null);
  const [facts, setFacts] = useState('');
  const [problem, setProblem] = useState('');
  const [point, setPoint] = useState('');

  useEffect(() => {
    if (codec === null || typeof codec === 'string' || topic === '') return undefined;
    let current = true;
    let newest: { readonly type: string; readonly value: Readonly<Record<string, unknown>> } | null = null;
    let frame = 0;
    let busy = false;
    const draw = async (): Promise<void> => {
      frame = 0;
      const next = newest;
      const element = canvas.current;
      if (next === null || element === null || busy) return;
      newest = null;
      busy = true;
      const told =
        next.type === kRaw
          ? drawRaw(element, next.value, (image) => {
              raw.current = image;
            })
          : await drawCompressed(element, next.value);
      busy = false;
      if (!current) return;
      if (next.type !== kRaw) raw.current = null;
      setProblem(told.problem);
      if (told.problem === '') setFacts(told.facts);
      if (newest !== null && frame === 0) frame = requestAnimationFrame(() => void draw());
    };
    setFacts('');
    setProblem('');
    const stop = feed(session, codec, topic, ({ decoded, type }) => {
      if (decoded.kind === 'failed') {
        setProblem(texts.topics.undecodable(decoded.reason));
        return;
      }
      if (!isMessage(decoded.value)) return;
      // Only the newest one that there is time for is drawn.
      newest = { type, value: decoded.value };
      if (frame === 0) frame = requestAnimationFrame(() => void draw());
    });
    return () => {
      current = false;
      cancelAnimationFrame(frame);
      stop();
    };
  }, [session, codec, topic]);

  const follow = (event: PointerEvent): void => {
    const box = canvas.current?.getBoundingClientRect();
    const image = raw.current;
    if (box === undefined || image === null) return;
    // The picture keeps its proportions within the box.
    const scale = Math.min(box.width / image.width, box.height / image.height);
    const x = Math.floor((event.clientX - box.left - (box.width - image.width * scale) / 2) / scale);
    const y = Math.floor((event.clientY - box.top - (box.height - image.height * scale) / 2) / scale);
    const words = pixelWords(image, x, y);
    setPoint(words === '' ? '' : panelTexts.image.point(x, y, words));
  };

  return (
    <PanelFrame
      id="image"
      title={texts.panels.image}
      icon="image"
      note={[facts, point].filter((part) => part !== '').join(', ')}
      tools={
        <select
          class="select image-topic"
          aria-label={panelTexts.image.topic}
          value={topic}
          onChange={(event) => setState({ topic: event.currentTarget.value })}
        >
          {topic === '' ? <option value="">{panelTexts.image.none}</option> : null}
          {[...new Set([...topics, ...(topic === '' ? [] : [topic])])].map((name) => (
            <option value={name}>{name}</option>
          ))}
        </select>
      }
    >
      {problem === '' ? null : <p class="hint">{problem}</p>}
      {facts === '' && problem === '' ? (
        <p class="hint">{topic === '' ? panelTexts.image.noTopic : panelTexts.paths.waiting}</p>
      ) : null}
      <canvas
        class="image-canvas"
        role="img"
        aria-label={panelTexts.image.of(topic, facts)}
        ref={canvas}
        onPointerMove={follow}
        onPointerLeave={() => setPoint('')}
      />
    </PanelFrame>
  );
}

interface Told {
  readonly facts: string;
  readonly problem: string;
}

function drawRaw(
  canvas: HTMLCanvasElement,
  value: Readonly<Record<string, unknown>>,
  keep: (image: RawImage) => void,
): Told {
  const { data, encoding } = value;
  if (!(data instanceof Uint8Array) || typeof encoding !== 'string')
    return { facts: '', problem: panelTexts.image.noImage };
  const image: RawImage = {
    width: asNumber(value['width']),
    height: asNumber(value['height']),
    step: asNumber(value['step']),
    isBigEndian: asNumber(value['is_bigendian']) !== 0,
    encoding,
    data,
  };
  const pixels = pixelsOf(image);
  if (typeof pixels === 'string') return { facts: '', problem: texts.topics.undecodable(pixels) };
  resize(canvas, pixels.width, pixels.height);
  canvas.getContext('2d')?.putImageData(new ImageData(pixels.rgba, pixels.width, pixels.height), 0, 0);
  keep(image);
  return { facts: panelTexts.image.facts(pixels.width, pixels.height, encoding), problem: '' };
}

async function drawCompressed(
  canvas: HTMLCanvasElement,
  value: Readonly<Record<string, unknown>>,
): Promise<Told> {
  const { data, format } = value;
  if (!(data instanceof Uint8Array) || data.length > kMostCompressed)
    return { facts: '', problem: panelTexts.image.noImage };
  const name = typeof format === 'string' ? format : '';
  try {
    const picture = await createImageBitmap(new Blob([Uint8Array.from(data)]));
    resize(canvas, picture.width, picture.height);
    canvas.getContext('2d')?.drawImage(picture, 0, 0);
    const facts = panelTexts.image.facts(picture.width, picture.height, name.slice(0, 40));
    picture.close();
    return { facts, problem: '' };
  } catch {
    return { facts: '', problem: panelTexts.image.notRead(name.slice(0, 40)) };
  }
}

function resize(canvas: HTMLCanvasElement, width: number, height: number): void {
  if (canvas.width === width && canvas.height === height) return;
  canvas.width = width;
  canvas.height = height;
}
