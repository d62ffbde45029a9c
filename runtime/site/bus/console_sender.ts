// Sends console lines from a worker to the page: at once while the page keeps up, in batches when it does not, and
// the newest only when a program prints without end.

import { BusParticipant } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { SiteClock } from './clock.ts';
import type { ConsoleCredit, Link } from './link.ts';

/** Stream (1 or 2), ms since 1970 in site time, text. */
export type SentLine = readonly [stream: 1 | 2, time: number, text: string];

const batchesAhead = 8;
/** Upper bound of the lines in one batch. */
export const mostLines = 10_000;

export class LocalCredit implements ConsoleCredit {
  private count = 0;

  posted(): void {
    this.count += 1;
  }

  /** The page has dealt with a batch. */
  seen(): void {
    this.count -= 1;
  }

  ahead(): number {
    return this.count;
  }
}

/** Counts on the bus, where the page adds what it has seen: a blocked worker gets no message, and the browser would keep each for ever. */
export class SharedCredit implements ConsoleCredit {
  private readonly bus: Bus;
  private readonly word: number;

  constructor(bus: Bus, participantWord: number) {
    this.bus = bus;
    this.word = participantWord;
  }

  posted(): void {
    this.bus.add(this.word + BusParticipant.consolePosted, 1);
  }

  ahead(): number {
    const { bus } = this;
    const posted = bus.load(this.word + BusParticipant.consolePosted);
    return (posted - bus.load(this.word + BusParticipant.consoleSeen)) | 0;
  }
}

export class ConsoleSender {
  private readonly credit: ConsoleCredit;
  private readonly clock: SiteClock;
  private readonly post: (lines: readonly SentLine[], dropped: number) => void;
  private waiting: SentLine[] = [];
  private dropped = 0;

  constructor(link: Link, post: (lines: readonly SentLine[], dropped: number) => void) {
    this.credit = link.consoleCredit;
    this.clock = link.clock;
    this.post = post;
  }

  line(stream: 'stdout' | 'stderr', text: string): void {
    if (this.waiting.length >= mostLines) {
      this.waiting.shift();
      this.dropped += 1;
    }
    this.waiting.push([stream === 'stdout' ? 1 : 2, Math.floor(this.clock.systemNs() / 1e6), text]);
    if (this.credit.ahead() < batchesAhead) this.flush();
  }

  /** Sends what waits, whatever the credit: called before the program waits, and at its end. */
  flush(): void {
    if (this.waiting.length === 0) return;
    this.credit.posted();
    this.post(this.waiting, this.dropped);
    this.waiting = [];
    this.dropped = 0;
  }
}
