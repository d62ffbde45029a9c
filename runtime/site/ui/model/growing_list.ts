// A list of lines that also grows at its front: what was there before, read piece by piece.

import type { ConsoleLine } from '../../contract/session.ts';
import { LineList, passes } from './line_list.ts';
import { displayLine } from './log_line.ts';

export class GrowingList extends LineList {
  private firstKey = 0;

  /** Adds lines before all others, in the order given; a reader's place stays. */
  prepend(earlier: readonly ConsoleLine[]): void {
    this.firstKey -= earlier.length;
    const lines = earlier.map((line, i) => displayLine(line, this.firstKey + i, ''));
    this.all = lines.concat(this.all);
    this.shown = lines.filter((line) => passes(line, this.filter)).concat(this.shown);
    const rows = this.totalRows;
    this.measure();
    this.fallen -= this.totalRows - rows;
  }
}
