// Times of an endpoint on the bus, where its writers and all threads of its participant reach them.

import { BusEndpoint, type StatusKind } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import type { TimeCells } from './timing.ts';

export class BusCells implements TimeCells {
  private readonly bus: Bus;
  private readonly i64: BigInt64Array;
  private readonly word: number;

  /** The tables never move, so a view of the bus as it is now reaches them for ever. */
  constructor(bus: Bus, endpointWord: number) {
    this.bus = bus;
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
    return this.bus.load(this.word + BusEndpoint.deadlineTotal);
  }

  addMissed(count: number): void {
    this.bus.add(this.word + BusEndpoint.deadlineTotal, count);
  }

  lost(): number {
    return this.bus.load(this.word + BusEndpoint.livelinessTotal);
  }

  addLost(count: number): void {
    this.bus.add(this.word + BusEndpoint.livelinessTotal, count);
  }

  watched(): number {
    return this.bus.load(this.word + BusEndpoint.watched);
  }

  watch(status: StatusKind): void {
    this.bus.or(this.word + BusEndpoint.watched, 1 << status);
  }
}
