// Evaluates the argument of `--filter`: a Python expression over the message `m`. It supports a part of Python:
// fields, indices, numbers, texts, comparisons (also chained), arithmetic, `and`, `or`, `not`, `in`, `is`, `x if c else y`, some of
// the built-in functions and of the methods of texts. Pure; nothing but the message can be reached.

import { isMessage } from '../decode/yaml.ts';
import { CommandError } from './command.ts';
import { filterFunctions, filterMethods } from './filter_functions.ts';
import { compared, item, kindOf, numeric, reckon, truth } from './filter_values.ts';

type Evaluation = (message: unknown) => unknown;

const DEEPEST = 100;
const TOKEN =
  /\s*(?:(\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?)|("(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')|([A-Za-z_]\w*)|(\*\*|\/\/|<=|>=|==|!=|[-+*/%<>()[\],.]))/iy;

interface Token {
  readonly kind: 'number' | 'text' | 'name' | 'sign' | 'end';
  readonly text: string;
}

/** True for the messages that pass. Throws a CommandError for what is no such expression, as each call does for what cannot be reckoned. */
export function filterOf(text: string): (message: unknown) => boolean {
  const evaluation = new Parser(tokensOf(text)).whole();
  return (message) => {
    try {
      return truth(evaluation(message));
    } catch (error) {
      if (error instanceof CommandError) throw error;
      // Such as too little memory: the reader of a topic shows the error once, and ends.
      throw new CommandError(error instanceof Error ? `${error.name}: ${error.message}` : String(error));
    }
  };
}

function tokensOf(text: string): readonly Token[] {
  const tokens: Token[] = [];
  TOKEN.lastIndex = 0;
  const { length } = text.trimEnd();
  while (TOKEN.lastIndex < length) {
    const from = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
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

  /** Parses what is nested: parentheses, and what stands to the right of `else` and `**`. */
  private deeper(parse: () => Evaluation): Evaluation {
    this.depth += 1;
    if (this.depth > DEEPEST) throw new CommandError('SyntaxError: too many nested parentheses');
    const parsed = parse();
    this.depth -= 1;
    return parsed;
  }

  private choice(): Evaluation {
    return this.deeper(() => {
      const value = this.either();
      if (this.take('if') === undefined) return value;
      const condition = this.either();
      this.expect('else');
      const other = this.choice();
      return (m) => (truth(condition(m)) ? value(m) : other(m));
    });
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
    const rest: { readonly sign: string; readonly value: Evaluation; }[] = [];
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
    for (let sign = this.take('+', '-'); sign !== undefined; sign = this.take('+', '-')) left = between(sign, left, this.product());
    return left;
  }

  private product(): Evaluation {
    let left = this.signed();
    for (let sign = this.take('*', '/', '//', '%'); sign !== undefined; sign = this.take('*', '/', '//', '%')) left = between(sign, left, this.signed());
    return left;
  }

  private signed(): Evaluation {
    let minus = false;
    for (let sign = this.take('-', '+'); sign !== undefined; sign = this.take('-', '+')) minus = minus !== (sign === '-');
    const value = this.reached();
    const power = this.take('**') === undefined ? value : between('**', value, this.deeper(() => this.signed()));
    return minus ? (m) => -numeric(power(m)) : power;
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
      const value = literal(text);
      return () => value;
    }
    if (kind === 'text') {
      this.at += 1;
      const value = text.slice(1, -1).replace(ESCAPE, unescaped);
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
    if (kind !== 'name' || WORDS.has(text)) throw this.wrong();
    this.at += 1;
    if (text === 'm') return (m) => m;
    if (CONSTANTS.has(text)) return () => CONSTANTS.get(text);
    const call = filterFunctions.get(text);
    if (call === undefined) throw new CommandError(`NameError: name '${text}' is not defined`);
    this.expect('(');
    const given = this.list(')');
    return (m) => call(given.map((one) => one(m)));
  }
}

const WORDS: ReadonlySet<string> = new Set(['and', 'or', 'not', 'in', 'is', 'if', 'else', 'for', 'lambda']);
const CONSTANTS: ReadonlyMap<string, unknown> = new Map<string, unknown>([['True', true], ['False', false], ['None', null]]);

function method(value: unknown, name: string, given: readonly unknown[]): unknown {
  const call = typeof value === 'string' ? filterMethods.get(name) : undefined;
  if (call === undefined) throw new CommandError(`AttributeError: ${kindOf(value)} has no method '${name}' here`);
  return call([value, ...given]);
}

function field(value: unknown, name: string): unknown {
  if (isMessage(value) && Object.hasOwn(value, name)) return value[name];
  throw new CommandError(`AttributeError: ${kindOf(value)} has no attribute '${name}'`);
}

function between(sign: string, left: Evaluation, right: Evaluation): Evaluation {
  return (m) => reckon(sign, left(m), right(m));
}

const ESCAPE = /\\(\r?\n|x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|[0-7]{1,3}|[^])/g;
const LETTERS: Readonly<Record<string, string>> = {
  a: '\x07',
  b: '\b',
  f: '\f',
  n: '\n',
  r: '\r',
  t: '\t',
  v: '\v',
  '\\': '\\',
  "'": "'",
  '"': '"',
  '\n': '',
  '\r\n': '',
};

/** As Python reads them: an unknown one keeps its backslash. */
function unescaped(whole: string, escape: string): string {
  const kind = escape.charAt(0);
  const isNumber = 'xuU'.includes(kind) && escape.length > 1;
  if (!isNumber && 'xuU'.includes(kind)) throw new CommandError(`SyntaxError: truncated \\${kind} escape`);
  if (kind === 'N') throw new CommandError('SyntaxError: names of characters (\\N) are not known here');
  const code = isNumber ? Number.parseInt(escape.slice(1), 16) : /^[0-7]/.test(escape) ? Number.parseInt(escape, 8) : undefined;
  if (code === undefined) return LETTERS[escape] ?? whole;
  if (code > 0x10ffff) throw new CommandError('SyntaxError: illegal Unicode character');
  return String.fromCodePoint(code);
}

/** Whole numbers beyond 2^53 are exact, as those of messages are. */
function literal(text: string): number | bigint {
  if (/^0+[1-9]\d*$/.test(text)) throw new CommandError('SyntaxError: leading zeros in decimal integer literals are not permitted');
  const value = Number(text);
  return /^\d+$/.test(text) && !Number.isSafeInteger(value) ? BigInt(text) : value;
}
