// Message values as YAML, letter for letter as `ros2 topic echo` prints them (PyYAML's block style with
// the default limit of 128 items and characters). Pure.

import { isFloat } from './shape.ts';
import type { Field, Shape } from './shape.ts';

/** inFlow() of flow_yaml.ts, which is loaded when somebody wants it. */
export type InFlow = (value: unknown, field: Field | undefined, truncate: number | null) => string;

/** Arrays and strings longer than this are cut, as `ros2 topic echo` does without --full-length. */
export const TRUNCATE_LENGTH = 128;

/** True for every kind of array that the decoder returns. */
export function isList(value: unknown): value is ArrayLike<unknown> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

/** True for a message inside a message. */
export function isMessage(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null && !isList(value);
}

/** How much is shown, and how. */
interface Style {
  /** Longer arrays and texts are cut; null: none is. */
  readonly truncate: number | null;
  /** Writes an array in one line, as with --flow-style; undefined: below each other. */
  readonly flow: InFlow | undefined;
}

/** One document: every line ends with a newline. */
export function toYaml(
  value: unknown,
  shape: Shape | null,
  truncate: number | null = TRUNCATE_LENGTH,
  flow?: InFlow,
): string {
  if (!isMessage(value)) return `${formatScalar(value, truncate, '')}\n`;
  if (Object.keys(value).length === 0) return '{}\n';
  const lines: string[] = [];
  writeMessage(value, shape, '', '', { truncate, flow }, lines);
  return `${lines.join('\n')}\n`;
}

/** A number, boolean or text as a YAML scalar. `indent` is where continued lines of a text begin. */
export function formatScalar(
  value: unknown,
  truncate: number | null,
  indent: string,
  float = false,
): string {
  switch (typeof value) {
    case 'string': {
      const cut = truncate !== null && value.length > truncate ? `${value.slice(0, truncate)}...` : value;
      return formatText(cut, indent);
    }
    case 'number':
      return float || !Number.isInteger(value) ? formatFloat(value) : String(value);
    case 'bigint':
    case 'boolean':
      return String(value);
    default:
      return value === null || value === undefined ? 'null' : formatText(String(value), indent);
  }
}

/** Python's repr of a float in YAML's dress: 1.0, 0.1, 1.0e-05, .inf, .nan */
export function formatFloat(value: number): string {
  if (Number.isNaN(value)) return '.nan';
  if (value === Infinity) return '.inf';
  if (value === -Infinity) return '-.inf';
  if (Object.is(value, -0)) return '-0.0';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e16)) {
    const [mantissa, exponent] = value.toExponential().split('e') as [string, string];
    const sign = exponent.startsWith('-') ? '-' : '+';
    const digits = exponent.replace(/^[-+]/, '').padStart(2, '0');
    return `${mantissa.includes('.') ? mantissa : `${mantissa}.0`}e${sign}${digits}`;
  }
  const text = String(value);
  return text.includes('.') ? text : `${text}.0`;
}

/** The field called `name`; names are unique within a message. */
export function fieldOf(shape: Shape | null, name: string): Field | undefined {
  return shape?.find((field) => field.name === name);
}

function writeMessage(
  message: Readonly<Record<string, unknown>>,
  shape: Shape | null,
  first: string,
  indent: string,
  style: Style,
  lines: string[],
): void {
  let start = first;
  for (const [key, value] of Object.entries(message)) {
    const field = fieldOf(shape, key);
    const head = `${start}${key}:`;
    start = indent;
    if (isList(value)) {
      writeList(head, value, field, indent, style, lines);
    } else if (!isMessage(value)) {
      lines.push(`${head} ${formatScalar(value, style.truncate, `${indent}  `, isFloat(field))}`);
    } else if (Object.keys(value).length === 0) {
      lines.push(`${head} {}`);
    } else {
      lines.push(head);
      writeMessage(value, field?.shape ?? null, `${indent}  `, `${indent}  `, style, lines);
    }
  }
}

function writeList(
  head: string,
  list: ArrayLike<unknown>,
  field: Field | undefined,
  indent: string,
  style: Style,
  lines: string[],
): void {
  if (list.length === 0) {
    lines.push(`${head} []`);
    return;
  }
  const { truncate, flow } = style;
  if (flow !== undefined) {
    lines.push(`${head} ${flow(list, field, truncate)}`);
    return;
  }
  lines.push(head);
  const count = truncate === null ? list.length : Math.min(list.length, truncate);
  for (let i = 0; i < count; i += 1) {
    const item = list[i];
    if (isMessage(item) && Object.keys(item).length > 0) {
      writeMessage(item, field?.shape ?? null, `${indent}- `, `${indent}  `, style, lines);
    } else {
      lines.push(
        `${indent}- ${isMessage(item) ? '{}' : formatScalar(item, style.truncate, `${indent}  `, isFloat(field))}`,
      );
    }
  }
  if (count < list.length) {
    lines.push(`${indent}- '...'`);
  }
}

// --- Text, by the rules of PyYAML's emitter -----------------------------------------------------------

const BREAK = '\n\u0085\u2028\u2029';
const RESOLVES_TO_OTHER = [
  /^(?:yes|Yes|YES|no|No|NO|true|True|TRUE|false|False|FALSE|on|On|ON|off|Off|OFF)$/,
  /^(?:[-+]?[0-9][0-9_]*\.[0-9_]*(?:[eE][-+][0-9]+)?|\.[0-9][0-9_]*(?:[eE][-+][0-9]+)?|[-+]?[0-9][0-9_]*(?::[0-5]?[0-9])+\.[0-9_]*|[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN))$/,
  /^(?:[-+]?0b[0-1_]+|[-+]?0[0-7_]+|[-+]?(?:0|[1-9][0-9_]*)|[-+]?0x[0-9a-fA-F_]+|[-+]?[1-9][0-9_]*(?::[0-5]?[0-9])+)$/,
  /^(?:<<|=|~|null|Null|NULL)?$/,
  /^(?:\d{4}-\d\d-\d\d|\d{4}-\d\d?-\d\d?(?:[Tt]|[ \t]+)\d\d?:\d\d:\d\d(?:\.\d*)?(?:[ \t]*(?:Z|[-+]\d\d?(?::\d\d)?))?)$/,
];

interface Analysis {
  readonly plain: boolean;
  readonly singleQuoted: boolean;
}

export function formatText(text: string, indent: string): string {
  const { plain, singleQuoted } = analyse(text);
  if (plain && !RESOLVES_TO_OTHER.some((pattern) => pattern.test(text))) return text;
  return singleQuoted ? singleQuote(text, indent) : doubleQuote(text);
}

function analyse(text: string): Analysis {
  if (text === '') return { plain: false, singleQuoted: true };
  let indicators = /^(?:---|\.\.\.)/.test(text);
  let special = false;
  let breaks = false;
  let breakThenSpace = false;
  let spaceThenBreak = false;
  let afterSpace = false;
  let afterBreak = false;
  const characters = Array.from(text);
  const isWhite = (c: string | undefined): boolean => c === undefined || '\0 \t\r'.includes(c) || BREAK.includes(c);
  characters.forEach((c, index) => {
    const whiteAfter = isWhite(characters[index + 1]);
    const whiteBefore = index === 0 || isWhite(characters[index - 1]);
    if (index === 0) {
      if ('#,[]{}&*!|>\'"%@`'.includes(c) || ('?:-'.includes(c) && whiteAfter)) indicators = true;
    } else if ((c === ':' && whiteAfter) || (c === '#' && whiteBefore)) {
      indicators = true;
    }
    if (BREAK.includes(c)) breaks = true;
    if (!isPrintable(c)) special = true;
    if (c === ' ') {
      if (afterBreak) breakThenSpace = true;
      afterSpace = true;
      afterBreak = false;
    } else if (BREAK.includes(c)) {
      if (afterSpace) spaceThenBreak = true;
      afterBreak = true;
      afterSpace = false;
    } else {
      afterSpace = false;
      afterBreak = false;
    }
  });
  const edge = (c: string | undefined): boolean => c === ' ' || (c !== undefined && BREAK.includes(c));
  const never = breakThenSpace || spaceThenBreak || special;
  return {
    plain: !(indicators || breaks || edge(characters[0]) || edge(characters.at(-1)) || never),
    singleQuoted: !never,
  };
}

function isPrintable(c: string): boolean {
  const code = c.codePointAt(0) ?? 0;
  return (
    c === '\n'
    || (code >= 0x20 && code <= 0x7e)
    || code === 0x85
    || (code >= 0xa0 && code <= 0xd7ff)
    || (code >= 0xe000 && code <= 0xfffd && code !== 0xfeff)
    || (code >= 0x10000 && code < 0x10ffff)
  );
}

function singleQuote(text: string, indent: string): string {
  const escaped = text.replaceAll("'", "''");
  // A run of n newlines is written as n + 1: one is folded away by readers.
  return `'${escaped.replace(/[\n\u0085\u2028\u2029]+/g, (run) => `${run.startsWith('\n') ? '\n' : ''}${run}${indent}`)}'`;
}

const ESCAPES: Readonly<Record<string, string>> = {
  '\0': '0',
  '\u0007': 'a',
  '\b': 'b',
  '\t': 't',
  '\n': 'n',
  '\v': 'v',
  '\f': 'f',
  '\r': 'r',
  '\u001b': 'e',
  '"': '"',
  '\\': '\\',
  '\u0085': 'N',
  '\u00a0': '_',
  '\u2028': 'L',
  '\u2029': 'P',
};

function doubleQuote(text: string): string {
  let out = '';
  for (const c of text) {
    const code = c.codePointAt(0) ?? 0;
    const asIs = !'"\\\u0085\u2028\u2029\ufeff'.includes(c)
      && ((code >= 0x20 && code <= 0x7e)
        || (code >= 0xa0 && code <= 0xd7ff)
        || (code >= 0xe000 && code <= 0xfffd));
    const short = ESCAPES[c];
    if (asIs) out += c;
    else if (short !== undefined) out += `\\${short}`;
    else if (code <= 0xff) out += `\\x${hex(code, 2)}`;
    else out += code <= 0xffff ? `\\u${hex(code, 4)}` : `\\U${hex(code, 8)}`;
  }
  return `"${out}"`;
}

function hex(code: number, width: number): string {
  return code.toString(16).toUpperCase().padStart(width, '0');
}
