// A robot as its description shows it: the shapes of each link, in the link's frame, wherever /tf has it now.

import { Group } from 'three';
import { member } from '../model/json.ts';
import { readUrdf } from '../model/urdf.ts';
import type { LinkShape, UrdfFault } from '../model/urdf.ts';
import { unreachable } from '../../wasm_js/session.ts';
import { panelTexts } from '../texts_panels.ts';
import type { Anchored, Display } from './display.ts';
import { emptied } from './dispose.ts';
import type { MeshShelf, PlacedMesh } from './mesh_shelf.ts';
import { ball, box, cylinder, mesh, named, placeAt, rgba } from './shapes.ts';
import type { BufferGeometry } from 'three';

const kPlain = '#b9c0ca';
/** That are said at once. */
const kMostFaults = 3;

export class RobotModel implements Display {
  readonly group = new Group();
  private fault = '';
  private readonly meshes: MeshShelf;
  private placed: readonly PlacedMesh[] = [];
  private waiting: string | null = null;
  private links: readonly Anchored[] = [];

  constructor(meshes: MeshShelf) {
    this.meshes = meshes;
  }

  get problem(): string {
    const faults = new Set([this.fault, ...this.placed.map(({ problem }) => problem)].filter((one) => one !== ''));
    return [...faults].slice(0, kMostFaults).join('; ');
  }

  take(message: unknown): void {
    const text = member(message, 'data');
    if (typeof text === 'string') this.waiting = text;
  }

  build(): undefined {
    if (this.waiting === null) return;
    const robot = readUrdf(this.waiting);
    this.waiting = null;
    this.empty();
    const placed: PlacedMesh[] = [];
    if (typeof robot === 'string') {
      this.fault = panelTexts.scene.noRobot(faultWords(robot));
      return;
    }
    this.fault = robot.leftOut > 0 ? panelTexts.scene.shapesLeftOut(robot.leftOut) : '';
    this.links = robot.links
      .filter(({ visuals }) => visuals.length > 0)
      .map(({ name, visuals }) => {
        const link = new Group();
        for (const { shape, origin, color } of visuals) {
          const look = color === null ? named(kPlain) : rgba(...color);
          const part = new Group();
          placeAt(part, origin);
          link.add(part);
          if (shape.kind === 'mesh') {
            const file = this.meshes.place({ ...shape, look, ownLook: true });
            placed.push(file);
            part.add(file.object);
          } else part.add(mesh(geometryOf(shape), look));
        }
        return { object: link, header: { stamp: NaN, frame: name } };
      });
    this.placed = placed;
    for (const { object } of this.links) this.group.add(object);
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

function geometryOf(shape: Exclude<LinkShape, { kind: 'mesh' }>): BufferGeometry {
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
