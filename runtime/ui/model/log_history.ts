// What nodes logged before somebody looked at /rosout, which holds the newest seconds only: read off their consoles. Pure.

import type { ConsoleLine } from '../../wasm_js/session.ts';
import { parseLogParts } from './log_line.ts';

export interface LogEntry {
  readonly node: string;
  readonly line: ConsoleLine;
  /** As a traceback names it, so that it leads there; empty where nobody said it. */
  readonly place: string;
}

/** Of each console. */
const kMostLines = 2000;

/** In the order of their times. */
export function loggedBefore(consoles: readonly (readonly ConsoleLine[])[]): readonly LogEntry[] {
  const found = consoles.flatMap((lines) =>
    lines.slice(-kMostLines).flatMap((line) => {
      const parts = line.level === undefined ? null : parseLogParts(line.text);
      return parts === null ? [] : [{ node: parts.logger.slice(1, -1), line, place: '' }];
    }),
  );
  return found.sort((a, b) => a.line.time - b.line.time);
}

/** Lines that are known already, by their first line: a console has the others as lines of their own. */
export class KnownLines {
  private readonly first = new Map<string, LogEntry>();

  constructor(entries: readonly LogEntry[]) {
    for (const entry of entries) this.first.set(entry.line.text, entry);
  }

  /** The entry that the message is, once; undefined: it is a new one. */
  take(message: LogEntry): LogEntry | undefined {
    const text = message.line.text.split('\n', 1)[0] ?? '';
    const known = this.first.get(text);
    this.first.delete(text);
    return known;
  }
}
