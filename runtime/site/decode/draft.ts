// The message that a type begins with: zeros, empty texts and arrays, and the defaults of its definition. Plain
// values that a form can change and the encoder takes; 64-bit integers are bigints.

import type { Field, Shape } from './shape.ts';

export type MessageValue = Record<string, unknown>;

/** Fixed arrays hold at most so many items in all; a definition may ask for any number. */
const mostItems = 1 << 20;

export class TooLarge extends Error {}

/** Throws TooLarge. */
export function draftOf(shape: Shape): MessageValue {
  let left = mostItems;
  const spend = (items: number): void => {
    left -= items;
    if (left < 0) throw new TooLarge(`its fixed arrays hold more than ${mostItems} items`);
  };
  const message = (fields: Shape): MessageValue => {
    const value: MessageValue = {};
    for (const field of fields) {
      // By definition, not assignment: a field may be called __proto__.
      Object.defineProperty(value, field.name, { value: begin(field), writable: true, enumerable: true, configurable: true });
    }
    return value;
  };
  const begin = (field: Field): unknown => {
    if (!field.isArray) return item(field);
    if (field.defaultValue instanceof Array) return field.defaultValue.map((each) => scalar(field.type, each));
    const length = field.length ?? 0;
    spend(length);
    return Array.from({ length }, () => item({ ...field, isArray: false }));
  };
  const item = (field: Field): unknown => {
    if (field.shape !== null) return message(field.shape);
    return scalar(field.type, field.defaultValue instanceof Array ? undefined : field.defaultValue);
  };
  return message(shape);
}

function scalar(type: string, given: unknown): unknown {
  switch (type) {
    case 'bool':
      return given === undefined ? false : Boolean(given);
    case 'string':
    case 'wstring':
      return given === undefined ? '' : String(given);
    case 'int64':
    case 'uint64':
      return typeof given === 'bigint' ? given : BigInt(typeof given === 'number' ? given : 0);
    case 'time':
    case 'duration':
      return { sec: 0, nanosec: 0 };
    default:
      return given === undefined ? 0 : Number(given);
  }
}
