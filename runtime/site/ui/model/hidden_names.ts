// Which topics a beginner need not see. ROS 2 hides names with a token that starts with `_`; the two
// topics that every node has are put beside them.

import { isHiddenName } from '../../decode/ros_names.ts';

const EVERY_NODE: ReadonlySet<string> = new Set(['/rosout', '/parameter_events']);

export function isHiddenTopic(name: string): boolean {
  return EVERY_NODE.has(name) || isHiddenName(name);
}
