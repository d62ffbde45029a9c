// Requests of programs for the visitor's camera: cv2.VideoCapture(N) publishes them on /cv2/camera_N/wanted (see
// runtime/packages/vendor/py_opencv/cv2/_camera.py).

import type { TopicView } from '../../contract/session.ts';
import { flagMember, numberMember } from './json.ts';

const WANTED = /^\/cv2\/camera_(\d{1,2})\/wanted$/;
const MOST_SIDE = 4096;
const MOST_RATE = 240;

/** The numbers of the cameras that programs request now. */
export function wantedCameras(topics: readonly TopicView[]): readonly number[] {
  return topics
    .filter(({ publishers, type }) => publishers > 0 && type === 'std_msgs/msg/String')
    .flatMap(({ name }) => {
      const number = WANTED.exec(name)?.[1];
      return number === undefined ? [] : [Number(number)];
    });
}

export interface CameraWish {
  /** Number of the request. */
  readonly turn: number;
  readonly width: number;
  readonly height: number;
  readonly fps: number;
  /** The program waits for the next picture. */
  readonly picture: boolean;
}

/** Any node can publish on the topic: invalid requests are ignored. */
export function readWish(text: string): CameraWish | undefined {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return undefined;
  }
  const turn = numberMember(value, 'turn', 0, Number.MAX_SAFE_INTEGER, -1);
  if (turn < 0) return undefined;
  return {
    turn,
    width: Math.round(numberMember(value, 'width', 1, MOST_SIDE, 640)),
    height: Math.round(numberMember(value, 'height', 1, MOST_SIDE, 480)),
    fps: numberMember(value, 'fps', 1, MOST_RATE, 30),
    picture: flagMember(value, 'picture', false),
  };
}

/** Converts RGBA to BGR. `room` is reused if it has the right size. */
export function blueFirst(rgba: Uint8ClampedArray, room?: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const count = rgba.length >> 2;
  const bgr = room?.length === 3 * count ? room : new Uint8Array(3 * count);
  for (let from = 0, to = 0; to < bgr.length; from += 4, to += 3) {
    bgr[to] = rgba[from + 2]!;
    bgr[to + 1] = rgba[from + 1]!;
    bgr[to + 2] = rgba[from]!;
  }
  return bgr;
}
