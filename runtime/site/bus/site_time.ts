// The page's hand on the time of a site: holds it, lets it run for a while, sets its speed.

import type { Broker } from './broker.ts';
import { realNanoseconds } from './clock.ts';
import type { SiteTime, TimeView, Unsubscribe } from '../contract/session.ts';

/** Speeds that the law of time can express. */
export const slowest = 0.001;
export const fastest = 1000;

export class SiteTimeControl implements SiteTime {
  private readonly broker: Broker;
  /** Called after each change, for those whom the broker does not reach. */
  private readonly changed: () => void;
  private readonly listeners = new Set<(view: TimeView) => void>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private rate = 1;
  /** Where time stands, or will at the end of a step; steady ns. */
  private limitNs = Infinity;

  constructor(broker: Broker, changed: () => void) {
    this.broker = broker;
    this.changed = changed;
  }

  view(): TimeView {
    const { clock } = this.broker.link;
    const held = clock.steadyNs() >= this.limitNs;
    return {
      state: this.limitNs === Infinity ? 'running' : held ? 'paused' : 'stepping',
      rate: this.rate,
      now: clock.systemNs() / 1e6,
    };
  }

  pause(): void {
    // One reading: a limit before the site's time would let programs run on.
    const now = this.broker.link.clock.steadyNs();
    this.apply(now, now);
  }

  resume(): void {
    this.apply(Infinity);
  }

  /** Steps that are asked for while one is under way add up. */
  step(ns: number): void {
    if (!(ns > 0) || !Number.isFinite(ns)) throw new RangeError(`not a step: ${ns}`);
    const now = this.broker.link.clock.steadyNs();
    this.apply((this.limitNs === Infinity ? now : Math.max(now, this.limitNs)) + ns);
  }

  setRate(rate: number): void {
    if (!(rate >= slowest && rate <= fastest)) throw new RangeError(`time runs at ${slowest} to ${fastest} times its speed`);
    this.rate = rate;
    this.apply(this.limitNs);
  }

  onChange(listener: (view: TimeView) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  close(): void {
    clearTimeout(this.timer);
    this.listeners.clear();
  }

  private apply(limitNs: number, now = this.broker.link.clock.steadyNs()): void {
    const { broker, rate } = this;
    this.limitNs = Math.round(limitNs);
    const siteNs = Math.round(now);
    broker.setTime({ realNs: Math.round(realNanoseconds()), siteNs, rate, limitNs: this.limitNs });
    this.changed();
    clearTimeout(this.timer);
    this.tell();
  }

  /** Tells when a step is over, which it may be by now. */
  private watchStep(): void {
    const left = this.broker.link.clock.realMsUntil(this.limitNs);
    this.timer = setTimeout(() => {
      if (this.view().state === 'stepping') this.watchStep();
      else this.tell();
    }, Math.min(left, 2 ** 31 - 1));
    if (typeof this.timer === 'object') this.timer.unref();
  }

  private tell(): void {
    const { limitNs } = this;
    const view = this.view();
    for (const listener of [...this.listeners]) listener(view);
    // A listener may have decided otherwise.
    if (view.state === 'stepping' && this.limitNs === limitNs) this.watchStep();
  }
}
