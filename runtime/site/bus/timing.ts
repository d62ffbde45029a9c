// Deadlines and leases of one endpoint as functions of time: nothing counts down, so a worker that is busy or blocked
// misses nothing, and one that waits is woken only when a count that somebody reads is about to change. Both links use
// it; they differ in where the times lie. Times are the site's steady ones, in ns; 0 is never.

import { EndpointKind, Liveliness, StatusKind } from '../../protocol/generated/constants.ts';
import type { EndpointRecord } from './graph.ts';

/** Where the times and totals of an endpoint lie. */
export interface TimeCells {
  /** The last sample: of a writer the one it wrote, of a reader the one written for it. */
  activeAt(): number;
  /** Returns what was there. */
  exchangeActive(now: number): number;
  /** The last sign of life of a writer with manual liveliness. */
  assertedAt(): number;
  exchangeAsserted(now: number): number;
  /** Missed deadlines before activeAt. */
  missed(): number;
  addMissed(count: number): void;
  /** Lapsed leases before assertedAt. */
  lost(): number;
  addLost(count: number): void;
  /** Bits of the StatusKinds that somebody reads. */
  watched(): number;
  watch(status: StatusKind): void;
}

interface Lease {
  readonly cells: TimeCells;
  readonly leaseNs: number;
}

/** The lease that a writer must renew itself, in ns; 0: none. */
export function manualLease(writer: EndpointRecord): number {
  const manual = writer.kind === EndpointKind.publisher && writer.qos.liveliness === Liveliness.manualByTopic;
  return manual ? Number(writer.qos.lease) : 0;
}

/** The deadline of a topic's endpoint in ns; 0: none. Services have none. */
export function deadlineOf({ kind, qos }: EndpointRecord): number {
  return kind === EndpointKind.publisher || kind === EndpointKind.subscription ? Number(qos.deadline) : 0;
}

function periodsSince(since: number, now: number, period: number): number {
  return since === 0 || period === 0 ? 0 : Math.max(0, Math.floor((now - since) / period));
}

/** A sample for an endpoint with a deadline: the silence before it is counted. */
export function noteSample(cells: TimeCells, deadlineNs: number, now: number): void {
  const missed = periodsSince(cells.exchangeActive(now), now, deadlineNs);
  if (missed > 0) cells.addMissed(missed);
}

/** Whether a lease has run out. */
function lapsed({ cells, leaseNs }: Lease, now: number): boolean {
  return now - cells.assertedAt() >= leaseNs;
}

export class Timing {
  private readonly cells: TimeCells;
  private readonly deadlineNs: number;
  private readonly own: Lease | undefined;
  /** For a reader: the matched writers that must renew a lease. */
  private readonly leases = new Map<number, Lease>();
  private told = 0;

  constructor(record: EndpointRecord, cells: TimeCells) {
    this.cells = cells;
    this.deadlineNs = deadlineOf(record);
    const leaseNs = manualLease(record);
    this.own = leaseNs === 0 ? undefined : { cells, leaseNs };
  }

  /** Time alone may change a status of this endpoint. */
  get ticks(): boolean {
    return this.deadlineNs !== 0 || this.own !== undefined || this.leases.size > 0;
  }

  /** The writer wrote; true when its liveliness had been lost. */
  wrote(now: number): boolean {
    if (this.deadlineNs !== 0) noteSample(this.cells, this.deadlineNs, now);
    return this.assert(now);
  }

  /** The reader got a sample. */
  received(now: number): void {
    if (this.deadlineNs !== 0) noteSample(this.cells, this.deadlineNs, now);
  }

  /** A sign of life of the writer; true when its liveliness had been lost. */
  assert(now: number): boolean {
    if (this.own === undefined) return false;
    const before = this.cells.exchangeAsserted(now);
    const lost = now - before >= this.own.leaseNs;
    if (lost) this.cells.addLost(1);
    return lost;
  }

  match(writer: EndpointRecord, cells: TimeCells): void {
    const leaseNs = manualLease(writer);
    if (leaseNs !== 0) this.leases.set(writer.key, { cells, leaseNs });
  }

  unmatch(writer: number): void {
    this.leases.delete(writer);
  }

  /** At `now` the reader had no writer left: no deadline runs until the next sample. */
  pause(now: number): void {
    if (this.deadlineNs === 0) return;
    const active = this.cells.exchangeActive(0);
    // A writer that came after that has written already.
    if (active > now) this.cells.exchangeActive(active);
    const missed = periodsSince(active, now, this.deadlineNs);
    if (missed > 0) this.cells.addMissed(missed);
  }

  deadlinesMissed(now: number): number {
    return this.cells.missed() + periodsSince(this.cells.activeAt(), now, this.deadlineNs);
  }

  /** How often the writer's liveliness was lost. */
  livelinessLost(now: number): number {
    return this.cells.lost() + (this.own !== undefined && lapsed(this.own, now) ? 1 : 0);
  }

  /** Matched writers that have not renewed their lease. */
  lapsedWriters(now: number): number {
    let count = 0;
    for (const lease of this.leases.values()) if (lapsed(lease, now)) count += 1;
    return count;
  }

  /** A status that is read once is watched from then on. */
  watch(status: StatusKind): void {
    this.cells.watch(status);
  }

  /** True when time has changed a watched status since it was asked last. */
  changed(now: number): boolean {
    const watched = this.cells.watched();
    let state = 0;
    if ((watched & deadlineBits) !== 0) state += this.deadlinesMissed(now);
    if ((watched & livelinessBits) !== 0) state += 1e9 * (this.livelinessLost(now) + this.lapsedWriters(now));
    const differs = state !== this.told;
    this.told = state;
    return differs;
  }

  /** When time will change a watched status; Infinity when it will not. */
  nextChange(now: number): number {
    const watched = this.cells.watched();
    let next = Infinity;
    const since = this.cells.activeAt();
    if ((watched & deadlineBits) !== 0 && this.deadlineNs !== 0 && since !== 0) {
      next = since + (periodsSince(since, now, this.deadlineNs) + 1) * this.deadlineNs;
    }
    if ((watched & livelinessBits) === 0) return next;
    for (const lease of this.own === undefined ? this.leases.values() : [this.own]) {
      if (!lapsed(lease, now)) next = Math.min(next, lease.cells.assertedAt() + lease.leaseNs);
    }
    return next;
  }
}

const deadlineBits = (1 << StatusKind.offeredDeadlineMissed) | (1 << StatusKind.requestedDeadlineMissed);
const livelinessBits = (1 << StatusKind.livelinessLost) | (1 << StatusKind.livelinessChanged);

/** Times of an endpoint that only one thread knows. */
export class LocalCells implements TimeCells {
  private active = 0;
  private asserted: number;
  private missedTotal = 0;
  private lostTotal = 0;
  private watchedBits = 0;

  constructor(now: number) {
    this.asserted = now;
  }

  activeAt(): number {
    return this.active;
  }

  exchangeActive(now: number): number {
    const before = this.active;
    this.active = now;
    return before;
  }

  assertedAt(): number {
    return this.asserted;
  }

  exchangeAsserted(now: number): number {
    const before = this.asserted;
    this.asserted = now;
    return before;
  }

  missed(): number {
    return this.missedTotal;
  }

  addMissed(count: number): void {
    this.missedTotal += count;
  }

  lost(): number {
    return this.lostTotal;
  }

  addLost(count: number): void {
    this.lostTotal += count;
  }

  watched(): number {
    return this.watchedBits;
  }

  watch(status: StatusKind): void {
    this.watchedBits |= 1 << status;
  }
}
