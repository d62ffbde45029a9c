// AVI files with a JPEG in each frame, as cameras and OpenCV's VideoWriter write them.
import { encode } from 'jpeg-js';

function chunk(name: string, ...parts: readonly Uint8Array[]): Uint8Array {
  const body = Buffer.concat(parts);
  const head = Buffer.alloc(8);
  head.write(name, 0, 'latin1');
  head.writeUInt32LE(body.length, 4);
  return Buffer.concat([head, body, Buffer.alloc(body.length & 1)]);
}

function list(kind: string, ...parts: readonly Uint8Array[]): Uint8Array {
  return chunk('LIST', Buffer.from(kind, 'latin1'), ...parts);
}

function words(...numbers: readonly number[]): Uint8Array {
  const bytes = Buffer.alloc(4 * numbers.length);
  numbers.forEach((number, index) => bytes.writeUInt32LE(number, 4 * index));
  return bytes;
}

export interface AviOptions {
  readonly width: number;
  readonly height: number;
  readonly fps: number;
  /** Red, green and blue of each frame. */
  readonly colours: readonly (readonly [number, number, number])[];
  readonly codec?: string;
}

export function mjpegAvi({ width, height, fps, colours, codec = 'MJPG' }: AviOptions): Uint8Array {
  const frames = colours.map((colour) => {
    const data = Buffer.alloc(4 * width * height, Uint8Array.from([...colour, 255]));
    return new Uint8Array(encode({ width, height, data }, 95).data);
  });
  const name = Buffer.from(codec, 'latin1');
  const main = chunk('avih', words(Math.round(1e6 / fps), 0, 0, 0x10, frames.length, 0, 1, 0, width, height, 0, 0, 0, 0));
  const stream = list(
    'strl',
    chunk('strh', Buffer.from('vids'), name, words(0, 0, 0, 1, fps, 0, frames.length, 0, 0, 0, 0, 0)),
    chunk('strf', words(40, width, height, 1 | (24 << 16)), name, words(3 * width * height, 0, 0, 0, 0)),
  );
  return chunk('RIFF', Buffer.from('AVI '), list('hdrl', main, stream), chunk('JUNK', Buffer.alloc(13)),
    list('movi', ...frames.map((frame) => chunk('00dc', frame))));
}
