// Tools that work on lines, from files or behind `|`: cat, head, tail, wc, sort, uniq, grep. Pure.

import { shellTexts } from '../texts_shell.ts';
import { readGrep } from './grep.ts';

/** Takes the lines of one file, or of the pipe. */
export interface LineSink {
  readonly line: (text: string) => void;
  /** That was all. */
  readonly end: () => void;
}

export interface ToolPorts {
  readonly out: (line: string) => void;
  /** Nothing more is needed: what still comes through the pipe may end. */
  readonly stop: () => void;
}

export interface TextTool {
  readonly files: readonly string[];
  /** Folders stand for all files below them. */
  readonly recursive: boolean;
  /** `name`: of the file; undefined: the pipe. */
  readonly begin: (name: string | undefined, many: boolean) => LineSink;
  /** After all; gives the exit code. */
  readonly end: (many: boolean) => number;
}

type Maker = (rest: readonly string[], ports: ToolPorts) => TextTool | string;

const nothing = (): void => undefined;

/** Splits flags from names; `-n 5`, `-n5`, `-5` and `--lines=5` count lines. A text says what is wrong. */
function readWords(program: string, rest: readonly string[], flags: string): {
  readonly flags: ReadonlySet<string>;
  readonly files: readonly string[];
  readonly count: string;
} | string {
  const given = new Set<string>();
  const files: string[] = [];
  let count = '';
  for (let i = 0; i < rest.length; i += 1) {
    const word = rest[i]!;
    const counted = /^(?:-n|--lines=)(\+?\d+)$/.exec(word)?.[1] ?? /^-(\d+)$/.exec(word)?.[1];
    if (flags.includes('#') && counted !== undefined) count = counted;
    else if (flags.includes('#') && word === '-n') {
      const next = rest[i += 1] ?? '';
      if (!/^\+?\d+$/.test(next)) return shellTexts.badCount(program, next);
      count = next;
    } else if (/^-[A-Za-z]+$/.test(word)) {
      for (const flag of word.slice(1)) {
        if (flag === 'f' && program === 'tail') return shellTexts.noFollow;
        if (!flags.includes(flag)) return shellTexts.badOption(program, flag);
        given.add(flag);
      }
    } else if (word.startsWith('--')) return shellTexts.badOption(program, word);
    else if (word !== '-') files.push(word);
  }
  return { flags: given, files, count };
}

const heading = (name: string | undefined, many: boolean, first: boolean, out: (line: string) => void): void => {
  if (!many || name === undefined) return;
  if (!first) out('');
  out(`==> ${name} <==`);
};

const cat: Maker = (rest, { out }) => {
  const read = readWords('cat', rest, 'n');
  if (typeof read === 'string') return read;
  let number = 0;
  const show = (text: string): void => out(read.flags.has('n') ? `${String(number += 1).padStart(6)}\t${text}` : text);
  return { files: read.files, recursive: false, begin: () => ({ line: show, end: nothing }), end: () => 0 };
};

const USUAL_COUNT = '10';

const head: Maker = (rest, { out, stop }) => {
  const read = readWords('head', rest, '#q');
  if (typeof read === 'string') return read;
  const most = Number((read.count === '' ? USUAL_COUNT : read.count).replace('+', ''));
  let first = true;
  const begin = (name: string | undefined, many: boolean): LineSink => {
    heading(name, many, first, out);
    first = false;
    let count = 0;
    if (most === 0 && name === undefined) stop();
    return {
      line: (text) => {
        count += 1;
        if (count <= most) out(text);
        if (count === most && name === undefined) stop();
      },
      end: nothing,
    };
  };
  return { files: read.files, recursive: false, begin, end: () => 0 };
};

const tail: Maker = (rest, { out }) => {
  const read = readWords('tail', rest, '#q');
  if (typeof read === 'string') return read;
  const count = read.count === '' ? USUAL_COUNT : read.count;
  const from = count.startsWith('+') ? Number(count.slice(1)) : undefined;
  const most = Number(count);
  let first = true;
  const begin = (name: string | undefined, many: boolean): LineSink => {
    heading(name, many, first, out);
    first = false;
    let number = 0;
    let last: string[] = [];
    return {
      line: (text) => {
        number += 1;
        if (from !== undefined && number >= from) out(text);
        if (from !== undefined || most === 0) return;
        last.push(text);
        // Cut now and then, so that a long stream costs little.
        if (last.length >= 2 * most + 100) last = last.slice(-most);
      },
      end: () => {
        if (most > 0) last.slice(-most).forEach(out);
      },
    };
  };
  return { files: read.files, recursive: false, begin, end: () => 0 };
};

const wc: Maker = (rest, { out }) => {
  const read = readWords('wc', rest, 'lwcm');
  if (typeof read === 'string') return read;
  const shown = (['l', 'w', 'c'] as const).filter((kind) => read.flags.size === 0 || read.flags.has(kind) || (kind === 'c' && read.flags.has('m')));
  const sums = { l: 0, w: 0, c: 0 };
  const row = (numbers: typeof sums, name: string): void => {
    const columns = shown.map((kind) => String(numbers[kind]));
    const wide = shown.length > 1 ? columns.map((column) => column.padStart(7)).join(' ') : columns.join(' ');
    out(name === '' ? wide : `${wide} ${name}`);
  };
  const begin = (name: string | undefined): LineSink => {
    const own = { l: 0, w: 0, c: 0 };
    return {
      line: (text) => {
        own.l += 1;
        own.w += text.split(/\s+/).filter((word) => word !== '').length;
        own.c += new TextEncoder().encode(text).length + 1;
      },
      end: () => {
        row(own, name ?? '');
        for (const kind of ['l', 'w', 'c'] as const) sums[kind] += own[kind];
      },
    };
  };
  return {
    files: read.files,
    recursive: false,
    begin,
    end: (many) => {
      if (many) row(sums, 'total');
      return 0;
    },
  };
};

const sort: Maker = (rest, { out }) => {
  const read = readWords('sort', rest, 'rnu');
  if (typeof read === 'string') return read;
  const all: string[] = [];
  const number = (text: string): number => Number(/^\s*-?\d*\.?\d+/.exec(text)?.[0] ?? 0);
  return {
    files: read.files,
    recursive: false,
    begin: () => ({ line: (text) => void all.push(text), end: nothing }),
    end: () => {
      const byText = (a: string, b: string): number => (a < b ? -1 : a > b ? 1 : 0);
      all.sort((a, b) => (read.flags.has('n') ? number(a) - number(b) : 0) || byText(a, b));
      if (read.flags.has('r')) all.reverse();
      for (const text of read.flags.has('u') ? new Set(all) : all) out(text);
      return 0;
    },
  };
};

const uniq: Maker = (rest, { out }) => {
  const read = readWords('uniq', rest, 'c');
  if (typeof read === 'string') return read;
  let last: string | undefined;
  let count = 0;
  const tell = (): void => {
    if (last !== undefined) out(read.flags.has('c') ? `${String(count).padStart(7)} ${last}` : last);
  };
  const line = (text: string): void => {
    if (text === last) {
      count += 1;
      return;
    }
    tell();
    [last, count] = [text, 1];
  };
  return {
    files: read.files,
    recursive: false,
    begin: () => ({ line, end: nothing }),
    end: () => {
      tell();
      return 0;
    },
  };
};

const grep: Maker = (rest, { out }) => {
  const call = readGrep(rest);
  if (typeof call === 'string') return call;
  let met = 0;
  const begin = (name: string | undefined, many: boolean): LineSink => {
    const before = name !== undefined && (many || call.recursive) && !call.bare ? `${name}:` : '';
    let number = 0;
    let count = 0;
    return {
      line: (text) => {
        number += 1;
        if (!call.passes(text)) return;
        count += 1;
        met += 1;
        if (!call.counts) out(`${before}${call.numbers ? `${number}:` : ''}${text}`);
      },
      end: () => {
        if (call.counts) out(`${before}${count}`);
      },
    };
  };
  return { files: call.files, recursive: call.recursive, begin, end: () => (met > 0 ? 0 : 1) };
};

const TOOLS: ReadonlyMap<string, Maker> = new Map([
  ['cat', cat],
  ['head', head],
  ['tail', tail],
  ['wc', wc],
  ['sort', sort],
  ['uniq', uniq],
  ['grep', grep],
]);

export const textToolNames: readonly string[] = [...TOOLS.keys()];

/** undefined: the tool does not exist. A text: what is wrong with its arguments. */
export function textTool([program = '', ...rest]: readonly string[], ports: ToolPorts): TextTool | string | undefined {
  return TOOLS.get(program)?.(rest, ports);
}
