// Displays of poses: one, many, a path through them, and where odometry says that a robot is.

import { InstancedMesh, Matrix4, Quaternion, Vector3 } from 'three';
import { member } from '../model/json.ts';
import { readHeader, readPose } from '../model/transform.ts';
import type { Transform } from '../model/transform.ts';
import { texts } from '../texts.ts';
import { isPlace } from './display.ts';
import type { Built } from './newest_display.ts';
import { lines, pairsOf } from './lines.ts';
import { arrow, mesh, named, placeAt, solid } from './shapes.ts';
import type { ArrowSize } from './shapes.ts';

const kOne: ArrowSize = { length: 0.6, shaft: 0.05, head: 0.14, headLength: 0.18 };
const kMany: ArrowSize = { length: 0.3, shaft: 0.025, head: 0.07, headLength: 0.09 };
const kPathWidth = { width: 3, unit: 'pixels' } as const;
const kMostPoses = 100_000;
const kMostArrows = 10_000;

type Make = (message: unknown) => Built;

/** geometry_msgs/msg/PoseStamped, PoseWithCovarianceStamped, nav_msgs/msg/Odometry. */
export function singlePose(color: string): Make {
  return (message) => {
    const outer = member(message, 'pose');
    const pose = readPose(member(outer, 'pose') ?? outer);
    if (pose === null || !isPlace(...pose.translation)) return { object: null, problem: texts.scene.noPose };
    const pointer = mesh(arrow(kOne), named(color));
    placeAt(pointer, pose);
    return { object: pointer, problem: '' };
  };
}

/** geometry_msgs/msg/PoseArray. */
export function poseArray(color: string): Make {
  return (message) => {
    const { poses, problem } = readPoses(member(message, 'poses'), kMostArrows, (item) => item);
    const instances = new InstancedMesh(arrow(kMany), solid(named(color)), poses.length);
    const one = new Vector3(1, 1, 1);
    const matrix = new Matrix4();
    for (const [index, { translation, rotation }] of poses.entries())
      instances.setMatrixAt(index, matrix.compose(new Vector3(...translation), new Quaternion(...rotation), one));
    instances.frustumCulled = false;
    return { object: instances, problem };
  };
}

/** nav_msgs/msg/Path: a line. */
export function path(color: string): Make {
  return (message) => {
    const list = member(message, 'poses');
    const { poses, problem } = readPoses(list, kMostPoses, (item) => member(item, 'pose'));
    const positions = new Float32Array(poses.length * 3);
    for (const [index, { translation }] of poses.entries()) positions.set(translation, index * 3);
    // Some fill in the header of the poses only.
    const header = readHeader(message);
    const first: unknown = Array.isArray(list) ? list[0] : undefined;
    const frame = header.frame === '' ? readHeader(first).frame : header.frame;
    return { object: lines(pairsOf(positions), named(color), null, kPathWidth), problem, header: { ...header, frame } };
  };
}

function readPoses(
  list: unknown,
  most: number,
  poseOf: (item: unknown) => unknown,
): { readonly poses: readonly Transform[]; readonly problem: string } {
  if (!Array.isArray(list)) return { poses: [], problem: texts.scene.noPose };
  const poses = (list.slice(0, most) as readonly unknown[])
    .map((item) => readPose(poseOf(item)))
    .filter((pose) => pose !== null)
    .filter((pose) => isPlace(...pose.translation));
  return { poses, problem: list.length > most ? texts.scene.leftOut(list.length - most) : '' };
}
