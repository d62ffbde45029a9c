// sensor_msgs/msg/PointCloud2 as places and colours: any layout of fields, either byte order, sizes that lie. Pure.

import { asNumber } from './field_path.ts';
import { member } from './json.ts';

export interface PointCloud {
  /** x, y, z of each point; only points whose three are finite. */
  readonly positions: Float32Array;
  /** Red, green, blue of each, 0 to 1, as on a screen; null: all have one colour. */
  readonly colors: Float32Array | null;
  /** By what it is coloured: `flat`, `rgb`, or the field that is spread over the rainbow. */
  readonly coloredBy: string;
  /** Which of the message's points each one is. */
  readonly sources: Uint32Array;
  /** Points that the message has but that are not here, because they are too many. */
  readonly leftOut: number;
}

export interface PointColors {
  /** A field, `rgb` or `flat`; without, what the cloud has: colours, else intensities, else heights. */
  readonly channel?: string | undefined;
  /** The values that are violet and red; without, the least and the most that there are. */
  readonly least?: number | undefined;
  readonly most?: number | undefined;
}

export type CloudFault = 'no-places' | 'no-data';

interface Field {
  readonly name: string;
  readonly offset: number;
  readonly datatype: number;
}

export const MOST_POINTS = 1_000_000;
const FARTHEST = 1e7;

/** Bytes of each datatype of sensor_msgs/msg/PointField, by its number. */
const SIZES: readonly number[] = [0, 1, 1, 2, 2, 4, 4, 4, 8];

export function readCloud(message: unknown, by: PointColors = {}): PointCloud | CloudFault {
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
  const count = Math.min(held, MOST_POINTS);

  const positions = new Float32Array(count * 3);
  const sources = new Uint32Array(count);
  const { packed, measured } = channelOf(fields, z, by.channel);
  const colors = packed === undefined ? null : new Float32Array(count * 3);
  const values = measured === undefined ? null : new Float32Array(count);
  let found = 0;
  for (let i = 0; i < count; i += 1) {
    const start = Math.floor(i / width) * rows + (i % width) * step;
    if (start + step > data.byteLength) break;
    const [a, b, c] = [number(view, start, x, isLittle), number(view, start, y, isLittle), number(view, start, z, isLittle)];
    if (!(Math.abs(a) < FARTHEST && Math.abs(b) < FARTHEST && Math.abs(c) < FARTHEST)) continue;
    const at = found * 3;
    positions[at] = a;
    positions[at + 1] = b;
    positions[at + 2] = c;
    sources[found] = i;
    if (values !== null && measured !== undefined) values[found] = number(view, start, measured, isLittle);
    else if (colors !== null && packed !== undefined) {
      const color = view.getUint32(start + packed.offset, isLittle);
      colors[at] = ((color >> 16) & 255) / 255;
      colors[at + 1] = ((color >> 8) & 255) / 255;
      colors[at + 2] = (color & 255) / 255;
    }
    found += 1;
  }
  return {
    positions: positions.subarray(0, found * 3),
    colors: values === null ? (colors?.subarray(0, found * 3) ?? null) : colored(values.subarray(0, found), by),
    coloredBy: packed === undefined ? (measured?.name ?? 'flat') : 'rgb',
    sources: sources.subarray(0, found),
    leftOut: held - count,
  };
}

/** Packed colours, a field to measure by, or neither. A field that the cloud does not have is as none was named. */
function channelOf(
  fields: ReadonlyMap<string, Field>,
  height: Field,
  channel: string | undefined,
): { readonly packed?: Field | undefined; readonly measured?: Field | undefined; } {
  if (channel === 'flat') return {};
  const packed = fields.get('rgb') ?? fields.get('rgba');
  const named = channel === undefined || channel === 'rgb' ? undefined : fields.get(channel);
  if (named !== undefined && named !== packed) return { measured: named };
  return packed === undefined ? { measured: fields.get('intensity') ?? fields.get('intensities') ?? height } : { packed };
}

/** Everything that a message says of one of its points, by the names of its fields. */
export function pointValues(message: unknown, index: number): ReadonlyMap<string, number> {
  const data = member(message, 'data');
  const step = asNumber(member(message, 'point_step'));
  const width = asNumber(member(message, 'width'));
  const rowStep = asNumber(member(message, 'row_step'));
  const found = new Map<string, number>();
  if (!(data instanceof Uint8Array) || !(step > 0) || !(width > 0)) return found;
  const start = Math.floor(index / width) * (rowStep >= width * step ? rowStep : width * step) + (index % width) * step;
  if (!(start >= 0) || start + step > data.byteLength) return found;
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const isLittle = asNumber(member(message, 'is_bigendian')) === 0;
  for (const [name, field] of readFields(member(message, 'fields'), step)) found.set(name, number(view, start, field, isLittle));
  return found;
}

function readFields(value: unknown, step: number): ReadonlyMap<string, Field> {
  const fields = new Map<string, Field>();
  if (!Array.isArray(value)) return fields;
  for (const item of value.slice(0, 100) as readonly unknown[]) {
    const name = member(item, 'name');
    const offset = asNumber(member(item, 'offset'));
    const datatype = asNumber(member(item, 'datatype'));
    const size = SIZES[datatype] ?? 0;
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

/** Colours of the rainbow, violet to red. A value that is not a number is in the middle; so are all when they are equal. */
export function colored(values: Float32Array, by: PointColors): Float32Array {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    if (value < least) least = value;
    if (value > most) most = value;
  }
  [least, most] = [by.least ?? least, by.most ?? most];
  const colors = new Float32Array(values.length * 3);
  for (let i = 0; i < values.length; i += 1) {
    const value = values[i] ?? NaN;
    const part = most > least && Number.isFinite(value) ? Math.max(0, Math.min(1, (value - least) / (most - least))) : 0.5;
    const index = Math.round(part * (SHADES - 1)) * 3;
    for (let channel = 0; channel < 3; channel += 1) colors[i * 3 + channel] = shades[index + channel] ?? 0;
  }
  return colors;
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

const SHADES = 512;
const shades = Float32Array.from(Array.from({ length: SHADES }, (_, i) => [...rainbow(i / (SHADES - 1))]).flat());
