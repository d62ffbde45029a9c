// Topics of the windows of Python libraries: /figures/PROGRAM/NAME (see runtime/packages/tools/ros2wasm_figures). Separate
// from figure_controls.ts, because the page needs these lines at its start.

import type { TopicView } from '../../contract/session.ts';

const TOPIC = /^\/figures\/\w+\/\w+$/;
const IMAGE = 'sensor_msgs/msg/Image';

export function isFigure(topic: string): boolean {
  return TOPIC.test(topic);
}

/** The figures that a node shows now. */
export function figuresOf(topics: readonly TopicView[]): readonly string[] {
  return topics.filter(({ name, type, publishers }) => type === IMAGE && isFigure(name) && publishers > 0).map(({ name }) => name);
}
