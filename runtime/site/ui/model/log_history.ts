// The data of the Log panel: lines that nodes logged before somebody looked at /rosout, which stores the newest seconds only,
// so they are read from the consoles piece by piece; and the messages of /rosout from then on. Stores the newest lines, appends
// cheaply. Pure.

import type { ConsoleLine } from '../../contract/session.ts';
import { parseLogParts } from './log_line.ts';

export interface LogEntry {
  readonly node: string;
  readonly line: ConsoleLine;
  /** As a traceback names it, so that it leads there; empty where nobody said it. */
  readonly place: string;
}

/**
 * The kind of a message of /rosout: a new line; one that a console had too, which it completes with its place or with
 * further lines; or one older than the lines read from the consoles until now, which comes with `older`.
 */
export type Taken = 'new' | 'placed' | 'longer' | 'held';

const firstLine = ({ line }: LogEntry): string => line.text.split('\n', 1)[0] ?? '';

export class LogHistory {
  private readonly capacity: number;
  private consoles: readonly (readonly ConsoleLine[])[];
  /** For each console, the number of lines that are not read yet. */
  private readonly left: number[];
  private kept: LogEntry[] = [];
  /** Entries are counted; those read of the consoles later have numbers below zero. */
  private first = 0;
  /** By its first line, as a console has the others as lines of their own: the number of its entry. */
  private readonly known = new Map<string, number>();
  private readonly held = new Map<string, LogEntry>();
  private reading = true;

  constructor(capacity: number, consoles: readonly (readonly ConsoleLine[])[]) {
    this.capacity = capacity;
    this.consoles = consoles;
    this.left = consoles.map(({ length }) => length);
  }

  /** In the order of their times; the newest ones. */
  get entries(): readonly LogEntry[] {
    return this.kept.length > this.capacity ? this.kept.slice(-this.capacity) : this.kept;
  }

  get count(): number {
    return Math.min(this.kept.length, this.capacity);
  }

  /** Have the consoles nothing older? */
  get done(): boolean {
    return !this.reading;
  }

  take(message: LogEntry): Taken {
    const text = firstLine(message);
    const number = this.known.get(text);
    if (number !== undefined) {
      this.known.delete(text);
      const same = this.kept[number - this.first];
      // Unless it has fallen off, or was cleared.
      if (same !== undefined) this.kept[number - this.first] = message;
      return same !== undefined && same.line.text !== message.line.text ? 'longer' : 'placed';
    }
    const oldest = this.kept[0];
    if (this.reading && oldest !== undefined && message.line.time < oldest.line.time) {
      this.held.set(text, message);
      return 'held';
    }
    this.kept.push(message);
    // Dropping in steps keeps the cost of moving the array small.
    if (this.kept.length > this.capacity * 1.25) this.dropTo(this.capacity);
    return 'new';
  }

  /** Reads on, so many lines of all consoles: what they logged, older than all before. */
  older(lines: number): readonly LogEntry[] {
    if (!this.reading) return [];
    let found: LogEntry[] = [];
    const read = new Set<LogEntry>();
    let count = 0;
    for (; count < lines; count += 1) {
      const at = this.newest();
      const line = at < 0 ? undefined : this.consoles[at]?.[(this.left[at] ?? 0) - 1];
      if (line === undefined) break;
      this.left[at]! -= 1;
      const parts = line.level === undefined ? null : parseLogParts(line.text);
      if (parts === null) continue;
      // As /rosout has told it already, if it has.
      const told = this.held.get(line.text);
      this.held.delete(line.text);
      const entry = told ?? { node: parts.logger.slice(1, -1), line, place: '' };
      if (told === undefined) read.add(entry);
      found.push(entry);
    }
    if (count < lines) this.reading = false;
    found.reverse();
    // Messages of /rosout that no console has.
    const oldest = found[0]?.line.time ?? Infinity;
    const due = [...this.held].filter(([, { line }]) => !this.reading || line.time >= oldest);
    for (const [text, entry] of due) {
      this.held.delete(text);
      found.push(entry);
    }
    if (due.length > 0) found.sort((a, b) => a.line.time - b.line.time);
    const room = this.capacity - this.kept.length;
    if (found.length >= room) {
      found = room > 0 ? found.slice(-room) : [];
      this.stop();
    }
    this.first -= found.length;
    found.forEach((entry, i) => {
      if (read.has(entry)) this.known.set(entry.line.text, this.first + i);
    });
    this.kept = found.concat(this.kept);
    if (!this.reading) this.stop();
    return found;
  }

  /** Nothing that was said until now is wanted any more. */
  clear(): void {
    this.first += this.kept.length;
    this.kept = [];
    this.stop();
  }

  /** The console whose last line of those left is the newest of all; of the same time, the last one. */
  private newest(): number {
    let found = -1;
    let time = -Infinity;
    this.consoles.forEach((lines, at) => {
      const last = lines[(this.left[at] ?? 0) - 1];
      if (last === undefined || last.time < time) return;
      found = at;
      ({ time } = last);
    });
    return found;
  }

  private stop(): void {
    this.reading = false;
    this.consoles = [];
    this.held.clear();
  }

  private dropTo(count: number): void {
    this.first += this.kept.length - count;
    this.kept = this.kept.slice(-count);
    for (const [text, number] of this.known) if (number < this.first) this.known.delete(text);
  }
}
