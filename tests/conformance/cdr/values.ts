// Pseudo-random message values, a plain CDR encoder for either byte order, and a comparison of
// values with what a reader gives. Written against the schema only.
import type { MessageDefinitionField } from '@foxglove/message-definition';

import type { Schemas } from './schemas.ts';

export type Value = number | bigint | boolean | string | Value[] | { [name: string]: Value; };

/** Mulberry32: small, the same everywhere. */
export class Random {
  #state: number;
  constructor(seed: number) {
    this.#state = seed;
  }
  next(): number {
    this.#state = (this.#state + 0x6d2b79f5) | 0;
    let t = Math.imul(this.#state ^ (this.#state >>> 15), 1 | this.#state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return (t ^ (t >>> 14)) >>> 0;
  }
  below(limit: number): number {
    return this.next() % limit;
  }
}

interface IntegerType {
  readonly bits: number;
  readonly signed: boolean;
}
const INTEGERS: ReadonlyMap<string, IntegerType> = new Map(
  [8, 16, 32, 64].flatMap((bits): [string, IntegerType][] => [
    [`int${bits}`, { bits, signed: true }],
    [`uint${bits}`, { bits, signed: false }],
  ]),
);

function randomInteger(random: Random, bits: number, signed: boolean): number | bigint {
  const wide = (BigInt(random.next()) << 32n) | BigInt(random.next());
  const value = signed ? BigInt.asIntN(bits, wide) : BigInt.asUintN(bits, wide);
  return bits === 64 ? value : Number(value);
}

function randomText(random: Random, bound: number | undefined, alphabet: string): string {
  const units = [...alphabet];
  const most = Math.min(bound ?? 12, 12);
  return Array.from({ length: random.below(most + 1) }, () => units[random.below(units.length)]).join('');
}

function randomOne(schemas: Schemas, field: MessageDefinitionField, random: Random): Value {
  if (field.isComplex === true) return randomMessage(schemas, field.type, random);
  const integer = INTEGERS.get(field.type);
  if (integer !== undefined) return randomInteger(random, integer.bits, integer.signed);
  switch (field.type) {
    case 'bool':
      return random.below(2) === 1;
    case 'float32':
      return Math.fround((random.next() | 0) / 1024);
    case 'float64':
      return (random.next() | 0) * 1.1 ** (random.below(200) - 100);
    case 'string':
      return randomText(random, field.upperBound, 'abc XYZ019"\\\'/\t');
    case 'wstring':
      return randomText(random, field.upperBound, 'aZé☃');
    default:
      throw new Error(`unknown type ${field.type}`);
  }
}

export function randomMessage(schemas: Schemas, type: string, random: Random): { [name: string]: Value; } {
  const message: { [name: string]: Value; } = {};
  for (const field of schemas.get(type) ?? []) {
    if (field.isArray !== true) {
      message[field.name] = randomOne(schemas, field, random);
      continue;
    }
    const most = Math.min(field.arrayUpperBound ?? 4, 4);
    const length = field.arrayLength ?? random.below(most + 1);
    message[field.name] = Array.from({ length }, () => randomOne(schemas, field, random));
  }
  return message;
}

class Writer {
  readonly #bytes: number[];
  readonly #little: boolean;
  constructor(little: boolean) {
    this.#little = little;
    this.#bytes = [0, little ? 1 : 0, 0, 0];
  }
  put(size: number, write: (view: DataView, little: boolean) => void): void {
    while ((this.#bytes.length - 4) % size !== 0) this.#bytes.push(0);
    const view = new DataView(new ArrayBuffer(size));
    write(view, this.#little);
    this.#bytes.push(...new Uint8Array(view.buffer));
  }
  count(value: number): void {
    this.put(4, (view, little) => view.setUint32(0, value, little));
  }
  finish(): Uint8Array {
    return Uint8Array.from(this.#bytes);
  }
}

function writeOne(schemas: Schemas, field: MessageDefinitionField, value: Value, to: Writer): void {
  if (field.isComplex === true) {
    writeMessage(schemas, field.type, value as { [name: string]: Value; }, to);
    return;
  }
  const integer = INTEGERS.get(field.type);
  if (integer !== undefined) {
    const all = BigInt(value as number | bigint);
    to.put(integer.bits / 8, (view, little) => {
      if (integer.bits === 64) view.setBigUint64(0, BigInt.asUintN(64, all), little);
      else if (integer.bits === 32) view.setUint32(0, Number(BigInt.asUintN(32, all)), little);
      else if (integer.bits === 16) view.setUint16(0, Number(BigInt.asUintN(16, all)), little);
      else view.setUint8(0, Number(BigInt.asUintN(8, all)));
    });
  } else if (field.type === 'bool') {
    to.put(1, (view) => view.setUint8(0, value === true ? 1 : 0));
  } else if (field.type === 'float32') {
    to.put(4, (view, little) => view.setFloat32(0, value as number, little));
  } else if (field.type === 'float64') {
    to.put(8, (view, little) => view.setFloat64(0, value as number, little));
  } else if (field.type === 'string') {
    const bytes = new TextEncoder().encode(value as string);
    to.count(bytes.length + 1);
    for (const byte of [...bytes, 0]) to.put(1, (view) => view.setUint8(0, byte));
  } else {
    const text = value as string;
    to.count(text.length);
    for (let i = 0; i < text.length; i++) to.count(text.charCodeAt(i));
  }
}

function writeMessage(schemas: Schemas, type: string, message: { [name: string]: Value; }, to: Writer): void {
  const fields = schemas.get(type) ?? [];
  if (fields.length === 0) to.put(1, (view) => view.setUint8(0, 0));
  for (const field of fields) {
    const value = message[field.name];
    if (value === undefined) throw new Error(`${type} lacks ${field.name}`);
    if (field.isArray !== true) {
      writeOne(schemas, field, value, to);
      continue;
    }
    const list = value as Value[];
    if (field.arrayLength === undefined) to.count(list.length);
    for (const one of list) writeOne(schemas, field, one, to);
  }
}

export function encode(schemas: Schemas, type: string, message: { [name: string]: Value; }, little: boolean): Uint8Array {
  const to = new Writer(little);
  writeMessage(schemas, type, message, to);
  return to.finish();
}

/** Brings values of any reader into one form: plain arrays, 64-bit integers as text. */
export function plain(schemas: Schemas, type: string, message: unknown): unknown {
  const source = message as Record<string, unknown>;
  const one = (field: MessageDefinitionField, value: unknown): unknown => {
    if (field.isComplex === true) return plain(schemas, field.type, value);
    if (field.type === 'int64' || field.type === 'uint64') return String(value);
    return value;
  };
  return Object.fromEntries(
    (schemas.get(type) ?? []).map((field) => {
      const value = source[field.name];
      if (field.isArray !== true) return [field.name, one(field, value)];
      return [field.name, Array.from(value as Iterable<unknown>, (element) => one(field, element))];
    }),
  );
}
