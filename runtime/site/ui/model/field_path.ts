// Paths of fields, as `/odom.pose.pose.position.x` or `/scan.ranges[3]`: a topic, and the way to one value in its
// messages. Pure.

import type { Shape } from '../../decode/shape.ts';

export interface FieldPath {
  readonly topic: string;
  readonly steps: readonly (string | number)[];
}

const MOST_LENGTH = 300;

/** null when the text is no such path. */
export function parseFieldPath(text: string): FieldPath | null {
  const trimmed = text.trim();
  if (trimmed.length > MOST_LENGTH) return null;
  const match = /^(\/[A-Za-z_][A-Za-z0-9_]*(?:\/[A-Za-z_][A-Za-z0-9_]*)*)((?:\.[A-Za-z_][A-Za-z0-9_]*|\[\d{1,9}\])+)$/.exec(trimmed);
  if (match === null) return null;
  const steps = [...(match[2] ?? '').matchAll(/\.([A-Za-z0-9_]+)|\[(\d+)\]/g)].map((step) => step[1] === undefined ? Number(step[2]) : step[1]);
  return { topic: match[1] ?? '', steps };
}

/** The value at the path; undefined where there is none. */
export function valueAt(message: unknown, steps: readonly (string | number)[]): unknown {
  let value = message;
  for (const step of steps) {
    if (typeof value !== 'object' || value === null || !Object.hasOwn(value, step)) return undefined;
    value = (value as Readonly<Record<string | number, unknown>>)[step];
  }
  return value;
}

/** A number for a plot: of a number, a boolean, a time (its seconds); NaN for anything else. */
export function asNumber(value: unknown): number {
  switch (typeof value) {
    case 'number':
      return value;
    case 'bigint':
    case 'boolean':
      return Number(value);
    case 'object': {
      if (value === null) return Number.NaN;
      const { sec, nanosec } = value as { readonly sec?: unknown; readonly nanosec?: unknown; };
      return typeof sec === 'number' && typeof nanosec === 'number' ? sec + nanosec * 1e-9 : Number.NaN;
    }
    default:
      return Number.NaN;
  }
}

/** A short text for a state: of anything that is one value; undefined for messages and lists. */
export function asState(value: unknown): string | undefined {
  switch (typeof value) {
    case 'string':
      return value.slice(0, 80);
    case 'number':
    case 'bigint':
    case 'boolean':
      return String(value);
    default:
      return undefined;
  }
}

export type FieldKind = 'number' | 'state';

/** The paths of a type's plain values, at most `limit`; of a list, that of its first item. */
export function pathsOf(topic: string, shape: Shape, kind: FieldKind, limit = 100): readonly string[] {
  const found: string[] = [];
  const walk = (fields: Shape, prefix: string, depth: number): void => {
    for (const field of fields) {
      if (found.length >= limit || depth > 12) return;
      const path = `${prefix}.${field.name}${field.isArray ? '[0]' : ''}`;
      const text = field.type === 'string' || field.type === 'wstring';
      if (field.shape !== null) walk(field.shape, path, depth + 1);
      else if (!text || kind === 'state') found.push(path);
    }
  };
  walk(shape, topic, 0);
  return found;
}
