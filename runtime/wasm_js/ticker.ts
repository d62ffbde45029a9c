// Which endpoints' statuses time alone may change, and when the next one is due.

import { steadyNanoseconds } from './clock.ts';
import type { Timing } from './timing.ts';

export class Ticker {
  private timings: readonly Timing[] = [];

  follow(endpoints: Iterable<{ readonly timing: Timing }>): void {
    this.timings = [...endpoints].map(({ timing }) => timing).filter((timing) => timing.ticks);
  }

  /** Nothing to look after. */
  get idle(): boolean {
    return this.timings.length === 0;
  }

  /** True when time has changed a status that somebody reads. */
  tick(): boolean {
    if (this.idle) return false;
    const now = steadyNanoseconds();
    let changed = false;
    for (const timing of this.timings) if (timing.changed(now)) changed = true;
    return changed;
  }

  /** ms until time changes such a status; Infinity when it will not. */
  due(): number {
    const now = steadyNanoseconds();
    let next = Infinity;
    for (const timing of this.timings) next = Math.min(next, timing.nextChange(now));
    return Math.max(0, (next - now) / 1e6);
  }
}
