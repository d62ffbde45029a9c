// The changes of one value that is a text: what it was from when to when. Times are seconds. Pure.

import { APART } from './samples.ts';

export interface StateSpan {
  readonly from: number;
  readonly to: number;
  readonly text: string;
  /** 1 to 8: the same for the same text, as far as they reach. */
  readonly color: number;
}

const MOST_CHANGES = 5_000;
/** No more than this is drawn in one row. */
const MOST_SPANS = 400;
const COLORS = 8;

export class StateTrack {
  private changes: { readonly time: number; readonly text: string; }[] = [];
  private readonly colors = new Map<string, number>();
  private newest = Number.NEGATIVE_INFINITY;

  add(published: number, text: string): void {
    const isAnew = this.newest - published > APART;
    if (isAnew) this.changes = [];
    const time = isAnew ? published : Math.max(published, this.newest);
    this.newest = time;
    if (this.last === text && this.changes.length > 0) return;
    if (this.changes.length === MOST_CHANGES) this.changes.splice(0, MOST_CHANGES / 2);
    this.changes.push({ time, text });
    if (!this.colors.has(text)) {
      if (this.colors.size > 1000) this.colors.clear();
      this.colors.set(text, (this.colors.size % COLORS) + 1);
    }
  }

  /** The value now; empty before the first. */
  get last(): string {
    return this.changes.at(-1)?.text ?? '';
  }

  /** The newest ones that reach into that time. */
  spans(least: number, most: number): readonly StateSpan[] {
    const found: StateSpan[] = [];
    let to = most;
    for (let i = this.changes.length - 1; i >= 0 && to > least && found.length < MOST_SPANS; i -= 1) {
      const change = this.changes[i];
      if (change === undefined || change.time > most) continue;
      const from = Math.max(least, change.time);
      found.push({ from, to, text: change.text, color: this.colors.get(change.text) ?? 1 });
      to = change.time;
    }
    return found.reverse();
  }
}
