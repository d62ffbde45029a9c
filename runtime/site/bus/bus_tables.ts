// The node and endpoint tables of the bus: claiming, filling, reading and freeing slots, and the log of changes.

import { BusEndpoint, BusHeader, BusPhase, EndpointKind, flagHidden, maxHashLength, maxNameLength } from '../../protocol/generated/constants.ts';
import { type Bus, readText } from './bus.ts';
import type { EndpointRecord } from './graph.ts';
import { endpointKey, keyIndex, nextGeneration } from './shared_ring.ts';

const encoder = new TextEncoder();

/** Marks entries of the graph log that are about nodes. */
export const nodeBit = 0x8000;

/** Finds a free slot and marks it; -1 when all are taken. */
export function claimSlot(bus: Bus, participant: number, count: number, wordOf: (index: number) => number): number {
  const claimed = ((participant + 1) << 8) | BusPhase.claimed;
  for (let index = 0; index < count; index += 1) {
    if (bus.compareExchange(wordOf(index), BusPhase.free, claimed) === BusPhase.free) return index;
  }
  return -1;
}

/** Makes a counter at least `value`; true when it was less. */
export function raise(bus: Bus, word: number, value: number): boolean {
  for (let now = bus.load(word); now < value; now = bus.load(word)) {
    if (bus.compareExchange(word, now, value) === now) return true;
  }
  return false;
}

/** Writes an entry of the graph log; the change itself must be in the table before. Returns the version. */
export function logChange(bus: Bus, entry: number): number {
  const version = (bus.add(BusHeader.graphVersion, 1) + 1) | 0;
  bus.store(bus.graphLog + (version & bus.graphLogMask), (version << 16) | entry);
  return version;
}

function put64(i32: Int32Array, word: number, value: bigint): void {
  i32[word] = Number(BigInt.asIntN(32, value));
  i32[word + 1] = Number(BigInt.asIntN(32, value >> 32n));
}

function get64(i32: Int32Array, word: number): bigint {
  return (BigInt(i32[word + 1]!) << 32n) | BigInt(i32[word]! >>> 0);
}

/** Fills a slot that the caller has claimed. Strings must fit. */
export function fillEndpoint(bus: Bus, record: EndpointRecord): void {
  const word = bus.endpointWord(keyIndex(record.key));
  const { i32 } = bus;
  const { qos } = record;
  i32.fill(0, word + BusEndpoint.kind, word + (BusEndpoint.nameBytes >> 2));
  i32[word + BusEndpoint.kind] = record.kind;
  i32[word + BusEndpoint.node] = record.nodeKey;
  i32[word + BusEndpoint.flags] = record.flags;
  i32[word + BusEndpoint.reliability] = qos.reliability;
  i32[word + BusEndpoint.durability] = qos.durability;
  i32[word + BusEndpoint.history] = qos.history;
  i32[word + BusEndpoint.depth] = qos.depth;
  i32[word + BusEndpoint.liveliness] = qos.liveliness;
  put64(i32, word + BusEndpoint.deadline, qos.deadline);
  put64(i32, word + BusEndpoint.lifespan, qos.lifespan);
  put64(i32, word + BusEndpoint.lease, qos.lease);
  i32.set(record.gid, word + BusEndpoint.gid);
  for (
    const [length, text, at] of [
      [BusEndpoint.nameLength, record.name, BusEndpoint.nameBytes],
      [BusEndpoint.typeLength, record.type, BusEndpoint.typeBytes],
      [BusEndpoint.hashLength, record.hash, BusEndpoint.hashBytes],
    ] as const
  ) {
    const bytes = encoder.encode(text);
    i32[word + length] = bytes.length;
    bus.u8.set(bytes, (word << 2) + at);
  }
  bus.store(word + BusEndpoint.signal, 1);
  bus.store(word + BusEndpoint.born, (bus.load(BusHeader.graphVersion) + 1) | 0);
}

/** Takes an endpoint out of the graph; what it wrote can still be read. False when someone else did so. */
export function departEndpoint(bus: Bus, key: number, participant: number): boolean {
  const word = bus.endpointWord(keyIndex(key));
  const live = ((participant + 1) << 8) | BusPhase.live;
  if (bus.load(word + BusEndpoint.generation) !== key >>> 13) return false;
  bus.store(word + BusEndpoint.gone, (bus.load(BusHeader.graphVersion) + 1) | 0);
  const gone = (live & ~255) | BusPhase.departed;
  if (bus.compareExchange(word, live, gone) !== live) return false;
  logChange(bus, keyIndex(key));
  return true;
}

/** Was a reader there before a writer left? If not, the writer has nothing for it. Words of their entries. */
export function metBefore(bus: Bus, reader: number, writer: number): boolean {
  return ((bus.load(writer + BusEndpoint.gone) - bus.load(reader + BusEndpoint.born)) | 0) > 0;
}

/** Reads an endpoint slot; undefined when it is neither live nor departed, or changed meanwhile. */
export function readEndpoint(bus: Bus, index: number): { record: EndpointRecord; departed: boolean; } | undefined {
  const { i32 } = bus;
  const word = bus.endpointWord(index);
  const state = bus.load(word);
  const phase = state & 255;
  if (phase !== BusPhase.live && phase !== BusPhase.departed) return undefined;
  const generation = bus.load(word + BusEndpoint.generation);
  const at = word << 2;
  const participant = (state >>> 8) - 1;
  const kind = i32[word + BusEndpoint.kind]!;
  // Nobody makes such ones: something has written over them.
  if (participant < 0 || participant >= bus.participantCount || kind < EndpointKind.publisher || kind > EndpointKind.server) return undefined;
  const record: EndpointRecord = {
    key: endpointKey(index, generation),
    participant,
    nodeKey: i32[word + BusEndpoint.node]!,
    kind,
    name: readText(bus, at + BusEndpoint.nameBytes, i32[word + BusEndpoint.nameLength]!, maxNameLength),
    type: readText(bus, at + BusEndpoint.typeBytes, i32[word + BusEndpoint.typeLength]!, maxNameLength),
    hash: readText(bus, at + BusEndpoint.hashBytes, i32[word + BusEndpoint.hashLength]!, maxHashLength),
    qos: {
      reliability: i32[word + BusEndpoint.reliability]!,
      durability: i32[word + BusEndpoint.durability]!,
      history: i32[word + BusEndpoint.history]!,
      depth: i32[word + BusEndpoint.depth]!,
      liveliness: i32[word + BusEndpoint.liveliness]!,
      deadline: get64(i32, word + BusEndpoint.deadline),
      lifespan: get64(i32, word + BusEndpoint.lifespan),
      lease: get64(i32, word + BusEndpoint.lease),
    },
    flags: i32[word + BusEndpoint.flags]!,
    gid: i32.slice(word + BusEndpoint.gid, word + BusEndpoint.gid + 4),
  };
  if (bus.load(word) !== state || bus.load(word + BusEndpoint.generation) !== generation) {
    return undefined;
  }
  return { record, departed: phase === BusPhase.departed };
}

/** Publishers that departed, and are not freed yet. */
export function departedPublishers(bus: Bus): EndpointRecord[] {
  const records: EndpointRecord[] = [];
  const endpoints = bus.used(BusHeader.endpointHigh, bus.endpointCount);
  for (let index = 0; index < endpoints; index += 1) {
    const word = bus.endpointWord(index);
    if ((bus.load(word) & 255) !== BusPhase.departed) continue;
    if (bus.i32[word + BusEndpoint.kind] !== EndpointKind.publisher) continue;
    const record = readEndpoint(bus, index)?.record;
    if (record !== undefined && (record.flags & flagHidden) === 0) records.push(record);
  }
  return records;
}

/** A claimed slot's next generation, within the bits that a key has for it. */
export function bumpGeneration(bus: Bus, word: number): void {
  bus.store(word + BusEndpoint.generation, nextGeneration(bus.load(word + BusEndpoint.generation)));
}

/**
 * Frees the slot and the pages of an endpoint that departed. `killed`: its participant was terminated, perhaps between the
 * allocation of a page and the word that would lead to it, so all pages are searched.
 */
export function releaseEndpoint(bus: Bus, key: number, participant: number, killed: boolean): void {
  const word = bus.endpointWord(keyIndex(key));
  if (bus.load(word + BusEndpoint.generation) !== key >>> 13) return;
  const departed = ((participant + 1) << 8) | BusPhase.departed;
  const claimed = (departed & ~255) | BusPhase.claimed;
  if (bus.compareExchange(word, departed, claimed) !== departed) return;
  const pages = killed || bus.load(word + BusEndpoint.ring) !== 0 || bus.load(word + BusEndpoint.table) !== 0;
  bumpGeneration(bus, word);
  bus.store(word + BusEndpoint.ring, 0);
  bus.store(word + BusEndpoint.hazard, 0);
  if (pages) bus.freeAll(key);
  bus.store(word, BusPhase.free);
  logChange(bus, keyIndex(key));
}
