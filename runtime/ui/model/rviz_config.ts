// What an .rviz file says about a scene, as far as the page has the same: fixed frame, view, topics, grid, names of
// frames, where goals go. Loaded when such a file is opened. The file may be anything.

import { parseDocument } from 'yaml';
import { kFieldOfView, readView } from './camera_view.ts';
import type { CameraView } from './camera_view.ts';
import { member, textMember } from './json.ts';
import { kMostKept } from './scene_options.ts';
import type { SceneOptions } from './scene_options.ts';
import { frameName } from './transform.ts';

export interface RvizScene {
  readonly options: Partial<SceneOptions>;
  /** Names of displays that are on in the file and unknown here. */
  readonly leftOut: readonly string[];
}

const kMostCharacters = 1 << 20;
const kMostDisplays = 200;
const kDeepest = 8;
/** RViz writes pixels for a metre; this is taken for the height of its picture. */
const kPictureHeight = 600;

/** Displays with a topic that the scene draws. `pack` tells by the same list what the page has (bundler/launch/rviz_config.cpp). */
export const kDrawn: ReadonlySet<string> = new Set([
  'LaserScan', 'Map', 'Marker', 'MarkerArray', 'Odometry', 'Path', 'Pose', 'PoseArray', 'PointCloud2', 'PoseWithCovariance',
  'RobotModel',
]);
/** `rviz` is what ROS 1 calls it. */
const kLibraries: ReadonlySet<string> = new Set(['rviz_default_plugins/', 'rviz/']);
const kTopics = ['Topic', 'Description Topic', 'Image Topic', 'Marker Topic'] as const;

interface Display {
  /** Empty: of somebody else's library. */
  readonly kind: string;
  readonly name: string;
  readonly value: unknown;
}

/** null: it is no such file. */
export function readRviz(text: string): RvizScene | null {
  const root = member(parsed(text), 'Visualization Manager');
  const displays = member(root, 'Displays');
  if (!Array.isArray(displays)) return null;
  const on = [...enabled(displays, 0)].slice(0, kMostDisplays);
  const topics = new Set<string>();
  const leftOut: string[] = [];
  for (const { kind, name, value } of on) {
    if (kind === 'Grid' || kind === 'TF') continue;
    const topic = kTopics.map((key) => topicOf(member(value, key))).find((each) => each !== '');
    if (topic === undefined || !kDrawn.has(kind)) leftOut.push(name);
    else topics.add(topic);
  }
  const keep = member(on.find(({ kind }) => kind === 'Odometry')?.value, 'Keep');
  const frames = on.find(({ kind }) => kind === 'TF');
  const frame = frameName(textMember(member(root, 'Global Options'), 'Fixed Frame'));
  const view = viewOf(member(member(root, 'Views'), 'Current'));
  const goal = goalOf(member(root, 'Tools'));
  return {
    options: {
      topics: [...topics],
      grid: on.some(({ kind }) => kind === 'Grid'),
      frames: frames !== undefined,
      names: member(frames?.value, 'Show Names') !== false,
      ...(frame === '' ? {} : { frame }),
      ...(view === null ? {} : { view }),
      ...(goal === '' ? {} : { goal }),
      // 0 is without end there.
      ...(typeof keep === 'number' ? { keep: keep >= 1 && keep <= kMostKept ? keep : kMostKept } : {}),
    },
    leftOut,
  };
}

function parsed(text: string): unknown {
  if (text.length > kMostCharacters) return undefined;
  try {
    const document = parseDocument(text, { logLevel: 'silent' });
    return document.errors.length > 0 ? undefined : document.toJS({ maxAliasCount: 100 });
  } catch {
    return undefined; // aliases without end
  }
}

/** Displays within groups count when all groups around them are on. */
function* enabled(list: unknown, depth: number): Iterable<Display> {
  if (!Array.isArray(list) || depth > kDeepest) return;
  for (const value of list as readonly unknown[]) {
    // As RViz: what does not say so is off, and its value stands for that.
    if ((member(value, 'Enabled') ?? member(value, 'Value')) !== true) continue;
    const [, library = '', plain = ''] = /^(.*?)([^/]*)$/.exec(textMember(value, 'Class')) ?? [];
    if (plain === 'Group') {
      yield* enabled(member(value, 'Displays'), depth + 1);
      continue;
    }
    const isKnown = kLibraries.has(library);
    const name = textMember(value, 'Name').slice(0, 80);
    if (plain !== '') yield { kind: isKnown ? plain : '', name: name === '' ? plain : name, value };
  }
}

/** Of ROS 2 a mapping, of ROS 1 the name itself. */
function topicOf(value: unknown): string {
  const name = typeof value === 'string' ? value : textMember(value, 'Value');
  return name === '' || name.startsWith('/') ? name : `/${name}`;
}

function viewOf(view: unknown): CameraView | null {
  const at = member(view, 'Focal Point');
  switch (/([^/]*)$/.exec(textMember(view, 'Class'))?.[1]) {
    case 'Orbit':
    case 'XYOrbit':
      return readView({
        x: member(at, 'X'), y: member(at, 'Y'), z: member(at, 'Z'),
        distance: member(view, 'Distance'),
        azimuth: turn(member(view, 'Yaw')),
        elevation: member(view, 'Pitch'),
      });
    case 'TopDownOrtho': {
      const scale = member(view, 'Scale');
      const seen = typeof scale === 'number' ? kPictureHeight / Math.abs(scale) : NaN;
      return readView({
        x: member(view, 'X'), y: member(view, 'Y'), top: true, distance: seen / (2 * Math.tan(kFieldOfView / 2)),
      });
    }
    default:
      return null;
  }
}

/** RViz counts from 0 to a whole turn. */
function turn(yaw: unknown): number {
  return typeof yaw === 'number' ? Math.atan2(Math.sin(yaw), Math.cos(yaw)) : NaN;
}

function goalOf(tools: unknown): string {
  if (!Array.isArray(tools)) return '';
  const tool = (tools as readonly unknown[]).find((one) => textMember(one, 'Class').endsWith('/SetGoal'));
  return topicOf(member(tool, 'Topic'));
}
