// Windows of cv2: a Python node publishes what imshow() shows on /cv2/NAME (see runtime/packages/vendor/py_opencv/cv2/
// _windows.py). Apart from cv_windows.ts, as the page needs these lines from its start.

import type { TopicView } from '../../contract/session.ts';

const TOPIC = /^\/cv2\/\w+$/;
const IMAGE = 'sensor_msgs/msg/Image';

export function isWindow(topic: string): boolean {
  return TOPIC.test(topic);
}

/** The windows that a node shows now. */
export function windowsOf(topics: readonly TopicView[]): readonly string[] {
  return topics.filter(({ name, type, publishers }) => type === IMAGE && isWindow(name) && publishers > 0).map(({ name }) => name);
}
