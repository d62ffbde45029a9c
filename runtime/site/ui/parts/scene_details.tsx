// Details of an object in a scene: its topic, frame, stamp, place, and the newest message.

import type { Codec } from '../../decode/codec.ts';
import { readHeader } from '../model/transform.ts';
import type { Vector } from '../model/transform.ts';
import type { PickedPart } from '../scene/pick.ts';
import { sceneTexts } from '../texts_scene.ts';
import { IconButton } from './button.tsx';
import { MessageTree } from './message_tree.tsx';

export interface Inspected {
  readonly topic: string;
  /** Where it was hit, in the fixed frame, whose name is beside it; null: it was chosen from the list. */
  readonly hit: { readonly place: Vector; readonly frame: string; readonly part: PickedPart; } | null;
}

export interface SceneDetailsProps {
  readonly inspected: Inspected;
  readonly type: string;
  readonly message: unknown;
  readonly codec: Codec | null;
  readonly close: () => void;
}

const DIGITS = 3;

export function SceneDetails({ inspected: { topic, hit }, type, message, codec, close }: SceneDetailsProps) {
  const { frame, stamp } = hit?.part.header ?? readHeader(message);
  const words = sceneTexts.about;
  const facts: readonly (readonly [string, string])[] = [
    [words.topic, `${topic} (${type})`],
    ...(frame === '' ? [] : [[words.frame, frame] as const]),
    [words.stamp, Number.isNaN(stamp) ? words.noStamp : stamp.toFixed(6)],
    ...(hit === null ? [] : [
      [`${words.place} ${hit.frame}`, placeWords(hit.place)] as const,
      ...(frame === hit.frame ? [] : [[`${words.place} ${frame}`, placeWords(hit.part.local)] as const]),
      ...[...hit.part.values].map(([name, value]) => [name, typeof value === 'number' ? numberWords(value) : value] as const),
    ]),
  ];
  const parsed = codec?.types.get(type);
  const shape = parsed === undefined || typeof parsed === 'string' ? null : parsed.shape;
  return (
    <section class="scene-details" aria-label={sceneTexts.details(topic)}>
      <IconButton class="scene-details-close" icon="close" label={sceneTexts.closeDetails} onClick={close} />
      <dl class="scene-facts">
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {message === undefined ? <p class="hint">{words.none}</p> : (
        <details class="scene-message">
          <summary>{words.newest}</summary>
          <MessageTree label={words.newest} value={message} shape={shape} />
        </details>
      )}
    </section>
  );
}

function placeWords(place: Vector): string {
  return place.map((part) => part.toFixed(DIGITS)).join(', ');
}

function numberWords(value: number): string {
  return Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(7)));
}
