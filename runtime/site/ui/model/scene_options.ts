// The state of a scene's panel: fixed frame, view, the topics and their looks, the topics of its tools. It comes from links too.

import { readView, writeView } from './camera_view.ts';
import type { CameraView } from './camera_view.ts';
import { isColor, readLooks, writeLooks } from './display_look.ts';
import type { Looks } from './display_look.ts';
import { flagMember, member, numberMember, textMember, textsMember } from './json.ts';
import type { Json } from './json.ts';

export const IMAGE_SIZES = ['small', 'medium', 'large'] as const;
export type ImageSize = (typeof IMAGE_SIZES)[number];

/** A picture over the scene. */
export interface ImageOverlay {
  readonly topic: string;
  readonly size: ImageSize;
}

/** Metres squared, and radians squared of the heading. */
export interface PoseVariance {
  readonly x: number;
  readonly y: number;
  readonly yaw: number;
}

export interface SceneOptions {
  /** Empty: one that suits. */
  readonly frame: string;
  readonly view: CameraView;
  readonly grid: boolean;
  readonly frames: boolean;
  readonly names: boolean;
  /** Is the list of what is shown open? */
  readonly list: boolean;
  /** Topics that are shown; null: those that suit. */
  readonly topics: readonly string[] | null;
  /** Where goals are published. */
  readonly goal: string;
  /** Where estimates of the robot's pose are published. */
  readonly estimate: string;
  readonly variance: PoseVariance;
  /** Where points are published. */
  readonly point: string;
  /** The frame that the view goes with; empty: the fixed one. */
  readonly follow: string;
  readonly looks: Looks;
  readonly images: readonly ImageOverlay[];
  /** How many arrows of odometry stay. */
  readonly keep: number;
  /** Behind everything, as `#336699`; empty: the page's own. */
  readonly background: string;
}

export const MOST_KEPT = 1000;
/** As RViz. */
const USUALLY_KEPT = 100;

const MOST_TOPICS = 100;
export const MOST_IMAGES = 6;
/** As RViz: half a metre, and 15 degrees, which it keeps as a float32. */
const USUAL_VARIANCE: PoseVariance = { x: 0.25, y: 0.25, yaw: Math.fround((Math.PI / 12) ** 2) };
const MOST_VARIANCE = 1e6;

export function readOptions(state: Json): SceneOptions {
  const background = textMember(state, 'background');
  return {
    frame: textMember(state, 'frame'),
    view: readView(member(state, 'view')),
    grid: flagMember(state, 'grid', true),
    frames: flagMember(state, 'frames', true),
    names: flagMember(state, 'names', true),
    list: flagMember(state, 'list', true),
    topics: member(state, 'topics') === undefined ? null : textsMember(state, 'topics', MOST_TOPICS),
    goal: textMember(state, 'goal', '/goal_pose'),
    estimate: textMember(state, 'estimate', '/initialpose'),
    variance: readVariance(member(state, 'variance')),
    point: textMember(state, 'point', '/clicked_point'),
    follow: textMember(state, 'follow'),
    looks: readLooks(member(state, 'looks')),
    images: readImages(member(state, 'images')),
    keep: Math.round(numberMember(state, 'keep', 1, MOST_KEPT, USUALLY_KEPT)),
    background: isColor(background) ? background : '',
  };
}

export function readVariance(value: unknown): PoseVariance {
  const at = (name: 'x' | 'y' | 'yaw'): number => numberMember(value, name, 0, MOST_VARIANCE, USUAL_VARIANCE[name]);
  return { x: at('x'), y: at('y'), yaw: at('yaw') };
}

export function readImages(value: unknown): readonly ImageOverlay[] {
  if (!Array.isArray(value)) return [];
  return value
    .slice(0, MOST_IMAGES)
    .map((one: unknown) => ({
      topic: textMember(one, 'topic'),
      size: IMAGE_SIZES.find((size) => size === member(one, 'size')) ?? 'small',
    }))
    .filter(({ topic }) => topic !== '');
}

export function writeOptions({ view, topics, looks, variance, images, follow, background, ...plain }: SceneOptions): Json {
  const isUsual = variance.x === USUAL_VARIANCE.x && variance.y === USUAL_VARIANCE.y && variance.yaw === USUAL_VARIANCE.yaw;
  return {
    ...plain,
    view: writeView(view),
    ...(follow === '' ? {} : { follow }),
    ...(background === '' ? {} : { background }),
    ...(topics === null ? {} : { topics: [...topics] }),
    ...(Object.keys(looks).length === 0 ? {} : { looks: writeLooks(looks) }),
    ...(isUsual ? {} : { variance: { ...variance } }),
    ...(images.length === 0 ? {} : { images: images.map((one) => ({ ...one })) }),
  };
}
