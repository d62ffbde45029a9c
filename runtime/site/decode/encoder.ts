// Turns plain values into the bytes of a message (CDR). A field that is omitted takes its default; a value that does not fit
// its field gives an error with the field's path. @foxglove's MessageWriter is not used: it writes misfits
// as something else, and cuts texts that are not ASCII.

import { CdrWriter } from '@foxglove/cdr';
import { draftOf } from './draft.ts';
import type { Field, Shape } from './shape.ts';
import { messageOf, type Types } from './types.ts';

export type Encoded =
  | { readonly kind: 'bytes'; readonly bytes: Uint8Array<ArrayBuffer>; }
  /** `path`: as `header.stamp.sec` or `points[3].x`; empty for the message itself. */
  | { readonly kind: 'failed'; readonly path: string; readonly reason: string; };

interface Whole {
  readonly least: bigint;
  readonly most: bigint;
  readonly bits: number;
  readonly signed: boolean;
}

const whole = (bits: number, signed: boolean): Whole => ({
  bits,
  signed,
  least: signed ? -(1n << BigInt(bits - 1)) : 0n,
  most: (1n << BigInt(signed ? bits - 1 : bits)) - 1n,
});

const wholes: ReadonlyMap<string, Whole> = new Map([8, 16, 32, 64].flatMap((bits) => [
  [`int${bits}`, whole(bits, true)] as const,
  [`uint${bits}`, whole(bits, false)] as const,
]));

const utf8 = new TextEncoder();

/** A value that does not fit; caught in encode(). */
class Misfit extends Error {
  readonly path: string;

  constructor(path: string, reason: string) {
    super(reason);
    this.path = path;
  }
}

export function encodeMessage(types: Types, type: string, value: unknown): Encoded {
  const parsed = types.get(type);
  if (typeof parsed === 'string') return { kind: 'failed', path: '', reason: parsed };
  try {
    const writer = new CdrWriter();
    writeMessage(writer, parsed.shape, value, '');
    return { kind: 'bytes', bytes: Uint8Array.from(writer.data) };
  } catch (error) {
    return { kind: 'failed', path: error instanceof Misfit ? error.path : '', reason: messageOf(error) };
  }
}

function writeMessage(writer: CdrWriter, shape: Shape, value: unknown, path: string): void {
  const given = fieldsOf(value, path);
  const known = new Set(shape.map(({ name }) => name));
  const stranger = Object.keys(given).find((name) => !known.has(name));
  if (stranger !== undefined) throw new Misfit(join(path, stranger), 'there is no such field');
  // A message without fields has one byte on the wire.
  if (shape.length === 0) writer.uint8(0);
  for (const field of shape) {
    const at = join(path, field.name);
    const own = Object.hasOwn(given, field.name) ? given[field.name] : undefined;
    const used = own ?? draftOf([field])[field.name];
    if (field.isArray) writeArray(writer, field, used, at);
    else writeItem(writer, field, used, at);
  }
}

function writeArray(writer: CdrWriter, field: Field, value: unknown, path: string): void {
  const isList = Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
  if (!isList) throw new Misfit(path, `a list is wanted, not ${kindOf(value)}`);
  const list = value as ArrayLike<unknown>;
  if (field.length !== undefined && list.length !== field.length) {
    throw new Misfit(path, `exactly ${field.length} items are wanted, not ${list.length}`);
  }
  if (field.mostItems !== undefined && list.length > field.mostItems) {
    throw new Misfit(path, `at most ${field.mostItems} items are allowed, not ${list.length}`);
  }
  if (field.length === undefined) writer.sequenceLength(list.length);
  if (field.type === 'uint8' && list instanceof Uint8Array) {
    writer.uint8Array(list);
    return;
  }
  for (let i = 0; i < list.length; i += 1) writeItem(writer, field, list[i], `${path}[${i}]`);
}

function writeItem(writer: CdrWriter, field: Field, value: unknown, path: string): void {
  const { type, shape } = field;
  if (shape !== null) {
    writeMessage(writer, shape, value, path);
    return;
  }
  const bounds = wholes.get(type);
  if (bounds !== undefined) {
    writeWhole(writer, bounds, type, value, path);
    return;
  }
  switch (type) {
    case 'bool':
      if (typeof value !== 'boolean') throw new Misfit(path, `true or false is wanted, not ${kindOf(value)}`);
      writer.int8(value ? 1 : 0);
      return;
    case 'float32':
    case 'float64': {
      if (typeof value !== 'number' && typeof value !== 'bigint') throw new Misfit(path, `a number is wanted, not ${kindOf(value)}`);
      if (type === 'float32') writer.float32(Number(value));
      else writer.float64(Number(value));
      return;
    }
    case 'string':
      writeText(writer, field, value, path);
      return;
    case 'time':
    case 'duration': {
      const parts = fieldsOf(value, path);
      const stranger = Object.keys(parts).find((name) => name !== 'sec' && name !== 'nanosec');
      if (stranger !== undefined) throw new Misfit(join(path, stranger), 'there is no such field');
      writeWhole(writer, wholes.get('int32')!, 'int32', parts['sec'] ?? 0, join(path, 'sec'));
      writeWhole(writer, wholes.get('uint32')!, 'uint32', parts['nanosec'] ?? 0, join(path, 'nanosec'));
      return;
    }
    default:
      throw new Misfit(path, `${type} cannot be sent`);
  }
}

function writeWhole(writer: CdrWriter, { least, most, bits, signed }: Whole, type: string, value: unknown, path: string): void {
  const isWhole = typeof value === 'bigint' || (typeof value === 'number' && Number.isInteger(value));
  if (!isWhole) throw new Misfit(path, `a whole number is wanted, not ${kindOf(value)}`);
  const exact = BigInt(value);
  if (exact < least || exact > most) throw new Misfit(path, `${exact} is not a valid ${type}: ${least} to ${most}`);
  if (bits === 64) {
    if (signed) writer.int64(exact);
    else writer.uint64(exact);
    return;
  }
  const number = Number(exact);
  if (bits === 32) void (signed ? writer.int32(number) : writer.uint32(number));
  else if (bits === 16) void (signed ? writer.int16(number) : writer.uint16(number));
  else void (signed ? writer.int8(number) : writer.uint8(number));
}

function writeText(writer: CdrWriter, field: Field, value: unknown, path: string): void {
  if (typeof value !== 'string') throw new Misfit(path, `a text is wanted, not ${kindOf(value)}`);
  const bytes = utf8.encode(value);
  if (field.mostBytes !== undefined && bytes.length > field.mostBytes) {
    throw new Misfit(path, `at most ${field.mostBytes} bytes are allowed, not ${bytes.length}`);
  }
  writer.uint32(bytes.length + 1);
  writer.uint8Array(bytes);
  writer.uint8(0);
}

function fieldsOf(value: unknown, path: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value) || ArrayBuffer.isView(value)) {
    throw new Misfit(path, `fields are wanted, not ${kindOf(value)}`);
  }
  return value as Readonly<Record<string, unknown>>;
}

function join(path: string, name: string): string {
  return path === '' ? name : `${path}.${name}`;
}

function kindOf(value: unknown): string {
  switch (typeof value) {
    case 'string':
      return value.length > 40 ? 'a long text' : `the text ${JSON.stringify(value)}`;
    case 'number':
    case 'bigint':
    case 'boolean':
      return String(value);
    default:
      if (value === null || value === undefined) return 'nothing';
      return Array.isArray(value) || ArrayBuffer.isView(value) ? 'a list' : 'fields';
  }
}
