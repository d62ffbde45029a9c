// Which endpoints' statuses time alone may change, and when the next one is due.

import type { SiteClock } from './clock.ts';
import type { Timing } from './timing.ts';

export class Ticker {
  private timings: readonly Timing[] = [];
  private readonly clock: SiteClock;

  constructor(clock: SiteClock) {
    this.clock = clock;
  }

  follow(endpoints: Iterable<{ readonly timing: Timing; }>): void {
    this.timings = [...endpoints].map(({ timing }) => timing).filter((timing) => timing.ticks);
  }

  /** Nothing to look after. */
  get idle(): boolean {
    return this.timings.length === 0;
  }

  /** True when time has changed a status that somebody reads. */
  tick(): boolean {
    if (this.idle) return false;
    const now = this.clock.steadyNs();
    let changed = false;
    for (const timing of this.timings) if (timing.changed(now)) changed = true;
    return changed;
  }

  /** When time changes such a status, steady ns; Infinity when it will not. */
  due(): number {
    const now = this.clock.steadyNs();
    let next = Infinity;
    for (const timing of this.timings) next = Math.min(next, timing.nextChange(now));
    return next;
  }
}
