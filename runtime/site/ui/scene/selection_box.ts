// The box around what is selected, and the line from a hand to what it holds.

import { Box3, Box3Helper, BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments } from 'three';
import type { Vector } from '../model/transform.ts';
import type { Display } from './display.ts';
import { disposeOf } from './dispose.ts';

/** Boxes larger than this, in metres, such as that of a floor, would only be in the way. */
const LARGEST = 30;

export class SelectionBox {
  readonly group = new Group();
  private readonly bounds = new Box3();
  private readonly box = new Box3Helper(this.bounds);
  private readonly line: LineSegments<BufferGeometry, LineBasicMaterial>;

  constructor(color: string) {
    this.line = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    this.line.geometry.setAttribute('position', new BufferAttribute(new Float32Array(6), 3));
    this.line.frustumCulled = false;
    this.line.visible = false;
    this.setColor(color);
    this.group.add(this.box, this.line);
  }

  setColor(color: string): void {
    for (const { material } of [this.box, this.line]) (material as LineBasicMaterial).color = new Color(color);
  }

  /** Around the parts of the display whose frames fit; they have their places. */
  around(display: Display, fits: (frame: string) => boolean): void {
    this.bounds.makeEmpty();
    for (const { object, header } of display.anchored()) if (fits(header.frame)) this.bounds.expandByObject(object);
    const { min, max } = this.bounds;
    this.box.visible = !this.bounds.isEmpty() && max.distanceTo(min) < LARGEST;
    if (this.box.visible) this.bounds.expandByScalar(0.01);
  }

  /** null: no hand holds anything. */
  pull(from: Vector | null, to: Vector | null): void {
    this.line.visible = from !== null && to !== null;
    if (from === null || to === null) return;
    const places = this.line.geometry.getAttribute('position') as BufferAttribute;
    places.setXYZ(0, ...from);
    places.setXYZ(1, ...to);
    places.needsUpdate = true;
  }

  close(): void {
    disposeOf(this.group);
  }
}
