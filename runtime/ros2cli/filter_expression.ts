// What `--filter` takes: a Python expression over the message `m`. The part of Python that such expressions are made of:
// fields, indices, numbers, texts, comparisons (also chained), arithmetic, `and`, `or`, `not`, `in`, `is`, `x if c else y`, some of
// the built-in functions and of the methods of texts. Pure; nothing but the message can be reached.

import { isList, isMessage } from '../decode/yaml.ts';
import { CommandError } from './command.ts';

type Evaluation = (message: unknown) => unknown;

const kDeepest = 100;
const kToken = /\s*(?:(\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?)|("(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')|([A-Za-z_]\w*)|(\*\*|\/\/|<=|>=|==|!=|[-+*/%<>()[\],.]))/iy;

interface Token {
  readonly kind: 'number' | 'text' | 'name' | 'sign' | 'end';
  readonly text: string;
}

/** True for the messages that pass. Throws for what is no such expression, as each call does for what cannot be reckoned. */
export function filterOf(text: string): (message: unknown) => boolean {
  const evaluation = new Parser(tokensOf(text)).whole();
  return (message) => truth(evaluation(message));
}

function tokensOf(text: string): readonly Token[] {
  const tokens: Token[] = [];
  kToken.lastIndex = 0;
  const { length } = text.trimEnd();
  while (kToken.lastIndex < length) {
    const from = kToken.lastIndex;
    const match = kToken.exec(text);
    if (match === null) throw new CommandError(`SyntaxError: invalid syntax at '${text.slice(from, from + 20).trim()}'`);
    const kind = match[1] !== undefined ? 'number' : match[2] !== undefined ? 'text' : match[3] !== undefined ? 'name' : 'sign';
    tokens.push({ kind, text: match[0].trim() });
  }
  return tokens;
}

class Parser {
  private readonly tokens: readonly Token[];
  private at = 0;
  private depth = 0;

  constructor(tokens: readonly Token[]) {
    this.tokens = tokens;
  }

  whole(): Evaluation {
    const all = this.choice();
    if (this.next.kind !== 'end') throw this.wrong();
    return all;
  }

  private get next(): Token {
    return this.tokens[this.at] ?? { kind: 'end', text: '' };
  }

  private wrong(): CommandError {
    const { kind, text } = this.next;
    return new CommandError(kind === 'end' ? 'SyntaxError: unexpected end of the expression' : `SyntaxError: invalid syntax at '${text}'`);
  }

  /** Takes one of these signs or words, when it comes next. */
  private take(...wanted: readonly string[]): string | undefined {
    const { kind, text } = this.next;
    if ((kind !== 'sign' && kind !== 'name') || !wanted.includes(text)) return undefined;
    this.at += 1;
    return text;
  }

  private expect(sign: string): void {
    if (this.take(sign) === undefined) throw this.wrong();
  }

  private choice(): Evaluation {
    this.depth += 1;
    if (this.depth > kDeepest) throw new CommandError('SyntaxError: too many nested parentheses');
    const value = this.either();
    this.depth -= 1;
    if (this.take('if') === undefined) return value;
    const condition = this.either();
    this.expect('else');
    const other = this.choice();
    return (m) => (truth(condition(m)) ? value(m) : other(m));
  }

  private either(): Evaluation {
    let left = this.both();
    while (this.take('or') !== undefined) {
      const [first, second] = [left, this.both()];
      left = (m) => {
        const value = first(m);
        return truth(value) ? value : second(m);
      };
    }
    return left;
  }

  private both(): Evaluation {
    let left = this.negation();
    while (this.take('and') !== undefined) {
      const [first, second] = [left, this.negation()];
      left = (m) => {
        const value = first(m);
        return truth(value) ? second(m) : value;
      };
    }
    return left;
  }

  private negation(): Evaluation {
    let times = 0;
    while (this.take('not') !== undefined) times += 1;
    const value = this.comparison();
    return times === 0 ? value : (m) => truth(value(m)) === (times % 2 === 0);
  }

  private comparison(): Evaluation {
    const first = this.sum();
    const rest: { readonly sign: string; readonly value: Evaluation }[] = [];
    for (;;) {
      let sign = this.take('<', '>', '<=', '>=', '==', '!=', 'in', 'is', 'not');
      if (sign === undefined) break;
      if (sign === 'not') {
        this.expect('in');
        sign = 'not in';
      } else if (sign === 'is' && this.take('not') !== undefined) sign = 'is not';
      rest.push({ sign, value: this.sum() });
    }
    if (rest.length === 0) return first;
    return (m) => {
      let left = first(m);
      return rest.every(({ sign, value }) => {
        const right = value(m);
        const holds = compared(sign, left, right);
        left = right;
        return holds;
      });
    };
  }

  private sum(): Evaluation {
    let left = this.product();
    for (let sign = this.take('+', '-'); sign !== undefined; sign = this.take('+', '-')) left = reckoned(sign, left, this.product());
    return left;
  }

  private product(): Evaluation {
    let left = this.signed();
    for (let sign = this.take('*', '/', '//', '%'); sign !== undefined; sign = this.take('*', '/', '//', '%')) left = reckoned(sign, left, this.signed());
    return left;
  }

  private signed(): Evaluation {
    let minus = false;
    for (let sign = this.take('-', '+'); sign !== undefined; sign = this.take('-', '+')) minus = minus !== (sign === '-');
    const value = this.reached();
    const power = this.take('**') === undefined ? value : reckoned('**', value, this.signed());
    return minus ? (m) => -number(power(m)) : power;
  }

  /** A value, and what is reached from it. */
  private reached(): Evaluation {
    let value = this.atom();
    for (;;) {
      const from = value;
      if (this.take('.') !== undefined) {
        const name = this.name();
        if (this.take('(') === undefined) {
          value = (m) => field(from(m), name);
        } else {
          const given = this.list(')');
          value = (m) => method(from(m), name, given.map((one) => one(m)));
        }
      } else if (this.take('[') !== undefined) {
        const index = this.choice();
        this.expect(']');
        value = (m) => item(from(m), index(m));
      } else return value;
    }
  }

  private name(): string {
    const { kind, text } = this.next;
    if (kind !== 'name') throw this.wrong();
    this.at += 1;
    return text;
  }

  private list(end: string): readonly Evaluation[] {
    const items: Evaluation[] = [];
    while (this.take(end) === undefined) {
      if (items.length > 0) {
        this.expect(',');
        if (this.take(end) !== undefined) break;
      }
      items.push(this.choice());
    }
    return items;
  }

  private atom(): Evaluation {
    const { kind, text } = this.next;
    if (kind === 'number') {
      this.at += 1;
      const value = Number(text);
      return () => value;
    }
    if (kind === 'text') {
      this.at += 1;
      const value = text.slice(1, -1).replace(/\\(.)/gs, (_, letter: string) => ({ n: '\n', t: '\t' })[letter] ?? letter);
      return () => value;
    }
    if (this.take('(') !== undefined) {
      const value = this.choice();
      this.expect(')');
      return value;
    }
    if (this.take('[') !== undefined) {
      const items = this.list(']');
      return (m) => items.map((one) => one(m));
    }
    if (kind !== 'name' || kWords.has(text)) throw this.wrong();
    this.at += 1;
    if (text === 'm') return (m) => m;
    if (kConstants.has(text)) return () => kConstants.get(text);
    const call = kFunctions.get(text);
    if (call === undefined) throw new CommandError(`NameError: name '${text}' is not defined`);
    this.expect('(');
    const given = this.list(')');
    return (m) => call(given.map((one) => one(m)));
  }
}

const kWords: ReadonlySet<string> = new Set(['and', 'or', 'not', 'in', 'is', 'if', 'else', 'for', 'lambda']);
const kConstants: ReadonlyMap<string, unknown> = new Map<string, unknown>([['True', true], ['False', false], ['None', null]]);

const kFunctions: ReadonlyMap<string, (given: readonly unknown[]) => unknown> = new Map<string, (given: readonly unknown[]) => unknown>([
  ['abs', ([value]) => Math.abs(number(value))],
  ['all', ([list]) => items(list).every(truth)],
  ['any', ([list]) => items(list).some(truth)],
  ['bool', ([value]) => truth(value)],
  ['float', ([value]) => Number(typeof value === 'string' ? value : number(value))],
  ['int', ([value]) => Math.trunc(Number(typeof value === 'string' ? value : number(value)))],
  ['len', ([value]) => (typeof value === 'string' ? [...value].length : items(value).length)],
  ['max', (given) => Math.max(...(given.length === 1 ? items(given[0]) : given).map(number))],
  ['min', (given) => Math.min(...(given.length === 1 ? items(given[0]) : given).map(number))],
  ['round', ([value, digits]) => Number(number(value).toFixed(digits === undefined ? 0 : number(digits)))],
  ['str', ([value]) => (typeof value === 'boolean' ? (value ? 'True' : 'False') : String(value))],
  ['sum', ([list]) => items(list).reduce<number>((sum, one) => sum + number(one), 0)],
]);

const kMethods: ReadonlyMap<string, (text: string, given: readonly unknown[]) => unknown> = new Map<string, (text: string, given: readonly unknown[]) => unknown>([
  ['endswith', (text, [end]) => text.endsWith(String(end))],
  ['lower', (text) => text.toLowerCase()],
  ['startswith', (text, [begin]) => text.startsWith(String(begin))],
  ['strip', (text) => text.trim()],
  ['upper', (text) => text.toUpperCase()],
]);

function method(value: unknown, name: string, given: readonly unknown[]): unknown {
  const call = typeof value === 'string' ? kMethods.get(name) : undefined;
  if (call === undefined || typeof value !== 'string') throw new CommandError(`AttributeError: ${kindOf(value)} has no method '${name}' here`);
  return call(value, given);
}

function field(value: unknown, name: string): unknown {
  if (isMessage(value) && Object.hasOwn(value, name)) return value[name];
  throw new CommandError(`AttributeError: ${kindOf(value)} has no attribute '${name}'`);
}

function item(value: unknown, index: unknown): unknown {
  const list: ArrayLike<unknown> = typeof value === 'string' ? [...value] : items(value);
  const at = number(index);
  const found = at < 0 ? list.length + at : at;
  if (!Number.isInteger(found) || found < 0 || found >= list.length) throw new CommandError('IndexError: list index out of range');
  return list[found];
}

function kindOf(value: unknown): string {
  return isMessage(value) ? 'the message' : isList(value) ? 'a list' : value === null ? 'None' : `a ${typeof value === 'string' ? 'str' : typeof value === 'boolean' ? 'bool' : 'number'}`;
}

function items(value: unknown): readonly unknown[] {
  if (isList(value)) return Array.from(value);
  throw new CommandError(`TypeError: ${kindOf(value)} is no list`);
}

/** Flags count as 0 and 1; numbers of 64 bits as near as a double comes. */
function number(value: unknown): number {
  if (typeof value === 'number') return value;
  if (typeof value === 'bigint' || typeof value === 'boolean') return Number(value);
  throw new CommandError(`TypeError: ${kindOf(value)} is no number`);
}

function truth(value: unknown): boolean {
  return isList(value) ? value.length > 0 : Boolean(value);
}

function same(left: unknown, right: unknown): boolean {
  if (isList(left) && isList(right)) return left.length === right.length && Array.from(left).every((one, index) => same(one, right[index]));
  if (typeof left === 'string' || typeof right === 'string' || left === null || right === null || isMessage(left) || isMessage(right) || isList(left) || isList(right))
    return left === right;
  // Loosely: 1, 1.0, True and a number of 64 bits are equal, as in Python.
  return typeof left === 'bigint' && typeof right === 'bigint' ? left === right : number(left) === number(right);
}

function compared(sign: string, left: unknown, right: unknown): boolean {
  switch (sign) {
    case '==':
    case 'is':
      return same(left, right);
    case '!=':
    case 'is not':
      return !same(left, right);
    case 'in':
    case 'not in': {
      const within = typeof right === 'string' ? right.includes(String(left)) : items(right).some((one) => same(one, left));
      return within === (sign === 'in');
    }
    default: {
      const [a, b] = typeof left === 'string' && typeof right === 'string' ? [left, right] : [number(left), number(right)];
      return sign === '<' ? a < b : sign === '>' ? a > b : sign === '<=' ? a <= b : a >= b;
    }
  }
}

function reckoned(sign: string, left: Evaluation, right: Evaluation): Evaluation {
  return (m) => {
    const [first, second] = [left(m), right(m)];
    if (sign === '+' && typeof first === 'string' && typeof second === 'string') return first + second;
    const [a, b] = [number(first), number(second)];
    if (b === 0 && (sign === '/' || sign === '//' || sign === '%')) throw new CommandError('ZeroDivisionError: division by zero');
    switch (sign) {
      case '+':
        return a + b;
      case '-':
        return a - b;
      case '*':
        return a * b;
      case '/':
        return a / b;
      case '//':
        return Math.floor(a / b);
      case '%':
        // The sign of the divisor, as in Python.
        return a - b * Math.floor(a / b);
      default:
        return a ** b;
    }
  };
}
