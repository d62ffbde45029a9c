// The settings of a scene in an .rviz file, as far as the page has the same: fixed frame, view, topics and how they look,
// pictures, grid, names of frames, where tools publish. Loaded when such a file is opened. The file may be anything.

import { parseDocument } from 'yaml';
import { FIELD_OF_VIEW, readView } from './camera_view.ts';
import type { CameraView } from './camera_view.ts';
import { member, textMember } from './json.ts';
import { readLook } from './display_look.ts';
import type { DisplayLook, Looks } from './display_look.ts';
import { MOST_IMAGES, MOST_KEPT, readVariance } from './scene_options.ts';
import type { ImageOverlay, SceneOptions } from './scene_options.ts';
import { frameName } from './transform.ts';

export interface RvizScene {
  readonly options: Partial<SceneOptions>;
  /** Names of displays that are on in the file and unknown here. */
  readonly leftOut: readonly string[];
}

const MOST_CHARACTERS = 1 << 20;
const MOST_DISPLAYS = 200;
const DEEPEST = 8;
/** RViz writes pixels for a metre; this is taken for the height of its picture. */
const PICTURE_HEIGHT = 600;
const USUAL_BACKGROUND = '#303030';

/** Displays with a topic that the scene draws. `pack` tells by the same list what the page has (bundler/launch/rviz_config.cpp). */
export const DRAWN: ReadonlySet<string> = new Set([
  'AccelStamped',
  'GridCells',
  'LaserScan',
  'Map',
  'Marker',
  'MarkerArray',
  'Odometry',
  'Path',
  'PointCloud2',
  'PointStamped',
  'Polygon',
  'Pose',
  'PoseArray',
  'PoseWithCovariance',
  'Range',
  'RobotModel',
  'TwistStamped',
  'Wrench',
  'WrenchStamped',
]);
/** Displays whose topic is shown as a picture over the scene. The drawings of Camera in its picture are not shown. */
const PICTURES: ReadonlySet<string> = new Set(['Image', 'Camera']);
/** `rviz` is what ROS 1 calls it. */
const LIBRARIES: ReadonlySet<string> = new Set(['rviz_default_plugins/', 'rviz/']);
const TOPICS = ['Topic', 'Description Topic', 'Image Topic', 'Marker Topic'] as const;

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
  const on = [...enabled(displays, 0)].slice(0, MOST_DISPLAYS);
  const topics = new Set<string>();
  const leftOut: string[] = [];
  const looks: Record<string, DisplayLook> = {};
  const images: ImageOverlay[] = [];
  for (const { kind, name, value } of on) {
    if (kind === 'Grid' || kind === 'TF') continue;
    const topic = TOPICS.map((key) => topicOf(member(value, key))).find((each) => each !== '');
    if (topic !== undefined && PICTURES.has(kind) && images.length < MOST_IMAGES) {
      if (!images.some((image) => image.topic === topic)) images.push({ topic, size: 'small' });
    } else if (topic === undefined || !DRAWN.has(kind)) leftOut.push(name);
    else {
      topics.add(topic);
      const look = lookOf(kind, value);
      if (Object.keys(look).length > 0) looks[topic] = look;
    }
  }
  const keep = member(on.find(({ kind }) => kind === 'Odometry')?.value, 'Keep');
  const frames = on.find(({ kind }) => kind === 'TF');
  const frame = frameName(textMember(member(root, 'Global Options'), 'Fixed Frame'));
  const background = colorOf(member(member(root, 'Global Options'), 'Background Color'));
  const view = viewOf(member(member(root, 'Views'), 'Current'));
  const tools = member(root, 'Tools');
  const goal = topicOf(member(toolOf(tools, 'SetGoal'), 'Topic'));
  const estimating = toolOf(tools, 'SetInitialPose');
  const estimate = topicOf(member(estimating, 'Topic'));
  const point = topicOf(member(toolOf(tools, 'PublishPoint'), 'Topic'));
  const follow = textMember(member(member(root, 'Views'), 'Current'), 'Target Frame');
  return {
    options: {
      topics: [...topics],
      grid: on.some(({ kind }) => kind === 'Grid'),
      frames: frames !== undefined,
      names: member(frames?.value, 'Show Names') !== false,
      ...(frame === '' ? {} : { frame }),
      ...(view === null ? {} : { view }),
      // Each new file of RViz has that one: the page's own, which follows its theme, stands for it.
      ...(background === null || background === USUAL_BACKGROUND ? {} : { background }),
      ...(goal === '' ? {} : { goal }),
      ...(estimate === '' ? {} : { estimate }),
      ...(estimating === undefined ? {} : { variance: varianceOf(estimating) }),
      ...(point === '' ? {} : { point }),
      // RViz writes the fixed frame in brackets: `<Fixed Frame>`.
      follow: follow.startsWith('<') ? '' : frameName(follow),
      looks: looks satisfies Looks,
      images,
      // 0 is without end there.
      ...(typeof keep === 'number' ? { keep: keep >= 1 && keep <= MOST_KEPT ? keep : MOST_KEPT } : {}),
    },
    leftOut,
  };
}

function parsed(text: string): unknown {
  if (text.length > MOST_CHARACTERS) return undefined;
  try {
    const document = parseDocument(text, { logLevel: 'silent' });
    return document.errors.length > 0 ? undefined : document.toJS({ maxAliasCount: 100 });
  } catch {
    return undefined; // aliases without end
  }
}

/** Displays within groups count when all groups around them are on. */
function* enabled(list: unknown, depth: number): Iterable<Display> {
  if (!Array.isArray(list) || depth > DEEPEST) return;
  for (const value of list as readonly unknown[]) {
    // As RViz: what does not say so is off, and its value stands for that.
    if ((member(value, 'Enabled') ?? member(value, 'Value')) !== true) continue;
    const [, library = '', plain = ''] = /^(.*?)([^/]*)$/.exec(textMember(value, 'Class')) ?? [];
    if (plain === 'Group') {
      yield* enabled(member(value, 'Displays'), depth + 1);
      continue;
    }
    const isKnown = LIBRARIES.has(library);
    const name = textMember(value, 'Name').slice(0, 80);
    if (plain !== '') yield { kind: isKnown ? plain : '', name: name === '' ? plain : name, value };
  }
}

/** A topic is a mapping in files of ROS 2, and the name itself in those of ROS 1. */
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
        x: member(at, 'X'),
        y: member(at, 'Y'),
        z: member(at, 'Z'),
        distance: member(view, 'Distance'),
        azimuth: turn(member(view, 'Yaw')),
        elevation: member(view, 'Pitch'),
      });
    case 'TopDownOrtho': {
      const scale = member(view, 'Scale');
      const seen = typeof scale === 'number' ? PICTURE_HEIGHT / Math.abs(scale) : NaN;
      return readView({
        x: member(view, 'X'),
        y: member(view, 'Y'),
        top: true,
        distance: seen / (2 * Math.tan(FIELD_OF_VIEW / 2)),
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

function toolOf(tools: unknown, kind: string): unknown {
  if (!Array.isArray(tools)) return undefined;
  return (tools as readonly unknown[]).find((one) => textMember(one, 'Class').endsWith(`/${kind}`));
}

function varianceOf(tool: unknown): SceneOptions['variance'] {
  const [x, y, yaw] = ['x', 'y', 'yaw'].map((name) => member(tool, `Covariance ${name}`));
  return readVariance({ x, y, yaw });
}

/** The settings of a display that the scene has, too. Those that are as RViz has them at first are left to the scene. */
function lookOf(kind: string, display: unknown): DisplayLook {
  const alpha = member(display, 'Alpha');
  const color = colorOf(
    member(display, kind.startsWith('Wrench') ? 'Force Color' : kind.endsWith('Stamped') && kind !== 'PointStamped' ? 'Linear Color' : 'Color'),
  );
  const isPoints = kind === 'LaserScan' || kind === 'PointCloud2';
  const scheme = member(display, 'Color Scheme');
  return readLook({
    // A map's own usual opacity is not that of the others.
    ...(alpha === 1 && kind !== 'Map' ? {} : { alpha }),
    ...(isPoints ? pointLook(display) : color === null ? {} : { color }),
    ...(kind === 'Map' ? { scheme: scheme === 'map' ? undefined : scheme } : {}),
    ...(kind === 'RobotModel'
      ? { hideVisual: member(display, 'Visual Enabled') === false, collision: member(display, 'Collision Enabled') === true }
      : {}),
  });
}

function pointLook(display: unknown): Readonly<Record<string, unknown>> {
  const size = member(display, 'Size (Pixels)');
  const decay = member(display, 'Decay Time');
  const common = { ...(size === 3 ? {} : { size }), ...(decay === 0 ? {} : { decay }) };
  switch (member(display, 'Color Transformer')) {
    case 'FlatColor':
      return { ...common, channel: 'flat', color: colorOf(member(display, 'Color')) };
    case 'RGB8':
    case 'RGBF32':
      return { ...common, channel: 'rgb' };
    case 'AxisColor': {
      const bounds = member(display, 'Autocompute Value Bounds');
      const range = member(bounds, 'Value') === false ? { least: member(bounds, 'Min Value'), most: member(bounds, 'Max Value') } : {};
      return { ...common, channel: textMember(display, 'Axis', 'Z').toLowerCase(), ...range };
    }
    case 'Intensity': {
      const isFixed = member(display, 'Autocompute Intensity Bounds') === false;
      const range = isFixed ? { least: member(display, 'Min Intensity'), most: member(display, 'Max Intensity') } : {};
      return { ...common, channel: textMember(display, 'Channel Name', 'intensity'), ...range };
    }
    default:
      return common;
  }
}

/** `255; 128; 0` as `#ff8000`; null: it is none. */
function colorOf(value: unknown): string | null {
  const parts = typeof value === 'string' ? value.split(';').map(Number) : [];
  const isColor = parts.length === 3 && parts.every((part) => Number.isInteger(part) && part >= 0 && part <= 255);
  return isColor ? `#${parts.map((part) => part.toString(16).padStart(2, '0')).join('')}` : null;
}
