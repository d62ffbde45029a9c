// The rate of one topic, as `ros2 topic hz` reckons it: from when messages were published, over several periods, so
// that a slow topic reads steady and a fast one follows quickly. Pure.

interface Mark {
  readonly count: number;
  readonly bytes: number;
  /** ms: when the newest of `count` messages was published. */
  readonly time: number;
}

export interface Rate {
  readonly hz: number;
  readonly bytesPerSecond: number;
}

/** The window holds at least this much of time and of messages. */
const leastMs = 2000;
const leastMessages = 5;
/** A message may be late by this much before the rate goes down. */
const patienceMs = 500;
/** After so many periods of silence, and so long, the rate is 0. */
const silentPeriods = 5;
const silentMs = 3000;

export const noRate: Rate = { hz: 0, bytesPerSecond: 0 };

export class RateWindow {
  private marks: Mark[] = [];

  /** Records the totals so far and the time of the newest message. It may be called at any pace. */
  add(count: number, bytes: number, time: number): void {
    const last = this.marks.at(-1);
    if (last?.count === count) return;
    // Another type, and so another count; or a clock that was set back.
    if (last !== undefined && (count < last.count || time < last.time)) this.marks = [];
    if (count === 0) return;
    this.marks.push({ count, bytes, time });
    while (this.enoughFrom(1)) this.marks.shift();
  }

  rate(now: number): Rate {
    const first = this.marks[0];
    const last = this.marks.at(-1);
    if (first === undefined || last === undefined || last.time <= first.time) return noRate;
    const messages = last.count - first.count;
    const spanMs = last.time - first.time;
    const periodMs = spanMs / messages;
    const silence = now - last.time;
    if (silence > Math.max(silentPeriods * periodMs, silentMs)) return noRate;
    const hz = silence > periodMs + patienceMs ? Math.min(messages / spanMs, 1 / silence) * 1000 : messages / spanMs * 1000;
    return { hz, bytesPerSecond: (last.bytes - first.bytes) / messages * hz };
  }

  private enoughFrom(index: number): boolean {
    const first = this.marks[index];
    const last = this.marks.at(-1);
    return first !== undefined && last !== undefined
      && last.time - first.time >= leastMs && last.count - first.count >= leastMessages;
  }
}
