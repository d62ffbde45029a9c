// A line of the terminal as a shell reads it: commands with ; && || between them, each with filters behind | and a
// file behind >. Pure.

import { splitLine } from '../../ros2cli/parse.ts';

export interface ShellStep {
  /** When it runs: whatever became of the one before, when that one succeeded, or when it failed. */
  readonly when: 'always' | 'succeeded' | 'failed';
  readonly words: readonly string[];
  /** Behind `|`, each one's words. */
  readonly filters: readonly (readonly string[])[];
  /** Behind a `>` or `>>` at the end: where the output goes. */
  readonly target?: string;
  /** It goes behind what is there already. */
  readonly append?: true;
  /** An `&` at the end. */
  readonly background?: true;
}

const WHEN: Readonly<Record<string, ShellStep['when']>> = { ';': 'always', '&&': 'succeeded', '||': 'failed' };

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

type Redirected = Pick<ShellStep, 'words' | 'target' | 'append' | 'background'>;

/** Errors stand in the terminal as they do. */
const ERRORS_ELSEWHERE = /^2>(?:&1|\/dev\/null)$/;

function redirected(all: readonly string[]): Redirected {
  const words = all.filter((word) => !ERRORS_ELSEWHERE.test(word));
  const last = words.at(-1);
  if (last === undefined) return { words };
  if (last === '&') return { ...redirected(words.slice(0, -1)), background: true };
  if (words.length < 2) return { words };
  const sign = words.at(-2);
  if (sign === '>' || sign === '>>') return { words: words.slice(0, -2), target: last, ...(sign === '>>' ? { append: true } : {}) };
  const joined = /^(>>?)([^>].*)$/s.exec(last);
  return joined === null ? { words } : { words: words.slice(0, -1), target: joined[2] ?? '', ...(joined[1] === '>>' ? { append: true } : {}) };
}

/** undefined: a quote is left open. A word that is missing makes an empty step. `valueOf`: of a variable. */
export function shellSteps(line: string, valueOf?: (name: string) => string): readonly ShellStep[] | undefined {
  const steps: ShellStep[] = [];
  for (const [joint, text] of pieces(line)) {
    const split = splitLine(text, valueOf);
    if (split === undefined) return undefined;
    const { words, ...rest } = redirected(split);
    const before = steps.at(-1);
    if (joint === '|' && before !== undefined) steps[steps.length - 1] = { ...before, ...rest, filters: [...before.filters, words] };
    else steps.push({ when: WHEN[joint] ?? 'always', words, filters: [], ...rest });
  }
  // Nothing stands behind the last ; and in an empty line.
  return steps.filter(({ words, filters, when }) => words.length > 0 || filters.length > 0 || when !== 'always');
}
