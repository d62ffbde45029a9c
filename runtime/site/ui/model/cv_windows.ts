// Windows of cv2: a Python node publishes what imshow() shows on /cv2/NAME, and waits for keys on /cv2/NAME/key (see
// runtime/packages/vendor/py_opencv/cv2/_windows.py).

import type { TopicView } from '../../contract/session.ts';

const kTopic = /^\/cv2\/\w+$/;
const kImage = 'sensor_msgs/msg/Image';

export function isWindow(topic: string): boolean {
  return kTopic.test(topic);
}

/** The windows that a node shows now. */
export function windowsOf(topics: readonly TopicView[]): readonly string[] {
  return topics.filter(({ name, type, publishers }) => type === kImage && isWindow(name) && publishers > 0).map(({ name }) => name);
}

/** As waitKey() gives them under GTK, cut to a byte. */
const kNamed: ReadonlyMap<string, number> = new Map([
  ['Backspace', 8], ['Tab', 9], ['Enter', 13], ['Escape', 27], ['Delete', 255],
  ['ArrowLeft', 81], ['ArrowUp', 82], ['ArrowRight', 83], ['ArrowDown', 84], ['PageUp', 85], ['PageDown', 86], ['End', 87], ['Home', 80],
]);

/** undefined: it has none, as Shift alone. */
export function keyCode(key: string): number | undefined {
  const code = key.length === 1 ? key.charCodeAt(0) : kNamed.get(key);
  return code !== undefined && code <= 255 ? code : undefined;
}
