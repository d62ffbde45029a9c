// Draws the messages of an image topic, raw or compressed, on a canvas: the newest one, once per frame of the page at most.

import { isMessage } from '../../decode/yaml.ts';
import type { Codec } from '../../decode/codec.ts';
import type { Session, Unsubscribe } from '../../contract/session.ts';
import { asNumber } from '../model/field_path.ts';
import type { RawImage } from '../model/image_encodings.ts';
import { AUTOMATIC, pixelsOf } from '../model/image_pixels.ts';
import type { ImageRange, WantedRange } from '../model/image_pixels.ts';
import { texts } from '../texts.ts';
import { imageTexts } from '../texts_image.ts';
import { feed } from './message_feed.ts';

const RAW = 'sensor_msgs/msg/Image';
const COMPRESSED = 'sensor_msgs/msg/CompressedImage';
const MOST_COMPRESSED = 1 << 26;

export function isImage(type: string): boolean {
  return type === RAW || type === COMPRESSED;
}

export interface ImageTold {
  /** Size and encoding, in words. */
  readonly facts: string;
  /** Why the newest one is not drawn; empty: it is. */
  readonly problem: string;
  /** null when it came compressed, or not at all. */
  readonly raw: RawImage | null;
  /** Over what its numbers are spread; null where they are colours. */
  readonly range: ImageRange | null;
}

export interface ImageDrawing {
  readonly stop: Unsubscribe;
  /** Draws the last image once more: the range that is wanted is another one. */
  readonly again: () => void;
}

interface ImageMessage {
  readonly type: string;
  readonly value: Readonly<Record<string, unknown>>;
}

export function drawImages(
  session: Session,
  codec: Codec,
  topic: string,
  canvas: () => HTMLCanvasElement | null,
  tell: (told: ImageTold) => void,
  range: () => WantedRange = () => AUTOMATIC,
): ImageDrawing {
  let current = true;
  let newest: ImageMessage | null = null;
  let last: ImageMessage | null = null;
  let frame = 0;
  let busy = false;
  const room: Room = { rgba: new Uint8ClampedArray() };
  const draw = async (): Promise<void> => {
    frame = 0;
    const next = newest;
    const element = canvas();
    if (next === null || element === null || busy) return;
    newest = null;
    last = next;
    busy = true;
    const told = next.type === RAW ? drawRaw(element, next.value, range(), room) : await drawCompressed(element, next.value);
    busy = false;
    if (!current) return;
    tell(told);
    if (newest !== null) soon();
  };
  const soon = (): void => {
    if (frame === 0) frame = requestAnimationFrame(() => void draw());
  };
  const stop = feed(session, codec, topic, ({ decoded, type }) => {
    if (decoded.kind === 'failed') {
      tell(fault(texts.topics.undecodable(decoded.reason)));
      return;
    }
    if (!isMessage(decoded.value)) return;
    // Only the newest one that there is time for is drawn.
    newest = { type, value: decoded.value };
    soon();
  });
  return {
    stop: () => {
      current = false;
      cancelAnimationFrame(frame);
      stop();
    },
    again: () => {
      newest ??= last;
      if (newest !== null) soon();
    },
  };
}

function fault(problem: string): ImageTold {
  return { facts: '', problem, raw: null, range: null };
}

/** The pixels of the last image, in whose place those of the next one come: nearly always it has the same size. */
interface Room {
  rgba: Uint8ClampedArray<ArrayBuffer>;
}

function drawRaw(canvas: HTMLCanvasElement, value: Readonly<Record<string, unknown>>, range: WantedRange, room: Room): ImageTold {
  const { data, encoding } = value;
  if (!(data instanceof Uint8Array) || typeof encoding !== 'string') return fault(imageTexts.noImage);
  const raw: RawImage = {
    width: asNumber(value['width']),
    height: asNumber(value['height']),
    step: asNumber(value['step']),
    isBigEndian: asNumber(value['is_bigendian']) !== 0,
    encoding,
    data,
  };
  const pixels = pixelsOf(raw, range, room.rgba);
  if (typeof pixels === 'string') return fault(texts.topics.undecodable(pixels));
  room.rgba = pixels.rgba;
  resize(canvas, pixels.width, pixels.height);
  canvas.getContext('2d')?.putImageData(new ImageData(pixels.rgba, pixels.width, pixels.height), 0, 0);
  return { facts: imageTexts.facts(pixels.width, pixels.height, encoding), problem: '', raw, range: pixels.range };
}

async function drawCompressed(canvas: HTMLCanvasElement, value: Readonly<Record<string, unknown>>): Promise<ImageTold> {
  const { data, format } = value;
  if (!(data instanceof Uint8Array) || data.length > MOST_COMPRESSED) return fault(imageTexts.noImage);
  const name = typeof format === 'string' ? format : '';
  try {
    const picture = await createImageBitmap(new Blob([Uint8Array.from(data)]));
    resize(canvas, picture.width, picture.height);
    canvas.getContext('2d')?.drawImage(picture, 0, 0);
    const facts = imageTexts.facts(picture.width, picture.height, name.slice(0, 40));
    picture.close();
    return { facts, problem: '', raw: null, range: null };
  } catch {
    return fault(imageTexts.notRead(name.slice(0, 40)));
  }
}

function resize(canvas: HTMLCanvasElement, width: number, height: number): void {
  if (canvas.width === width && canvas.height === height) return;
  canvas.width = width;
  canvas.height = height;
}
