// The last error in what a Python node printed, as far as it concerns one file: the traceback's innermost line there, and
// the words of the exception. Pure.

import { tracebackPlace } from './traceback_line.ts';

export interface NodeTrouble {
  /** In the file, from 1. */
  readonly line: number;
  /** The exception as Python prints it: `NameError: name 'x' is not defined`. */
  readonly words: string;
}

/** The class of an exception, perhaps with its module, and what it says. */
const EXCEPTION = /^[A-Za-z_][\w.]*(?:: .*|$)/;
const MOST_WORDS = 300;

/** null: nothing that was printed leads to the file. `path`: of the file in the installation. */
export function nodeTrouble(lines: readonly string[], path: string): NodeTrouble | null {
  let line: number | null = null;
  let found: NodeTrouble | null = null;
  for (const text of lines) {
    if (text.startsWith('Traceback (most recent call last)')) {
      line = null;
      continue;
    }
    const place = tracebackPlace(text);
    if (place !== null) {
      if (place.path === path) line = place.line;
      continue;
    }
    // The lines of a traceback are indented; the first that is not ends it.
    if (line === null || /^\s/.test(text) || text === '') continue;
    if (EXCEPTION.test(text)) found = { line, words: text.slice(0, MOST_WORDS) };
    line = null;
  }
  return found;
}
