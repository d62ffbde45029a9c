// The expressions of grep: which lines it lets through. Pure.

import { shellTexts } from '../texts_shell.ts';

export interface GrepCall {
  readonly passes: (line: string) => boolean;
  readonly files: readonly string[];
  readonly numbers: boolean;
  readonly counts: boolean;
  readonly recursive: boolean;
  /** Without the names of files before the lines. */
  readonly bare: boolean;
}

/** A text says what is wrong. */
export function readGrep(rest: readonly string[]): GrepCall | string {
  const words = shellTexts.grep;
  const flags = new Set<string>();
  const patterns: string[] = [];
  const plain: string[] = [];
  for (const [i, word] of rest.entries()) {
    if (rest[i - 1] === '-e') patterns.push(word);
    else if (/^-[ivEFwencrRhH]+$/.test(word)) { for (const flag of word.slice(1)) flags.add(flag); }
    else if (word === '--line-buffered' || word.startsWith('--color')) continue;
    else if (word.startsWith('-') && word.length > 1) return words.flag(word);
    else plain.push(word);
  }
  const pattern = patterns[0] ?? plain.shift();
  if (pattern === undefined || patterns.length > 1) return words.usage;
  const source = flags.has('F') ? pattern.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&') : flags.has('E') ? pattern : fromBasic(pattern);
  try {
    const wanted = new RegExp(flags.has('w') ? `\\b(?:${source})\\b` : source, flags.has('i') ? 'i' : '');
    return {
      passes: (line) => wanted.test(line) !== flags.has('v'),
      files: plain,
      numbers: flags.has('n'),
      counts: flags.has('c'),
      recursive: flags.has('r') || flags.has('R'),
      bare: flags.has('h'),
    };
  } catch {
    return words.expression(pattern);
  }
}

/** In a basic expression + ? | ( ) { } are text, and special behind a backslash. */
function fromBasic(pattern: string): string {
  return pattern.replace(/\\(.)|[+?|(){}]/gs,
    (all, escaped: string | undefined) => escaped === undefined ? `\\${all}` : '+?|(){}'.includes(escaped) ? escaped : all);
}
