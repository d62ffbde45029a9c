// Requests for the visitor's camera, and the conversion of its pictures for OpenCV.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { TopicView } from '../../../runtime/site/contract/session.ts';
import { blueFirst, readWish, wantedCameras } from '../../../runtime/site/ui/model/camera_wishes.ts';

const topic = (name: string, publishers = 1, type = 'std_msgs/msg/String') => ({ name, type, publishers }) as TopicView;

test('cameras are wanted by number, while a program wants them', () => {
  assert.deepEqual(
    wantedCameras([topic('/cv2/camera_0/wanted'), topic('/cv2/camera_12/wanted'), topic('/cv2/camera_1/wanted', 0), topic('/cv2/camera_2/wanted', 1, 'x'),
      topic('/cv2/camera_0/told')]),
    [0, 12],
  );
});

test('wishes are those that make sense, whoever has sent them', () => {
  const wish = { turn: 3, width: 320, height: 240, fps: 15, picture: true };
  assert.deepEqual(readWish(JSON.stringify(wish)), wish);
  assert.deepEqual(readWish('{"turn": 0, "width": -1, "height": 1e9, "fps": "x", "picture": 1}'), {
    turn: 0,
    width: 640,
    height: 480,
    fps: 30,
    picture: false,
  });
  for (const text of ['', '{', 'null', '[]', '{"turn": -1}', '{"turn": "1"}']) assert.equal(readWish(text), undefined, text);
});

test('pixels have blue first, in the room that there is', () => {
  const first = blueFirst(Uint8ClampedArray.from([1, 2, 3, 255, 4, 5, 6, 0]));
  assert.deepEqual([...first], [3, 2, 1, 6, 5, 4]);
  const second = blueFirst(Uint8ClampedArray.from([9, 8, 7, 255, 6, 5, 4, 255]), first);
  assert.equal(second, first);
  assert.deepEqual([...second], [7, 8, 9, 4, 5, 6]);
  assert.equal(blueFirst(new Uint8ClampedArray(4), first).length, 3);
});
