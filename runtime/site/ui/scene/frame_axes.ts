// The frames of the tree: three axes each (x red, y green, z blue), a line to the parent, the name. As large on the
// screen at any distance.

import {
  Color,
  CylinderGeometry,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
  BufferAttribute,
  BufferGeometry,
} from 'three';
import type { Sprite } from 'three';
import type { CameraView } from '../model/camera_view.ts';
import type { Transform } from '../model/transform.ts';
import { isPlace } from './places.ts';
import { disposeOf } from './dispose.ts';
import { named, words } from './shapes.ts';

const MOST_SHOWN = 1000;
const MOST_NAMES = 200;
/** The sizes of axes and names, as shares of the distance of the target. */
const AXIS_LENGTH = 0.07;
const NAME_HEIGHT = 0.014;

export interface FramePlace {
  readonly name: string;
  readonly parent: string | null;
  readonly transform: Transform;
}

export class FrameAxes {
  readonly group = new Group();
  private readonly axes: readonly InstancedMesh[];
  private readonly links: LineSegments;
  private readonly names = new Map<string, Sprite>();
  private nameGroup = new Group();
  private color = '';
  private places: readonly FramePlace[] = [];
  private scale = NaN;

  constructor() {
    const across = 0.06;
    const shape = new CylinderGeometry(across / 2, across / 2, 1, 10).translate(0, 0.5, 0);
    this.axes = ([
      [shape.clone().rotateZ(-Math.PI / 2), '#e5484d'],
      [shape.clone(), '#30a46c'],
      [shape.clone().rotateX(Math.PI / 2), '#3e7bfa'],
    ] as const).map(([geometry, color]) => {
      const instances = new InstancedMesh(geometry, new MeshBasicMaterial({ color }), MOST_SHOWN);
      instances.count = 0;
      instances.frustumCulled = false;
      return instances;
    });
    shape.dispose();
    this.links = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: '#d08a1d' }));
    this.links.frustumCulled = false;
    this.group.add(...this.axes, this.links, this.nameGroup);
  }

  /** How many frames are shown. */
  get count(): number {
    return this.places.length;
  }

  showNames(shown: boolean): void {
    this.nameGroup.visible = shown;
  }

  set(places: readonly FramePlace[], color: string): void {
    this.places = places.filter(({ transform }) => isPlace(...transform.translation)).slice(0, MOST_SHOWN);
    this.scale = NaN;
    const at = new Map(this.places.map((place) => [place.name, place.transform.translation]));
    const lines: number[] = [];
    for (const { parent, transform } of this.places) {
      const end = parent === null ? undefined : at.get(parent);
      if (end !== undefined) lines.push(...transform.translation, ...end);
    }
    this.links.geometry.dispose();
    this.links.geometry = new BufferGeometry();
    this.links.geometry.setAttribute('position', new BufferAttribute(new Float32Array(lines), 3));
    this.name(color);
  }

  /** In the size that the view asks for. */
  fit(view: CameraView): void {
    const size = view.distance * AXIS_LENGTH;
    const nameScale = view.top ? view.distance : 1;
    if (size !== this.scale) {
      this.scale = size;
      const matrix = new Matrix4();
      const scale = new Vector3(size, size, size);
      for (const [index, { transform }] of this.places.entries()) {
        matrix.compose(new Vector3(...transform.translation), new Quaternion(...transform.rotation), scale);
        for (const axis of this.axes) axis.setMatrixAt(index, matrix);
      }
      for (const axis of this.axes) {
        axis.count = this.places.length;
        axis.instanceMatrix.needsUpdate = true;
      }
    }
    for (const { name, transform } of this.places) {
      const sprite = this.names.get(name);
      if (sprite === undefined) continue;
      const [x, y, z] = transform.translation;
      const [width, height] = sprite.userData['size'] as readonly [number, number];
      sprite.position.set(x, y, z);
      sprite.scale.set(width * nameScale, height * nameScale, 1);
    }
  }

  close(): void {
    disposeOf(this.group);
  }

  private name(color: string): void {
    if (color !== this.color) {
      this.color = color;
      for (const sprite of this.names.values()) sprite.material.color = new Color(color);
    }
    const wanted = new Set(this.places.slice(0, MOST_NAMES).map(({ name }) => name));
    for (const [name, sprite] of this.names)
      if (!wanted.has(name)) {
        this.nameGroup.remove(sprite);
        disposeOf(sprite);
        this.names.delete(name);
      }
    for (const name of wanted) {
      if (this.names.has(name)) continue;
      const sprite = words(name, NAME_HEIGHT, named(color), true);
      sprite.userData['size'] = [sprite.scale.x, sprite.scale.y];
      // Below the origin, where no axis is in the way.
      sprite.center.set(0.5, 1.4);
      sprite.material.depthTest = false;
      sprite.renderOrder = 1;
      this.names.set(name, sprite);
      this.nameGroup.add(sprite);
    }
  }
}
