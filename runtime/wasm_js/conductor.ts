// Stepped runs, in the page: one participant runs at a time, in an order that depends on the site alone. When all
// rest, time jumps to the earliest one that anybody waits for. So the same site does the same in every run.

import { BusParticipant } from '../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { Rest } from './turns.ts';

/** Steady time at which every stepped run begins: 1,700,000,001 s after 1970. */
const beginNs = 1e9;

export class Conductor {
  private readonly bus: Bus;
  /** By participant, in the order of their places; undefined: is starting or has its turn. */
  private readonly resting = new Map<number, Rest | undefined>();
  private last = -1;
  private nowNs = beginNs;
  private endNs = Infinity;
  private ended: () => void = () => undefined;

  constructor(bus: Bus) {
    this.bus = bus;
    this.setTime();
  }

  /** Nobody gets a turn after `ns` of site time since the begin; when all turns before are over, `then` is called. */
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

  /** The participant has ended. */
  leaves(participant: number): void {
    if (this.resting.delete(participant)) this.conduct();
  }

  /** Gives the next turn when nobody has one. To be called after everything that comes from outside of the site. */
  conduct(): void {
    const places = [...this.resting.keys()].sort((a, b) => a - b);
    if (places.length === 0 || [...this.resting.values()].includes(undefined)) return;
    const order = [...places.filter((place) => place > this.last), ...places.filter((place) => place <= this.last)];
    let next = order.find((place) => this.ready(place));
    if (next === undefined) {
      const earliest = Math.min(...[...this.resting.values()].map((rest) => rest?.untilNs ?? Infinity));
      const end = earliest > this.endNs;
      const until = Math.min(earliest, this.endNs);
      if (until === Infinity) return;
      this.nowNs = until;
      this.setTime();
      if (end) {
        this.ended();
        return;
      }
      next = order.find((place) => this.ready(place));
    }
    if (next === undefined) return;
    this.last = next;
    this.resting.set(next, undefined);
    const word = this.bus.participantWord(next) + BusParticipant.turn;
    Atomics.add(this.bus.i32, word, 1);
    Atomics.notify(this.bus.i32, word);
  }

  private ready(participant: number): boolean {
    const rest = this.resting.get(participant);
    if (rest === undefined) return false;
    const word = this.bus.participantWord(participant);
    const { i32 } = this.bus;
    return rest.untilNs <= this.nowNs
      || Atomics.load(i32, word + BusParticipant.stop) !== rest.stops
      || (rest.token !== undefined && Atomics.load(i32, word + BusParticipant.wake) !== rest.token);
  }

  private setTime(): void {
    this.bus.setTime({ realNs: 0, siteNs: this.nowNs, rate: 1, limitNs: this.nowNs });
  }
}
