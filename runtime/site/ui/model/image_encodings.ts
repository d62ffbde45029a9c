// The encodings of sensor_msgs/msg/Image, as sensor_msgs/image_encodings.hpp names them: where the channels of a pixel
// lie, what they are called, and what was measured there. Pure.

export interface RawImage {
  readonly width: number;
  readonly height: number;
  readonly encoding: string;
  /** Bytes of a row. */
  readonly step: number;
  readonly isBigEndian: boolean;
  readonly data: Uint8Array;
}

type Depth = 'u8' | 'u16' | 's16' | 'f32';

export interface ColorEncoding {
  readonly kind: 'color';
  readonly depth: 'u8' | 'u16';
  /** The name of each channel, in the order of the data; empty: the channel has no name. */
  readonly names: readonly string[];
  /** Which channels are red, green, blue and alpha; -1: opaque. */
  readonly order: readonly [number, number, number, number];
}

/** One number per pixel that is a measurement, not a brightness: a picture spreads them over a range. */
export interface MeasureEncoding {
  readonly kind: 'measure';
  readonly depth: 'u16' | 's16' | 'f32';
}

export interface BayerEncoding {
  readonly kind: 'bayer';
  /** Where red stands in each square of four: column, row. Blue is opposite, and green is the rest. */
  readonly red: readonly [number, number];
}

/** Two pixels share four bytes, and the colours in them. */
export interface YuvEncoding {
  readonly kind: 'yuv';
  /** Places in the four bytes; the second pixel's brightness is two further. */
  readonly y: number;
  readonly u: number;
  readonly v: number;
}

export type Encoding = ColorEncoding | MeasureEncoding | BayerEncoding | YuvEncoding;

function color(depth: 'u8' | 'u16', names: string): Encoding {
  const at = (name: string): number => names.indexOf(name);
  return { kind: 'color', depth, names: [...names], order: [at('R'), at('G'), at('B'), at('A')] };
}

const GREY: Encoding = { kind: 'color', depth: 'u8', names: [''], order: [0, 0, 0, -1] };
const UYVY: Encoding = { kind: 'yuv', y: 1, u: 0, v: 2 };
const YUYV: Encoding = { kind: 'yuv', y: 0, u: 1, v: 3 };

const ENCODINGS: ReadonlyMap<string, Encoding> = new Map<string, Encoding>([
  ['rgb8', color('u8', 'RGB')],
  ['bgr8', color('u8', 'BGR')],
  ['rgba8', color('u8', 'RGBA')],
  ['bgra8', color('u8', 'BGRA')],
  ['rgb16', color('u16', 'RGB')],
  ['bgr16', color('u16', 'BGR')],
  ['rgba16', color('u16', 'RGBA')],
  ['bgra16', color('u16', 'BGRA')],
  ['mono8', GREY],
  ['8UC1', GREY],
  // Nobody says what these channels are; OpenCV puts blue first.
  ['8UC3', { kind: 'color', depth: 'u8', names: ['', '', ''], order: [2, 1, 0, -1] }],
  ['8UC4', { kind: 'color', depth: 'u8', names: ['', '', '', ''], order: [2, 1, 0, 3] }],
  ['mono16', { kind: 'measure', depth: 'u16' }],
  ['16UC1', { kind: 'measure', depth: 'u16' }],
  ['16SC1', { kind: 'measure', depth: 's16' }],
  ['32FC1', { kind: 'measure', depth: 'f32' }],
  ['bayer_rggb8', { kind: 'bayer', red: [0, 0] }],
  ['bayer_bggr8', { kind: 'bayer', red: [1, 1] }],
  ['bayer_gbrg8', { kind: 'bayer', red: [0, 1] }],
  ['bayer_grbg8', { kind: 'bayer', red: [1, 0] }],
  // Each by the name that upstream calls old and by the new one.
  ['yuv422', UYVY],
  ['uyvy', UYVY],
  ['yuv422_yuy2', YUYV],
  ['yuyv', YUYV],
]);

const BYTES: Readonly<Record<Depth, number>> = { u8: 1, u16: 2, s16: 2, f32: 4 };

export function encodingOf(name: string): Encoding | undefined {
  return ENCODINGS.get(name);
}

/** Bytes that a row of so many pixels takes. */
export function rowBytes(encoding: Encoding, width: number): number {
  switch (encoding.kind) {
    case 'color':
      return width * encoding.names.length * BYTES[encoding.depth];
    case 'measure':
      return width * BYTES[encoding.depth];
    case 'bayer':
      return width;
    case 'yuv':
      return 4 * Math.ceil(width / 2);
  }
}

/** Reads a number of a measured or coloured image, `at` bytes from the beginning. */
export function numberReader({ data, isBigEndian }: RawImage, depth: Depth): (at: number) => number {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const little = !isBigEndian;
  switch (depth) {
    case 'u8':
      return (at) => view.getUint8(at);
    case 'u16':
      return (at) => view.getUint16(at, little);
    case 's16':
      return (at) => view.getInt16(at, little);
    case 'f32':
      return (at) => view.getFloat32(at, little);
  }
}

/**
 * The value at a pixel, in the units and the order of its encoding: `R 12 G 200 B 3`, `1.25`. Empty outside.
 * The image is one that pixelsOf() took.
 */
export function pixelWords(image: RawImage, x: number, y: number): string {
  const encoding = encodingOf(image.encoding);
  if (encoding === undefined || !(x >= 0 && y >= 0 && x < image.width && y < image.height)) return '';
  const row = y * image.step;
  switch (encoding.kind) {
    case 'color': {
      const read = numberReader(image, encoding.depth);
      const bytes = BYTES[encoding.depth];
      const from = row + x * bytes * encoding.names.length;
      return encoding.names.map((name, index) => `${name} ${read(from + index * bytes)}`.trimStart()).join(' ');
    }
    case 'measure':
      return String(Number(numberReader(image, encoding.depth)(row + x * BYTES[encoding.depth]).toPrecision(6)));
    case 'bayer': {
      const [redX, redY] = encoding.red;
      const across = (x & 1) === redX;
      const along = (y & 1) === redY;
      return `${across && along ? 'R' : across || along ? 'G' : 'B'} ${image.data[row + x] ?? 0}`;
    }
    case 'yuv': {
      const [luma, u, v] = yuvAt(image, encoding, x, y);
      return `Y ${luma} U ${u} V ${v}`;
    }
  }
}

export function yuvAt({ data, step }: RawImage, { y: luma, u, v }: YuvEncoding, x: number, y: number): readonly [number, number, number] {
  const pair = y * step + 4 * (x >> 1);
  return [data[pair + luma + 2 * (x & 1)] ?? 0, data[pair + u] ?? 0, data[pair + v] ?? 0];
}
