// How a program on the port link waits and sleeps: it is suspended, and the event loop runs meanwhile.

import { WaitResult } from '../../protocol/generated/constants.ts';
import type { SiteClock } from './clock.ts';

/** A program that never waits long must still let messages in. */
const longestRunMs = 4;
/** A timer that is set for longer fires at once. */
const longestTimerMs = 2 ** 31 - 1;

export class PortWaits {
  /** Changes with every event. */
  token = 0;
  stops = 0;
  private stopsTold = 0;
  private lastYield = performance.now();
  private readonly clock: SiteClock;
  private readonly waiters = new Set<() => void>();
  private readonly sleepers = new Set<() => void>();
  /** Each one checks again when a suspension is over. */
  private readonly timed = new Set<() => void>();
  private turn: MessageChannel | undefined;
  private readonly turns: (() => void)[] = [];

  constructor(clock: SiteClock) {
    this.clock = clock;
  }

  wake(): void {
    this.token = (this.token + 1) | 0;
    release(this.waiters);
  }

  timeChanged(): void {
    release(this.timed);
  }

  stop(): void {
    this.stops += 1;
    release(this.sleepers);
    this.wake();
  }

  /** A negative timeout is none. */
  async wait(token: number, timeoutMs: number): Promise<WaitResult> {
    if (this.tellStop()) return WaitResult.stop;
    if (this.token !== token) {
      if (performance.now() - this.lastYield > longestRunMs) await this.yieldTurn();
    } else if (timeoutMs === 0) {
      await this.yieldTurn();
    } else {
      await this.suspend(this.waiters, timeoutMs);
    }
    if (this.token === token) return WaitResult.timeout;
    return this.tellStop() ? WaitResult.stop : WaitResult.woken;
  }

  async sleep(durationMs: number): Promise<WaitResult> {
    if (this.tellStop()) return WaitResult.stop;
    if (durationMs <= 0) await this.yieldTurn();
    else await this.suspend(this.sleepers, durationMs);
    return this.tellStop() ? WaitResult.stop : WaitResult.woken;
  }

  close(): void {
    this.turn?.port1.close();
    this.wake();
  }

  /** A stop is told once. */
  private tellStop(): boolean {
    if (this.stops === this.stopsTold) return false;
    this.stopsTold = this.stops;
    return true;
  }

  /** Until the time is over (negative: never) or somebody calls what stands in `ends` meanwhile. */
  private async suspend(ends: Set<() => void>, durationMs: number): Promise<void> {
    await new Promise<void>((resolve) => {
      const deadline = this.clock.steadyNs() + durationMs * 1e6;
      let timer: ReturnType<typeof setTimeout> | undefined;
      const end = (): void => {
        clearTimeout(timer);
        ends.delete(end);
        this.timed.delete(check);
        resolve();
      };
      const check = (): void => {
        clearTimeout(timer);
        const left = this.clock.realMsUntil(deadline);
        if (left === 0) end();
        else if (left !== Infinity) timer = setTimeout(check, Math.min(left, longestTimerMs));
      };
      ends.add(end);
      if (durationMs < 0) return;
      this.timed.add(check);
      check();
    });
    this.lastYield = performance.now();
  }

  /** One turn of the event loop, without the clamping of timers. */
  private yieldTurn(): Promise<void> {
    return new Promise((resolve) => {
      this.turns.push(() => {
        this.lastYield = performance.now();
        resolve();
      });
      this.turn ??= this.openTurn();
      this.turn.port2.postMessage(0);
    });
  }

  private openTurn(): MessageChannel {
    const turn = new MessageChannel();
    turn.port1.addEventListener('message', () => this.turns.shift()?.());
    turn.port1.start();
    unref(turn.port1);
    return turn;
  }
}

function release(ends: Set<() => void>): void {
  for (const end of [...ends]) end();
}

/** Under Node.js an idle port must not hold the process. */
export function unref(port: MessagePort): void {
  if ('unref' in port && typeof port.unref === 'function') port.unref();
}
