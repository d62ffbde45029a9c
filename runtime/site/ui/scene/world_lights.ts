// The lights of a simulated world, from the simulator's markers: an arrow each, as light_markers() of ros2wasm_sim has them.

import { Color, DirectionalLight, Group, Object3D, PointLight, SpotLight, Vector3 } from 'three';
import type { Light } from 'three';
import { asNumber } from '../model/field_path.ts';
import { member } from '../model/json.ts';
import { readHeader, readPose, readVector } from '../model/transform.ts';
import type { HeaderView, Vector } from '../model/transform.ts';
import type { Anchored, Display } from './display.ts';
import { emptied } from './dispose.ts';
import { isPlace } from './places.ts';
import { placeAt } from './shapes.ts';
import type { PlacedLight } from './shadow.ts';

/** Each makes every pixel dearer, and each shadow takes a texture of the material. */
const MOST_LIGHTS = 8;
const MOST_SHADOWS = 4;
/** A light of 0.8, such as Gazebo's sun, is as bright as the view's own. */
const BRIGHT = 2;
const BRIGHTEST = 100;
const WIDEST = Math.PI / 2;

export class WorldLights implements Display {
  readonly group = new Group();
  readonly problem = '';
  private readonly use: (lights: readonly PlacedLight[]) => void;
  private waiting: readonly unknown[] | null = null;
  private anchors: readonly Anchored[] = [];

  /** `use` gets the lights when they have changed. */
  constructor(use: (lights: readonly PlacedLight[]) => void) {
    this.use = use;
  }

  take(message: unknown): void {
    const list = member(message, 'markers');
    if (Array.isArray(list)) this.waiting = list as readonly unknown[];
  }

  build(): undefined {
    if (this.waiting === null) return;
    const made = this.waiting.flatMap((marker) => lightOf(marker) ?? []).slice(0, MOST_LIGHTS);
    this.waiting = null;
    emptied(this.group);
    let shadows = 0;
    const lights = made.map(({ light, anchor, aim, casts }): PlacedLight => {
      this.group.add(anchor);
      if (light instanceof DirectionalLight) this.group.add(light, light.target);
      const shades = casts && !(light instanceof PointLight) && shadows < MOST_SHADOWS;
      shadows += shades ? 1 : 0;
      return {
        light,
        casts: shades,
        ahead: () => {
          anchor.updateMatrixWorld();
          return new Vector3(1, 0, 0).transformDirection(aim.matrixWorld);
        },
      };
    });
    this.anchors = made.map(({ anchor, header }) => ({ object: anchor, header }));
    this.use(lights);
  }

  anchored(): Iterable<Anchored> {
    return this.anchors;
  }

  repaint(): void {
    // Their colours are the world's.
  }

  close(): void {
    this.use([]);
    emptied(this.group);
    this.anchors = [];
  }
}

interface Made {
  readonly light: Light;
  /** Stands in the light's frame. */
  readonly anchor: Object3D;
  /** In the anchor; its x is where the light shines. */
  readonly aim: Object3D;
  readonly header: HeaderView;
  readonly casts: boolean;
}

/** null: the marker is not a light, or does not shine. */
function lightOf(marker: unknown): Made | null {
  const pose = readPose(member(marker, 'pose'));
  const scale = readVector(member(marker, 'scale'));
  if (asNumber(member(marker, 'action')) !== 0 || pose === null || scale === null || !isPlace(...pose.translation)) return null;
  const [red, green, blue] = (['r', 'g', 'b'] as const).map((part) => bounded(asNumber(member(member(marker, 'color'), part))));
  const strength = Math.max(red ?? 0, green ?? 0, blue ?? 0);
  if (strength === 0) return null;
  const color = new Color((red ?? 0) / strength, (green ?? 0) / strength, (blue ?? 0) / strength);
  const light = kindOf(member(marker, 'ns'), color, strength * BRIGHT, scale, fadingOf(marker));
  if (light === null) return null;
  const [anchor, aim] = [new Group(), new Group()];
  anchor.add(aim);
  placeAt(aim, pose);
  // A directional light shines from afar: where it is placed depends on what is seen.
  if (!(light instanceof DirectionalLight)) aim.add(light);
  if (light instanceof SpotLight) {
    light.position.set(0, 0, 0);
    light.target.position.set(1, 0, 0);
    aim.add(light.target);
  }
  const { frame } = readHeader(marker);
  return { light, anchor, aim, header: { stamp: NaN, frame }, casts: member(marker, 'mesh_use_embedded_materials') === true };
}

function kindOf(kind: unknown, color: Color, strength: number, [range, outer, inner]: Vector, decay: number): Light | null {
  const reach = range > 0 && range < 1e6 ? range : 0;
  if (kind === 'directional') return new DirectionalLight(color, strength);
  if (kind === 'point') return new PointLight(color, strength, reach, decay);
  if (kind !== 'spot') return null;
  // SDF has the whole angle of the cone, three.js half of it.
  const angle = Math.min(WIDEST, Math.max(0.01, outer / 2));
  const soft = Math.min(1, Math.max(0, 1 - inner / 2 / angle));
  return new SpotLight(color, strength, reach, angle, soft, decay);
}

/** The power of the distance by which it fades: that of the last term that counts. */
function fadingOf(marker: unknown): number {
  const points = member(marker, 'points');
  const terms = Array.isArray(points) ? readVector(points[0]) : null;
  return terms === null ? 0 : terms[2] > 0 ? 2 : terms[1] > 0 ? 1 : 0;
}

function bounded(part: number): number {
  return part > 0 ? Math.min(BRIGHTEST, part) : 0;
}
