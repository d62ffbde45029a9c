// Two points of the fixed frame and the line between them.

import { Group } from 'three';
import type { Vector } from '../model/transform.ts';
import { disposeOf, emptied } from './dispose.ts';
import { lines } from './lines.ts';
import { points } from './points.ts';
import { named } from './shapes.ts';

const COLOR = '#b455d6';

export class Ruler {
  readonly group = new Group();

  set(places: readonly Vector[]): void {
    emptied(this.group);
    if (places.length === 0) return;
    const dots = points(Float32Array.from(places.flat()), COLOR, 8);
    const line = lines(Float32Array.from(places.length < 2 ? [] : places.flat()), named(COLOR), null, { width: 2, unit: 'pixels' });
    dots.material.depthTest = false;
    for (const [order, part] of [line, dots].entries()) {
      part.renderOrder = 3 + order;
      this.group.add(part);
    }
  }

  close(): void {
    disposeOf(this.group);
  }
}
