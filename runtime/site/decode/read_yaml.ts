// Message values out of YAML, as `ros2 topic pub` and its like take them: YAML 1.1 as PyYAML reads it, then each
// value made into what its field wants. Loaded when a command or a form reads YAML.

import { isMap, parseDocument, type Tags } from 'yaml';
import type { Field, Shape } from './shape.ts';
import { messageOf } from './types.ts';
import { formatFloat, isList, isMessage } from './yaml.ts';

export type ReadValue =
  | { readonly kind: 'value'; readonly value: unknown; }
  | { readonly kind: 'failed'; readonly reason: string; };

/** PyYAML takes `y` and `n` for texts, so that `{x: 1, y: 2}` is a point. */
function asPyYaml(tags: Tags): Tags {
  return tags.map((tag) =>
    typeof tag === 'object' && tag.tag === 'tag:yaml.org,2002:bool' && 'test' in tag && tag.test !== undefined
      ? { ...tag, test: tag.test.test('true') ? /^(?:yes|Yes|YES|true|True|TRUE|on|On|ON)$/ : /^(?:no|No|NO|false|False|FALSE|off|Off|OFF)$/ }
      : tag
  );
}

/** Any YAML document; integers are bigints. An empty text is null. */
export function readYaml(text: string): ReadValue {
  try {
    const document = parseDocument(text, {
      version: '1.1',
      schema: 'yaml-1.1',
      intAsBigInt: true,
      strict: true,
      uniqueKeys: false,
      logLevel: 'silent',
      prettyErrors: true,
      customTags: asPyYaml,
    });
    const [error] = document.errors;
    if (error !== undefined) return { kind: 'failed', reason: error.message.trim() };
    // A bare date or set would become an object of JavaScript's own.
    const value: unknown = document.toJS({ maxAliasCount: 100, mapAsMap: false });
    return { kind: 'value', value: isMap(document.contents) ? plain(value) : plain(value ?? null) };
  } catch (error) {
    return { kind: 'failed', reason: messageOf(error) };
  }
}

function plain(value: unknown): unknown {
  if (value instanceof Date) return value.toISOString();
  if (Array.isArray(value)) return value.map(plain);
  if (value instanceof Uint8Array) return value;
  if (value instanceof Set) return [...value as Set<unknown>].map(plain);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, plain(each)]));
}

export interface Fill {
  /** The time for `stamp: now` and `header: auto`; undefined: these words have no special meaning. */
  readonly now?: { readonly sec: number; readonly nanosec: number; };
}

/** Reads a message's fields from YAML. Values that do not fit are left for the encoder to refuse. */
export function readMessage(text: string, shape: Shape, fill: Fill = {}): ReadValue {
  const read = readYaml(text);
  if (read.kind === 'failed') return read;
  const value = read.value ?? {};
  if (!isMessage(value)) return { kind: 'failed', reason: 'fields with their values are wanted, as `{data: 1}`' };
  return { kind: 'value', value: fitMessage(value, shape, fill) };
}

function fitMessage(value: Readonly<Record<string, unknown>>, shape: Shape, fill: Fill): Record<string, unknown> {
  const fields = new Map(shape.map((field) => [field.name, field]));
  return Object.fromEntries(Object.entries(value).map(([name, given]) => {
    const field = fields.get(name);
    return [name, field === undefined ? given : fitField(given, field, fill)];
  }));
}

function fitField(given: unknown, field: Field, fill: Fill): unknown {
  if (field.isArray) return isList(given) ? Array.from(given, (item) => fitItem(item, field, fill)) : given;
  return fitItem(given, field, fill);
}

function fitItem(given: unknown, field: Field, fill: Fill): unknown {
  const { type, shape } = field;
  if (fill.now !== undefined) {
    if (given === 'now' && type === 'time') return fill.now;
    if (given === 'auto' && type === 'std_msgs/msg/Header') return { stamp: fill.now };
  }
  if (shape !== null) return isMessage(given) ? fitMessage(given, shape, fill) : given;
  switch (type) {
    case 'string':
      return text(given);
    case 'bool':
      return typeof given === 'bigint' || typeof given === 'number' ? Boolean(Number(given)) : given;
    case 'float32':
    case 'float64':
      return real(given);
    case 'time':
    case 'duration':
      return isMessage(given) ? Object.fromEntries(Object.entries(given).map(([name, part]) => [name, integer(part)])) : given;
    default:
      return integer(given);
  }
}

function text(given: unknown): unknown {
  switch (typeof given) {
    case 'bigint':
      return String(given);
    case 'number':
      return formatFloat(given);
    case 'boolean':
      return given ? 'True' : 'False';
    default:
      return given;
  }
}

function real(given: unknown): unknown {
  if (typeof given === 'bigint') return Number(given);
  if (typeof given === 'boolean') return Number(given);
  const isNumber = typeof given === 'string' && /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/.test(given.trim());
  return isNumber ? Number(given) : given;
}

function integer(given: unknown): unknown {
  if (typeof given === 'number' && Number.isFinite(given)) return BigInt(Math.trunc(given));
  if (typeof given === 'boolean') return given ? 1n : 0n;
  return typeof given === 'string' && /^[-+]?\d{1,20}$/.test(given.trim()) ? BigInt(given) : given;
}
