// What a scene can show: for each type of messages, what draws it.

import type { Display, DisplayColors } from './display.ts';
import { Markers } from './markers.ts';
import type { MeshShelf } from './mesh_shelf.ts';
import { NewestDisplay } from './newest_display.ts';
import type { Built } from './newest_display.ts';
import { OdometryTrail } from './odometry_trail.ts';
import { occupancyGrid } from './occupancy_grid.ts';
import { laserScan, pointCloud } from './points.ts';
import { path, poseArray, singlePose } from './poses.ts';
import { RobotModel } from './robot_model.ts';

/** `keep`: how many arrows of odometry stay. */
type Make = (colors: DisplayColors, keep: number, meshes: MeshShelf) => Display;

const colored = (make: (accent: string) => (message: unknown) => Built): Make =>
  (colors) => new NewestDisplay((message) => make(colors.accent)(message), true);

/** What is shown of it depends on how many are kept. */
export const kOdometry = 'nav_msgs/msg/Odometry';

const kinds: ReadonlyMap<string, Make> = new Map<string, Make>([
  ['sensor_msgs/msg/LaserScan', colored(laserScan)],
  ['sensor_msgs/msg/PointCloud2', () => new NewestDisplay(pointCloud)],
  ['nav_msgs/msg/Path', colored(path)],
  [kOdometry, (colors, keep) => new OdometryTrail(colors, keep)],
  ['geometry_msgs/msg/PoseStamped', colored(singlePose)],
  ['geometry_msgs/msg/PoseWithCovarianceStamped', colored(singlePose)],
  ['nav_msgs/msg/OccupancyGrid', () => new NewestDisplay(occupancyGrid)],
  ['visualization_msgs/msg/Marker', (_colors, _keep, meshes) => new Markers(meshes)],
  ['visualization_msgs/msg/MarkerArray', (_colors, _keep, meshes) => new Markers(meshes)],
  ['geometry_msgs/msg/PoseArray', colored(poseArray)],
]);

export function canShow(topic: string, type: string): boolean {
  return kindOf(topic, type) !== undefined;
}

export function makeDisplay(topic: string, type: string, colors: DisplayColors, keep: number, meshes: MeshShelf): Display | null {
  return kindOf(topic, type)?.(colors, keep, meshes) ?? null;
}

function kindOf(topic: string, type: string): Make | undefined {
  // A text is a robot by the name of its topic only.
  if (type === 'std_msgs/msg/String') return /(^|[/_])robot_description$/.test(topic) ? (_colors, _keep, meshes) => new RobotModel(meshes) : undefined;
  return kinds.get(type);
}
