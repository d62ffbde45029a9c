// Where each line of a long list stands, counted in rows: lines are appended at the end, dropped from
// the front, and may be one or more rows high. Sums are kept per block, so that neither 100,000 lines
// nor 2,000 new ones per second cost more than a few hundred additions.

interface Block {
  rows: number[];
  sum: number;
}

const BLOCK = 256;

export class RowMap {
  private blocks: Block[] = [];
  /** Lines already dropped from the first block. */
  private skipped = 0;
  private lines = 0;
  private total = 0;

  get length(): number {
    return this.lines;
  }

  get totalRows(): number {
    return this.total;
  }

  push(rows: number): void {
    let last = this.blocks.at(-1);
    if (last === undefined || last.rows.length === BLOCK) {
      last = { rows: [], sum: 0 };
      this.blocks.push(last);
    }
    last.rows.push(rows);
    last.sum += rows;
    this.lines += 1;
    this.total += rows;
  }

  /** Drops lines from the front; returns how many rows went with them. */
  dropFirst(count: number): number {
    const before = this.total;
    let left = Math.min(count, this.lines);
    while (left > 0) {
      const first = this.blocks[0];
      if (first === undefined) break;
      const inBlock = first.rows.length - this.skipped;
      if (left >= inBlock) {
        this.blocks.shift();
        this.skipped = 0;
        this.total -= first.sum;
        this.lines -= inBlock;
        left -= inBlock;
      } else {
        for (let i = 0; i < left; i += 1) {
          const rows = first.rows[this.skipped + i] ?? 0;
          first.rows[this.skipped + i] = 0;
          first.sum -= rows;
          this.total -= rows;
        }
        this.skipped += left;
        this.lines -= left;
        left = 0;
      }
    }
    return before - this.total;
  }

  clear(): void {
    this.blocks = [];
    this.skipped = 0;
    this.lines = 0;
    this.total = 0;
  }

  /** The rows above line `index`. */
  offsetOf(index: number): number {
    const place = Math.min(index, this.lines) + this.skipped;
    const blockIndex = Math.floor(place / BLOCK);
    let offset = 0;
    for (let i = 0; i < blockIndex; i += 1) {
      offset += this.blocks[i]?.sum ?? 0;
    }
    const block = this.blocks[blockIndex];
    for (let i = 0; i < place % BLOCK; i += 1) {
      offset += block?.rows[i] ?? 0;
    }
    return offset;
  }

  /** The line that shows row `row`; the last line when `row` is past the end. */
  lineAt(row: number): number {
    let offset = 0;
    for (let b = 0; b < this.blocks.length; b += 1) {
      const block = this.blocks[b];
      if (block === undefined) break;
      if (row < offset + block.sum) {
        for (let i = 0; i < block.rows.length; i += 1) {
          offset += block.rows[i] ?? 0;
          if (row < offset) {
            return b * BLOCK + i - this.skipped;
          }
        }
      }
      offset += block.sum;
    }
    return Math.max(0, this.lines - 1);
  }

  rowsAt(index: number): number {
    const place = index + this.skipped;
    return this.blocks[Math.floor(place / BLOCK)]?.rows[place % BLOCK] ?? 0;
  }

  /** Corrects a line that turned out higher or lower than reckoned. */
  set(index: number, rows: number): void {
    const place = index + this.skipped;
    const block = this.blocks[Math.floor(place / BLOCK)];
    if (block === undefined) return;
    const change = rows - (block.rows[place % BLOCK] ?? 0);
    block.rows[place % BLOCK] = rows;
    block.sum += change;
    this.total += change;
  }
}
