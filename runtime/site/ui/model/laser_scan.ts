// sensor_msgs/msg/LaserScan as places and what each beam measured. Pure.

import { asNumber } from './field_path.ts';
import { member } from './json.ts';
import { colored, MOST_POINTS } from './point_cloud.ts';
import type { PointCloud, PointColors } from './point_cloud.ts';

const FARTHEST = 1e7;

/** null: it is not a scan. */
export function readScan(message: unknown, by: PointColors = {}): PointCloud | null {
  const ranges = member(message, 'ranges');
  const strengths = member(message, 'intensities');
  const start = asNumber(member(message, 'angle_min'));
  const step = asNumber(member(message, 'angle_increment'));
  const nearest = asNumber(member(message, 'range_min'));
  const farthest = asNumber(member(message, 'range_max'));
  if (!isNumbers(ranges) || !Number.isFinite(start) || !Number.isFinite(step)) return null;
  const count = Math.min(ranges.length, MOST_POINTS);
  const positions = new Float32Array(count * 3);
  const sources = new Uint32Array(count);
  const { channel = 'flat' } = by;
  const values = channel === 'flat' || channel === 'rgb' ? null : new Float32Array(count);
  let found = 0;
  for (let i = 0; i < count; i += 1) {
    const range = Number(ranges[i]);
    // Nothing was hit, or the sensor says that it cannot see there.
    if (!(range >= 0 && range < FARTHEST) || range < nearest || range > farthest) continue;
    const angle = start + i * step;
    const [x, y] = [range * Math.cos(angle), range * Math.sin(angle)];
    positions[found * 3] = x;
    positions[found * 3 + 1] = y;
    sources[found] = i;
    if (values !== null)
      values[found] = channel === 'x' ? x : channel === 'y' ? y : channel === 'z' ? 0 : isNumbers(strengths) ? Number(strengths[i]) : NaN;
    found += 1;
  }
  return {
    positions: positions.subarray(0, found * 3),
    colors: values === null ? null : colored(values.subarray(0, found), by),
    coloredBy: values === null ? 'flat' : channel,
    sources: sources.subarray(0, found),
    leftOut: ranges.length - count,
  };
}

function isNumbers(value: unknown): value is ArrayLike<number> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}
