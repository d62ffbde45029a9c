// The values of a `--filter`: what Python makes of numbers, texts and lists when it compares them and reckons with them.
// Whole numbers of 64 bits are bigint and stay exact; a double that is whole stands for an int and for a float.

import { isList, isMessage } from '../decode/yaml.ts';
import { CommandError } from './command.ts';

export type Numeric = number | bigint;

export function kindOf(value: unknown): string {
  if (isMessage(value)) return 'the message';
  if (isList(value)) return 'a list';
  return value === null ? 'None' : `a ${typeof value === 'string' ? 'str' : typeof value === 'boolean' ? 'bool' : 'number'}`;
}

/** Not copied: a message may have millions. */
export function items(value: unknown): ArrayLike<unknown> {
  if (isList(value)) return value;
  if (typeof value === 'string') return [...value];
  throw new CommandError(`TypeError: ${kindOf(value)} is not a list`);
}

/** Whether it holds for one of them. */
export function some(list: ArrayLike<unknown>, holds: (one: unknown) => boolean): boolean {
  for (let i = 0; i < list.length; i += 1) if (holds(list[i])) return true;
  return false;
}

/** Flags count as 0 and 1. */
export function numeric(value: unknown): Numeric {
  if (typeof value === 'number' || typeof value === 'bigint') return value;
  if (typeof value === 'boolean') return Number(value);
  throw new CommandError(`TypeError: ${kindOf(value)} is not a number`);
}

/** An index or a number of digits. */
export function integer(value: unknown): number {
  const given = Number(numeric(value));
  if (!Number.isInteger(given)) throw new CommandError(`TypeError: 'float' object cannot be interpreted as an integer`);
  return given;
}

export function item(value: unknown, index: unknown): unknown {
  const list = items(value);
  const at = integer(index);
  const found = at < 0 ? list.length + at : at;
  if (found < 0 || found >= list.length) throw new CommandError(`IndexError: ${typeof value === 'string' ? 'string' : 'list'} index out of range`);
  return list[found];
}

export function truth(value: unknown): boolean {
  return isList(value) ? value.length > 0 : Boolean(value);
}

export function same(left: unknown, right: unknown): boolean {
  if (isList(left) && isList(right)) {
    if (left.length !== right.length) return false;
    for (let i = 0; i < left.length; i += 1) if (!same(left[i], right[i])) return false;
    return true;
  }
  const other = (value: unknown): boolean => typeof value === 'string' || typeof value === 'object';
  if (other(left) || other(right)) return left === right;
  // Loosely: 1, 1.0, True and a number of 64 bits are equal, as in Python; exactly, whatever the two are.
  return numeric(left) == numeric(right);
}

/** Negative, 0 or positive. JavaScript's own order is that of UTF-16 units, which puts pairs of them before U+E000. */
function codePointOrder(left: string, right: string): number {
  const [a, b] = [[...left], [...right]];
  for (let i = 0; i < a.length && i < b.length; i += 1) {
    const difference = a[i]!.codePointAt(0)! - b[i]!.codePointAt(0)!;
    if (difference !== 0) return difference;
  }
  return a.length - b.length;
}

/** The result of a comparison, of `in` and `not in`, or of `is` and `is not`. */
export function compared(sign: string, left: unknown, right: unknown): boolean {
  switch (sign) {
    case '==':
    case 'is':
      return same(left, right);
    case '!=':
    case 'is not':
      return !same(left, right);
    case 'in':
    case 'not in':
      return within(left, right) === (sign === 'in');
    default: {
      const texts = typeof left === 'string' && typeof right === 'string';
      const [a, b] = texts ? [codePointOrder(left, right), 0] : [numeric(left), numeric(right)];
      return sign === '<' ? a < b : sign === '>' ? a > b : sign === '<=' ? a <= b : a >= b;
    }
  }
}

function within(one: unknown, all: unknown): boolean {
  if (typeof all !== 'string') return some(items(all), (each) => same(each, one));
  if (typeof one !== 'string') throw new CommandError(`TypeError: 'in <string>' requires string as left operand, not ${kindOf(one)}`);
  return all.includes(one);
}

/** Both exact, when one is of 64 bits and the other is whole too. */
function exact(a: Numeric, b: Numeric): readonly [bigint, bigint] | undefined {
  const whole = (value: Numeric): boolean => typeof value === 'bigint' || Number.isSafeInteger(value);
  return (typeof a === 'bigint' || typeof b === 'bigint') && whole(a) && whole(b) ? [BigInt(a), BigInt(b)] : undefined;
}

/** The quotient towards minus infinity and the rest with the sign of the divisor, as CPython has them. */
function divided(a: number, b: number): readonly [quotient: number, rest: number] {
  let rest = a % b;
  let quotient = (a - rest) / b;
  if (rest !== 0 && (b < 0) !== (rest < 0)) {
    rest += b;
    quotient -= 1;
  }
  const floor = Math.floor(quotient);
  return [quotient - floor > 0.5 ? floor + 1 : floor, rest];
}

function dividedExactly(a: bigint, b: bigint): readonly [quotient: bigint, rest: bigint] {
  const rest = a % b;
  return rest !== 0n && (b < 0n) !== (rest < 0n) ? [a / b - 1n, rest + b] : [a / b, rest];
}

/** Beyond these bits an exact power would take all memory: it is reckoned with doubles. */
const mostExponent = 4096n;

function reckonedExactly(sign: string, a: bigint, b: bigint): Numeric | undefined {
  switch (sign) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    case '//':
      return dividedExactly(a, b)[0];
    case '%':
      return dividedExactly(a, b)[1];
    case '**':
      return b >= 0n && b <= mostExponent ? a ** b : undefined;
    default:
      return undefined;
  }
}

function power(a: number, b: number): number {
  if (a === 0 && b < 0) throw new CommandError('ZeroDivisionError: 0.0 cannot be raised to a negative power');
  const value = a ** b;
  if (Number.isNaN(value) && !Number.isNaN(a) && !Number.isNaN(b)) {
    // 1 and -1 to the power of infinity are 1; a root of a negative number is complex.
    if (Math.abs(a) === 1) return 1;
    throw new CommandError('TypeError: a complex number is not a number here');
  }
  if (!Number.isFinite(value) && Number.isFinite(a) && Number.isFinite(b)) throw new CommandError("OverflowError: (34, 'Numerical result out of range')");
  return value;
}

/** The result of an arithmetic operator. */
export function reckon(sign: string, left: unknown, right: unknown): unknown {
  if (sign === '+' && typeof left === 'string' && typeof right === 'string') return left + right;
  const [a, b] = [numeric(left), numeric(right)];
  if (Number(b) === 0 && (sign === '/' || sign === '//' || sign === '%')) throw new CommandError('ZeroDivisionError: division by zero');
  const both = exact(a, b);
  const found = both === undefined ? undefined : reckonedExactly(sign, ...both);
  if (found !== undefined) return found;
  const [x, y] = [Number(a), Number(b)];
  switch (sign) {
    case '+':
      return x + y;
    case '-':
      return x - y;
    case '*':
      return x * y;
    case '/':
      return x / y;
    case '//':
      return divided(x, y)[0];
    case '%':
      return divided(x, y)[1];
    default:
      return power(x, y);
  }
}
