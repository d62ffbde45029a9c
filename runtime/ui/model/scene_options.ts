// What a scene's panel keeps: fixed frame, view, what is shown. It comes from links too.

import { readView, writeView } from './camera_view.ts';
import type { CameraView } from './camera_view.ts';
import { flagMember, member, numberMember, textMember, textsMember } from './json.ts';
import type { Json } from './json.ts';

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
  /** How many arrows of odometry stay. */
  readonly keep: number;
}

export const kMostKept = 1000;
/** As RViz. */
const kUsuallyKept = 100;

const kMostTopics = 100;

export function readOptions(state: Json): SceneOptions {
  return {
    frame: textMember(state, 'frame'),
    view: readView(member(state, 'view')),
    grid: flagMember(state, 'grid', true),
    frames: flagMember(state, 'frames', true),
    names: flagMember(state, 'names', true),
    list: flagMember(state, 'list', true),
    topics: member(state, 'topics') === undefined ? null : textsMember(state, 'topics', kMostTopics),
    goal: textMember(state, 'goal', '/goal_pose'),
    keep: Math.round(numberMember(state, 'keep', 1, kMostKept, kUsuallyKept)),
  };
}

export function writeOptions({ frame, view, grid, frames, names, list, topics, goal, keep }: SceneOptions): Json {
  return {
    frame,
    view: writeView(view),
    grid,
    frames,
    names,
    list,
    goal,
    keep,
    ...(topics === null ? {} : { topics: [...topics] }),
  };
}
