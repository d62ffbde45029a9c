// Solid shapes that displays share: boxes, balls, cylinders, arrows, lines, written words.

import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  ConeGeometry,
  CylinderGeometry,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
  SphereGeometry,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
} from 'three';
import type { Object3D } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Transform } from '../model/transform.ts';
import type { DisplayLook } from '../model/display_look.ts';

export interface Rgba {
  readonly color: Color;
  readonly alpha: number;
}

export function rgba(red: number, green: number, blue: number, alpha: number): Rgba {
  const part = (value: number): number => (value >= 0 ? Math.min(1, value) : 0);
  return { color: new Color().setRGB(part(red), part(green), part(blue), SRGBColorSpace), alpha: part(alpha) };
}

export function named(color: string): Rgba {
  return { color: new Color(color), alpha: 1 };
}

/** As was chosen for the display, or else of the page's colour. */
export function lookOf({ colors, look }: { readonly colors: { readonly accent: string; }; readonly look: DisplayLook; }, usual = colors.accent,
  usualAlpha = 1): Rgba
{
  return { color: new Color(look.color ?? usual), alpha: look.alpha ?? usualAlpha };
}

export function solid({ color, alpha }: Rgba): MeshStandardMaterial {
  return new MeshStandardMaterial({
    color,
    roughness: 0.7,
    metalness: 0,
    transparent: alpha < 1,
    opacity: alpha,
    depthWrite: alpha >= 1,
  });
}

export function box(x: number, y: number, z: number): BufferGeometry {
  return new BoxGeometry(x, y, z);
}

/** A sphere of diameter 1 around the origin. */
export function ball(): BufferGeometry {
  return new SphereGeometry(0.5, 24, 16);
}

/** Along z, as ROS has it, in the middle. */
export function cylinder(radius: number, length: number): BufferGeometry {
  return new CylinderGeometry(radius, radius, length, 32).rotateX(Math.PI / 2);
}

export function mesh(geometry: BufferGeometry, look: Rgba): Mesh<BufferGeometry, MeshStandardMaterial> {
  return new Mesh(geometry, solid(look));
}

export interface ArrowSize {
  readonly length: number;
  readonly shaft: number;
  readonly head: number;
  readonly headLength: number;
}

/** Along x from the origin; widths are diameters. In one piece, so that many can be drawn at once. */
export function arrow({ length, shaft, head, headLength }: ArrowSize): BufferGeometry {
  const tip = Math.min(headLength, length);
  const [stick, point] = [length - tip, length - tip / 2];
  return mergeGeometries([
    new CylinderGeometry(shaft / 2, shaft / 2, stick, 20).rotateZ(-Math.PI / 2).translate(stick / 2, 0, 0),
    new ConeGeometry(head / 2, tip, 20).rotateZ(-Math.PI / 2).translate(point, 0, 0),
  ]);
}

/** Pairs of points; colours of one each, in three's light, or one for all. */
export function segments(positions: Float32Array, look: Rgba | Float32Array, alpha = 1): LineSegments {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const material = new LineBasicMaterial();
  if (look instanceof Float32Array) {
    geometry.setAttribute('color', new BufferAttribute(look, 3));
    material.vertexColors = true;
  } else {
    material.color = look.color;
  }
  const seen = look instanceof Float32Array ? alpha : look.alpha;
  material.transparent = seen < 1;
  material.opacity = seen;
  const object = new LineSegments(geometry, material);
  object.frustumCulled = false;
  return object;
}

export function placeAt(object: Object3D, { translation, rotation }: Transform): void {
  object.position.set(...translation);
  object.quaternion.set(...rotation);
}

const LETTER_PIXELS = 48;
const MOST_LETTERS = 200;
const MOST_LINES = 20;
const WIDEST = 4096;

function linesOf(text: string): readonly string[] {
  const shown = [...text.slice(0, 4 * MOST_LETTERS)].slice(0, MOST_LETTERS).join('');
  return shown.split('\n').slice(0, MOST_LINES);
}

/** The most that words() draws of the lines: letters are seldom wider than high. */
function roomOf(lines: readonly string[]): { readonly width: number; readonly height: number; } {
  const longest = Math.max(...lines.map(({ length }) => length));
  return {
    width: Math.min(WIDEST, longest * LETTER_PIXELS + 8),
    height: Math.ceil(lines.length * LETTER_PIXELS * 1.3),
  };
}

/** Upper bound of the pixels of the picture that words() makes of the text. */
export function pixelsOfWords(text: string): number {
  const { width, height } = roomOf(linesOf(text));
  return width * height;
}

/** Words that face the eye: `height` of a capital letter, in metres, or in parts of the picture's height when `fixed`. */
export function words(text: string, height: number, look: Rgba, fixed: boolean): Sprite {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const font = `${LETTER_PIXELS}px system-ui, sans-serif`;
  const lines = linesOf(text);
  const room = roomOf(lines);
  if (context !== null) {
    context.font = font;
    const width = Math.max(1, ...lines.map((line) => context.measureText(line).width));
    canvas.width = Math.min(room.width, Math.ceil(width) + 8);
    canvas.height = room.height;
    context.font = font;
    context.textBaseline = 'middle';
    context.fillStyle = '#ffffff';
    for (const [index, line] of lines.entries()) context.fillText(line, 4, (index + 0.5) * LETTER_PIXELS * 1.3);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  const material = new SpriteMaterial({
    map: texture,
    color: look.color,
    opacity: look.alpha,
    transparent: true,
    depthWrite: false,
    sizeAttenuation: !fixed,
  });
  const sprite = new Sprite(material);
  const scale = height / (LETTER_PIXELS * 0.72);
  sprite.scale.set(canvas.width * scale, canvas.height * scale, 1);
  return sprite;
}
