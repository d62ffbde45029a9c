// Values as Python writes them: `ros2 topic pub` and `ros2 service call` print messages by repr(). Pure.

import { isFloat, type Field, type Shape } from '../decode/shape.ts';
import { isList, isMessage } from '../decode/yaml.ts';

/** `std_msgs.msg.String(data='hello')`. */
export function reprMessage(type: string, shape: Shape, value: unknown): string {
  const fields = isMessage(value) ? value : {};
  const inner = shape.map((field) => `${field.name}=${reprField(field, fields[field.name])}`);
  return `${type.replaceAll('/', '.')}(${inner.join(', ')})`;
}

function reprField(field: Field, value: unknown): string {
  if (field.isArray) return `[${isList(value) ? Array.from(value, (item) => reprItem(field, item)).join(', ') : ''}]`;
  return reprItem(field, value);
}

function reprItem(field: Field, value: unknown): string {
  if (field.shape !== null) return reprMessage(field.type, field.shape, value);
  if ((field.type === 'time' || field.type === 'duration') && isMessage(value)) {
    const type = field.type === 'time' ? 'Time' : 'Duration';
    return `builtin_interfaces.msg.${type}(sec=${String(value['sec'])}, nanosec=${String(value['nanosec'])})`;
  }
  return reprScalar(value, isFloat(field));
}

export function reprScalar(value: unknown, float = false): string {
  switch (typeof value) {
    case 'boolean':
      return value ? 'True' : 'False';
    case 'number':
      return float || !Number.isInteger(value) ? reprFloat(value) : String(value);
    case 'string':
      return reprText(value);
    case 'bigint':
      return String(value);
    default:
      return 'None';
  }
}

export function reprFloat(value: number): string {
  if (Number.isNaN(value)) return 'nan';
  if (!Number.isFinite(value)) return value > 0 ? 'inf' : '-inf';
  if (Object.is(value, -0)) return '-0.0';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e16)) {
    const [mantissa, exponent] = value.toExponential().split('e') as [string, string];
    return `${mantissa}e${exponent[0]}${exponent.slice(1).padStart(2, '0')}`;
  }
  const text = String(value);
  return text.includes('.') ? text : `${text}.0`;
}

export function reprText(text: string): string {
  const quote = text.includes("'") && !text.includes('"') ? '"' : "'";
  let out = '';
  for (const c of text) {
    const code = c.codePointAt(0)!;
    if (c === quote || c === '\\') out += `\\${c}`;
    else if (c === '\n') out += '\\n';
    else if (c === '\r') out += '\\r';
    else if (c === '\t') out += '\\t';
    else if (code < 32 || code === 127) out += `\\x${code.toString(16).padStart(2, '0')}`;
    else if (/[\p{C}\p{Zl}\p{Zp}]|[^\S ]/u.test(c))
      out += code < 256
        ? `\\x${code.toString(16)}`
        : code < 65536
        ? `\\u${code.toString(16).padStart(4, '0')}`
        : `\\U${code.toString(16).padStart(8, '0')}`;
    else out += c;
  }
  return `${quote}${out}${quote}`;
}
