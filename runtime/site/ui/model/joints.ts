// The joints of a robot description (URDF) that can be set, as joint_state_publisher_gui has them: revolute, continuous
// and prismatic ones, and those that mimic others. Pure. The text may be anything.

import { member } from './json.ts';
import { readXml } from './xml.ts';
import type { XmlElement } from './xml.ts';

export interface Joint {
  readonly name: string;
  /** Metres of prismatic ones, else radians. */
  readonly isSliding: boolean;
  readonly least: number;
  readonly most: number;
  /** Where it is at first: 0, or the middle where 0 is out of bounds. */
  readonly zero: number;
  /** null: it is set by itself. */
  readonly mimic: Mimic | null;
}

export interface Mimic {
  readonly joint: string;
  readonly factor: number;
  readonly offset: number;
}

const MOST_CHARACTERS = 1 << 24;
const MOST_JOINTS = 500;
const LARGEST = 1e6;
const DEEPEST = 20;

/** null: it is not a robot description. */
export function readJoints(text: string): readonly Joint[] | null {
  if (text.length > MOST_CHARACTERS) return null;
  const robot = readXml(text);
  if (robot?.name !== 'robot') return null;
  const found = new Map<string, Joint>();
  for (const element of robot.children) {
    const joint = element.name === 'joint' && found.size < MOST_JOINTS ? jointOf(element) : null;
    if (joint !== null) found.set(joint.name, joint);
  }
  return [...found.values()];
}

function jointOf(element: XmlElement): Joint | null {
  const name = element.attributes.get('name') ?? '';
  const type = element.attributes.get('type') ?? '';
  if (name === '' || !['revolute', 'continuous', 'prismatic'].includes(type)) return null;
  const limit = childOf(element, 'limit');
  const safety = childOf(element, 'safety_controller');
  const isContinuous = type === 'continuous';
  // The tighter ones of the limits and the soft ones.
  const least = isContinuous ? -Math.PI : Math.max(numberOf(limit, 'lower', 0), numberOf(safety, 'soft_lower_limit', -LARGEST));
  const most = isContinuous ? Math.PI : Math.min(numberOf(limit, 'upper', 0), numberOf(safety, 'soft_upper_limit', LARGEST));
  if (!(least <= most)) return null;
  const mimicked = childOf(element, 'mimic');
  const joint = mimicked?.attributes.get('joint') ?? '';
  return {
    name,
    isSliding: type === 'prismatic',
    least,
    most,
    zero: least <= 0 && most >= 0 ? 0 : (least + most) / 2,
    mimic: joint === '' ? null : { joint, factor: numberOf(mimicked, 'multiplier', 1), offset: numberOf(mimicked, 'offset', 0) },
  };
}

/** The positions of all joints, in their order; joints that mimic others follow these. A joint that was not set is at its zero. */
export function jointPositions(joints: readonly Joint[], set: ReadonlyMap<string, number>): readonly number[] {
  const known = new Map(joints.map((joint) => [joint.name, joint]));
  const at = (joint: Joint, depth: number): number => {
    const followed = joint.mimic === null ? undefined : known.get(joint.mimic.joint);
    if (joint.mimic === null || followed === undefined || depth > DEEPEST) return set.get(joint.name) ?? joint.zero;
    return joint.mimic.factor * at(followed, depth + 1) + joint.mimic.offset;
  };
  return joints.map((joint) => at(joint, 0));
}

/** The positions of a sensor_msgs/msg/JointState, by joint. A message may carry velocities only. */
export function readJointState(message: unknown): readonly (readonly [string, number])[] {
  const names = member(message, 'name');
  const positions = member(message, 'position');
  if (!Array.isArray(names) || !(Array.isArray(positions) || positions instanceof Float64Array)) return [];
  return (names as readonly unknown[]).slice(0, MOST_JOINTS).flatMap((name, index): readonly (readonly [string, number])[] => {
    const position: unknown = positions[index];
    return typeof name === 'string' && typeof position === 'number' && Number.isFinite(position) ? [[name, position]] : [];
  });
}

function childOf(element: XmlElement, name: string): XmlElement | undefined {
  return element.children.find((child) => child.name === name);
}

function numberOf(element: XmlElement | undefined, name: string, usual: number): number {
  const text = element?.attributes.get(name)?.trim() ?? '';
  const value = text === '' ? usual : Number(text);
  return Math.abs(value) <= LARGEST ? value : usual;
}
