// Displays of single measurements: a point, a polygon, a range, forces, velocities, cells of a grid.

import { ConeGeometry, DoubleSide, Group, InstancedMesh, Matrix4, MeshBasicMaterial, PlaneGeometry, Vector3 } from 'three';
import { asNumber } from '../model/field_path.ts';
import { member } from '../model/json.ts';
import { readVector } from '../model/transform.ts';
import type { Vector } from '../model/transform.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import { FARTHEST, isPlace } from './places.ts';
import { lines, pairsOf } from './lines.ts';
import type { Built } from './newest_display.ts';
import { arrow, ball, mesh } from './shapes.ts';
import type { Rgba } from './shapes.ts';

const MOST_CORNERS = 100_000;
const MOST_CELLS = 200_000;
const POINT_RADIUS = 0.2; // metres, as in RViz
const WIDTH = { width: 2, unit: 'pixels' } as const;

type Make = (message: unknown) => Built;

const nothing = (problem: string): Built => ({ object: null, problem });

/** geometry_msgs/msg/PointStamped: a ball. */
export function pointBall(look: Rgba): Make {
  return (message) => {
    const place = readVector(member(message, 'point'));
    if (place === null || !isPlace(...place)) return nothing(sceneTexts.noPlace);
    const object = mesh(ball().scale(2 * POINT_RADIUS, 2 * POINT_RADIUS, 2 * POINT_RADIUS), look);
    object.position.set(...place);
    return { object, problem: '' };
  };
}

/** geometry_msgs/msg/PolygonStamped: its edge, closed. */
export function polygon(look: Rgba): Make {
  return (message) => {
    const list = member(member(message, 'polygon'), 'points');
    if (!Array.isArray(list)) return nothing(sceneTexts.noPlace);
    const corners = placesOf(list.slice(0, MOST_CORNERS));
    const [first] = corners;
    const closed = new Float32Array(first === undefined ? [] : [...corners, first].flat());
    return { object: lines(pairsOf(closed), look, null, WIDTH), problem: leftOut(list.length - MOST_CORNERS) };
  };
}

/** sensor_msgs/msg/Range: a cone along x as long as was measured. */
export function rangeCone(look: Rgba): Make {
  return (message) => {
    const [view, least, most, range] = ['field_of_view', 'min_range', 'max_range', 'range'].map((name) => asNumber(member(message, name)));
    if (view === undefined || least === undefined || most === undefined || range === undefined || !(view >= 0 && view < Math.PI))
      return nothing(sceneTexts.noRange);
    // A sensor that tells only near and far says so by infinities; others say by them that nothing is there.
    const isInside = range >= least && range <= most && range < FARTHEST;
    const length = least === most && range === -Infinity ? least : isInside ? range : 0;
    if (!(length > 0 && length < FARTHEST)) return { object: null, problem: '' };
    const radius = Math.tan(view / 2) * length;
    const cone = new ConeGeometry(Math.max(radius, length / 1000), length, 40).rotateZ(Math.PI / 2).translate(length / 2, 0, 0);
    const object = mesh(cone, look);
    object.material.side = DoubleSide;
    return { object, problem: '' };
  };
}

export interface ArrowPart {
  /** Two fields: the message's own, and the vector's in it. */
  readonly path: readonly [string, string];
  readonly look: Rgba;
  /** Metres for one unit of the vector. */
  readonly scale: number;
}

/** geometry_msgs/msg/WrenchStamped, TwistStamped and AccelStamped: an arrow for each of their two vectors. */
export function vectorPair(parts: readonly ArrowPart[]): Make {
  return (message) => {
    const object = new Group();
    for (const { path: [outer, inner], look, scale } of parts) {
      const vector = readVector(member(member(message, outer), inner));
      if (vector === null || !isPlace(...vector)) return nothing(sceneTexts.noVector);
      const along = new Vector3(...vector);
      const length = along.length() * scale;
      if (length < 1e-6) continue;
      const pointer = mesh(arrow({ length, shaft: length * 0.08, head: length * 0.2, headLength: length * 0.25 }), look);
      pointer.quaternion.setFromUnitVectors(new Vector3(1, 0, 0), along.normalize());
      object.add(pointer);
    }
    return { object, problem: '' };
  };
}

/** nav_msgs/msg/GridCells: flat squares, drawn at once. */
export function gridCells(look: Rgba): Make {
  return (message) => {
    const [width, height] = [asNumber(member(message, 'cell_width')), asNumber(member(message, 'cell_height'))];
    const list = member(message, 'cells');
    if (!Array.isArray(list) || !(width > 0 && width < FARTHEST && height > 0 && height < FARTHEST)) return nothing(sceneTexts.noCells);
    const cells = placesOf(list.slice(0, MOST_CELLS));
    const material = new MeshBasicMaterial({ color: look.color, transparent: look.alpha < 1, opacity: look.alpha, side: DoubleSide });
    const object = new InstancedMesh(new PlaneGeometry(width, height), material, cells.length);
    const matrix = new Matrix4();
    for (const [index, [x, y, z]] of cells.entries()) object.setMatrixAt(index, matrix.makeTranslation(x, y, z));
    object.frustumCulled = false;
    return { object, problem: leftOut(list.length - MOST_CELLS) };
  };
}

function placesOf(list: readonly unknown[]): readonly Vector[] {
  return list.map(readVector).filter((place): place is Vector => place !== null && isPlace(...place));
}

function leftOut(count: number): string {
  return count > 0 ? panelTexts.scene.leftOut(count) : '';
}
