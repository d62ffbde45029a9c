// A robot description (URDF) as far as it is seen: of each link the shapes, those
// for seeing and those for collisions, where they are in it and their colours.
// The text may be anything. Joints are read by model/joints.ts; where links are is told by /tf.

import { fromRollPitchYaw, IDENTITY } from './transform.ts';
import type { Transform, Vector } from './transform.ts';
import { readXml } from './xml.ts';
import type { XmlElement } from './xml.ts';

export type LinkShape =
  | { readonly kind: 'box'; readonly size: Vector; }
  | { readonly kind: 'cylinder'; readonly radius: number; readonly length: number; }
  | { readonly kind: 'sphere'; readonly radius: number; }
  | { readonly kind: 'mesh'; readonly file: string; readonly scale: Vector; };

export type Rgba = readonly [red: number, green: number, blue: number, alpha: number];

export interface Visual {
  readonly origin: Transform;
  readonly shape: LinkShape;
  /** null: none is said. */
  readonly color: Rgba | null;
}

export interface RobotLink {
  readonly name: string;
  readonly visuals: readonly Visual[];
  /** The shapes for the detection of collisions. Without colours. */
  readonly collisions: readonly Visual[];
}

export interface Robot {
  readonly name: string;
  readonly links: readonly RobotLink[];
  /** Shapes without a size, or none that is known. */
  readonly leftOut: number;
}

const MOST_CHARACTERS = 1 << 24;
const MOST_LINKS = 2000;
const MOST_VISUALS = 5000;
const LARGEST = 1e6;

export type UrdfFault = 'too-long' | 'no-xml' | 'no-robot';

export function readUrdf(text: string): Robot | UrdfFault {
  if (text.length > MOST_CHARACTERS) return 'too-long';
  const robot = readXml(text);
  if (robot === null) return 'no-xml';
  if (robot.name !== 'robot') return 'no-robot';
  const colors = new Map<string, Rgba>();
  for (const material of childrenOf(robot, 'material')) {
    const color = colorOf(material);
    if (color !== null) colors.set(material.attributes.get('name') ?? '', color);
  }
  let count = 0;
  let leftOut = 0;
  const links = childrenOf(robot, 'link').slice(0, MOST_LINKS).map((link): RobotLink => {
    const shapes = (name: string): readonly Visual[] => {
      const found: Visual[] = [];
      for (const element of childrenOf(link, name)) {
        const visual = count < MOST_VISUALS ? visualOf(element, colors) : null;
        if (visual === null) leftOut += 1;
        else found.push(visual);
        count += 1;
      }
      return found;
    };
    return { name: link.attributes.get('name') ?? '', visuals: shapes('visual'), collisions: shapes('collision') };
  });
  return { name: robot.attributes.get('name') ?? '', links, leftOut };
}

function visualOf(visual: XmlElement, colors: ReadonlyMap<string, Rgba>): Visual | null {
  const [geometry] = childrenOf(visual, 'geometry');
  const shape = geometry === undefined ? null : shapeOf(geometry);
  const [origin] = childrenOf(visual, 'origin');
  const place = origin === undefined ? IDENTITY : originOf(origin);
  if (shape === null || place === null) return null;
  const [material] = childrenOf(visual, 'material');
  const color = material === undefined ? null : (colorOf(material) ?? colors.get(material.attributes.get('name') ?? '') ?? null);
  return { origin: place, shape, color };
}

function shapeOf(geometry: XmlElement): LinkShape | null {
  for (const element of geometry.children) {
    const length = (name: string): number => numbersOf(element, name, 1)?.[0] ?? NaN;
    switch (element.name) {
      case 'box': {
        const [x = NaN, y = NaN, z = NaN] = numbersOf(element, 'size', 3) ?? [];
        return [x, y, z].every(isLength) ? { kind: 'box', size: [x, y, z] } : null;
      }
      case 'cylinder': {
        const [radius, along] = [length('radius'), length('length')];
        return isLength(radius) && isLength(along) ? { kind: 'cylinder', radius, length: along } : null;
      }
      case 'sphere': {
        const radius = length('radius');
        return isLength(radius) ? { kind: 'sphere', radius } : null;
      }
      case 'mesh': {
        const file = element.attributes.get('filename') ?? '';
        const [x = NaN, y = NaN, z = NaN] = numbersOf(element, 'scale', 3) ?? [1, 1, 1];
        return file !== '' && [x, y, z].every((part) => isLength(Math.abs(part))) ? { kind: 'mesh', file, scale: [x, y, z] } : null;
      }
      default:
    }
  }
  return null;
}

/** null: numbers are said that are none. */
function originOf(origin: XmlElement): Transform | null {
  const [x = NaN, y = NaN, z = NaN] = numbersOf(origin, 'xyz', 3) ?? [0, 0, 0];
  const [roll = NaN, pitch = NaN, yaw = NaN] = numbersOf(origin, 'rpy', 3) ?? [0, 0, 0];
  const isSound = [x, y, z, roll, pitch, yaw].every((value) => Math.abs(value) < LARGEST);
  return isSound ? { translation: [x, y, z], rotation: fromRollPitchYaw(roll, pitch, yaw) } : null;
}

function colorOf(material: XmlElement): Rgba | null {
  const [element] = childrenOf(material, 'color');
  const [red = NaN, green = NaN, blue = NaN, alpha = NaN] = (element && numbersOf(element, 'rgba', 4)) ?? [];
  return [red, green, blue, alpha].every(Number.isFinite) ? [red, green, blue, alpha] : null;
}

/** null: the attribute is missing. */
function numbersOf(element: XmlElement, name: string, count: number): readonly number[] | null {
  const text = element.attributes.get(name);
  if (text === undefined) return null;
  const parts = text.trim().split(/\s+/).map(Number);
  return parts.length === count ? parts : Array.from({ length: count }, () => NaN);
}

function isLength(value: number): boolean {
  return value > 0 && value < LARGEST;
}

function childrenOf(element: XmlElement, name: string): readonly XmlElement[] {
  return element.children.filter((child) => child.name === name);
}
