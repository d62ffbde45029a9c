// Images of sensor_msgs/msg/Image as RGBA pixels. Encodings are those of sensor_msgs/image_encodings.hpp. Depth and
// 16-bit grey are spread between their least and most finite value. Pure; sizes are checked before anything is read.

export interface RawImage {
  readonly width: number;
  readonly height: number;
  readonly encoding: string;
  readonly step: number;
  readonly isBigEndian: boolean;
  readonly data: Uint8Array;
}

export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

const kMostPixels = 1 << 25;

interface Layout {
  readonly bytes: number;
  /** Puts the pixel that begins at `from` to `to`. */
  readonly put: (data: Uint8Array, from: number, rgba: Uint8ClampedArray, to: number) => void;
}

function ordered(bytes: number, red: number, green: number, blue: number, alpha: number | null): Layout {
  return {
    bytes,
    put(data, from, rgba, to) {
      rgba[to] = data[from + red] ?? 0;
      rgba[to + 1] = data[from + green] ?? 0;
      rgba[to + 2] = data[from + blue] ?? 0;
      rgba[to + 3] = alpha === null ? 255 : (data[from + alpha] ?? 255);
    },
  };
}

const kLayouts: ReadonlyMap<string, Layout> = new Map([
  ['rgb8', ordered(3, 0, 1, 2, null)],
  ['bgr8', ordered(3, 2, 1, 0, null)],
  ['8UC3', ordered(3, 2, 1, 0, null)],
  ['rgba8', ordered(4, 0, 1, 2, 3)],
  ['bgra8', ordered(4, 2, 1, 0, 3)],
  ['8UC4', ordered(4, 2, 1, 0, 3)],
  ['mono8', ordered(1, 0, 0, 0, null)],
  ['8UC1', ordered(1, 0, 0, 0, null)],
]);

/** Where red stands in each square of four, and where blue: column, row. */
const kBayer: ReadonlyMap<string, readonly [number, number]> = new Map([
  ['bayer_rggb8', [0, 0]],
  ['bayer_bggr8', [1, 1]],
  ['bayer_gbrg8', [0, 1]],
  ['bayer_grbg8', [1, 0]],
]);

/** The pixels, or why there are none. */
export function pixelsOf(image: RawImage): Pixels | string {
  const { width, height, step, data, encoding } = image;
  if (!(width > 0 && height > 0)) return 'the image is empty';
  if (width * height > kMostPixels) return `${width} \u00d7 ${height} pixels are too many`;
  const layout = kLayouts.get(encoding);
  const bayer = kBayer.get(encoding);
  const deep = encoding === 'mono16' || encoding === '16UC1' ? 2 : encoding === '32FC1' ? 4 : 0;
  const bytes = layout?.bytes ?? (bayer === undefined ? deep : 1);
  if (bytes === 0) return `the encoding \u201c${encoding.slice(0, 40)}\u201d is not known here`;
  if (step < width * bytes) return `a row of ${step} bytes is too short for ${width} pixels`;
  if (data.length < step * (height - 1) + width * bytes)
    return `${data.length} bytes are too few for ${height} rows of ${step}`;
  const rgba = new Uint8ClampedArray(4 * width * height);
  if (layout !== undefined) {
    for (let y = 0; y < height; y += 1)
      for (let x = 0; x < width; x += 1)
        layout.put(data, y * step + x * bytes, rgba, 4 * (y * width + x));
  } else if (bayer !== undefined) {
    putBayer(image, bayer, rgba);
  } else {
    putDeep(image, deep === 4, rgba);
  }
  return { width, height, rgba };
}

/** Each pixel takes the colours of its square of four: quick, and true to what was measured. */
function putBayer(image: RawImage, [redX, redY]: readonly [number, number], rgba: Uint8ClampedArray): void {
  const { width, height, step, data } = image;
  const at = (x: number, y: number): number =>
    data[Math.min(y, height - 1) * step + Math.min(x, width - 1)] ?? 0;
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

function putDeep(image: RawImage, float: boolean, rgba: Uint8ClampedArray): void {
  const { width, height } = image;
  const values = new Float32Array(width * height);
  let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = 0; i < values.length; i += 1) {
    const value = deepValue(image, i % width, Math.floor(i / width), float);
    values[i] = value;
    if (!Number.isFinite(value)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  const scale = most > least ? 255 / (most - least) : 0;
  values.forEach((value, i) => {
    const good = Number.isFinite(value);
    rgba.fill(good ? (scale === 0 ? 128 : (value - least) * scale) : 0, 4 * i, 4 * i + 3);
    // What was not measured is seen through.
    rgba[4 * i + 3] = good ? 255 : 0;
  });
}

function deepValue({ data, step, isBigEndian }: RawImage, x: number, y: number, float: boolean): number {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  return float
    ? view.getFloat32(y * step + 4 * x, !isBigEndian)
    : view.getUint16(y * step + 2 * x, !isBigEndian);
}

/** What was measured at a pixel, in words: `12 200 3`, `1.25`. Empty outside. */
export function pixelWords(image: RawImage, x: number, y: number): string {
  if (!(x >= 0 && y >= 0 && x < image.width && y < image.height)) return '';
  if (image.encoding === '32FC1') return String(Number(deepValue(image, x, y, true).toPrecision(6)));
  if (image.encoding === 'mono16' || image.encoding === '16UC1') return String(deepValue(image, x, y, false));
  const bytes = kLayouts.get(image.encoding)?.bytes ?? 1;
  const from = y * image.step + x * bytes;
  return [...image.data.subarray(from, from + bytes)].join(' ');
}
