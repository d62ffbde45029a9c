// A message as the command that publishes it: `ros2 topic pub --once /topic TYPE 'VALUES'`, whole, for this page's
// terminal and for a shell. Pure.

import { fieldOf, formatScalar, isList, isMessage } from '../../decode/yaml.ts';
import { isFloat } from '../../decode/shape.ts';
import type { Field, Shape } from '../../decode/shape.ts';

export function pubCommand(topic: string, type: string, value: unknown, shape: Shape | null): string {
  return `ros2 topic pub --once ${topic} ${type} ${shellQuoted(flow(value, shape, undefined))}`;
}

/** YAML in one line. */
function flow(value: unknown, shape: Shape | null, field: Field | undefined): string {
  if (isList(value)) {
    const items = Array.from(value, (item) => flow(item, field?.shape ?? null, field));
    return `[${items.join(', ')}]`;
  }
  if (isMessage(value)) {
    const entries = Object.entries(value).map(([name, inside]) => {
      const own = fieldOf(shape, name);
      return `${name}: ${flow(inside, own?.shape ?? null, own)}`;
    });
    return `{${entries.join(', ')}}`;
  }
  if (typeof value !== 'string') return formatScalar(value, null, '', isFloat(field));
  // Line ends that JSON lets stand are ends of lines for YAML.
  return JSON.stringify(value).replace(/[\u007f-\u009f\u2028\u2029\ufeff]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);
}

function shellQuoted(text: string): string {
  return `'${text.replaceAll("'", "'\\''")}'`;
}
