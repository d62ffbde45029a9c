// Stepped runs, in the page: one participant runs at a time, in an order that depends on the site alone. When all
// rest, time jumps to the earliest one that anybody waits for. So the same site does the same in every run.

import { BusParticipant } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import { turn } from './event_wait.ts';
import type { Rest } from './turns.ts';

/** Steady time at which every stepped run begins: 1,700,000,001 s after 1970. */
const beginNs = 1e9;

interface Alarm {
  readonly atNs: number;
  readonly ring: () => void;
}

export class Conductor {
  private readonly bus: Bus;
  /** By participant, in the order of their places; undefined: is starting or has its turn. */
  private readonly resting = new Map<number, Rest | undefined>();
  private readonly alarms = new Set<Alarm>();
  private last = -1;
  private nowNs = beginNs;
  private endNs = Infinity;
  private ended: () => void = () => undefined;
  /** The number of hold() calls that block all turns, and of think() calls that the page has not finished. */
  private held = 0;
  private thinkers = 0;
  private thinking = false;

  constructor(bus: Bus) {
    this.bus = bus;
    this.setTime();
  }

  /** Nobody gets a turn after `ns` of site time since the begin; when all turns before are over, `then` is called:
   * at once when nobody is there. */
  runUntil(ns: number, then: () => void): void {
    this.endNs = beginNs + ns;
    this.ended = then;
    this.conduct();
  }

  /** A participant that is about to start: all others rest until it has reached its first rest. */
  expect(participant: number): void {
    this.resting.set(participant, undefined);
  }

  rests(participant: number, rest: Rest): void {
    this.resting.set(participant, rest);
    this.conduct();
  }

  /** Calls `ring` when `ns` of site time have passed and everybody rests; the result takes it back. */
  after(ns: number, ring: () => void): () => void {
    const alarm = { atNs: this.nowNs + ns, ring };
    this.alarms.add(alarm);
    return () => void this.alarms.delete(alarm);
  }

  /** The participant has ended. */
  leaves(participant: number): void {
    if (this.resting.delete(participant)) this.conduct();
  }

  /** Nobody gets a turn, and time stands, until the result is called, once. */
  hold(): () => void {
    this.held += 1;
    return () => {
      this.held -= 1;
      this.conduct();
    };
  }

  /** Until the result is called, once: what the page makes of an event in promises is made before anything else happens. */
  think(): () => void {
    this.thinkers += 1;
    return () => {
      this.thinkers -= 1;
      this.conduct();
    };
  }

  /** Gives the next turn when nobody has one. To be called after everything that comes from outside of the site. */
  conduct(): void {
    if (this.thinkers === 0) {
      this.goOn();
      return;
    }
    if (this.thinking) return;
    this.thinking = true;
    void turn().then(() => {
      this.thinking = false;
      this.goOn();
    });
  }

  private goOn(): void {
    while (this.held === 0 && ![...this.resting.values()].includes(undefined)) {
      const next = this.nextReady();
      if (next !== undefined) {
        this.last = next;
        this.resting.set(next, undefined);
        const word = this.bus.participantWord(next) + BusParticipant.turn;
        this.bus.add(word, 1);
        Atomics.notify(this.bus.i32, word);
        return;
      }
      const earliest = this.earliest();
      const until = Math.min(earliest, this.endNs);
      if (until === Infinity) return;
      this.nowNs = until;
      this.setTime();
      if (earliest > this.endNs) {
        this.ended();
        return;
      }
      for (const alarm of [...this.alarms]) {
        if (alarm.atNs <= this.nowNs && this.alarms.delete(alarm)) alarm.ring();
      }
      if (this.thinkers > 0) {
        this.conduct();
        return;
      }
    }
  }

  /** In turn, beginning behind the one that was last. */
  private nextReady(): number | undefined {
    const places = [...this.resting.keys()].sort((a, b) => a - b);
    const order = [...places.filter((place) => place > this.last), ...places.filter((place) => place <= this.last)];
    return order.find((place) => this.ready(place));
  }

  /** The earliest time that a participant or an alarm waits for; Infinity: all wait for events only, or nobody is there. */
  private earliest(): number {
    const rests = [...this.resting.values()].map((rest) => rest?.untilNs ?? Infinity);
    return Math.min(...rests, ...[...this.alarms].map(({ atNs }) => atNs));
  }

  private ready(participant: number): boolean {
    const rest = this.resting.get(participant);
    if (rest === undefined) return false;
    const word = this.bus.participantWord(participant);
    const { bus } = this;
    return rest.untilNs <= this.nowNs
      || bus.load(word + BusParticipant.stop) !== rest.stops
      || (rest.token !== undefined && bus.load(word + BusParticipant.wake) !== rest.token);
  }

  private setTime(): void {
    this.bus.setTime({ realNs: 0, siteNs: this.nowNs, rate: 1, limitNs: this.nowNs });
  }
}
