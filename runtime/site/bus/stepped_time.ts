// The page's hand on the time of a stepped run: it is held at first, and goes as far as the page lets it. How it gets
// there, in steps or in one go, changes nothing of what the nodes do.

import type { SharedBroker } from './broker.ts';
import type { Conductor } from './conductor.ts';
import type { SiteTime, TimeView, Unsubscribe } from '../contract/session.ts';
import { fastest, slowest } from './site_time.ts';

/** While time runs, it is let go so often, in real ms. */
const beatMs = 20;

export class SteppedTime implements SiteTime {
  private readonly broker: SharedBroker;
  private readonly conductor: Conductor;
  private readonly listeners = new Set<(view: TimeView) => void>();
  private beat: ReturnType<typeof setInterval> | undefined;
  private rate = 1;
  /** How far time may go, in ns since the begin, and whether it is there and everybody rests. */
  private limitNs = 0;
  private reached = false;

  constructor(broker: SharedBroker, conductor: Conductor) {
    this.broker = broker;
    this.conductor = conductor;
    this.go(0);
  }

  view(): TimeView {
    const state = this.beat !== undefined ? 'running' : this.reached ? 'paused' : 'stepping';
    return { state, rate: this.rate, now: this.broker.link.clock.systemNs() / 1e6 };
  }

  pause(): void {
    this.halt();
    this.tell();
  }

  resume(): void {
    if (this.beat !== undefined) return;
    let before = performance.now();
    this.beat = setInterval(() => {
      const now = performance.now();
      const passed = now - before;
      before = now;
      // Nodes that cannot keep up hold time back.
      if (this.reached) this.go(this.limitNs + Math.round(passed * this.rate * 1e6));
    }, beatMs);
    this.tell();
  }

  step(ns: number): void {
    if (!(ns > 0) || !Number.isFinite(ns)) throw new RangeError(`not a step: ${ns}`);
    this.halt();
    this.go(this.limitNs + Math.round(ns));
    this.tell();
  }

  setRate(rate: number): void {
    if (!(rate >= slowest && rate <= fastest)) throw new RangeError(`time runs at ${slowest} to ${fastest} times its speed`);
    this.rate = rate;
    this.tell();
  }

  onChange(listener: (view: TimeView) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  close(): void {
    this.halt();
    this.listeners.clear();
  }

  private halt(): void {
    clearInterval(this.beat);
    this.beat = undefined;
  }

  private go(limitNs: number): void {
    this.limitNs = limitNs;
    this.reached = false;
    this.conductor.runUntil(limitNs, () => {
      if (this.reached) return;
      this.reached = true;
      if (this.beat === undefined) this.tell();
    });
  }

  private tell(): void {
    const view = this.view();
    for (const listener of [...this.listeners]) listener(view);
  }
}
