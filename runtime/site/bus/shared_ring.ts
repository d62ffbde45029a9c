// Where a writer's samples lie on the bus, and where a reader keeps its place. Used by shared_writer and shared_reader.
// Sequences and orders are Int32 that wrap: always compare through a difference.

import { BusEndpoint, BusHeader, BusSizes, maxSampleLength } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';

export const slotWords = BusSizes.slot >> 2;
export const unit = BusSizes.align;
const ringHeaderWords = BusSizes.ringHeader >> 2;

/** Ring word: page (20 bits), log2 of the slot count (5 bits), generation (7 bits). 0: no ring yet. */
export function packRing(page: number, log2: number, generation: number): number {
  return page | (log2 << 20) | ((generation & 127) << 25);
}

export function ringPage(ring: number): number {
  return ring & 0xfffff;
}

export function ringLog2(ring: number): number {
  return (ring >>> 20) & 31;
}

export function ringGeneration(ring: number): number {
  return ring >>> 25;
}

/** A ring has at most 2 to this many slots. */
export const maxLog2 = 15;

/** Whether a ring word leads to a ring that lies in pages: another program may have written over it. Makes the views reach it. */
export function ringFits(bus: Bus, ring: number): boolean {
  const log2 = ringLog2(ring);
  return log2 <= maxLog2 && bus.holds(bus.pageOffset(ringPage(ring)), ringFramesOffset(log2));
}

/** The same of a frame and its payload. `frame`: in units. */
export function frameFits(bus: Bus, frame: number, length: number): boolean {
  return length <= maxSampleLength && bus.holds(frame * unit, BusSizes.align + length) && length >= 0;
}

/** Word of the slot that holds a sequence. */
export function slotWord(bus: Bus, ring: number, sequence: number): number {
  const index = sequence & ((1 << ringLog2(ring)) - 1);
  return (bus.pageOffset(ringPage(ring)) >> 2) + ringHeaderWords + index * slotWords;
}

/** Bytes of a ring with its header and inline frames. */
export function ringBytes(log2: number, stride: number): number {
  return ringFramesOffset(log2) + (stride << log2);
}

export function ringFramesOffset(log2: number): number {
  return BusSizes.ringHeader + (BusSizes.slot << log2);
}

/** Generations go from 1 to this and from 1 again. */
const mostGenerations = 2 ** 19 - 1;

export function nextGeneration(generation: number): number {
  return generation % mostGenerations + 1;
}

export function previousGeneration(generation: number): number {
  return (generation + mostGenerations - 2) % mostGenerations + 1;
}

/** Key of an endpoint: its slot and how often the slot was used. Never 0. */
export function endpointKey(index: number, generation: number): number {
  return (generation << 13) | index;
}

export function keyIndex(key: number): number {
  return key & 0x1fff;
}

/** Where a reader's (writer key, cursor) pairs lie, and how many fit. */
export function cursorTable(bus: Bus, endpoint: number): { word: number; entries: number; } {
  const table = bus.load(endpoint + BusEndpoint.table);
  if (table === 0) return { word: endpoint + BusEndpoint.inlineTable, entries: BusEndpoint.inlineEntries };
  const pages = table >>> 20;
  const offset = bus.pageOffset(table & 0xfffff);
  if (!bus.holds(offset, pages * BusSizes.page)) return { word: endpoint + BusEndpoint.inlineTable, entries: BusEndpoint.inlineEntries };
  return { word: offset >> 2, entries: (pages * BusSizes.page) >> 3 };
}

/** Word of the pair of a writer, or -1: nothing was read of it yet, and its cursor is 0. */
export function findCursor(bus: Bus, reader: number, writerKey: number): number {
  const { word, entries } = cursorTable(bus, reader);
  for (let i = 0; i < entries; i += 1) {
    if (bus.load(word + 2 * i) === writerKey) return word + 2 * i;
  }
  return -1;
}

/** True when someone outside the reader lists (the page's sampler) is reading the frame. */
export function observed(bus: Bus, frameUnit: number, units: number): boolean {
  if (bus.load(BusHeader.observing) === 0) return false;
  for (let i = 0; i < BusHeader.observerCount; i += 1) {
    const hazard = bus.load(BusHeader.observers + i);
    if (hazard >= frameUnit && hazard < frameUnit + units) return true;
  }
  return false;
}

/** Copies within or between buffers; small ones word by word, since a view costs more than the copy. */
export function copyBytes(
  from: Uint8Array,
  fromWords: Int32Array,
  source: number,
  to: Uint8Array,
  toWords: Int32Array,
  target: number,
  length: number,
): void {
  if (length <= 256 && (source & 3) === 0 && (target & 3) === 0) {
    const words = length >> 2;
    const s = source >> 2;
    const t = target >> 2;
    for (let i = 0; i < words; i += 1) toWords[t + i] = fromWords[s + i]!;
    for (let i = words << 2; i < length; i += 1) to[target + i] = from[source + i]!;
    return;
  }
  to.set(from.subarray(source, source + length), target);
}
