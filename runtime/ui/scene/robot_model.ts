// A robot as its description shows it: the shapes of each link, in the link's frame, wherever /tf has it now.

import { Group } from 'three';
import { member } from '../model/json.ts';
import { readUrdf } from '../model/urdf.ts';
import type { LinkShape, UrdfFault } from '../model/urdf.ts';
import { unreachable } from '../../wasm_js/session.ts';
import { panelTexts } from '../texts_panels.ts';
import type { Anchored, Display } from './display.ts';
import { emptied } from './dispose.ts';
import { ball, box, cylinder, mesh, named, placeAt, rgba } from './shapes.ts';
import type { BufferGeometry } from 'three';

const kPlain = '#b9c0ca';

export class RobotModel implements Display {
  readonly group = new Group();
  problem = '';
  private waiting: string | null = null;
  private links: readonly Anchored[] = [];

  take(message: unknown): void {
    const text = member(message, 'data');
    if (typeof text === 'string') this.waiting = text;
  }

  build(): undefined {
    if (this.waiting === null) return;
    const robot = readUrdf(this.waiting);
    this.waiting = null;
    emptied(this.group);
    this.links = [];
    if (typeof robot === 'string') {
      this.problem = panelTexts.scene.noRobot(faultWords(robot));
      return;
    }
    this.problem = robot.leftOut > 0 ? panelTexts.scene.shapesLeftOut(robot.leftOut) : '';
    this.links = robot.links
      .filter(({ visuals }) => visuals.length > 0)
      .map(({ name, visuals }) => {
        const link = new Group();
        for (const { shape, origin, color } of visuals) {
          const part = mesh(geometryOf(shape), color === null ? named(kPlain) : rgba(...color));
          placeAt(part, origin);
          link.add(part);
        }
        return { object: link, header: { stamp: NaN, frame: name } };
      });
    for (const { object } of this.links) this.group.add(object);
  }

  anchored(): Iterable<Anchored> {
    return this.links;
  }

  close(): void {
    emptied(this.group);
  }
}

function geometryOf(shape: LinkShape): BufferGeometry {
  switch (shape.kind) {
    case 'box':
      return box(...shape.size);
    case 'cylinder':
      return cylinder(shape.radius, shape.length);
    case 'sphere':
      return ball().scale(2 * shape.radius, 2 * shape.radius, 2 * shape.radius);
    default:
      return unreachable(shape);
  }
}

function faultWords(fault: UrdfFault): string {
  return panelTexts.scene.urdfFaults[fault];
}
