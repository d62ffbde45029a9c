// A line of the terminal as a shell reads it: commands with ; && || between them, each with filters behind | and a
// file behind >. Pure.

import { splitLine } from '../../ros2cli/parse.ts';
import { panelTexts } from '../texts_panels.ts';

export interface ShellStep {
  /** When it runs: whatever became of the one before, when that one succeeded, or when it failed. */
  readonly when: 'always' | 'succeeded' | 'failed';
  readonly words: readonly string[];
  /** Behind `|`, each one's words. */
  readonly filters: readonly (readonly string[])[];
  /** Behind a `>` at the end: where the output goes. */
  readonly target?: string;
}

const kWhen: Readonly<Record<string, ShellStep['when']>> = { ';': 'always', '&&': 'succeeded', '||': 'failed' };

/** Pieces with what stands before each: `;` `&&` `||` `|`, outside of quotes. */
function pieces(line: string): readonly (readonly [joint: string, text: string])[] {
  const found: [string, string][] = [[';', '']];
  let quote = '';
  for (let i = 0; i < line.length; i += 1) {
    const c = line[i]!;
    const last = found.at(-1)!;
    const joint = quote !== '' ? undefined : /^(&&|\|\||;|\|)/.exec(line.slice(i, i + 2))?.[0];
    if (joint !== undefined) {
      found.push([joint, '']);
      i += joint.length - 1;
      continue;
    }
    if (c === '\\' && quote !== "'") {
      last[1] += c + (line[i + 1] ?? '');
      i += 1;
      continue;
    }
    if (quote === '' && (c === '"' || c === "'")) quote = c;
    else if (c === quote) quote = '';
    // The rest of the line is a remark.
    else if (c === '#' && quote === '' && (last[1] === '' || /\s$/.test(last[1]))) break;
    last[1] += c;
  }
  return found;
}

function withoutTarget(words: readonly string[]): { readonly words: readonly string[]; readonly target?: string } {
  const last = words.at(-1);
  if (last === undefined || words.length < 2) return { words };
  if (words.at(-2) === '>') return { words: words.slice(0, -2), target: last };
  return last.length > 1 && last.startsWith('>') ? { words: words.slice(0, -1), target: last.slice(1) } : { words };
}

/** undefined: a quote is left open. A word that is missing makes an empty step. */
export function shellSteps(line: string): readonly ShellStep[] | undefined {
  const steps: ShellStep[] = [];
  for (const [joint, text] of pieces(line)) {
    const split = splitLine(text);
    if (split === undefined) return undefined;
    const { words, target } = withoutTarget(split);
    const file = target === undefined ? {} : { target };
    const before = steps.at(-1);
    if (joint === '|' && before !== undefined) steps[steps.length - 1] = { ...before, ...file, filters: [...before.filters, words] };
    else steps.push({ when: kWhen[joint] ?? 'always', words, filters: [], ...file });
  }
  // Nothing stands behind the last ; and in an empty line.
  return steps.filter(({ words, filters, when }) => words.length > 0 || filters.length > 0 || when !== 'always');
}

/** Takes a line in: whether it goes on to the next one. */
export interface LineFilter {
  readonly passes: (line: string) => boolean;
}

/** What may stand behind `|`: grep. A text says what is wrong. */
export function lineFilter([program, ...rest]: readonly string[]): LineFilter | string {
  const words = panelTexts.terminal.grep;
  if (program !== 'grep') return program === undefined ? words.nothing : words.onlyGrep(program);
  const flags = new Set<string>();
  const patterns: string[] = [];
  for (const [i, word] of rest.entries()) {
    if (rest[i - 1] === '-e') patterns.push(word);
    else if (/^-[ivEFwe]+$/.test(word)) for (const flag of word.slice(1)) flags.add(flag);
    else if (word === '--line-buffered' || word.startsWith('--color')) continue;
    else if (word.startsWith('-') && word.length > 1) return words.flag(word);
    else if (patterns.length > 0) return words.file(word);
    else patterns.push(word);
  }
  const [pattern] = patterns;
  if (pattern === undefined || patterns.length > 1) return words.usage;
  const source = flags.has('F') ? pattern.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&') : flags.has('E') ? pattern : fromBasic(pattern);
  try {
    const wanted = new RegExp(flags.has('w') ? `\\b(?:${source})\\b` : source, flags.has('i') ? 'i' : '');
    return { passes: (line) => wanted.test(line) !== flags.has('v') };
  } catch {
    return words.expression(pattern);
  }
}

/** In a basic expression + ? | ( ) { } are text, and special behind a backslash. */
function fromBasic(pattern: string): string {
  return pattern.replace(/\\(.)|[+?|(){}]/gs, (all, escaped: string | undefined) =>
    escaped === undefined ? `\\${all}` : '+?|(){}'.includes(escaped) ? escaped : all);
}
