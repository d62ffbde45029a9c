// A robot as its description shows it: the shapes of each link, in the link's frame, wherever /tf has it now.

import { Group } from 'three';
import { member } from '../model/json.ts';
import { readUrdf } from '../model/urdf.ts';
import type { LinkShape, UrdfFault, Visual } from '../model/urdf.ts';
import { unreachable } from '../../contract/session.ts';
import { panelTexts } from '../texts_panels.ts';
import type { Anchored, Display, DisplayContext } from './display.ts';
import { emptied } from './dispose.ts';
import type { PlacedMesh } from './mesh_shelf.ts';
import { ball, box, cylinder, mesh, named, placeAt, rgba } from './shapes.ts';
import type { Rgba } from './shapes.ts';
import type { BufferGeometry } from 'three';

const PLAIN = '#b9c0ca';
/** The look of collision shapes: transparent, so that the visual shapes inside are seen. */
const COLLISION: Rgba = { ...named('#e5a03d'), alpha: 0.55 };
/** That are said at once. */
const MOST_FAULTS = 3;

export class RobotModel implements Display {
  readonly group = new Group();
  private fault = '';
  private readonly context: DisplayContext;
  private placed: PlacedMesh[] = [];
  private waiting: string | null = null;
  private shown: string | null = null;
  private links: readonly Anchored[] = [];

  constructor(context: DisplayContext) {
    this.context = context;
  }

  get problem(): string {
    const faults = new Set([this.fault, ...this.placed.map(({ problem }) => problem)].filter((one) => one !== ''));
    return [...faults].slice(0, MOST_FAULTS).join('; ');
  }

  take(message: unknown): void {
    const text = member(message, 'data');
    if (typeof text === 'string') this.waiting = text;
  }

  repaint(): void {
    this.waiting ??= this.shown;
  }

  build(): undefined {
    if (this.waiting === null) return;
    const robot = readUrdf(this.waiting);
    this.shown = this.waiting;
    this.waiting = null;
    this.empty();
    if (typeof robot === 'string') {
      this.fault = panelTexts.scene.noRobot(faultWords(robot));
      return;
    }
    this.fault = robot.leftOut > 0 ? panelTexts.scene.shapesLeftOut(robot.leftOut) : '';
    const { alpha = 1, hideVisual = false, collision = false } = this.context.look;
    const links: Anchored[] = [];
    for (const { name, visuals, collisions } of robot.links) {
      const link = new Group();
      for (const visual of hideVisual ? [] : visuals) {
        const own = visual.color === null ? named(PLAIN) : rgba(...visual.color);
        link.add(this.part(visual, { ...own, alpha: own.alpha * alpha }, alpha === 1));
      }
      for (const each of collision ? collisions : []) link.add(this.part(each, COLLISION, false));
      if (link.children.length > 0) links.push({ object: link, header: { stamp: NaN, frame: name } });
    }
    this.links = links;
    for (const { object } of this.links) this.group.add(object);
  }

  private part({ shape, origin }: Visual, look: Rgba, ownLook: boolean): Group {
    const part = new Group();
    placeAt(part, origin);
    if (shape.kind === 'mesh') {
      const file = this.context.meshes.place({ ...shape, look, ownLook });
      this.placed.push(file);
      part.add(file.object);
    } else part.add(mesh(geometryOf(shape), look));
    return part;
  }

  anchored(): Iterable<Anchored> {
    return this.links;
  }

  close(): void {
    this.empty();
  }

  private empty(): void {
    for (const each of this.placed) each.close();
    this.placed = [];
    this.links = [];
    emptied(this.group);
  }
}

function geometryOf(shape: Exclude<LinkShape, { kind: 'mesh'; }>): BufferGeometry {
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
