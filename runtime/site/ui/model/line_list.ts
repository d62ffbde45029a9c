// The lines of one console view: bounded, filtered by text and level, with their places in rows.
// Holds no DOM; the view asks it which lines a window shows.

import type { ConsoleLine } from '../../contract/session.ts';
import { displayLine, LEVELS, mayWrap, rowsOf } from './log_line.ts';
import type { DisplayLine, Level } from './log_line.ts';
import { RowMap } from './row_map.ts';

export interface LineFilter {
  /** Shown when the line contains it; letter case does not matter. Empty: all lines. */
  readonly text: string;
  /** Shown when at least as severe. null: all lines, those without a level too. */
  readonly level: Level | null;
}

export const NO_FILTER: LineFilter = { text: '', level: null };

/** A window of lines to draw: `top` rows are above it. */
export interface LineWindow {
  readonly lines: readonly DisplayLine[];
  readonly first: number;
  readonly top: number;
}

export class LineList {
  private readonly capacity: number;
  protected all: DisplayLine[] = [];
  protected shown: DisplayLine[] = [];
  private readonly map = new RowMap();
  protected filter: LineFilter = NO_FILTER;
  private columns = 80;
  private nextKey = 0;
  protected fallen = 0;
  private added = 0;

  constructor(capacity: number) {
    this.capacity = capacity;
  }

  get shownCount(): number {
    return this.shown.length;
  }

  /** Lines that ever passed the filter: grows with every new one. */
  get addedCount(): number {
    return this.added;
  }

  get allCount(): number {
    return this.all.length;
  }

  get totalRows(): number {
    return this.map.totalRows;
  }

  /** Adds lines in the order given. */
  append(added: readonly ConsoleLine[], prefix: string): void {
    for (const line of added.length > this.capacity ? added.slice(-this.capacity) : added) {
      const shown = displayLine(line, this.nextKey, prefix);
      this.nextKey += 1;
      this.all.push(shown);
      if (passes(shown, this.filter)) {
        this.shown.push(shown);
        this.added += 1;
        this.map.push(rowsOf(shown, this.columns));
      }
    }
    // Dropping in steps keeps the cost of moving the array small.
    if (this.all.length > this.capacity + 1024) this.dropTo(this.capacity);
  }

  /** The rows that fell off the front since the last call: what a reader's place moves up by. Below zero: came there. */
  takeFallenRows(): number {
    const rows = this.fallen;
    this.fallen = 0;
    return rows;
  }

  setFilter(filter: LineFilter): void {
    this.filter = filter;
    this.shown = this.all.filter((line) => passes(line, filter));
    this.measure();
  }

  /** The width of the view in characters. Returns whether anything moved. */
  setColumns(columns: number): boolean {
    if (columns === this.columns || columns < 1) {
      return false;
    }
    this.columns = columns;
    this.measure();
    return true;
  }

  clear(): void {
    this.all = [];
    this.shown = [];
    this.fallen = 0;
    this.map.clear();
  }

  /** The lines that rows [fromRow, toRow) touch. */
  window(fromRow: number, toRow: number): LineWindow {
    if (this.shown.length === 0) {
      return { lines: [], first: 0, top: 0 };
    }
    const first = this.map.lineAt(Math.max(0, fromRow));
    const last = this.map.lineAt(Math.max(0, toRow));
    return { lines: this.shown.slice(first, last + 1), first, top: this.map.offsetOf(first) };
  }

  /** Whether the drawn height of a line should be looked at. */
  isUncertain(line: DisplayLine): boolean {
    return mayWrap(line, this.columns);
  }

  /** Takes the number of rows that were really drawn for a line; returns whether it differs from the estimate. */
  correct(index: number, rows: number): boolean {
    if (this.map.rowsAt(index) === rows) {
      return false;
    }
    this.map.set(index, rows);
    return true;
  }

  /** The lines that are shown, as text for the clipboard. */
  text(): string {
    return this.shown.map((line) => `${line.prefix}${line.plain}\n`).join('');
  }

  private dropTo(count: number): void {
    this.all = this.all.slice(this.all.length - count);
    const firstKey = this.all[0]?.key ?? this.nextKey;
    let dropped = this.shown.findIndex((line) => line.key >= firstKey);
    if (dropped < 0) dropped = this.shown.length;
    this.shown = this.shown.slice(dropped);
    this.fallen += this.map.dropFirst(dropped);
  }

  protected measure(): void {
    this.map.clear();
    for (const line of this.shown) {
      this.map.push(rowsOf(line, this.columns));
    }
  }
}

export function passes(line: DisplayLine, filter: LineFilter): boolean {
  if (filter.level !== null) {
    if (line.level === null || LEVELS.indexOf(line.level) < LEVELS.indexOf(filter.level)) {
      return false;
    }
  }
  return (
    filter.text === ''
    || (line.prefix + line.plain).toLowerCase().includes(filter.text.toLowerCase())
  );
}
