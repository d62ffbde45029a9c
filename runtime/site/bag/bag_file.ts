// Opens a bag: MCAP, by its index, or without a valid one from front to back as far as it can be read. The sizes in
// it may be false: every length is checked before memory is allocated for it.

import { McapIndexedReader, McapStreamReader } from '@mcap/core';
import { splitSchema } from '../decode/definitions.ts';
import type { QosRequest } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { decompressHandlers, mostChunkBytes } from './decompress.ts';
import { readProfiles } from './qos_profiles.ts';

/** A file, or something like it. read() may give less than was asked for, at its end only. */
export interface BagSource {
  readonly name: string;
  readonly size: number;
  read(from: number, length: number): Promise<Uint8Array>;
}

export interface BagChannel {
  readonly id: number;
  readonly topic: string;
  /** `std_msgs/msg/String`. */
  readonly type: string;
  /** `cdr`; others cannot be played. */
  readonly encoding: string;
  readonly offered: readonly QosRequest[];
  readonly count: number;
}

export interface BagMessage {
  readonly channel: number;
  /** ns since 1970. */
  readonly logTime: bigint;
  readonly data: Uint8Array;
}

export interface Bag {
  readonly name: string;
  readonly size: number;
  /** Empty when nobody said. */
  readonly distro: string;
  readonly start: bigint;
  readonly end: bigint;
  readonly messages: number;
  /** Sorted by topic. */
  readonly channels: readonly BagChannel[];
  /** Definitions of types, by their full names. */
  readonly definitions: ReadonlyMap<string, string>;
  /** Why not all of it can be read; undefined: it is whole, as far as its index says. */
  readonly damage: string | undefined;
  /** In order of time, those of the topics from that time on. Rejects with a SiteError, R2W0741. */
  read(from: bigint, topics: readonly string[]): AsyncIterable<BagMessage>;
}

const mostSummaryBytes = 64 * 2 ** 20;
const mostChannels = 10_000;
const mostSchemaBytes = 1 << 20;
const mostSchemasBytes = 16 << 20;
/** Chunks whose times overlap are held side by side. */
const mostHeldBytes = 512 * 2 ** 20;
/** Upper bound of the messages that are stored for a bag without index, in bytes. */
const mostKeptBytes = 256 * 2 ** 20;
const mostKeptMessages = 2_000_000;
const pieceBytes = 1 << 20;
const magic = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];

interface SchemaRecord {
  readonly name: string;
  readonly encoding: string;
  readonly data: Uint8Array;
}

interface ChannelRecord {
  readonly id: number;
  readonly schemaId: number;
  readonly topic: string;
  readonly messageEncoding: string;
  readonly metadata: ReadonlyMap<string, string>;
}

/** Rejects with a SiteError, R2W0740: nothing of it can be played. */
export async function openBag(source: BagSource): Promise<Bag> {
  const head = await source.read(0, magic.length);
  if (magic.some((byte, index) => head[index] !== byte)) {
    throw new SiteError('R2W0740', `\`${source.name}\` is not a bag that can be read`, {
      why: 'bags are MCAP files, which begin with their sign; this one does not',
      fix: 'convert other bags with `ros2 bag convert`, or record with `--storage mcap`',
    });
  }
  const problem: string | { readonly bag: Bag; } = await openIndexed(source).then((bag) => ({ bag }), reasonOf);
  return typeof problem === 'string' ? await readWhole(source, problem) : problem.bag;
}

async function openIndexed(source: BagSource): Promise<Bag> {
  let most = mostSummaryBytes;
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: () => Promise.resolve(BigInt(source.size)),
      read: async (offset, size) => {
        if (offset < 0n || size < 0n || offset + size > BigInt(source.size)) throw new Error('it points behind its end');
        if (size > BigInt(most)) throw new Error(`a part of ${size} bytes is too large`);
        const bytes = await source.read(Number(offset), Number(size));
        if (bytes.length !== Number(size)) throw new Error('the file is shorter than it was');
        return bytes;
      },
    },
    decompressHandlers,
  });
  most = mostChunkBytes;
  const { chunkIndexes, statistics, channelsById, schemasById } = reader;
  if (chunkIndexes.length === 0 && statistics?.messageCount !== 0n) throw new Error('it has no index');
  let [start, end] = [0n, 0n];
  for (const [index, chunk] of chunkIndexes.entries()) {
    const isListed = [...chunk.messageIndexOffsets.keys()].every((id) => channelsById.has(id));
    if (!isListed || (chunk.messageIndexLength === 0n && chunk.messageEndTime !== 0n)) throw new Error('its index is not whole');
    if (chunk.messageEndTime < chunk.messageStartTime) throw new Error('a chunk ends before it begins');
    if (index === 0 || chunk.messageStartTime < start) start = chunk.messageStartTime;
    if (chunk.messageEndTime > end) end = chunk.messageEndTime;
  }
  if (heldAtOnce(chunkIndexes) > mostHeldBytes) throw new Error('too many of its chunks overlap');
  const counts = statistics?.channelMessageCounts;
  const described = describe([...channelsById.values()], schemasById, (id) => Number(counts?.get(id) ?? 0n));
  let distro = '';
  if (reader.metadataIndexes.length < 100) {
    for await (const { metadata } of reader.readMetadata({ name: 'rosbag2' })) {
      distro = metadata.get('ROS_DISTRO') ?? /^ros_distro: *["']?(\w+)/m.exec(metadata.get('serialized_metadata') ?? '')?.[1] ?? distro;
    }
  }
  return {
    name: source.name,
    size: source.size,
    distro: /^\w{1,40}$/.test(distro) ? distro : '',
    start,
    end,
    ...described,
    messages: Number(statistics?.messageCount ?? 0n),
    damage: undefined,
    async *read(from, topics) {
      try {
        for await (const { channelId, logTime, data } of reader.readMessages({ startTime: from, topics })) {
          yield { channel: channelId, logTime, data };
        }
      } catch (error) {
        throw new SiteError('R2W0741', `the bag \`${source.name}\` is damaged`, { why: reasonOf(error) });
      }
    },
  };
}

interface Span {
  readonly messageStartTime: bigint;
  readonly messageEndTime: bigint;
  readonly chunkLength: bigint;
  readonly uncompressedSize: bigint;
}

/** The most that chunks over each other take, as if all were as large as the largest. */
function heldAtOnce(chunks: readonly Span[]): number {
  const edges = chunks.flatMap((chunk) => [{ at: chunk.messageStartTime, step: 1 }, { at: chunk.messageEndTime, step: -1 }]);
  edges.sort((a, b) => (a.at < b.at ? -1 : a.at > b.at ? 1 : b.step - a.step));
  let [now, most, largest] = [0, 0, 0];
  for (const { step } of edges) {
    now += step;
    most = Math.max(most, now);
  }
  for (const { chunkLength, uncompressedSize } of chunks) largest = Math.max(largest, Number(chunkLength), Number(uncompressedSize));
  return most * largest;
}

function describe(
  channels: readonly ChannelRecord[],
  schemas: ReadonlyMap<number, SchemaRecord>,
  count: (channel: number) => number,
): { channels: BagChannel[]; definitions: Map<string, string>; } {
  if (channels.length > mostChannels) throw new Error(`it has ${channels.length} topics`);
  const definitions = new Map<string, string>();
  let left = mostSchemasBytes;
  for (const { name, encoding, data } of schemas.values()) {
    if (encoding !== 'ros2msg' || data.length > mostSchemaBytes || data.length > left) continue;
    left -= data.length;
    for (const [type, text] of splitSchema(fullType(name), new TextDecoder().decode(data))) {
      if (!definitions.has(type)) definitions.set(type, text);
    }
  }
  return {
    definitions,
    channels: channels.map(({ id, topic, schemaId, messageEncoding, metadata }) => ({
      id,
      topic,
      type: fullType(schemas.get(schemaId)?.name ?? ''),
      encoding: messageEncoding,
      count: count(id),
      offered: readProfiles(metadata.get('offered_qos_profiles') ?? ''),
    })).sort((a, b) => (a.topic < b.topic ? -1 : 1)),
  };
}

/** Some writers leave the middle out. */
function fullType(name: string): string {
  return name.replace(/^(\w+)\/(\w+)$/, '$1/msg/$2');
}

/** From front to back, everything in memory: for bags that were cut, or never had an index. */
async function readWhole(source: BagSource, noIndex: string): Promise<Bag> {
  const reader = new McapStreamReader({ decompressHandlers: { ...decompressHandlers } });
  const kept: BagMessage[] = [];
  const channels = new Map<number, ChannelRecord>();
  const schemas = new Map<number, SchemaRecord>();
  const counts = new Map<number, number>();
  let [bytes, schemaBytes] = [0, 0];
  let damage: string | undefined;
  const take = (): void => {
    for (let record = reader.nextRecord(); record !== undefined; record = reader.nextRecord()) {
      if (record.type === 'Schema') {
        schemaBytes += record.data.length;
        if (schemaBytes <= mostSchemasBytes) schemas.set(record.id, { ...record, data: record.data.slice() });
      } else if (record.type === 'Channel') {
        if (channels.size >= mostChannels) throw new Error(`it has more than ${mostChannels} topics`);
        channels.set(record.id, record);
      } else if (record.type === 'Message') {
        bytes += record.data.length;
        if (bytes > mostKeptBytes || kept.length >= mostKeptMessages) throw new Error('without an index no more of it can be held');
        counts.set(record.channelId, (counts.get(record.channelId) ?? 0) + 1);
        kept.push({ channel: record.channelId, logTime: record.logTime, data: record.data.slice() });
      }
    }
  };
  try {
    for (let at = 0; at < source.size && !reader.done(); at += pieceBytes) {
      reader.append(await source.read(at, pieceBytes));
      take();
      if (reader.bytesRemaining() > mostChunkBytes) throw new Error('a part of it is too large');
    }
    if (!reader.done()) damage = 'it ends early';
  } catch (error) {
    damage = reasonOf(error);
  }
  if (kept.length === 0 && damage !== undefined) {
    throw new SiteError('R2W0740', `\`${source.name}\` is not a bag that can be read`, { why: [...new Set([noIndex, damage])] });
  }
  kept.sort((a, b) => (a.logTime < b.logTime ? -1 : a.logTime > b.logTime ? 1 : 0));
  return {
    name: source.name,
    size: source.size,
    distro: '',
    start: kept[0]?.logTime ?? 0n,
    end: kept.at(-1)?.logTime ?? 0n,
    messages: kept.length,
    damage,
    ...describe([...channels.values()], schemas, (id) => counts.get(id) ?? 0),
    async *read(from, topics) {
      const wanted = new Set([...channels.values()].filter(({ topic }) => topics.includes(topic)).map(({ id }) => id));
      for (const message of kept) if (message.logTime >= from && wanted.has(message.channel)) yield message;
    },
  };
}

function reasonOf(error: unknown): string {
  const text = error instanceof Error ? error.message : String(error);
  // The text that the reader appends comes from the file itself, so it is removed.
  return text.replace(/ ?\[(?:library=[^]*|no header)\]$/, '').slice(0, 300);
}
