// How a thread on the shared bus waits and sleeps: in Atomics.wait, by the site's time; in a stepped run until its turn.

import { BusParticipant, WaitResult } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { SiteClock } from './clock.ts';
import type { SharedStatuses } from './shared_statuses.ts';
import { SpinPolicy, spinMs } from './spin_policy.ts';
import type { Turns } from './turns.ts';

/** In a stepped run, who only looks lets time go on by this: else nobody would get further. */
const lookNs = 1000;
const looksPerRound = 16;
const { pause } = Atomics as { pause?: () => void; };
const pauseProcessor = pause ?? ((): void => undefined);

export interface SharedWaitsOptions {
  readonly bus: Bus;
  readonly participant: number;
  readonly clock: SiteClock;
  readonly statuses: SharedStatuses;
  readonly turns: Turns | undefined;
  /** Brings the thread's view of the graph up to date. */
  readonly sync: () => void;
}

export class SharedWaits {
  private readonly bus: Bus;
  private readonly word: number;
  private readonly clock: SiteClock;
  private readonly statuses: SharedStatuses;
  private readonly turns: Turns | undefined;
  private readonly sync: () => void;
  private stopsTold = 0;
  private readonly policy = new SpinPolicy();

  constructor({ bus, participant, clock, statuses, turns, sync }: SharedWaitsOptions) {
    this.bus = bus;
    this.word = bus.participantWord(participant);
    this.clock = clock;
    this.statuses = statuses;
    this.turns = turns;
    this.sync = sync;
  }

  /** A stop is told once to each thread, also one that came before the wait. */
  private tellStop(): boolean {
    const stops = this.bus.load(this.word + BusParticipant.stop);
    if (stops === this.stopsTold) return false;
    this.stopsTold = stops;
    return true;
  }

  /** Looks for an event for a moment: falling asleep and being woken costs more than most answers take. */
  private spin(token: number, durationMs: number): boolean {
    const { bus } = this;
    const wake = this.word + BusParticipant.wake;
    const end = performance.now() + durationMs;
    do {
      for (let i = 0; i < looksPerRound; i += 1) {
        if (bus.load(wake) !== token) return true;
        pauseProcessor();
      }
    } while (performance.now() < end);
    return false;
  }

  /** Until an event after the token, a stop, or the time is over. */
  wait(token: number, timeoutMs: number): WaitResult {
    const { ticker } = this.statuses;
    const { clock, turns } = this;
    const polls = timeoutMs === 0 || timeoutMs === Infinity;
    if (polls && ticker.idle && turns === undefined) return this.blockOnce(token, timeoutMs);
    const end = this.endOf(timeoutMs);
    for (;;) {
      this.sync();
      if (this.statuses.tick()) return WaitResult.woken;
      const until = Math.min(end, ticker.due());
      const result = turns === undefined
        ? this.blockOnce(token, clock.realMsUntil(until))
        : this.rest(turns, token, until);
      if (result !== WaitResult.timeout || clock.steadyNs() >= end) return result;
    }
  }

  /** As wait(), but in real time, which does not affect others; so a stepped run does not wait here. */
  waitReally(token: number, timeoutMs: number): WaitResult {
    return this.turns === undefined ? this.blockOnce(token, timeoutMs) : WaitResult.timeout;
  }

  /** When a wait or sleep of this length is over, steady ns. */
  private endOf(durationMs: number): number {
    const least = this.turns === undefined ? 0 : lookNs;
    return this.clock.steadyNs() + Math.max(least, Math.round(durationMs * 1e6));
  }

  /** Others get their turn also when there is something to do already. */
  private rest(turns: Turns, token: number, untilNs: number): WaitResult {
    if (this.tellStop()) return WaitResult.stop;
    const came = (): boolean => this.bus.load(this.word + BusParticipant.wake) !== token;
    turns.give(came() ? 0 : untilNs, token, this.stopsTold);
    if (!came()) return WaitResult.timeout;
    return this.tellStop() ? WaitResult.stop : WaitResult.woken;
  }

  /** A stepped run: until all others that began with this one rest too. */
  awaitTurn(): void {
    this.turns?.give(0, undefined, this.stopsTold);
  }

  /** `timeoutMs` is real time. */
  private blockOnce(token: number, timeoutMs: number): WaitResult {
    const { bus, word } = this;
    if (this.tellStop()) return WaitResult.stop;
    const sleepers = word + BusParticipant.sleepers;
    let woken = bus.load(word + BusParticipant.wake) !== token;
    if (!woken && timeoutMs > 0) {
      const begin = performance.now();
      if (this.policy.spinsNow()) {
        woken = this.spin(token, Math.min(timeoutMs, spinMs));
        this.policy.spun(woken);
      }
      if (!woken) {
        bus.add(sleepers, 1);
        woken = Atomics.wait(bus.i32, word + BusParticipant.wake, token, timeoutMs) !== 'timed-out';
        bus.sub(sleepers, 1);
      }
      this.policy.waited(woken, performance.now() - begin);
    }
    if (!woken) return WaitResult.timeout;
    return this.tellStop() ? WaitResult.stop : WaitResult.woken;
  }

  sleep(durationMs: number): WaitResult {
    const { bus, word, clock, turns } = this;
    const end = this.endOf(durationMs);
    for (;;) {
      // Read before the stops and the time: what changes them changes it afterwards.
      const token = bus.load(word + BusParticipant.rouse);
      if (this.tellStop()) return WaitResult.stop;
      const left = clock.realMsUntil(end);
      if (left === 0) return WaitResult.woken;
      if (turns === undefined) Atomics.wait(bus.i32, word + BusParticipant.rouse, token, left);
      else turns.give(end, undefined, this.stopsTold);
    }
  }
}
