// Displays of poses: one, many, a path through them, and where odometry says that a robot is.

import { CircleGeometry, DoubleSide, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, Quaternion, Vector3 } from 'three';
import type { BufferGeometry } from 'three';
import { readCovariance } from '../model/covariance.ts';
import type { Spread } from '../model/covariance.ts';
import { member } from '../model/json.ts';
import { readHeader, readPose } from '../model/transform.ts';
import type { Transform } from '../model/transform.ts';
import { panelTexts } from '../texts_panels.ts';
import { isPlace } from './places.ts';
import type { Built } from './newest_display.ts';
import { lines, pairsOf } from './lines.ts';
import { arrow, mesh, placeAt, solid } from './shapes.ts';
import type { ArrowSize, Rgba } from './shapes.ts';

const ONE: ArrowSize = { length: 0.6, shaft: 0.05, head: 0.14, headLength: 0.18 };
const MANY: ArrowSize = { length: 0.3, shaft: 0.025, head: 0.07, headLength: 0.09 };
const PATH_WIDTH = { width: 3, unit: 'pixels' } as const;
const MOST_POSES = 100_000;
const MOST_ARROWS = 10_000;

type Make = (message: unknown) => Built;

/** geometry_msgs/msg/PoseStamped, PoseWithCovarianceStamped, nav_msgs/msg/Odometry. */
export function singlePose(look: Rgba): Make {
  return (message) => {
    const outer = member(message, 'pose');
    const pose = readPose(member(outer, 'pose') ?? outer);
    if (pose === null || !isPlace(...pose.translation)) return { object: null, problem: panelTexts.scene.noPose };
    const pointer = mesh(arrow(ONE), look);
    const spread = readCovariance(member(outer, 'covariance'));
    if (spread === null) {
      placeAt(pointer, pose);
      return { object: pointer, problem: '' };
    }
    const object = new Group();
    object.position.set(...pose.translation);
    pointer.quaternion.set(...pose.rotation);
    object.add(pointer, ...spreadOf(spread, pose, look));
    return { object, problem: '' };
  };
}

/** An ellipse in the directions of the message's frame, and a sector to both sides of the heading. */
function spreadOf({ ellipse, heading }: Spread, { rotation: [x, y, z, w] }: Transform, { color, alpha }: Rgba): readonly Mesh[] {
  const flat = (geometry: BufferGeometry, opacity: number): Mesh =>
    new Mesh(geometry, new MeshBasicMaterial({ color, opacity: opacity * alpha, transparent: true, depthWrite: false, side: DoubleSide }));
  const parts: Mesh[] = [];
  if (ellipse !== null) {
    const part = flat(new CircleGeometry(1, 48), 0.25);
    part.scale.set(...ellipse.radii, 1);
    part.rotation.z = ellipse.angle;
    parts.push(part);
  }
  if (heading > 0) {
    const part = flat(new CircleGeometry(ONE.length, 32, -heading, 2 * heading), 0.35);
    part.rotation.z = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    parts.push(part);
  }
  return parts;
}

/** Small ones, drawn at once. */
export function arrows(poses: readonly Transform[], look: Rgba): InstancedMesh {
  const instances = new InstancedMesh(arrow(MANY), solid(look), poses.length);
  const one = new Vector3(1, 1, 1);
  const matrix = new Matrix4();
  for (const [index, { translation, rotation }] of poses.entries())
    instances.setMatrixAt(index, matrix.compose(new Vector3(...translation), new Quaternion(...rotation), one));
  instances.frustumCulled = false;
  return instances;
}

/** geometry_msgs/msg/PoseArray. */
export function poseArray(look: Rgba): Make {
  return (message) => {
    const { poses, problem } = readPoses(member(message, 'poses'), MOST_ARROWS, (item) => item);
    return { object: arrows(poses, look), problem };
  };
}

/** nav_msgs/msg/Path: a line. */
export function path(look: Rgba): Make {
  return (message) => {
    const list = member(message, 'poses');
    const { poses, problem } = readPoses(list, MOST_POSES, (item) => member(item, 'pose'));
    const positions = new Float32Array(poses.length * 3);
    for (const [index, { translation }] of poses.entries()) positions.set(translation, index * 3);
    // Some fill in the header of the poses only.
    const header = readHeader(message);
    const first: unknown = Array.isArray(list) ? list[0] : undefined;
    const frame = header.frame === '' ? readHeader(first).frame : header.frame;
    return { object: lines(pairsOf(positions), look, null, PATH_WIDTH), problem, header: { ...header, frame } };
  };
}

function readPoses(
  list: unknown,
  most: number,
  poseOf: (item: unknown) => unknown,
): { readonly poses: readonly Transform[]; readonly problem: string; } {
  if (!Array.isArray(list)) return { poses: [], problem: panelTexts.scene.noPose };
  const poses = (list.slice(0, most) as readonly unknown[])
    .map((item) => readPose(poseOf(item)))
    .filter((pose) => pose !== null)
    .filter((pose) => isPlace(...pose.translation));
  return { poses, problem: list.length > most ? panelTexts.scene.leftOut(list.length - most) : '' };
}
