// The newest image of a topic, raw or compressed, and what was measured under the pointer. State: {topic}.

import { useEffect, useRef, useState } from 'preact/hooks';
import { pixelWords } from '../model/image_pixels.ts';
import type { RawImage } from '../model/image_pixels.ts';
import { textMember } from '../model/json.ts';
import { drawImages, isImage } from '../parts/image_drawing.ts';
import { useCodec } from '../parts/message_feed.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { useTopics } from '../parts/watch.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

export function ImagePanel({ session, state, setState }: PanelProps) {
  const topics = useTopics(session)
    .filter((topic) => isImage(topic.type))
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
    setFacts('');
    setProblem('');
    return drawImages(session, codec, topic, () => canvas.current, (told) => {
      setProblem(told.problem);
      if (told.problem !== '') return;
      raw.current = told.raw;
      setFacts(told.facts);
    });
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
