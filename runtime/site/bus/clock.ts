// Time as programs see it: site time, which the page can hold, step and scale. Kept in doubles, without BigInt on the
// way of a message.

import { BusHeader, BusTime, timeRateOne } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import { ordinaryTime, type TimeLaw } from './time_law.ts';

const high = 2 ** 32;

/** Writes ns (a whole number below 2^63) as two words. */
export function putNanoseconds(i32: Int32Array, word: number, ns: number): void {
  const upper = Math.floor(ns / high);
  // Not the rest of a division: that is a call of C's fmod(), for each message.
  i32[word] = ns - upper * high | 0;
  i32[word + 1] = upper;
}

// performance.now() counts from the worker's own start; a late zero (ms since 1970) keeps a double exact to 16 ns.
const steadyZero = 1.7e12;

/** Real time that all workers of a page share, monotonic, in ns. */
export function realNanoseconds(): number {
  return (performance.timeOrigin - steadyZero + performance.now()) * 1e6;
}

/** At a law that is being written: some hundredths of a second. */
const mostLooks = 1_000_000;

/** Site time in the hands of one thread: by the law on the bus, or by the one that was set last. */
export class SiteClock {
  private current: TimeLaw = ordinaryTime;
  private version = 0;
  private newest = 0;
  /** A version that nobody finishes. */
  private stuck: number | undefined;
  /** At hand: to ask the global object for them costs as much as to ask for the time. */
  private readonly timer = performance;
  private readonly origin = performance.timeOrigin - steadyZero;
  private readonly bus: Bus | undefined;
  /** The tables never move, so a view of the bus as it is now reaches them for ever. */
  private readonly i64: BigInt64Array | undefined;

  constructor(bus?: Bus) {
    this.bus = bus;
    this.i64 = bus?.i64;
  }

  set(law: TimeLaw): void {
    this.current = law;
  }

  law(): TimeLaw {
    this.keepUp();
    return this.current;
  }

  /** Changes with the law on the bus. */
  lawVersion(): number {
    this.keepUp();
    return this.version;
  }

  /** Never goes back, though the page may have held time a moment ago. */
  steadyNs(): number {
    this.keepUp();
    const { realNs, siteNs, rate, limitNs } = this.current;
    const now = Math.min(siteNs + ((this.origin + this.timer.now()) * 1e6 - realNs) * rate, limitNs);
    if (now > this.newest) this.newest = now;
    return this.newest;
  }

  /** Since 1970; resolves some hundred ns. */
  systemNs(): number {
    return this.steadyNs() + steadyZero * 1e6;
  }

  /** Real ms until the site's steady time is `ns`; Infinity while it does not get there. */
  realMsUntil(ns: number): number {
    const now = this.steadyNs();
    if (ns <= now) return 0;
    return ns > this.current.limitNs ? Infinity : (ns - now) / this.current.rate / 1e6;
  }

  private keepUp(): void {
    const { bus, i64 } = this;
    if (bus === undefined || i64 === undefined) return;
    const found = bus.load(BusHeader.siteTime + BusTime.version);
    if (found === this.version || found === this.stuck) return;
    for (let looks = 0; looks < mostLooks; looks += 1) {
      const version = bus.load(BusHeader.siteTime + BusTime.version);
      // Odd: the page is about to finish it.
      if ((version & 1) !== 0) continue;
      const rate = bus.load(BusHeader.siteTime + BusTime.rate) / timeRateOne;
      const realNs = Number(Atomics.load(i64, (BusHeader.siteTime + BusTime.real) >> 1));
      const siteNs = Number(Atomics.load(i64, (BusHeader.siteTime + BusTime.site) >> 1));
      const limit = Number(Atomics.load(i64, (BusHeader.siteTime + BusTime.limit) >> 1));
      if (bus.load(BusHeader.siteTime + BusTime.version) !== version) continue;
      this.current = { realNs, siteNs, rate, limitNs: limit < 0 ? Infinity : limit };
      this.version = version;
      return;
    }
    // No page takes so long: a program has written over it. The law that was there goes on until there is another one.
    this.stuck = bus.load(BusHeader.siteTime + BusTime.version);
  }
}
