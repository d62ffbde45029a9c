// Values in one line, as YAML's flow style has them. Pure.

import { isFloat } from './shape.ts';
import type { Field } from './shape.ts';
import { fieldOf, formatScalar, isList, isMessage } from './yaml.ts';

/** In one line, messages in it too. `field`: what it is, or what its items are. */
export function inFlow(value: unknown, field: Field | undefined, truncate: number | null): string {
  if (isList(value)) {
    const count = truncate === null ? value.length : Math.min(value.length, truncate);
    const items = Array.from({ length: count }, (_, i) => inFlow(value[i], field, truncate));
    return `[${[...items, ...(count < value.length ? ["'...'"] : [])].join(', ')}]`;
  }
  if (isMessage(value)) {
    return `{${Object.entries(value).map(([key, each]) => `${key}: ${inFlow(each, fieldOf(field?.shape ?? null, key), truncate)}`).join(', ')}}`;
  }
  const text = formatScalar(value, truncate, '', isFloat(field));
  // These have a meaning between braces.
  const plain = typeof value === 'string' && !/^['"]/.test(text);
  return plain && /[,?:[\]{}]/.test(text) ? `'${text.replaceAll("'", "''")}'` : text;
}
