// Finds samples that the readers of a writer on the shared bus have not read, and frees endpoints that departed.

import { BusEndpoint, BusHeader, BusPhase, BusSizes, BusSlot, EndpointKind, flagHidden } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import { metBefore, readEndpoint, releaseEndpoint } from './bus_tables.ts';
import { type EndpointRecord, relate, writes } from './graph.ts';
import { findCursor, keyIndex, ringFits, ringLog2, slotWord } from './shared_ring.ts';

/** Is there a living reader that was born before the writer left and has something of it to read? */
export function unread(bus: Bus, key: number): boolean {
  const { i32 } = bus;
  const word = bus.endpointWord(keyIndex(key));
  const head = bus.load(word + BusEndpoint.head);
  if (head === 0 || bus.load(word + BusEndpoint.ring) === 0) return false;
  const writer = readEndpoint(bus, keyIndex(key))?.record;
  if (writer === undefined) return false;
  const length = i32[word + BusEndpoint.nameLength];
  const endpoints = bus.used(BusHeader.endpointHigh, bus.endpointCount);
  for (let index = 0; index < endpoints; index += 1) {
    const reader = bus.endpointWord(index);
    if ((bus.load(reader) & 255) !== BusPhase.live) continue;
    if (!metBefore(bus, reader, word)) continue;
    // Saves reading the names of most.
    if (i32[reader + BusEndpoint.nameLength] !== length) continue;
    const record = readEndpoint(bus, index)?.record;
    if (record === undefined || relate(writer, record).kind !== 'match') continue;
    const pair = findCursor(bus, reader, key);
    const cursor = pair < 0 ? 0 : bus.load(pair + 1);
    if (cursor === head) continue;
    if (record.kind !== EndpointKind.client || hasReply(bus, writer, record.key, cursor, head)) return true;
  }
  return false;
}

/** As many of a participant's publishers that departed wait for the page to look at them. */
const keptForPage = 16;

/** Frees the own endpoints of a participant that departed, oldest first in the list. True when there were some. */
export function freeDeparted(
  bus: Bus,
  participant: number,
  departed: Map<number, { readonly record: EndpointRecord; }>,
  kept = keptForPage,
): boolean {
  let published = 0;
  const before = departed.size;
  for (const [key, { record }] of [...departed].reverse()) {
    const ring = bus.load(bus.endpointWord(keyIndex(key)) + BusEndpoint.ring);
    if (ring !== 0 && record.kind === EndpointKind.publisher && (record.flags & flagHidden) === 0) {
      published += 1;
      if (published <= kept) continue;
    }
    if (writes(record.kind) && unread(bus, key)) continue;
    departed.delete(key);
    releaseEndpoint(bus, key, participant, false);
  }
  return departed.size < before;
}

/** A client reads only its own replies among those of a server. */
function hasReply(bus: Bus, server: EndpointRecord, client: number, cursor: number, head: number): boolean {
  const ring = bus.load(bus.endpointWord(keyIndex(server.key)) + BusEndpoint.ring);
  if (!ringFits(bus, ring)) return false;
  const count = Math.min((head - cursor) >>> 0, 1 << ringLog2(ring));
  for (let age = 0; age < count; age += 1) {
    const sequence = (head - age) | 0;
    const slot = slotWord(bus, ring, sequence);
    bus.reach((slot << 2) + BusSizes.slot);
    if (bus.load(slot) === sequence && bus.load(slot + BusSlot.target) === client) return true;
  }
  return false;
}
