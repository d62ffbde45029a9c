// Rigid transforms, as in geometry_msgs/msg/Transform: a rotation by a unit quaternion, then a translation in metres.
// Also the readers of such values in decoded messages, which take only what is finite.

import { asNumber } from './field_path.ts';
import { member } from './json.ts';

export type Vector = readonly [x: number, y: number, z: number];
export type Quaternion = readonly [x: number, y: number, z: number, w: number];

export interface Transform {
  readonly translation: Vector;
  readonly rotation: Quaternion;
}

export const IDENTITY: Transform = { translation: [0, 0, 0], rotation: [0, 0, 0, 1] };

/** First `inner`, then `outer`: from inner's child to outer's parent. */
export function compose(outer: Transform, inner: Transform): Transform {
  const [x, y, z] = rotate(outer.rotation, inner.translation);
  const [a, b, c] = outer.translation;
  return { translation: [a + x, b + y, c + z], rotation: multiply(outer.rotation, inner.rotation) };
}

export function inverse({ translation, rotation }: Transform): Transform {
  const [qx, qy, qz, qw] = rotation;
  const back: Quaternion = [-qx, -qy, -qz, qw];
  const [x, y, z] = rotate(back, translation);
  return { translation: [-x, -y, -z], rotation: back };
}

/** The product of two unit quaternions; normalised again, so that long chains do not grow. */
export function multiply(a: Quaternion, b: Quaternion): Quaternion {
  const [ax, ay, az, aw] = a;
  const [bx, by, bz, bw] = b;
  return (
    normalized(
      aw * bx + ax * bw + ay * bz - az * by,
      aw * by - ax * bz + ay * bw + az * bx,
      aw * bz + ax * by - ay * bx + az * bw,
      aw * bw - ax * bx - ay * by - az * bz,
    ) ?? IDENTITY.rotation
  );
}

export function rotate([qx, qy, qz, qw]: Quaternion, [x, y, z]: Vector): Vector {
  const tx = 2 * (qy * z - qz * y);
  const ty = 2 * (qz * x - qx * z);
  const tz = 2 * (qx * y - qy * x);
  return [
    x + qw * tx + qy * tz - qz * ty,
    y + qw * ty + qz * tx - qx * tz,
    z + qw * tz + qx * ty - qy * tx,
  ];
}

/** Between two transforms, `part` of the way: straight on, and along the shorter arc. */
export function between(from: Transform, to: Transform, part: number): Transform {
  const mix = (a: number, b: number): number => a + (b - a) * part;
  const [ax, ay, az] = from.translation;
  const [bx, by, bz] = to.translation;
  return {
    translation: [mix(ax, bx), mix(ay, by), mix(az, bz)],
    rotation: slerp(from.rotation, to.rotation, part),
  };
}

function slerp(a: Quaternion, b: Quaternion, part: number): Quaternion {
  const dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = dot < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(dot)));
  // Near each other a straight line is the arc.
  const sine = Math.sin(angle);
  const first = sine < 1e-6 ? 1 - part : Math.sin((1 - part) * angle) / sine;
  const second = (sine < 1e-6 ? part : Math.sin(part * angle) / sine) * sign;
  return (
    normalized(
      a[0] * first + b[0] * second,
      a[1] * first + b[1] * second,
      a[2] * first + b[2] * second,
      a[3] * first + b[3] * second,
    ) ?? a
  );
}

/** By roll, pitch and yaw in radians, about fixed axes, as URDF's `rpy` and tf2's setRPY(). */
export function fromRollPitchYaw(roll: number, pitch: number, yaw: number): Quaternion {
  const [sr, cr] = [Math.sin(roll / 2), Math.cos(roll / 2)];
  const [sp, cp] = [Math.sin(pitch / 2), Math.cos(pitch / 2)];
  const [sy, cy] = [Math.sin(yaw / 2), Math.cos(yaw / 2)];
  return [
    sr * cp * cy - cr * sp * sy,
    cr * sp * cy + sr * cp * sy,
    cr * cp * sy - sr * sp * cy,
    cr * cp * cy + sr * sp * sy,
  ];
}

/** The same rotation as roll, pitch and yaw in radians. */
export function toRollPitchYaw([x, y, z, w]: Quaternion): Vector {
  const sine = Math.max(-1, Math.min(1, 2 * (w * y - z * x)));
  return [
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    Math.asin(sine),
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ];
}

/** null when the numbers are no rotation: all nearly zero, or not finite. */
function normalized(x: number, y: number, z: number, w: number): Quaternion | null {
  const length = Math.hypot(x, y, z, w);
  if (!Number.isFinite(length) || length < 1e-6) return null;
  return [x / length, y / length, z / length, w / length];
}

/** Fields x, y, z; null unless all are finite. */
export function readVector(value: unknown): Vector | null {
  const [x, y, z] = [asNumber(member(value, 'x')), asNumber(member(value, 'y')), asNumber(member(value, 'z'))];
  return Number.isFinite(x) && Number.isFinite(y) && Number.isFinite(z) ? [x, y, z] : null;
}

/** Fields x, y, z, w, made a unit. All zeros, as in messages that nobody filled, are no rotation at all: `zero`. */
export function readQuaternion(value: unknown, zero: Quaternion | null): Quaternion | null {
  const parts = ['x', 'y', 'z', 'w'].map((name) => asNumber(member(value, name)));
  const [x = NaN, y = NaN, z = NaN, w = NaN] = parts;
  if (parts.every((part) => part === 0)) return zero;
  return normalized(x, y, z, w);
}

/** A geometry_msgs/msg/Transform. tf2 refuses a rotation of zeros. */
export function readTransform(value: unknown): Transform | null {
  const translation = readVector(member(value, 'translation'));
  const rotation = readQuaternion(member(value, 'rotation'), null);
  return translation === null || rotation === null ? null : { translation, rotation };
}

/** A geometry_msgs/msg/Pose. One of zeros is upright, as RViz shows it. */
export function readPose(value: unknown): Transform | null {
  const translation = readVector(member(value, 'position'));
  const rotation = readQuaternion(member(value, 'orientation'), IDENTITY.rotation);
  return translation === null || rotation === null ? null : { translation, rotation };
}

export interface HeaderView {
  /** Seconds; NaN for time zero, which means the newest there is. */
  readonly stamp: number;
  readonly frame: string;
}

/** The std_msgs/msg/Header of a message. */
export function readHeader(message: unknown): HeaderView {
  const header = member(message, 'header');
  const frame = member(header, 'frame_id');
  return {
    stamp: readStamp(member(header, 'stamp')),
    frame: typeof frame === 'string' ? frameName(frame) : '',
  };
}

/** Seconds of a builtin_interfaces/msg/Time; NaN for zero and for what is none. */
export function readStamp(value: unknown): number {
  const stamp = asNumber(value);
  return Number.isFinite(stamp) && stamp !== 0 ? stamp : NaN;
}

/** tf2 knows no leading slash. */
export function frameName(name: string): string {
  return name.startsWith('/') ? name.slice(1) : name;
}
