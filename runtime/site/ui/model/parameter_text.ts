// Values of parameters as the text of a field, and back: numbers as YAML writes them, lists in one line. Pure.

import { formatFloat } from '../../decode/yaml.ts';
import type { ReadValue } from '../../decode/read_yaml.ts';
import type { Descriptor } from '../../ros2cli/parameter_calls.ts';
import { kindOf, parameterValue } from '../../ros2cli/parameters.ts';
import type { ParameterValue } from '../../ros2cli/parameters.ts';
import { readNumber } from './draft_value.ts';
import { panelTexts } from '../texts_panels.ts';

/** Bytes that are shown of a byte array. */
const MOST_BYTES = 64;
const LEAST = -(1n << 63n);
const MOST = (1n << 63n) - 1n;

export type ReadParameter =
  | { readonly kind: 'value'; readonly value: ParameterValue; }
  | { readonly kind: 'failed'; readonly reason: string; };

/** The text in the field of a value. */
export function parameterText(value: ParameterValue): string {
  const { field } = kindOf(value);
  const own = value[field];
  if (field === '') return '';
  if (field === 'byte_array_value') return bytesText(Array.from(own as ArrayLike<number>));
  if (field.endsWith('_array_value')) return `[${Array.from(own as ArrayLike<unknown>, (item) => itemText(item, field)).join(', ')}]`;
  return field === 'string_value' ? String(own) : itemText(own, field);
}

function itemText(item: unknown, field: string): string {
  if (field.startsWith('double')) return formatFloat(Number(item));
  return typeof item === 'string' ? JSON.stringify(item) : String(item);
}

function bytesText(bytes: readonly number[]): string {
  const shown = bytes.slice(0, MOST_BYTES).map((byte) => Number(byte).toString(16).padStart(2, '0'));
  return bytes.length > MOST_BYTES ? `${shown.join(' ')} \u2026` : shown.join(' ');
}

/** Is YAML read for parameters of this type? */
export function needsYaml(type: number): boolean {
  return !['integer_value', 'double_value', 'string_value'].includes(kindOf({ type }).field);
}

/**
 * Reads a text as a parameter of `type` (rcl_interfaces/msg/ParameterType); 0: the type comes from the text's YAML value.
 * `yaml` is only asked for types that need it.
 */
export function readParameter(text: string, type: number, yaml: (text: string) => ReadValue): ReadParameter {
  const { field } = kindOf({ type });
  switch (field) {
    case 'string_value':
      return { kind: 'value', value: { type, string_value: text } };
    case 'integer_value': {
      const number = readNumber(text, 'int64');
      return isInteger(number) ? { kind: 'value', value: { type, integer_value: number } } : failed(panelTexts.parameters.noInteger);
    }
    case 'double_value': {
      const number = readNumber(text, 'float64');
      return typeof number === 'number' ? { kind: 'value', value: { type, double_value: number } } : failed(panelTexts.parameters.noNumber);
    }
  }
  const read = yaml(text);
  if (field === '') return { kind: 'value', value: parameterValue(text, read.kind === 'value' ? read.value : text) };
  if (read.kind === 'failed') return read;
  if (field === 'bool_value')
    return typeof read.value === 'boolean' ? { kind: 'value', value: { type, bool_value: read.value } } : failed(panelTexts.parameters.noBoolean);
  const items: readonly unknown[] | null = Array.isArray(read.value) ? read.value : null;
  const list = items === null ? null : itemsOf(items, field);
  return list === null ? failed(panelTexts.parameters.noList(kindOf({ type }).name)) : { kind: 'value', value: { type, [field]: list } };
}

function itemsOf(items: readonly unknown[], field: string): readonly unknown[] | null {
  switch (field) {
    case 'bool_array_value':
      return items.every((item) => typeof item === 'boolean') ? items : null;
    case 'integer_array_value':
      return items.every(isInteger) ? items : null;
    case 'double_array_value':
      return items.every((item) => typeof item === 'number' || typeof item === 'bigint') ? items.map(Number) : null;
    case 'string_array_value':
      return items.every((item) => typeof item === 'string') ? items : null;
    default:
      return null;
  }
}

function isInteger(value: unknown): value is bigint {
  return typeof value === 'bigint' && value >= LEAST && value <= MOST;
}

function failed(reason: string): ReadParameter {
  return { kind: 'failed', reason };
}

/** Limits that a slider can have; null: none, or too wide for one. */
export interface SliderRange {
  readonly least: number;
  readonly most: number;
  /** 0: any. */
  readonly step: number;
}

export function sliderRange(descriptor: Descriptor | undefined, type: number): SliderRange | null {
  const { field } = kindOf({ type });
  const range = field === 'double_value' ? descriptor?.floating_point_range[0] : field === 'integer_value' ? descriptor?.integer_range[0] : undefined;
  if (range === undefined) return null;
  const [least, most, step] = [Number(range.from_value), Number(range.to_value), Number(range.step)];
  const whole = field === 'integer_value';
  if (!(Number.isFinite(least) && Number.isFinite(most) && least < most && step >= 0)) return null;
  if (whole && !(Number.isSafeInteger(least) && Number.isSafeInteger(most))) return null;
  return { least, most, step: whole ? Math.max(1, step) : step };
}

/** `0.0 to 2.0, step 0.1`; empty without a range. */
export function rangeText(descriptor: Descriptor | undefined): string {
  const double = descriptor?.floating_point_range[0];
  if (double !== undefined)
    return panelTexts.parameters.range(formatFloat(double.from_value), formatFloat(double.to_value), double.step === 0 ? '' : formatFloat(double.step));
  const whole = descriptor?.integer_range[0];
  if (whole === undefined) return '';
  const step = Number(whole.step) > 1 ? String(whole.step) : '';
  return panelTexts.parameters.range(String(whole.from_value), String(whole.to_value), step);
}
