// Markers of a topic, Marker or MarkerArray: added, changed, deleted, and gone when their lifetime is over.

import { Group } from 'three';
import type { Object3D } from 'three';
import { asNumber } from '../model/field_path.ts';
import { member } from '../model/json.ts';
import { readHeader } from '../model/transform.ts';
import type { HeaderView } from '../model/transform.ts';
import { panelTexts } from '../texts_panels.ts';
import type { Anchored, Display } from './display.ts';
import { disposeOf, emptied } from './dispose.ts';
import { markerCost, markerShape } from './marker_shape.ts';
import type { MarkerBuilt, MarkerCost } from './marker_shape.ts';
import type { MeshShelf, PlacedMesh } from './mesh_shelf.ts';

const MOST_MARKERS = 5000;
/** Upper bounds for all markers of a display together. Some hundred MB at most. */
const MOST: MarkerCost = { points: 1_000_000, solids: 100_000, pixels: 32_000_000 };
const NOTHING: MarkerCost = { points: 0, solids: 0, pixels: 0 };

/** As the message's constants number them; 1 is no longer used. */
const MarkerAction = { add: 0, remove: 2, removeAll: 3 } as const;

interface Kept {
  /** null: it is drawn as it is. */
  message: unknown;
  object: Object3D | null;
  /** The cost of the object. */
  cost: MarkerCost;
  header: HeaderView;
  problem: string;
  mesh: PlacedMesh | undefined;
  /** Seconds; 0: for good. */
  lifetime: number;
  /** Seconds of the site's time; Infinity: never. */
  ends: number;
}

export class Markers implements Display {
  readonly group = new Group();
  private readonly meshes: MeshShelf;
  private readonly kept = new Map<string, Kept>();
  private refused = false;
  private spent = NOTHING;

  constructor(meshes: MeshShelf) {
    this.meshes = meshes;
  }

  get problem(): string {
    if (this.refused) return panelTexts.scene.markersLeftOut;
    for (const { problem, mesh } of this.kept.values()) {
      if (problem !== '') return problem;
      if (mesh !== undefined && mesh.problem !== '') return mesh.problem;
    }
    return '';
  }

  take(message: unknown): void {
    const list = member(message, 'markers');
    if (!Array.isArray(list)) this.takeOne(message);
    else for (const marker of list as readonly unknown[]) this.takeOne(marker);
  }

  build(now: number): number | undefined {
    let next = Infinity;
    for (const [key, marker] of this.kept) {
      if (marker.message !== null) {
        this.withdraw(marker);
        const cost = markerCost(marker.message);
        const after = sum(this.spent, cost, 1);
        const fits = after.points <= MOST.points && after.solids <= MOST.solids && after.pixels <= MOST.pixels;
        const built: MarkerBuilt = fits ? markerShape(marker.message, this.meshes) : { object: null, problem: panelTexts.scene.markersLeftOut };
        const { object, problem } = built;
        marker.mesh = built.mesh;
        if (object !== null) [marker.cost, this.spent] = [cost, after];
        marker.message = null;
        marker.object = object;
        marker.problem = problem;
        marker.ends = marker.lifetime > 0 ? now + marker.lifetime : Infinity;
        if (object !== null) this.group.add(object);
      }
      if (marker.ends <= now) this.forget(key);
      else next = Math.min(next, marker.ends);
    }
    return Number.isFinite(next) ? next : undefined;
  }

  *anchored(): Iterable<Anchored> {
    for (const { object, header } of this.kept.values()) if (object !== null) yield { object, header };
  }

  describe(object: Object3D): ReadonlyMap<string, string | number> {
    for (const [key, kept] of this.kept) {
      if (kept.object !== object) continue;
      const [space = '', id = ''] = key.split('\n');
      return new Map<string, string | number>([['ns', space], ['id', Number(id)]]);
    }
    return new Map();
  }

  repaint(): void {
    // A marker says itself how it looks.
  }

  close(): void {
    for (const { mesh } of this.kept.values()) mesh?.close();
    emptied(this.group);
    this.kept.clear();
    this.spent = NOTHING;
  }

  private takeOne(marker: unknown): void {
    const key = `${String(member(marker, 'ns'))}\n${String(member(marker, 'id'))}`;
    switch (asNumber(member(marker, 'action'))) {
      case MarkerAction.add: {
        const { stamp, frame } = readHeader(marker);
        const header = { stamp: member(marker, 'frame_locked') === true ? NaN : stamp, frame };
        const lifetime = asNumber(member(marker, 'lifetime'));
        const known = this.kept.get(key);
        this.refused = known === undefined && this.kept.size >= MOST_MARKERS;
        if (known !== undefined) Object.assign(known, { message: marker, header, lifetime });
        else if (!this.refused)
          this.kept.set(key, { message: marker, object: null, cost: NOTHING, header, problem: '', mesh: undefined, lifetime, ends: Infinity });
        return;
      }
      case MarkerAction.remove:
        this.forget(key);
        return;
      case MarkerAction.removeAll:
        for (const each of [...this.kept.keys()]) this.forget(each);
        return;
      default:
    }
  }

  private forget(key: string): void {
    const marker = this.kept.get(key);
    if (marker !== undefined) this.withdraw(marker);
    this.kept.delete(key);
    this.refused = false;
  }

  private withdraw(marker: Kept): void {
    const { object, cost } = marker;
    marker.mesh?.close();
    marker.mesh = undefined;
    if (object === null) return;
    this.group.remove(object);
    disposeOf(object);
    marker.object = null;
    this.spent = sum(this.spent, cost, -1);
    marker.cost = NOTHING;
  }
}

function sum(a: MarkerCost, b: MarkerCost, sign: 1 | -1): MarkerCost {
  return { points: a.points + sign * b.points, solids: a.solids + sign * b.solids, pixels: a.pixels + sign * b.pixels };
}
