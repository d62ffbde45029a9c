// sensor_msgs/msg/PointCloud2 as places and colours: any layout of fields, either byte order, sizes that lie. Pure.

import { asNumber } from './field_path.ts';
import { member } from './json.ts';

export interface PointCloud {
  /** x, y, z of each point; only points whose three are finite. */
  readonly positions: Float32Array;
  /** Red, green, blue of each, 0 to 1, as on a screen. */
  readonly colors: Float32Array;
  /** By what it is coloured: `rgb`, or the field that is spread over the rainbow. */
  readonly coloredBy: string;
  /** Points that the message has but that are not here, because they are too many. */
  readonly leftOut: number;
}

export type CloudFault = 'no-places' | 'no-data';

interface Field {
  readonly name: string;
  readonly offset: number;
  readonly datatype: number;
}

const kMostPoints = 1_000_000;
const kFarthest = 1e7;

/** Bytes of each datatype of sensor_msgs/msg/PointField, by its number. */
const kSizes: readonly number[] = [0, 1, 1, 2, 2, 4, 4, 4, 8];

export function readCloud(message: unknown): PointCloud | CloudFault {
  const data = member(message, 'data');
  const step = asNumber(member(message, 'point_step'));
  const width = asNumber(member(message, 'width'));
  const height = asNumber(member(message, 'height'));
  const rowStep = asNumber(member(message, 'row_step'));
  if (!(data instanceof Uint8Array) || !(step > 0) || !(width >= 0) || !(height >= 0)) return 'no-data';
  const fields = readFields(member(message, 'fields'), step);
  const [x, y, z] = [fields.get('x'), fields.get('y'), fields.get('z')];
  if (x === undefined || y === undefined || z === undefined) return 'no-places';
  const rows = rowStep >= width * step ? rowStep : width * step;
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const isLittle = asNumber(member(message, 'is_bigendian')) === 0;
  // Only what the data really holds.
  const held = Math.min(width * height, Math.floor(data.byteLength / step));
  const count = Math.min(held, kMostPoints);

  const positions = new Float32Array(count * 3);
  const packed = fields.get('rgb') ?? fields.get('rgba');
  const measured = fields.get('intensity') ?? fields.get('intensities') ?? z;
  const colors = new Float32Array(count * 3);
  const values = packed === undefined ? new Float32Array(count) : null;
  let found = 0;
  for (let i = 0; i < count; i += 1) {
    const start = Math.floor(i / width) * rows + (i % width) * step;
    if (start + step > data.byteLength) break;
    const [a, b, c] = [number(view, start, x, isLittle), number(view, start, y, isLittle), number(view, start, z, isLittle)];
    if (!(Math.abs(a) < kFarthest && Math.abs(b) < kFarthest && Math.abs(c) < kFarthest)) continue;
    positions.set([a, b, c], found * 3);
    if (values !== null) values[found] = number(view, start, measured, isLittle);
    else if (packed !== undefined) {
      const color = view.getUint32(start + packed.offset, isLittle);
      colors.set([((color >> 16) & 255) / 255, ((color >> 8) & 255) / 255, (color & 255) / 255], found * 3);
    }
    found += 1;
  }
  if (values !== null) spread(values.subarray(0, found), colors);
  return {
    positions: positions.subarray(0, found * 3),
    colors: colors.subarray(0, found * 3),
    coloredBy: packed === undefined ? measured.name : 'rgb',
    leftOut: held - count,
  };
}

function readFields(value: unknown, step: number): ReadonlyMap<string, Field> {
  const fields = new Map<string, Field>();
  if (!Array.isArray(value)) return fields;
  for (const item of value.slice(0, 100) as readonly unknown[]) {
    const name = member(item, 'name');
    const offset = asNumber(member(item, 'offset'));
    const datatype = asNumber(member(item, 'datatype'));
    const size = kSizes[datatype] ?? 0;
    if (typeof name !== 'string' || size === 0 || !(offset >= 0) || offset + size > step) continue;
    // Packed colours are four bytes, whatever they are called.
    if ((name === 'rgb' || name === 'rgba') && size !== 4) continue;
    fields.set(name, { name, offset, datatype });
  }
  return fields;
}

function number(view: DataView, start: number, { offset, datatype }: Field, isLittle: boolean): number {
  const at = start + offset;
  switch (datatype) {
    case 1:
      return view.getInt8(at);
    case 2:
      return view.getUint8(at);
    case 3:
      return view.getInt16(at, isLittle);
    case 4:
      return view.getUint16(at, isLittle);
    case 5:
      return view.getInt32(at, isLittle);
    case 6:
      return view.getUint32(at, isLittle);
    case 7:
      return view.getFloat32(at, isLittle);
    default:
      return view.getFloat64(at, isLittle);
  }
}

/** From the least to the greatest over the colours of the rainbow, violet to red; one value alone is in the middle. */
export function spread(values: ArrayLike<number>, colors: Float32Array): void {
  let [least, most] = [Infinity, -Infinity];
  for (let i = 0; i < values.length; i += 1) {
    const value = values[i] ?? NaN;
    if (!Number.isFinite(value)) continue;
    if (value < least) least = value;
    if (value > most) most = value;
  }
  for (let i = 0; i < values.length; i += 1) {
    const value = values[i] ?? NaN;
    const part = most > least && Number.isFinite(value) ? (value - least) / (most - least) : 0.5;
    colors.set(rainbow(part), i * 3);
  }
}

/** 0 violet, through blue, green and yellow, to 1 red. */
function rainbow(part: number): readonly [number, number, number] {
  const hue = (1 - part) * 4.5;
  const channel = (shift: number): number => {
    const place = (shift + hue) % 6;
    return 1 - Math.max(0, Math.min(1, place, 4 - place));
  };
  return [channel(5), channel(3), channel(1)];
}
