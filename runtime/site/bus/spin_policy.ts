// Decides whether a thread looks for an event for a moment (spins) before it sleeps. Spinning wins only while the
// partner of an exchange runs on another core: on the same core it keeps the partner from running. The policy learns
// which of both holds from its own failures; it touches neither the clock nor shared memory.

/** A wait that was over sooner than this is part of an exchange, ms. Two slow wake-ups of a virtual machine fit in. */
export const briskMs = 0.5;
/** Longer than Chromium takes to wake a sleeper (55 us): else both sides of an exchange sleep just before each answer. */
export const spinMs = 0.12;
/** A thread that spins in vain tries again after this many waits at most, so that trials cost less than 1 us a wait. */
export const longestRest = 256;

export class SpinPolicy {
  /** The last wait was so short that the next may be worth a look. */
  private brisk = false;
  /** Waits to go through without spinning. */
  private rest = 0;
  /** How many waits the next failure adds to `rest`; doubles with each failure, halves with each success. */
  private penalty = 1;

  /** To be asked once before each wait: whether to spin now. */
  spinsNow(): boolean {
    if (!this.brisk) return false;
    if (this.rest === 0) return true;
    this.rest -= 1;
    return false;
  }

  /** The outcome of a spin. */
  spun(found: boolean): void {
    if (found) {
      this.penalty = Math.max(1, this.penalty >> 1);
      return;
    }
    this.rest = this.penalty;
    this.penalty = Math.min(longestRest, this.penalty * 2);
  }

  /** The whole wait is over; `woken`: by an event, and not by its end. */
  waited(woken: boolean, durationMs: number): void {
    this.brisk = woken && durationMs < briskMs;
  }
}
