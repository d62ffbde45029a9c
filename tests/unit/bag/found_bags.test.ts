// Bags as they are found: of other writers, without a summary or indexes, cut, changed, empty, or a folder of rosbag2.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { crc32 } from 'node:zlib';
import { type Bag, openBag } from '../../../runtime/site/bag/bag_file.ts';
import { bagInfo } from '../../../runtime/site/ros2cli/bag_info.ts';
import { bagFiles } from '../../../runtime/site/ros2cli/shell_files.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { sourceOf } from './bag_parts.ts';

const watchdog = { timeout: 60_000 };
const messages = 20;

interface Written {
  readonly chunks?: boolean;
  readonly messages?: number;
}

const encoder = new TextEncoder();

function number(value: bigint | number, bytes: 2 | 4 | 8): Uint8Array {
  const field = new DataView(new ArrayBuffer(8));
  field.setBigUint64(0, BigInt(value), true);
  return new Uint8Array(field.buffer, 0, bytes);
}

function joined(...parts: readonly Uint8Array[]): Uint8Array {
  return new Uint8Array(Buffer.concat(parts));
}

function counted(bytes: Uint8Array | string): Uint8Array {
  const content = typeof bytes === 'string' ? encoder.encode(bytes) : bytes;
  return joined(number(content.length, 4), content);
}

/** As the specification of MCAP has it. */
function record(operation: number, ...fields: readonly Uint8Array[]): Uint8Array {
  const content = joined(...fields);
  return joined(new Uint8Array([operation]), number(content.length, 8), content);
}

/** /chatter with messages 100 ms apart, and /empty; without a summary and without indexes. */
function written({ chunks = false, messages: count = messages }: Written): Uint8Array {
  const begin = 1_700_000_000_000_000_000n;
  const channel = (id: number, topic: string): Uint8Array => record(0x04, number(id, 2), number(1, 2), counted(topic), counted('cdr'), counted(''));
  const records = [
    record(0x03, number(1, 2), counted('std_msgs/msg/String'), counted('ros2msg'), counted('string data\n')),
    channel(1, '/chatter'),
    channel(2, '/empty'),
  ];
  for (let index = 0; index < count; ++index) {
    const time = number(begin + BigInt(index) * 100_000_000n, 8);
    records.push(record(0x05, number(1, 2), number(index, 4), time, time, new Uint8Array([0, 1, 0, 0]), counted(`message ${String(index)}\0`)));
  }
  const data = joined(...records);
  const chunk = (): Uint8Array =>
    record(0x06, number(begin, 8), number(begin + BigInt(count) * 100_000_000n, 8), number(data.length, 8), number(crc32(data), 4), counted(''),
      number(data.length, 8), data);
  const magic = new Uint8Array([0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a]);
  return joined(magic, record(0x01, counted('ros2'), counted('by hand')), chunks ? chunk() : data, record(0x0f, number(0, 4)),
    record(0x02, number(0, 8), number(0, 8), number(0, 4)), magic);
}

async function texts(bag: Bag): Promise<string[]> {
  const read: string[] = [];
  for await (const { data } of bag.read(0n, bag.channels.map(({ topic }) => topic))) read.push(new TextDecoder().decode(data.subarray(8, -1)));
  return read;
}

const all = Array.from({ length: messages }, (_, index) => `message ${String(index)}`);

test('a bag without a summary is read from front to back, topics without messages too', watchdog, async () => {
  for (const chunks of [false, true]) {
    const bag = await openBag(sourceOf(written({ chunks })));
    assert.deepEqual(await texts(bag), all);
    assert.deepEqual(bag.channels.map(({ topic, count }) => [topic, count]), [['/chatter', messages], ['/empty', 0]]);
    assert.match(bagInfo(bag), /^Messages: +20$/m);
    assert.match(bagInfo(bag), /Topic: \/empty \| Type: std_msgs\/msg\/String \| Count: 0 /);
  }
});

test('a bag that is cut in a message has those before it, and says that it is cut', watchdog, async () => {
  const whole = written({});
  const last = Buffer.from(whole).lastIndexOf('message 19');
  const bag = await openBag(sourceOf(whole.subarray(0, last + 4)));
  assert.deepEqual(await texts(bag), all.slice(0, -1));
  assert.notEqual(bag.damage, undefined);
});

test('a chunk that is cut or changed is not played as if it was right', watchdog, async () => {
  const whole = written({ chunks: true });
  const at = Buffer.from(whole).indexOf('message 7');
  const changed = whole.slice();
  changed[at] = 'M'.charCodeAt(0);
  for (const bytes of [whole.subarray(0, at), changed]) {
    const opened: Bag | SiteError = await openBag(sourceOf(bytes)).catch((error: SiteError) => error);
    if (opened instanceof SiteError) {
      assert.equal(opened.code, 'R2W0740');
      continue;
    }
    assert.notEqual(opened.damage, undefined);
    assert.ok(!(await texts(opened)).some((text) => text.startsWith('Message')));
  }
});

test('a bag without messages has its topics, and ends at once', watchdog, async () => {
  for (const chunks of [false, true]) {
    const bag = await openBag(sourceOf(written({ chunks, messages: 0 })));
    assert.deepEqual(bag.channels.map(({ topic }) => topic), ['/chatter', '/empty']);
    assert.deepEqual(await texts(bag), []);
    assert.equal(bag.damage, undefined);
    assert.match(bagInfo(bag), /^Messages: +0$/m);
  }
});

test('a folder of rosbag2 stands for its file; one without metadata is named as ros2 does', watchdog, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bags-'));
  try {
    mkdirSync(join(folder, 'run'));
    const bytes = written({ chunks: true });
    writeFileSync(join(folder, 'run/run_0.mcap'), bytes);
    await assert.rejects(bagFiles.open(join(folder, 'run')), /Could not find metadata in bag directory .*: name a file of it, '.*run_0\.mcap'/);
    writeFileSync(join(folder, 'run/metadata.yaml'), 'rosbag2_bagfile_information: {}\n');
    const source = await bagFiles.open(join(folder, 'run'));
    assert.equal(source?.size, bytes.length);
    assert.deepEqual(await texts(await openBag(source)), all);
    writeFileSync(join(folder, 'run/run_1.mcap'), bytes);
    await assert.rejects(bagFiles.open(join(folder, 'run')), /has 2 MCAP files: name a file of it/);
    assert.equal(await bagFiles.open(join(folder, 'none')), undefined);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
