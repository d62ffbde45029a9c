// Pictures over a scene, in its corner: one for each chosen image topic, in three sizes.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { IMAGE_SIZES } from '../model/scene_options.ts';
import type { ImageOverlay } from '../model/scene_options.ts';
import { sceneTexts } from '../texts_scene.ts';
import { IconButton } from './button.tsx';
import { drawImages } from './image_drawing.ts';
import { Name } from './name.tsx';

export interface SceneImagesProps {
  readonly session: Session;
  readonly codec: Codec;
  readonly images: readonly ImageOverlay[];
  readonly set: (images: readonly ImageOverlay[]) => void;
}

export function SceneImages({ session, codec, images, set }: SceneImagesProps) {
  return (
    <div class="scene-images" role="group" aria-label={sceneTexts.images}>
      {images.map((image) => (
        <Overlay
          key={image.topic}
          session={session}
          codec={codec}
          image={image}
          resize={(size) => set(images.map((one) => (one.topic === image.topic ? { ...one, size } : one)))}
          close={() => set(images.filter((one) => one.topic !== image.topic))}
        />
      ))}
    </div>
  );
}

interface OverlayProps {
  readonly session: Session;
  readonly codec: Codec;
  readonly image: ImageOverlay;
  readonly resize: (size: ImageOverlay['size']) => void;
  readonly close: () => void;
}

function Overlay({ session, codec, image: { topic, size }, resize, close }: OverlayProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [told, setTold] = useState({ facts: '', problem: '' });
  useEffect(
    () =>
      drawImages(session, codec, topic, () => canvas.current, ({ facts, problem }) =>
        setTold((before) => before.facts === facts && before.problem === problem ? before : { facts, problem })).stop,
    [session, codec, topic],
  );
  const next = IMAGE_SIZES[(IMAGE_SIZES.indexOf(size) + 1) % IMAGE_SIZES.length] ?? 'small';
  const words = told.problem !== '' ? told.problem : told.facts === '' ? sceneTexts.image.waiting : '';
  return (
    <div class={`scene-image scene-image-${size}`}>
      <div class="scene-image-head">
        <span class="scene-image-name">
          <Name text={topic} />
        </span>
        <IconButton icon="fit" label={sceneTexts.image.size(topic, sceneTexts.image.sizes[size])} onClick={() => resize(next)} />
        <IconButton icon="close" label={sceneTexts.image.close(topic)} onClick={close} />
      </div>
      {words === '' ? null : <p class="scene-image-words">{words}</p>}
      <canvas class="scene-image-canvas" role="img" aria-label={sceneTexts.image.of(topic, told.facts)} ref={canvas} />
    </div>
  );
}
