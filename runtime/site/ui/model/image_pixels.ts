// Images of sensor_msgs/msg/Image as RGBA pixels. Measured numbers (depth, 16-bit grey) are spread over a range: one
// that is given, or from the least to the most finite one. Pure; sizes are checked before anything is read.

import { encodingOf, numberReader, rowBytes, yuvAt } from './image_encodings.ts';
import type { BayerEncoding, ColorEncoding, MeasureEncoding, RawImage, YuvEncoding } from './image_encodings.ts';
import { imageTexts } from '../texts_image.ts';
import { numberMember } from './json.ts';

/** The values that are drawn black and white. */
export interface ImageRange {
  readonly least: number;
  readonly most: number;
}

/** An undefined bound is computed for each image. */
export interface WantedRange {
  readonly least: number | undefined;
  readonly most: number | undefined;
}

export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
  /** The range over which measured numbers are spread; null for other images. */
  readonly range: ImageRange | null;
}

export const AUTOMATIC: WantedRange = { least: undefined, most: undefined };

const MOST_PIXELS = 1 << 25;
const MOST_MEASURED = 1e9;

/** Reads the range in a panel's state. */
export function readRange(state: unknown): WantedRange {
  const bound = (name: string): number | undefined => {
    const value = numberMember(state, name, -MOST_MEASURED, MOST_MEASURED, Number.NaN);
    return Number.isNaN(value) ? undefined : value;
  };
  return { least: bound('least'), most: bound('most') };
}

/** The pixels, or why there are none. They are put into `room` when it is just as large. */
export function pixelsOf(image: RawImage, wanted: WantedRange = AUTOMATIC, room?: Uint8ClampedArray<ArrayBuffer>): Pixels | string {
  const { width, height, step, data, encoding: name } = image;
  if (!(width > 0 && height > 0)) return imageTexts.empty;
  if (width * height > MOST_PIXELS) return imageTexts.tooMany(width, height);
  const encoding = encodingOf(name);
  if (encoding === undefined) return imageTexts.unknown(name.slice(0, 40));
  const row = rowBytes(encoding, width);
  if (step < row) return imageTexts.shortRow(step, width);
  if (data.length < step * (height - 1) + row) return imageTexts.tooFew(data.length, height, step);
  const bytes = 4 * width * height;
  const rgba = room?.length === bytes ? room : new Uint8ClampedArray(bytes);
  let range: ImageRange | null = null;
  switch (encoding.kind) {
    case 'color':
      putColors(image, encoding, rgba);
      break;
    case 'bayer':
      putBayer(image, encoding, rgba);
      break;
    case 'yuv':
      putYuv(image, encoding, rgba);
      break;
    case 'measure':
      range = putMeasured(image, encoding, wanted, rgba);
      break;
  }
  return { width, height, rgba, range };
}

function putColors(image: RawImage, { depth, names, order }: ColorEncoding, rgba: Uint8ClampedArray): void {
  const { width, height, step, data } = image;
  const [red, green, blue, alpha] = order;
  const channels = names.length;
  if (depth === 'u8') {
    // A word for each pixel, its lowest byte first, as every machine with a browser has it: three times as quick.
    const words = new Uint32Array(rgba.buffer, rgba.byteOffset, width * height);
    for (let y = 0; y < height; y += 1) {
      const end = (y + 1) * width;
      for (let to = y * width, from = y * step; to < end; to += 1, from += channels) {
        const opacity = alpha < 0 ? 255 : data[from + alpha]!;
        words[to] = data[from + red]! | (data[from + green]! << 8) | (data[from + blue]! << 16) | (opacity << 24);
      }
    }
    return;
  }
  const read = numberReader(image, depth);
  // 65535 is 255.
  const at = (from: number, channel: number): number => read(from + 2 * channel) / 257;
  for (let y = 0; y < height; y += 1) {
    for (let x = 0, from = y * step, to = 4 * y * width; x < width; x += 1, from += 2 * channels, to += 4) {
      rgba[to] = at(from, red);
      rgba[to + 1] = at(from, green);
      rgba[to + 2] = at(from, blue);
      rgba[to + 3] = alpha < 0 ? 255 : at(from, alpha);
    }
  }
}

/** Each pixel takes the colours of its square of four: quick, and true to what was measured. */
function putBayer(image: RawImage, { red: [redX, redY] }: BayerEncoding, rgba: Uint8ClampedArray): void {
  const { width, height, step, data } = image;
  const at = (x: number, y: number): number => data[Math.min(y, height - 1) * step + Math.min(x, width - 1)] ?? 0;
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const [left, top] = [x & ~1, y & ~1];
      const to = 4 * (y * width + x);
      rgba[to] = at(left + redX, top + redY);
      rgba[to + 1] = (at(left + 1 - redX, top + redY) + at(left + redX, top + 1 - redY)) / 2;
      rgba[to + 2] = at(left + 1 - redX, top + 1 - redY);
      rgba[to + 3] = 255;
    }
  }
}

/** By BT.601 with brightness from 16 to 235, as OpenCV turns them into colours. */
function putYuv(image: RawImage, encoding: YuvEncoding, rgba: Uint8ClampedArray): void {
  const { width, height } = image;
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const [luma, u, v] = yuvAt(image, encoding, x, y);
      const bright = 1.164 * Math.max(0, luma - 16);
      const to = 4 * (y * width + x);
      rgba[to] = bright + 1.596 * (v - 128);
      rgba[to + 1] = bright - 0.813 * (v - 128) - 0.391 * (u - 128);
      rgba[to + 2] = bright + 2.018 * (u - 128);
      rgba[to + 3] = 255;
    }
  }
}

function putMeasured(image: RawImage, { depth }: MeasureEncoding, wanted: WantedRange, rgba: Uint8ClampedArray): ImageRange {
  const { width, height, step } = image;
  const read = numberReader(image, depth);
  const bytes = depth === 'f32' ? 4 : 2;
  const values = new Float32Array(width * height);
  let [lowest, highest] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const value = read(y * step + bytes * x);
      values[y * width + x] = value;
      if (!Number.isFinite(value)) continue;
      lowest = Math.min(lowest, value);
      highest = Math.max(highest, value);
    }
  }
  const none = lowest > highest;
  const least = wanted.least ?? (none ? 0 : lowest);
  const most = wanted.most ?? (none ? 0 : highest);
  const scale = most > least ? 255 / (most - least) : 0;
  for (let i = 0, to = 0; i < values.length; i += 1, to += 4) {
    const value = values[i] ?? Number.NaN;
    const good = Number.isFinite(value);
    const grey = good ? (scale === 0 ? 128 : (value - least) * scale) : 0;
    rgba[to] = grey;
    rgba[to + 1] = grey;
    rgba[to + 2] = grey;
    // A pixel without a measurement is transparent.
    rgba[to + 3] = good ? 255 : 0;
  }
  return { least, most };
}
