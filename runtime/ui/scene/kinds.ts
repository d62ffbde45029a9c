// What a scene can show: for each type of messages, what draws it.

import type { Display, DisplayColors } from './display.ts';
import { NewestDisplay } from './newest_display.ts';
import { laserScan, pointCloud } from './points.ts';
import { path, poseArray, singlePose } from './poses.ts';

type Make = (colors: DisplayColors) => Display;

const kinds: ReadonlyMap<string, Make> = new Map<string, Make>([
  ['sensor_msgs/msg/LaserScan', ({ accent }) => new NewestDisplay(laserScan(accent))],
  ['sensor_msgs/msg/PointCloud2', () => new NewestDisplay(pointCloud)],
  ['nav_msgs/msg/Path', ({ accent }) => new NewestDisplay(path(accent))],
  ['nav_msgs/msg/Odometry', ({ accent }) => new NewestDisplay(singlePose(accent))],
  ['geometry_msgs/msg/PoseStamped', ({ accent }) => new NewestDisplay(singlePose(accent))],
  ['geometry_msgs/msg/PoseWithCovarianceStamped', ({ accent }) => new NewestDisplay(singlePose(accent))],
  ['geometry_msgs/msg/PoseArray', ({ accent }) => new NewestDisplay(poseArray(accent))],
]);

export function canShow(topic: string, type: string): boolean {
  return kindOf(topic, type) !== undefined;
}

export function makeDisplay(topic: string, type: string, colors: DisplayColors): Display | null {
  return kindOf(topic, type)?.(colors) ?? null;
}

function kindOf(topic: string, type: string): Make | undefined {
  void topic;
  return kinds.get(type);
}
