// Connects a program's requests with the visitor's camera, once the visitor agrees.

import type { Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { readWish } from '../model/camera_wishes.ts';
import type { CameraWish } from '../model/camera_wishes.ts';
import { textMember } from '../model/json.ts';
import { cameraTexts } from '../texts_camera.ts';
import { openCamera, refusal } from './camera_source.ts';
import type { CameraPicture, CameraSource } from './camera_source.ts';
import { feedFromPast } from './message_feed.ts';

const TEXT = 'std_msgs/msg/String';
const IMAGE = 'sensor_msgs/msg/Image';

/** asks: waits for the visitor. refused: by the visitor or the browser, or stopped. */
export type CameraState = 'asks' | 'opening' | 'open' | 'refused';

export interface CameraDesk {
  readonly allow: () => void;
  /** Also stops a running camera. */
  readonly refuse: () => void;
  readonly close: () => void;
}

export function cameraDesk(session: Session, codec: Codec, number: number, onState: (state: CameraState) => void): CameraDesk {
  const topic = `/cv2/camera_${number}`;
  const answers = session.node().publisher(`${topic}/told`, TEXT);
  const pictures = session.node().publisher(`${topic}/image`, IMAGE);
  let state: CameraState = 'asks';
  let reason = '';
  let wish: CameraWish | undefined;
  let camera: CameraSource | undefined;
  let isTaking = false;
  let isClosed = false;

  const answer = (): void => {
    const told = state === 'open' ? { state, ...camera?.facts() } : { state, reason };
    const encoded = codec.encode(TEXT, { data: JSON.stringify({ turn: wish?.turn ?? 0, ...told }) });
    if (encoded.kind === 'bytes') answers.publish(encoded.bytes);
  };
  const become = (next: CameraState, why = ''): void => {
    state = next;
    reason = why;
    onState(next);
    if (next === 'open' || next === 'refused') answer();
  };
  const end = (why: string): void => {
    camera?.close();
    camera = undefined;
    isTaking = false;
    if (!isClosed) become('refused', why);
  };
  const send = ({ width, height, bgr }: CameraPicture): void => {
    isTaking = false;
    if (camera === undefined) return;
    const encoded = codec.encode(IMAGE, { height, width, encoding: 'bgr8', step: 3 * width, data: bgr });
    if (encoded.kind === 'bytes') pictures.publish(encoded.bytes);
  };
  const follow = async (next: CameraWish): Promise<void> => {
    const before = wish;
    wish = next;
    if (state === 'refused') answer();
    if (camera === undefined) return;
    if (next.picture) {
      if (!isTaking) camera.next(send);
      isTaking = true;
      return;
    }
    if (before?.width !== next.width || before.height !== next.height || before.fps !== next.fps) await camera.change(next).catch(() => undefined);
    if (state === 'open') answer();
  };
  const stop = feedFromPast(session, codec, `${topic}/wanted`, ({ decoded }) => {
    const next = decoded.kind === 'failed' ? undefined : readWish(textMember(decoded.value, 'data'));
    if (next !== undefined) void follow(next);
  });
  const allow = async (): Promise<void> => {
    become('opening');
    try {
      const opened = await openCamera(number, wish ?? { turn: 0, width: 640, height: 480, fps: 30, picture: false }, () => end(cameraTexts.ended));
      if (isClosed || state !== 'opening') {
        opened.close();
        return;
      }
      camera = opened;
      become('open');
    } catch (error) {
      if (!isClosed) become('refused', refusal(error));
    }
  };
  return {
    allow: () => void allow(),
    refuse: () => end(cameraTexts.refused),
    close: () => {
      isClosed = true;
      stop();
      camera?.close();
      answers.close();
      pictures.close();
    },
  };
}
