// Parameters of nodes over their services: values in and out of rcl_interfaces, as `ros2 param` shows them.

import { formatScalar } from '../decode/yaml.ts';
import { reprFloat, reprScalar, reprText } from './python_text.ts';

export type ParameterValue = Readonly<Record<string, unknown>>;

interface Kind {
  /** Field of rcl_interfaces/msg/ParameterValue. */
  readonly field: string;
  readonly name: string;
  /** Before the value in `ros2 param get`. */
  readonly label: string;
}

/** By the constants of rcl_interfaces/msg/ParameterType; 0 is not set. */
export const parameterKinds: readonly Kind[] = [
  { field: '', name: 'not set', label: 'Parameter not set.' },
  { field: 'bool_value', name: 'boolean', label: 'Boolean value is:' },
  { field: 'integer_value', name: 'integer', label: 'Integer value is:' },
  { field: 'double_value', name: 'double', label: 'Double value is:' },
  { field: 'string_value', name: 'string', label: 'String value is:' },
  { field: 'byte_array_value', name: 'byte array', label: 'Byte values are:' },
  { field: 'bool_array_value', name: 'boolean array', label: 'Boolean values are:' },
  { field: 'integer_array_value', name: 'integer array', label: 'Integer values are:' },
  { field: 'double_array_value', name: 'double array', label: 'Double values are:' },
  { field: 'string_array_value', name: 'string array', label: 'String values are:' },
];

export function kindOf(value: ParameterValue): Kind {
  return parameterKinds[Number(value['type'])] ?? parameterKinds[0]!;
}

/** As Python prints it. */
export function pythonValue(value: ParameterValue): string {
  const kind = kindOf(value);
  const own = value[kind.field];
  switch (kind.field) {
    case '':
      return 'None';
    case 'string_value':
      return String(own);
    case 'double_value':
      return reprFloat(Number(own));
    case 'bool_value':
    case 'integer_value':
      return reprScalar(own);
    default: {
      const list = Array.from(own as ArrayLike<unknown>);
      if (kind.field === 'byte_array_value') return `[${list.map((byte) => `b'\\x${Number(byte).toString(16).padStart(2, '0')}'`).join(', ')}]`;
      const text = (item: unknown): string => typeof item === 'string' ? reprText(item) : reprScalar(item, kind.field === 'double_array_value');
      const numbers = kind.field === 'integer_array_value' ? 'q' : kind.field === 'double_array_value' ? 'd' : undefined;
      const items = `[${list.map(text).join(', ')}]`;
      return numbers === undefined ? items : `array('${numbers}', ${items})`;
    }
  }
}

/** The parameter value that a typed text means: its YAML value gives the type, as in rclpy's get_parameter_value. */
export function parameterValue(text: string, value: unknown): ParameterValue {
  if (typeof value === 'boolean') return { type: 1, bool_value: value };
  if (typeof value === 'bigint') return { type: 2, integer_value: value };
  if (typeof value === 'number') return { type: 3, double_value: value };
  if (Array.isArray(value)) {
    const list: readonly unknown[] = value;
    if (list.length > 0 && list.every((item) => typeof item === 'boolean')) return { type: 6, bool_array_value: list };
    if (list.length > 0 && list.every((item) => typeof item === 'bigint')) return { type: 7, integer_array_value: list };
    if (list.length > 0 && list.every((item) => typeof item === 'number')) return { type: 8, double_array_value: list };
    if (list.every((item) => typeof item === 'string')) return { type: 9, string_array_value: list };
  }
  return { type: 4, string_value: text };
}

/** A file of parameters, as `ros2 param dump` writes it: nested by the dots of their names, sorted. */
export function dumpText(node: string, values: ReadonlyMap<string, ParameterValue>): string {
  type Tree = Map<string, Tree | ParameterValue>;
  const root: Tree = new Map();
  for (const [name, value] of values) {
    const steps = name.split('.');
    let at = root;
    for (const step of steps.slice(0, -1)) {
      const next = at.get(step);
      const inner: Tree = next instanceof Map ? next : new Map();
      at.set(step, inner);
      at = inner;
    }
    at.set(steps.at(-1)!, value);
  }
  const lines = [`${node}:`, '  ros__parameters:'];
  const write = (tree: Tree, indent: string): void => {
    for (const [name, value] of [...tree].sort(([a], [b]) => (a < b ? -1 : 1))) {
      const head = `${indent}${formatScalar(name, null, indent)}:`;
      if (value instanceof Map) {
        lines.push(head);
        write(value, `${indent}  `);
      } else {
        lines.push(...valueLines(head, value, indent));
      }
    }
  };
  write(root, '    ');
  return lines.join('\n');
}

function valueLines(head: string, value: ParameterValue, indent: string): string[] {
  const { field } = kindOf(value);
  const own = value[field];
  const isDouble = field.startsWith('double');
  if (field === '') return [`${head} null`];
  if (!field.endsWith('_array_value')) return [`${head} ${formatScalar(own, null, `${indent}  `, isDouble)}`];
  const list = Array.from(own as ArrayLike<unknown>);
  if (list.length === 0) return [`${head} []`];
  return [head, ...list.map((item) => `${indent}- ${formatScalar(item, null, `${indent}  `, isDouble)}`)];
}
