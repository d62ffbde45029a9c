// Completes a line in the terminal at the Tab key, and reads the lines that were typed before. Pure.

import { textsMember } from './json.ts';

export interface Offered {
  readonly word: string;
  readonly start: number;
  readonly choices: readonly string[];
}

export type Completed =
  | { readonly kind: 'line'; readonly line: string; }
  | { readonly kind: 'choices'; readonly choices: readonly string[]; }
  | { readonly kind: 'nothing'; };

const TAB = 8;
const LONGEST_LINE = 4096;

export function completeInput(line: string, { word, start, choices }: Offered): Completed {
  const [first] = choices;
  if (first === undefined) return { kind: 'nothing' };
  if (choices.length === 1) return { kind: 'line', line: `${line.slice(0, start)}${first}${first.endsWith('/') ? '' : ' '}` };
  let shared = first.length;
  for (const choice of choices) while (!choice.startsWith(first.slice(0, shared))) shared -= 1;
  if (shared > word.length) return { kind: 'line', line: line.slice(0, start) + first.slice(0, shared) };
  return { kind: 'choices', choices };
}

/** Spaces up to the next eighth column, so that rows can be counted. */
export function expandTabs(text: string): string {
  if (!text.includes('\t')) return text;
  let out = '';
  for (const c of text) out += c === '\t' ? ' '.repeat(TAB - (out.length % TAB)) : c;
  return out;
}

/** Reads the lines typed before from the browser's storage: the newest ones; invalid contents give no lines. */
export function readHistory(kept: string | null, most: number): string[] {
  if (kept === null) return [];
  try {
    return textsMember({ lines: JSON.parse(kept) as unknown }, 'lines', Number.MAX_SAFE_INTEGER)
      .slice(-most)
      .map((line) => line.slice(0, LONGEST_LINE).replace(/\p{Cc}/gu, ' '));
  } catch {
    return [];
  }
}
