// Stepped runs, as a program's worker sees them: a participant that waits gives up its turn, and continues when the page gives
// it the next one. Nobody else runs in between, and time stands still while anybody does.

import { BusParticipant } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';

/** The events that a participant rests for; the page gives it a turn when one of them occurs. */
export interface Rest {
  /** The site's steady time; Infinity: for an event only. */
  readonly untilNs: number;
  /** The number of the last event that it knows of; undefined: it sleeps, and no event wakes it. */
  readonly token: number | undefined;
  /** The number of stop requests that it knows of. */
  readonly stops: number;
}

export class Turns {
  private readonly bus: Bus;
  private readonly word: number;
  private readonly post: (rest: Rest) => void;

  constructor(bus: Bus, participant: number, post: (rest: Rest) => void) {
    this.bus = bus;
    this.word = bus.participantWord(participant);
    this.post = post;
  }

  /** Blocks until the page gives the next turn. */
  give(untilNs: number, token: number | undefined, stops: number): void {
    const { bus } = this;
    const turn = bus.load(this.word + BusParticipant.turn);
    this.post({ untilNs: Math.ceil(untilNs), token, stops });
    Atomics.wait(bus.i32, this.word + BusParticipant.turn, turn);
  }
}
