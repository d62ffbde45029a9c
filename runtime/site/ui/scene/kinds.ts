// The message types that a scene can show: for each of them, the display that draws it and its settings.

import type { Setting } from '../model/display_look.ts';
import type { Display, DisplayContext } from './display.ts';
import { Markers } from './markers.ts';
import { NewestDisplay } from './newest_display.ts';
import type { Built } from './newest_display.ts';
import { GridDisplay } from './occupancy_grid.ts';
import { OdometryTrail } from './odometry_trail.ts';
import { PointDisplay } from './point_display.ts';
import { path, poseArray, singlePose } from './poses.ts';
import { RobotModel } from './robot_model.ts';
import { lookOf, named } from './shapes.ts';
import type { Rgba } from './shapes.ts';
import { gridCells, pointBall, polygon, rangeCone, vectorPair } from './small_shapes.ts';

interface Kind {
  readonly make: (context: DisplayContext) => Display;
  readonly settings: readonly Setting[];
  /** The end of a second topic's name, which tells of changes. */
  readonly updates?: string;
}

const PAINT = ['color', 'alpha'] as const;
const POINTS = ['size', 'color', 'alpha', 'decay', 'channel'] as const;

/** The newest message, in the colour that was chosen, or else the page's. */
const painted = (make: (look: Rgba) => (message: unknown) => Built, alpha = 1): Kind => ({
  make: (context) => new NewestDisplay((message) => make(lookOf(context, undefined, alpha))(message)),
  settings: PAINT,
});

/** Two vectors of one field, in RViz's colours and scale; the first one's can be chosen. */
const pair = (outer: string, first: string, second: string, scale: number): Kind => ({
  make: (context) =>
    new NewestDisplay((message) => {
      const look = lookOf(context, '#cc3333');
      return vectorPair([
        { path: [outer, first], look, scale },
        { path: [outer, second], look: { ...named('#cccc33'), alpha: look.alpha }, scale },
      ])(message);
    }),
  settings: PAINT,
});

const markers: Kind = { make: ({ meshes }) => new Markers(meshes), settings: [] };

/** Its display depends on the number of messages that stay. */
export const ODOMETRY = 'nav_msgs/msg/Odometry';

const kinds: ReadonlyMap<string, Kind> = new Map<string, Kind>([
  ['sensor_msgs/msg/LaserScan', { make: (context) => PointDisplay.scan(context), settings: POINTS }],
  ['sensor_msgs/msg/PointCloud2', { make: (context) => PointDisplay.cloud(context), settings: POINTS }],
  ['sensor_msgs/msg/Range', painted(rangeCone, 0.5)],
  ['nav_msgs/msg/Path', painted(path)],
  [ODOMETRY, { make: (context) => new OdometryTrail(context), settings: PAINT }],
  ['nav_msgs/msg/OccupancyGrid', { make: (context) => new GridDisplay(context), settings: ['alpha', 'scheme'], updates: '_updates' }],
  ['nav_msgs/msg/GridCells', painted(gridCells)],
  ['geometry_msgs/msg/PoseStamped', painted(singlePose)],
  ['geometry_msgs/msg/PoseWithCovarianceStamped', painted(singlePose)],
  ['geometry_msgs/msg/PoseArray', painted(poseArray)],
  ['geometry_msgs/msg/PointStamped', painted(pointBall)],
  ['geometry_msgs/msg/PolygonStamped', painted(polygon)],
  ['geometry_msgs/msg/WrenchStamped', pair('wrench', 'force', 'torque', 2)],
  ['geometry_msgs/msg/TwistStamped', pair('twist', 'linear', 'angular', 1)],
  ['geometry_msgs/msg/AccelStamped', pair('accel', 'linear', 'angular', 1)],
  ['visualization_msgs/msg/Marker', markers],
  ['visualization_msgs/msg/MarkerArray', markers],
]);

const robot: Kind = { make: (context) => new RobotModel(context), settings: ['alpha', 'shapes'] };

export function canShow(topic: string, type: string): boolean {
  return kindOf(topic, type) !== undefined;
}

export function settingsOf(topic: string, type: string): readonly Setting[] {
  return kindOf(topic, type)?.settings ?? [];
}

/** The topic that tells of changes; empty: none does. */
export function updatesOf(topic: string, type: string): string {
  const { updates } = kindOf(topic, type) ?? {};
  return updates === undefined ? '' : topic + updates;
}

export function makeDisplay(topic: string, type: string, context: DisplayContext): Display | null {
  return kindOf(topic, type)?.make(context) ?? null;
}

function kindOf(topic: string, type: string): Kind | undefined {
  // A text is a robot by the name of its topic only.
  if (type === 'std_msgs/msg/String') return /(^|[/_])robot_description$/.test(topic) ? robot : undefined;
  return kinds.get(type);
}
