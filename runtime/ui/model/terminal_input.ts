// What the Tab key makes of a line in the terminal. Pure.

export interface Offered {
  readonly word: string;
  readonly start: number;
  readonly choices: readonly string[];
}

export type Completed =
  | { readonly kind: 'line'; readonly line: string }
  | { readonly kind: 'choices'; readonly choices: readonly string[] }
  | { readonly kind: 'nothing' };

const kTab = 8;

export function completeInput(line: string, { word, start, choices }: Offered): Completed {
  const [first] = choices;
  if (first === undefined) return { kind: 'nothing' };
  if (choices.length === 1) return { kind: 'line', line: `${line.slice(0, start)}${first} ` };
  let shared = first.length;
  for (const choice of choices) while (!choice.startsWith(first.slice(0, shared))) shared -= 1;
  if (shared > word.length) return { kind: 'line', line: line.slice(0, start) + first.slice(0, shared) };
  return { kind: 'choices', choices };
}

export interface Redirected {
  readonly words: readonly string[];
  /** Behind a `>` at the end: where the output goes. */
  readonly target?: string;
}

export function withoutTarget(words: readonly string[]): Redirected {
  const last = words.at(-1);
  if (last === undefined || words.length < 2) return { words };
  if (words.at(-2) === '>') return { words: words.slice(0, -2), target: last };
  return last.length > 1 && last.startsWith('>') ? { words: words.slice(0, -1), target: last.slice(1) } : { words };
}

/** Spaces up to the next eighth column, so that rows can be counted. */
export function expandTabs(text: string): string {
  if (!text.includes('\t')) return text;
  let out = '';
  for (const c of text) out += c === '\t' ? ' '.repeat(kTab - (out.length % kTab)) : c;
  return out;
}
