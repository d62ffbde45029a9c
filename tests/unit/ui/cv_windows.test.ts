// Windows of cv2: which topics are windows, what their controls are, and how keys and the pointer read for OpenCV.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { TopicView } from '../../../runtime/site/contract/session.ts';
import { isWindow, windowsOf } from '../../../runtime/site/ui/model/cv_window_topics.ts';
import { keyCode, NO_CONTROLS, mouseEvent, readControls } from '../../../runtime/site/ui/model/cv_windows.ts';

const topic = (name: string, type: string, publishers: number) => ({ name, type, publishers }) as TopicView;

test('windows are images that a node publishes below /cv2', () => {
  assert.deepEqual(['/cv2/mask', '/cv2/My_mask', '/cv2', '/cv2/a/input', '/x/cv2/a', '/camera'].map(isWindow), [true, true, false, false, false, false]);
  const image = 'sensor_msgs/msg/Image';
  assert.deepEqual(windowsOf([topic('/cv2/a', image, 1), topic('/cv2/b', image, 0), topic('/cv2/c', 'std_msgs/msg/String', 1), topic('/d', image, 1)]), [
    '/cv2/a',
  ]);
});

test('controls are those that make sense, whoever has sent them', () => {
  const bars = [{ name: 'Hue', value: 30, count: 179 }];
  assert.deepEqual(readControls(JSON.stringify({ trackbars: bars, mouse: true })), { trackbars: bars, mouse: true });
  assert.deepEqual(readControls('{"trackbars": [{"name": "a", "value": 12, "count": 5}, {"count": "x"}, 7]}').trackbars, [
    { name: 'a', value: 0, count: 5 },
    { name: '', value: 0, count: 0 },
    { name: '', value: 0, count: 0 },
  ]);
  for (const text of ['', '{', 'null', '[]', '{"trackbars": {"length": 3}, "mouse": 1}']) assert.deepEqual(readControls(text), NO_CONTROLS, text);
  assert.equal(readControls(JSON.stringify({ trackbars: Array.from({ length: 1000 }, () => bars[0]) })).trackbars.length, 50);
});

test('keys have the codes that waitKey gives for them', () => {
  assert.deepEqual(['q', 'A', '0', ' ', 'Escape', 'Enter', 'ArrowLeft', 'ArrowDown', 'é'].map(keyCode), [113, 65, 48, 32, 27, 13, 81, 84, 233]);
  for (const key of ['Shift', 'F5', 'Ω', 'Dead']) assert.equal(keyCode(key), undefined, key);
});

test('the pointer reads as the events and flags of a mouse callback', () => {
  const none = { button: 0, buttons: 0, ctrlKey: false, shiftKey: false, altKey: false };
  assert.deepEqual(mouseEvent('down', 3, 4, { ...none, buttons: 1 }), [1, 3, 4, 1]);
  assert.deepEqual(mouseEvent('up', 3, 4, { ...none, button: 2 }), [5, 3, 4, 0]);
  assert.deepEqual(mouseEvent('move', 0, 9, { ...none, button: -1, buttons: 2, ctrlKey: true, altKey: true }), [0, 0, 9, 2 | 8 | 32]);
  assert.deepEqual(mouseEvent('double', 1, 1, none), [7, 1, 1, 0]);
  assert.equal(mouseEvent('down', 1, 1, { ...none, button: 4 }), undefined);
});
