// The visitor's camera. Pictures are read one at a time, on request.

import type { CameraWish } from '../model/camera_wishes.ts';
import { blueFirst } from '../model/camera_wishes.ts';
import { cameraTexts } from '../texts_camera.ts';

export interface CameraPicture {
  readonly width: number;
  readonly height: number;
  /** BGR, valid until the next picture. */
  readonly bgr: Uint8Array<ArrayBuffer>;
}

export interface CameraSource {
  readonly facts: () => { readonly width: number; readonly height: number; readonly fps: number; };
  readonly change: (wish: CameraWish) => Promise<void>;
  /** Calls back once, with the next frame of the camera. */
  readonly next: (listener: (picture: CameraPicture) => void) => void;
  readonly close: () => void;
}

function constraintsOf({ width, height, fps }: CameraWish): MediaTrackConstraints {
  return { width: { ideal: width }, height: { ideal: height }, frameRate: { ideal: fps } };
}

class NoCamera extends Error {}

async function streamOf(number: number, wish: CameraWish): Promise<MediaStream> {
  // undefined on pages without https.
  const devices = navigator.mediaDevices as MediaDevices | undefined;
  if (devices === undefined) throw new NoCamera(cameraTexts.insecure);
  const first = await devices.getUserMedia({ video: constraintsOf(wish) });
  if (number === 0) return first;
  const chosen = (await devices.enumerateDevices()).filter(({ kind }) => kind === 'videoinput')[number];
  for (const track of first.getTracks()) track.stop();
  if (chosen === undefined) throw new NoCamera(cameraTexts.noCamera);
  return devices.getUserMedia({ video: { ...constraintsOf(wish), deviceId: { exact: chosen.deviceId } } });
}

/** The reason for the program's console. */
export function refusal(error: unknown): string {
  if (error instanceof NoCamera) return error.message;
  const name = error instanceof Error ? error.name : '';
  return name === 'NotFoundError' || name === 'OverconstrainedError' ? cameraTexts.noCamera : cameraTexts.notAllowed;
}

/** `ended`: the device was removed. Rejects if the camera cannot be opened; see refusal(). */
export async function openCamera(number: number, wish: CameraWish, ended: () => void): Promise<CameraSource> {
  const stream = await streamOf(number, wish);
  const [track] = stream.getVideoTracks();
  if (track === undefined) throw new NoCamera(cameraTexts.noCamera);
  track.addEventListener('ended', ended);
  const video = document.createElement('video');
  video.muted = true;
  video.playsInline = true;
  video.srcObject = stream;
  await video.play();
  const sheet = new OffscreenCanvas(1, 1);
  const context = sheet.getContext('2d', { willReadFrequently: true });
  let room: Uint8Array<ArrayBuffer> | undefined;
  const take = (listener: (picture: CameraPicture) => void): void => {
    const { videoWidth: width, videoHeight: height } = video;
    if (context === null || width === 0 || height === 0) return;
    if (sheet.width !== width || sheet.height !== height) Object.assign(sheet, { width, height });
    context.drawImage(video, 0, 0);
    room = blueFirst(context.getImageData(0, 0, width, height).data, room);
    listener({ width, height, bgr: room });
  };
  return {
    facts: () => ({ width: video.videoWidth, height: video.videoHeight, fps: track.getSettings().frameRate ?? wish.fps }),
    change: async (next) => {
      const resized = new Promise<void>((done) => {
        video.addEventListener('resize', () => done(), { once: true });
        setTimeout(done, 1000);
      });
      await track.applyConstraints(constraintsOf(next));
      const { width, height } = track.getSettings();
      if (width !== video.videoWidth || height !== video.videoHeight) await resized;
    },
    next: (listener) => void video.requestVideoFrameCallback(() => take(listener)),
    close: () => {
      track.removeEventListener('ended', ended);
      for (const one of stream.getTracks()) one.stop();
      video.srcObject = null;
    },
  };
}
