// The drawing of one visualization_msgs/msg/Marker, by its type.

import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, InstancedMesh, Matrix4, Quaternion, Vector3 } from 'three';
import type { Object3D } from 'three';
import { asNumber } from '../model/field_path.ts';
import { member } from '../model/json.ts';
import { readPose, readVector } from '../model/transform.ts';
import type { Vector } from '../model/transform.ts';
import { panelTexts } from '../texts_panels.ts';
import { isPlace } from './places.ts';
import { lines, pairsOf } from './lines.ts';
import type { MeshShelf, PlacedMesh } from './mesh_shelf.ts';
import type { Built } from './newest_display.ts';
import { points } from './points.ts';
import { arrow, ball, box, cylinder, mesh, pixelsOfWords, placeAt, rgba, solid, words } from './shapes.ts';
import type { Rgba } from './shapes.ts';

const MOST_POINTS = 200_000;
const MOST_SOLIDS = 20_000;
const LARGEST = 1e5;
const AHEAD = new Vector3(1, 0, 0);

/** As the message's constants number them. */
export const MarkerType = {
  arrow: 0,
  cube: 1,
  sphere: 2,
  cylinder: 3,
  lineStrip: 4,
  lineList: 5,
  cubeList: 6,
  sphereList: 7,
  points: 8,
  text: 9,
  meshResource: 10,
  triangleList: 11,
  arrowStrip: 12,
} as const;

interface Parts {
  readonly scale: Vector;
  readonly look: Rgba;
  /** x, y, z of each point. */
  readonly places: Float32Array;
  /** Red, green, blue of each point in three's light; null: they have the marker's colour. */
  readonly colors: Float32Array | null;
  readonly text: string;
}

/** Upper bounds of the resources of a marker; each is bounded for all markers of a display together. */
export interface MarkerCost {
  readonly points: number;
  /** Cubes, balls and arrows of lists. */
  readonly solids: number;
  /** The pixels of written words. */
  readonly pixels: number;
}

export function markerCost(marker: unknown): MarkerCost {
  const type = asNumber(member(marker, 'type'));
  const [all, text] = [member(marker, 'points'), member(marker, 'text')];
  const points = Array.isArray(all) ? Math.min(all.length, MOST_POINTS) : 0;
  const isStrip = type === MarkerType.arrowStrip;
  const isList = type === MarkerType.cubeList || type === MarkerType.sphereList || type === MarkerType.points;
  return {
    points,
    solids: isStrip || (isList && points <= MOST_SOLIDS) ? Math.min(points, MOST_SOLIDS) : 0,
    pixels: type === MarkerType.text && typeof text === 'string' ? pixelsOfWords(text) : 0,
  };
}

export interface MarkerBuilt extends Built {
  readonly mesh?: PlacedMesh;
}

export function markerShape(marker: unknown, meshes: MeshShelf): MarkerBuilt {
  const pose = readPose(member(marker, 'pose'));
  const scale = readVector(member(marker, 'scale'));
  if (pose === null || scale === null || !isPlace(...pose.translation) || scale.some((part) => Math.abs(part) > LARGEST))
    return { object: null, problem: panelTexts.scene.noPose };
  if (asNumber(member(marker, 'type')) === MarkerType.meshResource) {
    const placed = markerMesh(marker, scale, meshes);
    if (placed === null) return { object: null, problem: panelTexts.scene.mesh.none };
    placeAt(placed.object, pose);
    return { object: new Group().add(placed.object), problem: '', mesh: placed };
  }
  const all = member(marker, 'points');
  const text = member(marker, 'text');
  const { places, colors } = readPoints(all, member(marker, 'colors'));
  const shape = shapeOf(asNumber(member(marker, 'type')), {
    scale,
    look: colorOf(member(marker, 'color')),
    places,
    colors,
    text: typeof text === 'string' ? text : '',
  });
  if (typeof shape === 'string') return { object: null, problem: shape };
  placeAt(shape, pose);
  const missing = Array.isArray(all) ? all.length - MOST_POINTS : 0;
  // The marker's frame is that of what it stands in.
  return { object: new Group().add(shape), problem: missing > 0 ? panelTexts.scene.leftOut(missing) : '' };
}

/** null: it names no file. */
function markerMesh(marker: unknown, scale: Vector, meshes: MeshShelf): PlacedMesh | null {
  const file = member(marker, 'mesh_resource');
  if (typeof file !== 'string' || file === '') return null;
  const bytes = member(member(marker, 'mesh_file'), 'data');
  return meshes.place({
    file,
    scale,
    look: colorOf(member(marker, 'color')),
    ownLook: member(marker, 'mesh_use_embedded_materials') === true,
    ...(bytes instanceof Uint8Array && bytes.length > 0 ? { bytes } : {}),
  });
}

/** A text: why there is none. */
function shapeOf(type: number, parts: Parts): Object3D | string {
  const { scale, look, places, colors, text } = parts;
  const solidOf = (geometry: BufferGeometry): Object3D => mesh(geometry.scale(...scale), look);
  switch (type) {
    case MarkerType.arrow:
      if (places.length >= 6) return arrowBetween(parts, 0);
      return solidOf(arrow({ length: 1, shaft: 1, head: 2, headLength: 0.23 }));
    case MarkerType.cube:
      return solidOf(box(1, 1, 1));
    case MarkerType.sphere:
      return solidOf(ball());
    case MarkerType.cylinder:
      return solidOf(cylinder(0.5, 1));
    case MarkerType.lineStrip:
      return lines(pairsOf(places), look, colors === null ? null : pairsOf(colors), { width: scale[0], unit: 'metres' });
    case MarkerType.lineList: {
      const whole = places.length - (places.length % 6);
      return lines(places.subarray(0, whole), look, colors?.subarray(0, whole) ?? null, { width: scale[0], unit: 'metres' });
    }
    case MarkerType.cubeList:
      return many(box(1, 1, 1).scale(...scale), parts);
    case MarkerType.sphereList:
      return many(ball().scale(...scale), parts);
    case MarkerType.points:
      return many(box(scale[0], scale[1], Math.min(scale[0], scale[1])), parts);
    case MarkerType.text:
      return text === '' ? new Group() : words(text, scale[2], look, false);
    case MarkerType.triangleList:
      return triangles(parts);
    case MarkerType.arrowStrip:
      return arrowStrip(parts);
    default:
      return panelTexts.scene.markerType(type);
  }
}

/** From the point at that index to the next: widths of shaft and head, and the head's length, are the scale. */
function arrowBetween({ places, scale: [shaft, head, headLength], look }: Parts, index: number): Object3D {
  const start = new Vector3().fromArray(places, index);
  const way = new Vector3().fromArray(places, index + 3).sub(start);
  const length = way.length();
  const tip = headLength > 0 ? headLength : length * 0.23;
  const object = mesh(arrow({ length, shaft, head, headLength: tip }), look);
  object.position.copy(start);
  if (length > 0) object.quaternion.setFromUnitVectors(new Vector3(1, 0, 0), way.normalize());
  return object;
}

/** Arrows of two pieces each; all of one piece are drawn at once. */
function arrowStrip({ places, scale: [shaft, head, headLength], look }: Parts): Object3D {
  const most = Math.min(Math.max(0, places.length / 3 - 1), MOST_SOLIDS);
  const material = solid(look);
  const sticks = new InstancedMesh(arrow({ length: 1, shaft: 1, head: 0, headLength: 0 }), material, most);
  const tips = new InstancedMesh(arrow({ length: 1, shaft: 0, head: 1, headLength: 1 }), material, most);
  const [matrix, at, size, turn] = [new Matrix4(), new Vector3(), new Vector3(), new Quaternion()];
  let count = 0;
  for (let i = 0; i < most; i += 1) {
    const way = new Vector3().fromArray(places, i * 3 + 3).sub(at.fromArray(places, i * 3));
    const length = way.length();
    if (length === 0) continue;
    const tip = Math.min(headLength > 0 ? headLength : length * 0.23, length);
    // A flat stick has no sides that the light could fall on.
    const stick = Math.max(length - tip, length * 1e-6);
    turn.setFromUnitVectors(AHEAD, way.divideScalar(length));
    sticks.setMatrixAt(count, matrix.compose(at, turn, size.set(stick, shaft, shaft)));
    tips.setMatrixAt(count, matrix.compose(at.addScaledVector(way, length - tip), turn, size.set(tip, head, head)));
    count += 1;
  }
  for (const each of [sticks, tips]) {
    each.count = count;
    each.frustumCulled = false;
  }
  return new Group().add(sticks, tips);
}

function many(geometry: BufferGeometry, { places, colors, look }: Parts): Object3D {
  const count = places.length / 3;
  if (count > MOST_SOLIDS) {
    geometry.dispose();
    const cloud = points(places, `#${look.color.getHexString()}`);
    if (colors !== null) {
      cloud.geometry.setAttribute('color', new BufferAttribute(colors, 3));
      cloud.material.vertexColors = true;
      cloud.material.color.set('#ffffff');
    }
    return cloud;
  }
  const material = solid(colors === null ? look : { ...look, color: new Color(0xffffff) });
  const instances = new InstancedMesh(geometry, material, count);
  const [matrix, color] = [new Matrix4(), new Color()];
  for (let i = 0; i < count; i += 1) {
    instances.setMatrixAt(i, matrix.makeTranslation(places[i * 3] ?? 0, places[i * 3 + 1] ?? 0, places[i * 3 + 2] ?? 0));
    if (colors !== null) instances.setColorAt(i, color.fromArray(colors, i * 3));
  }
  instances.frustumCulled = false;
  return instances;
}

function triangles({ places, colors, look, scale }: Parts): Object3D {
  const whole = places.length - (places.length % 9);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places.slice(0, whole), 3));
  if (colors !== null) geometry.setAttribute('color', new BufferAttribute(colors.slice(0, whole), 3));
  geometry.scale(...scale);
  geometry.computeVertexNormals();
  const object = mesh(geometry, colors === null ? look : { ...look, color: new Color(0xffffff) });
  object.material.vertexColors = colors !== null;
  object.material.side = DoubleSide;
  object.frustumCulled = false;
  return object;
}

/** Points that are no places are skipped, with their colours. */
function readPoints(list: unknown, shades: unknown): Pick<Parts, 'places' | 'colors'> {
  const all = Array.isArray(list) ? (list.slice(0, MOST_POINTS) as readonly unknown[]) : [];
  const isColored = Array.isArray(shades) && Array.isArray(list) && shades.length === list.length && list.length > 0;
  const places = new Float32Array(all.length * 3);
  const colors = isColored ? new Float32Array(all.length * 3) : null;
  let count = 0;
  for (const [index, item] of all.entries()) {
    const point = readVector(item);
    if (point === null || !isPlace(...point)) continue;
    places.set(point, count * 3);
    if (colors !== null && isColored) colorOf(shades[index]).color.toArray(colors, count * 3);
    count += 1;
  }
  return { places: places.subarray(0, count * 3), colors: colors?.subarray(0, count * 3) ?? null };
}

function colorOf(value: unknown): Rgba {
  const part = (name: string): number => asNumber(member(value, name));
  return rgba(part('r'), part('g'), part('b'), part('a'));
}
