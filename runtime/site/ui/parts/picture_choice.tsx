// The topics of images that a 3D view can show beside the scene, to be ticked.

import { MOST_IMAGES } from '../model/scene_options.ts';
import type { ImageOverlay } from '../model/scene_options.ts';
import { sceneTexts } from '../texts_scene.ts';
import { Name } from './name.tsx';

export interface PictureChoiceProps {
  readonly topics: readonly string[];
  /** Those that are shown. */
  readonly images: readonly ImageOverlay[];
  readonly set: (images: readonly ImageOverlay[]) => void;
}

export function PictureChoice({ topics, images, set }: PictureChoiceProps) {
  if (topics.length === 0) return null;
  const show = (topic: string, on: boolean): void => {
    const others = images.filter((image) => image.topic !== topic);
    set([...others, ...(on ? [{ topic, size: 'small' as const }] : [])].slice(-MOST_IMAGES));
  };
  return (
    <fieldset class="scene-pictures">
      <legend>{sceneTexts.images}</legend>
      {topics.map((topic) => (
        <label class="check" key={topic}>
          <input
            type="checkbox"
            checked={images.some((image) => image.topic === topic)}
            onChange={(event) => show(topic, event.currentTarget.checked)}
          />
          <span class="scene-topic">
            <Name text={topic} />
          </span>
        </label>
      ))}
    </fieldset>
  );
}
