// Calls that come when a time of the site is reached: they wait while it is held, and come sooner when it runs faster.

import type { SiteClock } from './clock.ts';
import type { Conductor } from './conductor.ts';

/** A timer that is set for longer fires at once. */
const longestTimerMs = 2 ** 31 - 1;

interface Entry {
  readonly atNs: number;
  readonly ring: () => void;
}

export class SiteTimers {
  private readonly clock: SiteClock;
  private readonly conductor: Conductor | undefined;
  private readonly entries = new Set<Entry>();
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(clock: SiteClock, conductor: Conductor | undefined) {
    this.clock = clock;
    this.conductor = conductor;
  }

  /** Calls `ring` once, `ms` of the site's time from now; Infinity: never. The result takes it back. */
  after(ms: number, ring: () => void): () => void {
    if (ms === Infinity) return () => undefined;
    if (this.conductor !== undefined) {
      const takeBack = this.conductor.after(ms * 1e6, ring);
      // Everybody may rest: time goes on to it now.
      queueMicrotask(() => this.conductor?.conduct());
      return takeBack;
    }
    const entry = { atNs: this.clock.steadyNs() + ms * 1e6, ring };
    this.entries.add(entry);
    this.arm();
    return () => {
      if (this.entries.delete(entry)) this.arm();
    };
  }

  /** The law of time is another one. */
  timeChanged(): void {
    this.arm();
  }

  close(): void {
    this.entries.clear();
    clearTimeout(this.timer);
  }

  private arm(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    let next = Infinity;
    for (const { atNs } of this.entries) next = Math.min(next, atNs);
    if (next === Infinity) return;
    const left = this.clock.realMsUntil(next);
    if (left === Infinity) return;
    this.timer = setTimeout(() => this.look(), Math.min(left, longestTimerMs));
  }

  private look(): void {
    const now = this.clock.steadyNs();
    const due = [...this.entries].filter(({ atNs }) => atNs <= now).sort((a, b) => a.atNs - b.atNs);
    for (const entry of due) if (this.entries.delete(entry)) entry.ring();
    this.arm();
  }
}
