// Times of an endpoint on the bus, where its writers and all threads of its participant reach them.

import { BusEndpoint, type StatusKind } from '../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { TimeCells } from './timing.ts';

export class BusCells implements TimeCells {
  private readonly i32: Int32Array;
  private readonly i64: BigInt64Array;
  private readonly word: number;

  /** The tables never move, so the views of the bus as it is now reach them for ever. */
  constructor(bus: Bus, endpointWord: number) {
    this.i32 = bus.i32;
    this.i64 = bus.i64;
    this.word = endpointWord;
  }

  activeAt(): number {
    return Number(Atomics.load(this.i64, (this.word + BusEndpoint.activeAt) >> 1));
  }

  exchangeActive(now: number): number {
    return Number(Atomics.exchange(this.i64, (this.word + BusEndpoint.activeAt) >> 1, BigInt(Math.floor(now))));
  }

  assertedAt(): number {
    return Number(Atomics.load(this.i64, (this.word + BusEndpoint.assertedAt) >> 1));
  }

  exchangeAsserted(now: number): number {
    return Number(Atomics.exchange(this.i64, (this.word + BusEndpoint.assertedAt) >> 1, BigInt(Math.floor(now))));
  }

  missed(): number {
    return Atomics.load(this.i32, this.word + BusEndpoint.deadlineTotal);
  }

  addMissed(count: number): void {
    Atomics.add(this.i32, this.word + BusEndpoint.deadlineTotal, count);
  }

  lost(): number {
    return Atomics.load(this.i32, this.word + BusEndpoint.livelinessTotal);
  }

  addLost(count: number): void {
    Atomics.add(this.i32, this.word + BusEndpoint.livelinessTotal, count);
  }

  watched(): number {
    return Atomics.load(this.i32, this.word + BusEndpoint.watched);
  }

  watch(status: StatusKind): void {
    Atomics.or(this.i32, this.word + BusEndpoint.watched, 1 << status);
  }
}
