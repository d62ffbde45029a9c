// Bags that others made, that were cut, and that lie: what can be read is, the rest is told, and nothing hangs or grows.

// Guarantee, hostile input: a bag that was cut, changed or made to lie gives what can be read of it or an error with a code, within
// bounded memory

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { zstdCompressSync } from 'node:zlib';
import { McapWriter } from '@mcap/core';
import { type Bag, type BagMessage, openBag } from '../../../runtime/site/bag/bag_file.ts';
import { decompressHandlers } from '../../../runtime/site/bag/decompress.ts';
import { BagPlayer } from '../../../runtime/site/bag/player.ts';
import { offerFor, readProfiles, requestFor } from '../../../runtime/site/bag/qos_profiles.ts';
import { splitSchema } from '../../../runtime/site/decode/definitions.ts';
import { seededRandom } from '../../../runtime/site/contract/seeded_random.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { FakeSession, stringBytes } from '../ui/fake_session.ts';
import { MemorySink, sourceOf, until } from './bag_parts.ts';

const watchdog = { timeout: 60_000 };
const words =
  'the quick brown fox jumps over the lazy dog, the quick brown fox jumps over the lazy dog. aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa';

interface Made {
  readonly messages?: number;
  readonly compression?: 'zstd' | 'none' | 'unknown';
  readonly chunks?: boolean;
  readonly index?: boolean;
}

async function made({ messages = 100, compression = 'none', chunks = true, index = true }: Made = {}): Promise<Uint8Array> {
  const sink = new MemorySink();
  let written = 0;
  const writer = new McapWriter({
    useChunks: chunks,
    useChunkIndex: index,
    useMessageIndex: index,
    useSummaryOffsets: index,
    repeatChannels: index,
    repeatSchemas: index,
    chunkSize: 1000,
    ...(compression === 'none' ? {} : { compressChunk: (data) => ({ compression, compressedData: compression === 'zstd' ? zstdCompressSync(data) : data }) }),
    writable: {
      write: (bytes) => {
        written += bytes.length;
        sink.write(bytes.slice());
        return Promise.resolve();
      },
      position: () => BigInt(written),
    },
  });
  await writer.start({ profile: 'ros2', library: 'a test' });
  const schemaId = await writer.registerSchema({ name: 'std_msgs/msg/String', encoding: 'ros2msg', data: Buffer.from('string data') });
  const channelId = await writer.registerChannel({ topic: '/chatter', schemaId, messageEncoding: 'cdr', metadata: new Map() });
  for (let i = 0; i < messages; i += 1) {
    const time = 1_700_000_000_000_000_000n + BigInt(i) * 1_000_000n;
    await writer.addMessage({ channelId, sequence: i, logTime: time, publishTime: time, data: stringBytes(`Hello World: ${i}`) });
  }
  await writer.end();
  return sink.bytes();
}

async function read(bag: Bag, from = 0n): Promise<BagMessage[]> {
  const found: BagMessage[] = [];
  for await (const message of bag.read(from, ['/chatter'])) found.push(message);
  return found;
}

const refused = (code: string) => (error: unknown): boolean => error instanceof SiteError && error.code === code;

for (
  const [title, form] of Object.entries({
    'compressed with zstd': { compression: 'zstd' },
    'without an index': { index: false },
    'without chunks': { chunks: false },
  } satisfies Record<string, Made>)
) {
  test(`a bag ${title} is read whole`, watchdog, async () => {
    const bag = await openBag(sourceOf(await made(form)));
    assert.equal(bag.damage, undefined);
    assert.equal(bag.messages, 100);
    assert.equal((await read(bag)).length, 100);
    assert.equal((await read(bag, bag.start + 50_000_000n)).length, 50);
    assert.equal(bag.end - bag.start, 99_000_000n);
  });
}

test('LZ4 is read, with blocks that reach back into others', watchdog, () => {
  const header = [0x04, 0x22, 0x4d, 0x18, 0x40, 0x40, 0];
  const linked = [...header, 5, 0, 0, 0, 0x40, 97, 98, 99, 100, 5, 0, 0, 0, 0x02, 4, 0, 0x10, 120, 0, 0, 0, 0];
  assert.equal(Buffer.from(decompressHandlers.lz4(Uint8Array.from(linked), 11n)).toString(), 'abcdabcdabx');
  const behind = linked.with(header.length + 4 + 5 + 4 + 1, 5);
  assert.throws(() => decompressHandlers.lz4(Uint8Array.from(behind), 11n), /outside/);
  // Made by lz4 1.9.4: lz4 -BD --content-size
  const frame = Buffer.from(
    '04224d186440a740000000f01074686520717569636b2062726f776e20666f78206a756d7073206f766572201f00916c617a7920646f672c0e000f2d00143f2e2061010037506161616161000000006dab4372',
    'hex',
  );
  assert.equal(Buffer.from(decompressHandlers.lz4(frame, BigInt(words.length))).toString(), words);
  assert.throws(() => decompressHandlers.lz4(frame, BigInt(words.length - 1)));
  assert.throws(() => decompressHandlers.lz4(frame, BigInt(words.length + 1)), /said/);
  // The last four bytes are its checksum.
  for (let at = 1; at < frame.length - 4; at += 1) {
    const cut = frame.subarray(0, at);
    assert.throws(() => decompressHandlers.lz4(cut, BigInt(words.length)), Error, `cut at ${at}`);
  }
});

test('a bomb makes no more than it says, and no chunk may say much', watchdog, () => {
  const bomb = zstdCompressSync(Buffer.alloc(64 << 20));
  assert.ok(bomb.length < 10_000);
  assert.equal(decompressHandlers.zstd(bomb, 1000n).buffer.byteLength, 1000);
  assert.throws(() => decompressHandlers.zstd(bomb, 2n ** 60n), /too large/);
  assert.throws(() => decompressHandlers.lz4(bomb, 2n ** 63n), /too large/);
});

test('what is not a bag is refused', watchdog, async () => {
  for (const bytes of [new Uint8Array(), Buffer.from('#ROSBAG V2.0\n'), Buffer.from('SQLite format 3\0'), (await made()).slice(0, 20)]) {
    await assert.rejects(openBag(sourceOf(bytes)), refused('R2W0740'));
  }
  const unknown = await made({ compression: 'unknown' });
  const bag = await openBag(sourceOf(unknown));
  await assert.rejects(read(bag), (error: unknown) => refused('R2W0741')(error) && /Unsupported compression unknown/.test((error as SiteError).why.join()));
});

test('a bag that was cut anywhere gives what is there, in order', watchdog, async () => {
  const whole = await made();
  let last = -1;
  for (let length = 200; length < whole.length; length += 97) {
    const bag = await openBag(sourceOf(whole.slice(0, length))).catch((error: unknown) => {
      assert.ok(refused('R2W0740')(error));
      return undefined;
    });
    if (bag === undefined) {
      assert.equal(last, -1, 'more of it is there, and less is read');
      continue;
    }
    assert.notEqual(bag.damage, undefined);
    const count = (await read(bag)).length;
    assert.ok(count >= last);
    last = count;
  }
  assert.equal(last, 100);
});

test('lengths that lie ask for no memory', watchdog, async () => {
  const whole = await made();
  // The first record behind the header, of an endless length; then the header itself.
  for (const at of [9, 9 + 8 + 4 + 4 + 4 + 6 + 1]) {
    const bytes = whole.slice();
    new DataView(bytes.buffer).setBigUint64(at, 2n ** 50n, true);
    let most = 0;
    const source = sourceOf(bytes);
    const counted = {
      ...source,
      read: (from: number, length: number) => {
        most = Math.max(most, length);
        return source.read(from, length);
      },
    };
    await openBag(counted).catch((error: unknown) => assert.ok(refused('R2W0740')(error)));
    assert.ok(most <= 1 << 20);
  }
  // A footer that says that the summary begins at the front.
  const bytes = whole.slice();
  new DataView(bytes.buffer).setBigUint64(bytes.length - 8 - 20, 8n, true);
  const bag = await openBag(sourceOf(bytes));
  assert.equal((await read(bag)).length, 100);
});

test('bytes that were changed by chance never hang, and give messages or a code', watchdog, async () => {
  const whole = await made({ compression: 'zstd', messages: 60 });
  const fill = seededRandom(17, 'bags');
  const drawn = new Uint8Array(8);
  const random = (): number => {
    fill(drawn);
    return new DataView(drawn.buffer).getUint32(0) / 2 ** 32;
  };
  for (let round = 0; round < 300; round += 1) {
    const bytes = whole.slice();
    for (let i = 0; i < 4; i += 1) bytes[8 + Math.floor(random() * (bytes.length - 8))] = Math.floor(random() * 256);
    try {
      const bag = await openBag(sourceOf(bytes));
      const messages = await read(bag);
      assert.ok(messages.length <= 60 * 70, `${messages.length} messages in round ${round}`);
    } catch (error) {
      assert.ok(refused('R2W0740')(error) || refused('R2W0741')(error), `round ${round}: ${String(error)}`);
    }
  }
});

test('a player ends with the code when the bag is damaged on its way', watchdog, async () => {
  const bytes = await made();
  const good = await openBag(sourceOf(bytes));
  const source = sourceOf(bytes);
  let spoilt = false;
  const bag = await openBag({
    ...source,
    read: async (from, length) => {
      const piece = await source.read(from, length);
      if (spoilt) piece.fill(0xff);
      return piece;
    },
  });
  assert.equal(bag.messages, good.messages);
  spoilt = true;
  const session = new FakeSession({ nodes: [] });
  const player = new BagPlayer(session, bag, () => undefined);
  player.play();
  await until(() => player.problem !== undefined);
  assert.equal(player.problem?.code, 'R2W0741');
  assert.equal(player.state, 'paused');
  player.close();
  session.close();
});

test('QoS is read as Jazzy and as Humble write it, and from nothing', () => {
  const old =
    '- history: 1\n  depth: 5\n  reliability: 2\n  durability: 1\n  deadline:\n    sec: 2147483647\n    nsec: 4294967295\n  lifespan:\n    sec: 1\n    nsec: 5\n  liveliness: 3\n  liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n  avoid_ros_namespace_conventions: false';
  assert.deepEqual(readProfiles(`${old}\n- history: keep_all\n  depth: 0`), [
    {
      history: 'keep_last',
      depth: 5,
      reliability: 'best_effort',
      durability: 'transient_local',
      liveliness: 'manual_by_topic',
      deadlineNs: 0,
      lifespanNs: 1_000_000_005,
      leaseNs: 0,
    },
    { history: 'keep_all', deadlineNs: 0, lifespanNs: 0, leaseNs: 0 },
  ]);
  assert.deepEqual(readProfiles('{{{{'), []);
  assert.deepEqual(readProfiles('x'.repeat(1 << 20)), []);
  assert.equal(offerFor(readProfiles(old)).reliability, 'best_effort');
  assert.deepEqual(offerFor([{ reliability: 'reliable' }, { reliability: 'best_effort' }]), {});
  assert.equal(requestFor([{ reliability: 'reliable', durability: 'transient_local' }, { reliability: 'reliable', durability: 'volatile' }]).durability,
    'volatile');
});

test('a schema comes apart into types, and odd ones do no harm', () => {
  const schema =
    'a/B b\n================================================================================\nMSG: a/B\nint32 x\n=====\nMSG: ../evil\nint8 y\n=====\nMSG: a/srv/C_Request\n';
  assert.deepEqual([...splitSchema('demo/msg/A', schema)], [['demo/msg/A', 'a/B b\n'], ['a/msg/B', 'int32 x\n'], ['a/srv/C_Request', '']]);
  assert.equal(splitSchema('x', '='.repeat(100_000)).size, 1);
});
