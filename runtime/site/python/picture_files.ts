// Files of pictures for cv2: PNG by fast-png, JPEG by jpeg-js. Pixels are as OpenCV has them, with blue first.

import { decode as decodePng, encode as encodePng } from 'fast-png';
import { decode as decodeJpeg, encode as encodeJpeg } from 'jpeg-js';

export interface Picture {
  readonly rows: number;
  readonly cols: number;
  readonly channels: number;
  /** 0: bytes, 2: words of 16 bits. */
  readonly depth: number;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

const mostPixels = 100e6;
/** Millions of pixels, and MB of memory. */
const mostOfJpeg = { maxResolutionInMP: mostPixels / 1e6, maxMemoryUsageInMB: 1024 };
/** Where a PNG file says how wide it is; the height follows. Both are words of four bytes. */
const sizeOfPng = 16;

/** Exchanges red and blue. */
function turned<Pixels extends Uint8Array | Uint16Array>(pixels: Pixels, channels: number): Pixels {
  if (channels < 3) return pixels;
  for (let i = 0; i + 2 < pixels.length; i += channels) [pixels[i], pixels[i + 2]] = [pixels[i + 2]!, pixels[i]!];
  return pixels;
}

function bytesOf(pixels: Uint8Array | Uint16Array): Uint8Array<ArrayBuffer> {
  return new Uint8Array(pixels.slice().buffer as ArrayBuffer);
}

/** Pixel `i` of rows with 8 bits or less per pixel: several in a byte, the first one in its upper bits. */
function packedPixel(data: Uint8Array, width: number, depth: number, i: number): number {
  const place = (i % width) * depth;
  const row = Math.floor(i / width) * Math.ceil((width * depth) / 8);
  return (data[row + (place >> 3)]! >> (8 - depth - (place & 7))) & ((1 << depth) - 1);
}

function fromPng(file: Uint8Array<ArrayBuffer>): Picture {
  const head = new DataView(file.buffer, file.byteOffset, file.byteLength);
  // Before anything is unpacked: a small file can hold a huge picture.
  if (head.getUint32(sizeOfPng) * head.getUint32(sizeOfPng + 4) > mostPixels) throw new RangeError('the picture is too large');
  const { width, height, data, depth, channels, palette } = decodePng(file);
  if (palette !== undefined) {
    const pixels = new Uint8Array(width * height * 3);
    for (let i = 0; i < width * height; i += 1) {
      const [red = 0, green = 0, blue = 0] = palette[packedPixel(data as Uint8Array, width, depth, i)] ?? [];
      pixels.set([blue, green, red], 3 * i);
    }
    return { rows: height, cols: width, channels: 3, depth: 0, bytes: pixels };
  }
  if (depth < 8) {
    const most = (1 << depth) - 1;
    const pixels = new Uint8Array(width * height);
    for (let i = 0; i < pixels.length; i += 1) pixels[i] = (packedPixel(data as Uint8Array, width, depth, i) * 255) / most;
    return { rows: height, cols: width, channels: 1, depth: 0, bytes: pixels };
  }
  const pixels = data as Uint8Array | Uint16Array;
  const wide = depth === 16;
  // Gray with an opacity: OpenCV has four channels then.
  if (channels === 2) {
    const four = wide ? new Uint16Array(width * height * 4) : new Uint8Array(width * height * 4);
    for (let i = 0; i < width * height; i += 1) four.set([pixels[2 * i]!, pixels[2 * i]!, pixels[2 * i]!, pixels[2 * i + 1]!], 4 * i);
    return { rows: height, cols: width, channels: 4, depth: wide ? 2 : 0, bytes: bytesOf(four) };
  }
  return { rows: height, cols: width, channels, depth: wide ? 2 : 0, bytes: bytesOf(turned(pixels, channels)) };
}

function fromJpeg(file: Uint8Array<ArrayBuffer>): Picture {
  const { width, height, data } = decodeJpeg(file, { useTArray: true, formatAsRGBA: false, tolerantDecoding: true, ...mostOfJpeg });
  const channels = data.length / (width * height);
  return { rows: height, cols: width, channels, depth: 0, bytes: bytesOf(turned(data, channels)) };
}

/** undefined: the file is not a whole one of a known form. */
export function decodePicture(file: Uint8Array<ArrayBuffer>): Picture | undefined {
  try {
    if (file[0] === 0x89 && file[1] === 0x50) return fromPng(file);
    return file[0] === 0xff && file[1] === 0xd8 ? fromJpeg(file) : undefined;
  } catch {
    return undefined;
  }
}

/** `ending`: `.png`, else JPEG. */
export function encodePicture(ending: string, { rows, cols, channels, depth, bytes }: Picture, quality: number): Uint8Array {
  if (ending === '.png') {
    const pixels = depth === 0 ? bytes : new Uint16Array(bytes.buffer);
    return encodePng({ width: cols, height: rows, data: turned(pixels, channels), channels: channels as 1 | 2 | 3 | 4, depth: depth === 0 ? 8 : 16 });
  }
  const data = new Uint8Array(rows * cols * 4).fill(255);
  for (let i = 0; i < rows * cols; i += 1) {
    const at = i * channels;
    const blue = bytes[at]!;
    data.set(channels < 3 ? [blue, blue, blue] : [bytes[at + 2]!, bytes[at + 1]!, blue], 4 * i);
  }
  return encodeJpeg({ data, width: cols, height: rows }, quality).data;
}
