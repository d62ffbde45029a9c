// The interface of all displays of a scene: a display takes messages as they come, builds their drawing when one is due, and
// reports the frame of each of its parts. Messages may be anything: invalid parts are skipped, or reported by `problem`.

import type { Group, Object3D } from 'three';
import type { DisplayLook } from '../model/display_look.ts';
import type { HeaderView } from '../model/transform.ts';
import type { MeshShelf } from './mesh_shelf.ts';

/** A part of a scene that stands still in a frame. */
export interface Anchored {
  readonly object: Object3D;
  readonly header: HeaderView;
}

/** As they are now: another theme changes them. */
export interface DisplayColors {
  readonly text: string;
  /** For what has no colour of its own. */
  readonly accent: string;
}

export interface DisplayContext {
  readonly colors: DisplayColors;
  /** As it is now: repaint() tells that it has changed. */
  readonly look: DisplayLook;
  /** How many arrows of odometry stay. */
  readonly keep: number;
  readonly meshes: MeshShelf;
}

export interface Display {
  readonly group: Group;
  /** Only keeps it, if the newest one is all that is shown. */
  take(message: unknown): void;
  /** Makes of what was taken what is drawn. `now`: seconds of the site's time. Later, the same way: when to ask again. */
  build(now: number): number | undefined;
  anchored(): Iterable<Anchored>;
  /** Colours or the look have changed: what has them is to be built again. */
  repaint(): void;
  /** Details of the part that was hit: one of its objects, and which of that object's points or copies. */
  describe?(object: Object3D, index: number | undefined): ReadonlyMap<string, string | number>;
  /** Why nothing or not all is shown; empty: all is. */
  readonly problem: string;
  close(): void;
}
