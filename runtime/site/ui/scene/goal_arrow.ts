// The arrow on the ground while a goal or an estimate is set.

import { Group } from 'three';
import { fromRollPitchYaw } from '../model/transform.ts';
import type { GroundPose } from './camera_control.ts';
import { disposeOf } from './dispose.ts';
import { arrow, mesh, named, placeAt } from './shapes.ts';

const SIZE = { length: 1, shaft: 0.09, head: 0.26, headLength: 0.32 };
/** The size of the arrow, as a share of the distance of the target. */
const SCALE = 0.14;

export class GoalArrow {
  readonly group = new Group();

  constructor() {
    const part = mesh(arrow(SIZE), named('#b455d6'));
    part.material.depthTest = false;
    part.renderOrder = 2;
    this.group.add(part);
    this.group.visible = false;
  }

  set(goal: GroundPose | null, distance: number): void {
    this.group.visible = goal !== null;
    if (goal === null) return;
    placeAt(this.group, { translation: goal.place, rotation: fromRollPitchYaw(0, 0, goal.heading) });
    this.group.scale.setScalar(distance * SCALE);
  }

  close(): void {
    disposeOf(this.group);
  }
}
