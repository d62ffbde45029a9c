// Python's built-in functions and methods of texts that a `--filter` may call, with their errors.

import { isList, isMessage } from '../decode/yaml.ts';
import { CommandError } from './command.ts';
import { compared, integer, items, kindOf, numeric, type Numeric, reckon, some, truth } from './filter_values.ts';

type Call = (given: readonly unknown[]) => unknown;

/** Refuses what Python's function does not take: it has from `least` to `most` arguments. */
function taking(name: string, least: number, most: number, call: Call): readonly [string, Call] {
  return [name, (given) => {
    if (given.length >= least && given.length <= most) return call(given);
    const wanted = least === most ? `exactly ${least}` : given.length < least ? `at least ${least}` : `at most ${most}`;
    throw new CommandError(`TypeError: ${name}() takes ${wanted} argument${wanted.endsWith(' 1') ? '' : 's'} (${given.length} given)`);
  }];
}

function extreme(name: 'max' | 'min'): Call {
  const sign = name === 'max' ? '>' : '<';
  return (given) => {
    const list = given.length === 1 ? items(given[0]) : given;
    if (list.length === 0) throw new CommandError(`ValueError: ${name}() iterable argument is empty`);
    let best = list[0];
    if (typeof best !== 'string') numeric(best);
    for (let i = 1; i < list.length; i += 1) if (compared(sign, list[i], best)) best = list[i];
    return best;
  };
}

/** As CPython 3.12 adds doubles: what each addition loses is added at the end. */
function sum([list, start = 0]: readonly unknown[]): unknown {
  if (typeof list === 'string') throw new CommandError("TypeError: unsupported operand type(s) for +: 'int' and 'str'");
  const all = items(list);
  let exactly: unknown = numeric(start);
  let i = 0;
  // Whole numbers first: they are exact as long as they are.
  while (i < all.length && typeof exactly !== 'string' && isWhole(exactly) && isWhole(numeric(all[i]))) {
    exactly = reckon('+', exactly, all[i]);
    i += 1;
  }
  if (i === all.length) return exactly;
  let total = Number(exactly);
  let lost = 0;
  for (; i < all.length; i += 1) {
    const value = Number(numeric(all[i]));
    const next = total + value;
    lost += Math.abs(total) >= Math.abs(value) ? total - next + value : value - next + total;
    total = next;
  }
  return Number.isFinite(lost) ? total + lost : total;
}

function isWhole(value: unknown): boolean {
  return typeof value === 'bigint' || Number.isSafeInteger(value);
}

function toInt([value = 0, base]: readonly unknown[]): Numeric {
  if (typeof value === 'string') return integerOf(value, base === undefined ? 10 : integer(base));
  if (base !== undefined) throw new CommandError("TypeError: int() can't convert non-string with explicit base");
  const given = numeric(value);
  if (typeof given === 'bigint') return given;
  if (Number.isNaN(given)) throw new CommandError('ValueError: cannot convert float NaN to integer');
  if (!Number.isFinite(given)) throw new CommandError('OverflowError: cannot convert float infinity to integer');
  return Math.trunc(given) + 0;
}

/** As CPython's limit, which holds for bases that are not powers of two. */
const mostIntDigits = 4300;
const prefixes: Readonly<Record<number, RegExp>> = { 2: /^0b/i, 8: /^0o/i, 16: /^0x/i };

function integerOf(text: string, base: number): Numeric {
  const wrong = (): CommandError => new CommandError(`ValueError: invalid literal for int() with base ${base}: ${quoted(text)}`);
  if (base < 2 || base > 36) throw new CommandError('ValueError: int() base must be >= 2 and <= 36, or 0');
  const [, sign = '', written = ''] = /^([+-]?)(.*)$/s.exec(text.trim()) ?? [];
  const digits = prefixes[base] === undefined ? written : written.replace(prefixes[base], '');
  if (!/^[0-9a-z]+(?:_[0-9a-z]+)*$/i.test(digits)) throw wrong();
  const plain = digits.replaceAll('_', '');
  if (plain.length > mostIntDigits && ![2, 4, 8, 16, 32].includes(base)) {
    throw new CommandError(`ValueError: Exceeds the limit (${mostIntDigits} digits) for integer string conversion: value has ${plain.length} digits`);
  }
  if (plain.length > 50 * mostIntDigits) throw new CommandError('MemoryError');
  let value = 0n;
  for (const letter of plain) {
    const digit = Number.parseInt(letter, 36);
    if (digit >= base) throw wrong();
    value = value * BigInt(base) + BigInt(digit);
  }
  if (sign === '-') value = -value;
  const number = Number(value);
  return Number.isSafeInteger(number) ? number : value;
}

function toFloat([value = 0]: readonly unknown[]): number {
  if (typeof value !== 'string') return Number(numeric(value));
  const text = value.trim();
  const named = /^([+-]?)(?:(inf|infinity)|nan)$/i.exec(text);
  if (named !== null) return named[2] === undefined ? NaN : named[1] === '-' ? -Infinity : Infinity;
  const digits = String.raw`\d+(?:_\d+)*`;
  if (!new RegExp(`^[+-]?(?:${digits}(?:\\.(?:${digits})?)?|\\.${digits})(?:e[+-]?${digits})?$`, 'i').test(text)) {
    throw new CommandError(`ValueError: could not convert string to float: ${quoted(value)}`);
  }
  return Number(text.replaceAll('_', ''));
}

/** The double as a fraction of whole numbers. */
function fraction(value: number): readonly [bigint, bigint] {
  let [numerator, exponent] = [value, 0];
  while (!Number.isInteger(numerator)) {
    numerator *= 2;
    exponent += 1;
  }
  return [BigInt(numerator), 1n << BigInt(exponent)];
}

/** The nearest whole number, of two the even one. */
function halfEven(numerator: bigint, denominator: bigint): bigint {
  const isNegative = numerator < 0n;
  const size = isNegative ? -numerator : numerator;
  const whole = size / denominator;
  const twice = 2n * (size % denominator);
  const up = twice > denominator || (twice === denominator && whole % 2n === 1n);
  const rounded = up ? whole + 1n : whole;
  return isNegative ? -rounded : rounded;
}

/** A double has no more digits, before and behind its point. */
const mostDigits = 330;

function round([value, digits]: readonly unknown[]): Numeric {
  const given = numeric(value);
  const places = digits === undefined || digits === null ? 0 : integer(digits);
  if (typeof given === 'number' && !Number.isFinite(given)) {
    if (digits === undefined || digits === null) return toInt([given]);
    return given;
  }
  if (places > mostDigits || (typeof given === 'bigint' && places >= 0)) return given;
  if (places < -mostDigits) return 0;
  const [numerator, denominator] = typeof given === 'bigint' ? [given, 1n] as const : fraction(given);
  const scale = 10n ** BigInt(Math.abs(places));
  const units = places < 0 ? halfEven(numerator, denominator * scale) : halfEven(numerator * scale, denominator);
  if (typeof given === 'bigint') return units * scale;
  return Number(`${units}e${-places}`);
}

function quoted(text: string): string {
  return text.includes("'") && !text.includes('"') ? `"${text}"` : `'${text.replaceAll('\\', '\\\\').replaceAll("'", "\\'")}'`;
}

function toText([value = '']: readonly unknown[]): string {
  if (typeof value === 'string') return value;
  if (typeof value === 'boolean') return value ? 'True' : 'False';
  if (value === null) return 'None';
  if (isMessage(value)) throw new CommandError('TypeError: a message is not text here');
  if (isList(value)) return `[${Array.from(value, (one) => (typeof one === 'string' ? quoted(one) : toText([one]))).join(', ')}]`;
  if (typeof value === 'number' && !Number.isFinite(value)) return Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf';
  return typeof value === 'number' ? numberText(value) : String(value);
}

/** As Python's repr(), but a double that is whole may be an int of the message: it has no `.0` unless it is beyond what an int of it
 * could be. */
function numberText(value: number): string {
  const size = Math.abs(value);
  if (Object.is(value, -0)) return '-0.0';
  if (size === 0 || (size >= 1e-4 && size < 1e16)) return String(value);
  const [digits = '', exponent = '0'] = value.toExponential().split('e');
  const power = Number(exponent);
  return `${digits}e${power < 0 ? '-' : '+'}${String(Math.abs(power)).padStart(2, '0')}`;
}

export const filterFunctions: ReadonlyMap<string, Call> = new Map([
  taking('abs', 1, 1, ([value]) => {
    const given = numeric(value);
    return typeof given === 'bigint' ? (given < 0n ? -given : given) : Math.abs(given);
  }),
  taking('all', 1, 1, ([list]) => !some(items(list), (one) => !truth(one))),
  taking('any', 1, 1, ([list]) => some(items(list), truth)),
  taking('bool', 0, 1, ([value = false]) => truth(value)),
  taking('float', 0, 1, toFloat),
  taking('int', 0, 2, toInt),
  taking('len', 1, 1, ([value]) => items(value).length),
  taking('max', 1, Infinity, extreme('max')),
  taking('min', 1, Infinity, extreme('min')),
  taking('round', 1, 2, round),
  taking('str', 0, 1, toText),
  taking('sum', 1, 2, sum),
]);

function text(value: unknown): string {
  if (typeof value === 'string') return value;
  throw new CommandError(`TypeError: ${kindOf(value)} is not a str`);
}

/** Takes what stands in `letters` off both ends. */
function stripped(from: string, letters: unknown): string {
  if (letters === undefined || letters === null) return from.trim();
  const off = new Set(text(letters));
  const all = [...from];
  let [begin, end] = [0, all.length];
  while (begin < end && off.has(all[begin]!)) begin += 1;
  while (end > begin && off.has(all[end - 1]!)) end -= 1;
  return all.slice(begin, end).join('');
}

/** The first argument is the text itself. */
export const filterMethods: ReadonlyMap<string, Call> = new Map([
  taking('endswith', 2, 2, ([from, end]) => text(from).endsWith(text(end))),
  taking('lower', 1, 1, ([from]) => text(from).toLowerCase()),
  taking('startswith', 2, 2, ([from, begin]) => text(from).startsWith(text(begin))),
  taking('strip', 1, 2, ([from, letters]) => stripped(text(from), letters)),
  taking('upper', 1, 1, ([from]) => text(from).toUpperCase()),
]);
