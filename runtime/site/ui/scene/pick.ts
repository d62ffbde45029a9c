// Finds the object under a point of the picture: its place, and the topic of its message.

import { Vector3 } from 'three';
import type { Object3D } from 'three';
import type { HeaderView, Vector } from '../model/transform.ts';
import type { Anchored, Display } from './display.ts';
import type { Stage } from './stage.ts';

export interface Picked {
  /** In the fixed frame. */
  readonly place: Vector;
  /** null: the ground. */
  readonly part: PickedPart | null;
}

export interface PickedPart {
  readonly topic: string;
  readonly header: HeaderView;
  /** In the header's frame. */
  readonly local: Vector;
  readonly values: ReadonlyMap<string, string | number>;
}

/** null: nothing, not even the ground. */
export function pick(stage: Stage, displays: ReadonlyMap<string, Display>, x: number, y: number): Picked | null {
  let nearest = Infinity;
  let found: Picked | null = null;
  for (const [topic, display] of displays) {
    const [hit] = stage.hits(x, y, display.group);
    if (hit === undefined || hit.distance >= nearest) continue;
    const anchored = anchorOf(hit.object, display.anchored());
    if (anchored === null) continue;
    nearest = hit.distance;
    const index = hit.index ?? hit.instanceId;
    const values = display.describe?.(anchored.object, index) ?? new Map(index === undefined ? [] : [['index', index]]);
    const local = vectorOf(anchored.object.worldToLocal(hit.point.clone()));
    found = { place: vectorOf(hit.point), part: { topic, header: anchored.header, local, values } };
  }
  if (found !== null) return found;
  const place = stage.groundAt(x, y);
  return place === null ? null : { place, part: null };
}

function anchorOf(object: Object3D, parts: Iterable<Anchored>): Anchored | null {
  const objects = new Map([...parts].map((part) => [part.object, part]));
  for (let one: Object3D | null = object; one !== null; one = one.parent) {
    const part = objects.get(one);
    if (part !== undefined) return part;
  }
  return null;
}

function vectorOf({ x, y, z }: Vector3): Vector {
  return [x, y, z];
}
