// Bags that nodes write and read: recorders, generators and players of C++ and Python, as the tutorials of ROS 2 have them, on both
// links; what they wrote is written to disk and read by others. In Chromium a recorder is stopped, and its bag lies in the panel Bag.

// Compatibility, works: bags that nodes write: the panel Bag lists them when they are closed, for play and download;
// `ros2wasm run SITE --bags DIR` writes them to disk

import assert from 'node:assert/strict';
import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { parse as parseDefinition } from '@foxglove/rosmsg';
import { MessageReader } from '@foxglove/rosmsg2-serialization';
import { McapIndexedReader, McapWriter } from '@mcap/core';
import { type Browser, chromium } from 'playwright-core';
import { parse as parseYaml } from 'yaml';
import { MemorySink } from '../../unit/bag/bag_parts.ts';
import { stringBytes } from '../../unit/ui/fake_session.ts';
import { nightlyTest, played } from '../../support/nightly.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const PACKAGES = resolve(import.meta.dirname, '../../packages');
const SHARED = '/opt/ros/jazzy/share/bag_checks/bags/sample';
const watchdog = { timeout: 400_000 };
const patience = { timeout: 120_000 };
const begin = 1_700_000_000_000_000_000n;
let workspace: PackWorkspace;
let site: string;
let browser: Browser;

before(async () => {
  workspace = new PackWorkspace('shared');
  for (const name of ['bag_checks', 'bag_checks_py']) cpSync(join(PACKAGES, name), join(workspace.root, 'src', name), { recursive: true });
  cpSync(join(PACKAGES, 'rclcpp_checks/src'), join(workspace.root, 'src/rclcpp_checks/src'), { recursive: true });
  const sample = join(workspace.root, 'src/bag_checks/bags/sample');
  mkdirSync(sample, { recursive: true });
  writeFileSync(join(sample, 'sample_0.mcap'), await sampleBag());
  writeFileSync(join(sample, 'metadata.yaml'), metadataOf('sample_0.mcap'));
  workspace.write('workspace.yaml', `schema: 1
name: node_bags
packages: [src/bag_checks, src/bag_checks_py]
dependencies: [demo_nodes_cpp]
launch:
  - {package: demo_nodes_cpp, executable: talker}
  - {package: bag_checks, executable: recorder}
  - {package: bag_checks_py, executable: recorder_py}
  - {package: bag_checks, executable: generator}
  - {package: bag_checks_py, executable: generator_py, arguments: [${SHARED}]}
  - {package: bag_checks, executable: bags, arguments: [${SHARED}]}
  - {package: bag_checks, executable: replayer, arguments: [${SHARED}], remappings: {chatter: again}}
  - {package: bag_checks_py, executable: replayer_py, arguments: [${SHARED}], remappings: {chatter: again}}
`);
  site = await workspace.packed();
  browser = await chromium.launch(chromiumOptions());
}, { timeout: 600_000 });

after(async () => {
  await browser.close();
  workspace.close();
});

/** LZ4, of which nothing is smaller: a frame with one block that has literals only. */
function lz4(data: Uint8Array): Uint8Array {
  const lengths = data.length < 15 ? [] : [...Array<number>(Math.floor((data.length - 15) / 255)).fill(255), (data.length - 15) % 255];
  const block = [Math.min(15, data.length) << 4, ...lengths, ...data];
  const size = new Uint8Array(new Uint32Array([block.length]).buffer);
  return Uint8Array.from([0x04, 0x22, 0x4d, 0x18, 0x40, 0x40, 0, ...size, ...block, 0, 0, 0, 0]);
}

/** Two messages on "chatter", the second in a chunk of LZ4. */
async function sampleBag(): Promise<Uint8Array> {
  const sink = new MemorySink();
  let [written, chunks] = [0, 0];
  const writer = new McapWriter({
    chunkSize: 1,
    compressChunk: (data) => {
      chunks += 1;
      return chunks === 1 ? { compression: '', compressedData: data } : { compression: 'lz4', compressedData: lz4(data) };
    },
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
  const channelId = await writer.registerChannel({ topic: 'chatter', schemaId, messageEncoding: 'cdr', metadata: new Map() });
  for (const [sequence, text] of ['from the share', 'compressed'].entries()) {
    const logTime = begin + BigInt(sequence);
    await writer.addMessage({ channelId, sequence, logTime, publishTime: logTime, data: stringBytes(text) });
  }
  await writer.end();
  return sink.bytes();
}

/** As Jazzy writes it. */
function metadataOf(file: string): string {
  return `rosbag2_bagfile_information:
  version: 9
  storage_identifier: mcap
  duration:
    nanoseconds: 1
  starting_time:
    nanoseconds_since_epoch: ${begin}
  message_count: 2
  topics_with_message_count:
    - topic_metadata:
        name: chatter
        type: std_msgs/msg/String
        serialization_format: cdr
        offered_qos_profiles:
          - history: unknown
            depth: 0
            reliability: reliable
            durability: volatile
            deadline:
              sec: 9223372036
              nsec: 854775807
            lifespan:
              sec: 9223372036
              nsec: 854775807
            liveliness: automatic
            liveliness_lease_duration:
              sec: 9223372036
              nsec: 854775807
            avoid_ros_namespace_conventions: false
        type_description_hash: RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18
      message_count: 2
  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - ${file}
  files:
    - path: ${file}
      starting_time:
        nanoseconds_since_epoch: ${begin}
      duration:
        nanoseconds: 1
      message_count: 2
  custom_data: ~
  ros_distro: jazzy
`;
}

interface Bag {
  readonly reader: McapIndexedReader;
  readonly messages: readonly { readonly topic: string; readonly logTime: bigint; readonly value: unknown; }[];
}

/** As others read it. */
async function openBag(bytes: Uint8Array): Promise<Bag> {
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: () => Promise.resolve(BigInt(bytes.length)),
      read: (offset, size) => Promise.resolve(bytes.slice(Number(offset), Number(offset + size))),
    },
  });
  const messages: Bag['messages'][number][] = [];
  for await (const { channelId, logTime, data } of reader.readMessages()) {
    const { topic, schemaId } = reader.channelsById.get(channelId)!;
    const schema = reader.schemasById.get(schemaId)!;
    const decode = new MessageReader(parseDefinition(new TextDecoder().decode(schema.data), { ros2: true }));
    messages.push({ topic, logTime, value: (decode.readMessage(data) as { readonly data: unknown; }).data });
  }
  return { reader, messages };
}

interface Metadata {
  readonly version: number;
  readonly storage_identifier: string;
  readonly duration: { readonly nanoseconds: bigint; };
  readonly starting_time: { readonly nanoseconds_since_epoch: bigint; };
  readonly message_count: bigint;
  readonly topics_with_message_count: readonly {
    readonly topic_metadata: { readonly name: string; readonly type: string; readonly serialization_format: string; };
    readonly message_count: bigint;
  }[];
  readonly relative_file_paths: readonly string[];
  readonly files: readonly { readonly path: string; readonly message_count: bigint; }[];
  readonly custom_data: unknown;
  readonly ros_distro: string;
}

/** The bag of a node, which has one topic; its file and metadata.yaml say the same. */
async function bagOf(folder: string, node: string, name: string, topic: string, type: string): Promise<Bag> {
  const place = join(workspace.root, folder, node, name);
  const bag = await openBag(new Uint8Array(readFileSync(join(place, `${name}_0.mcap`))));
  const { rosbag2_bagfile_information: said } = parseYaml(readFileSync(join(place, 'metadata.yaml'), 'utf8'), { intAsBigInt: true }) as {
    rosbag2_bagfile_information: Metadata;
  };
  const { messages, reader } = bag;
  const [first, last] = [messages.at(0)?.logTime ?? 0n, messages.at(-1)?.logTime ?? 0n];
  const count = BigInt(messages.length);
  assert.deepEqual({ ...said, topics_with_message_count: [] }, {
    version: 9n,
    storage_identifier: 'mcap',
    duration: { nanoseconds: last - first },
    starting_time: { nanoseconds_since_epoch: first },
    message_count: count,
    topics_with_message_count: [],
    compression_format: '',
    compression_mode: '',
    relative_file_paths: [`${name}_0.mcap`],
    custom_data: null,
    ros_distro: 'jazzy',
    files: [{ path: `${name}_0.mcap`, starting_time: { nanoseconds_since_epoch: first }, duration: { nanoseconds: last - first }, message_count: count }],
  });
  assert.deepEqual(said.topics_with_message_count, [{
    topic_metadata: { name: topic, type, serialization_format: 'cdr', offered_qos_profiles: [], type_description_hash: '' },
    message_count: count,
  }]);
  assert.equal(reader.header.profile, 'ros2');
  assert.equal(reader.statistics?.messageCount, count);
  assert.equal([...reader.schemasById.values()][0]?.encoding, 'ros2msg');
  const kept: string[] = [];
  for await (const { metadata } of reader.readMetadata({ name: 'rosbag2' })) kept.push(metadata.get('serialized_metadata') ?? '');
  const inside = parseYaml(kept.at(-1) ?? '', { intAsBigInt: true }) as Metadata;
  assert.deepEqual(inside, said);
  return bag;
}

/** Runs the site until all has been said, and stops it. */
async function heard(link: string, folder: string, wanted: readonly RegExp[]): Promise<string> {
  const child = workspace.start(['run', site, '--link', link, '--for', '180s', '--bags', folder]);
  const text = { stdout: '', stderr: '' };
  const hear = (stream: keyof typeof text) => (bytes: Buffer): void => {
    text[stream] += bytes.toString();
    const isOver = /^\[\S+\] error\[/m.test(text.stderr) || wanted.every((line) => line.test(text.stdout) || line.test(text.stderr));
    if (isOver && !child.killed) child.kill('SIGINT');
  };
  child.stdout?.on('data', hear('stdout'));
  child.stderr?.on('data', hear('stderr'));
  const code = await new Promise((ended) => {
    child.once('close', ended);
  });
  const all = text.stdout + text.stderr;
  assert.equal(code, 130, all);
  for (const line of wanted) assert.match(all, line);
  return all;
}

for (const link of played('shared', 'port')) {
  test(`${link}: nodes record, make, read and play bags, which are written to disk`, watchdog, async () => {
    const folder = `kept-${link}`;
    const said = await heard(link, folder, [
      /\[recorder\]: recorded \d+ bytes\n[^]*\[recorder\]: recorded/,
      /\[simple_bag_recorder\]: recorded Hello World: \d+\n[^]*\[simple_bag_recorder\]: recorded/,
      /\[bags-\d\] .*all \d+ checks hold/,
      /\[bags-\d\] process has finished cleanly/,
      /\[generator-\d\] process has finished cleanly/,
      /\[generator_py-\d\] process has finished cleanly/,
      /played compressed/,
      /\[simple_bag_reader\]: Publish serialized data to chatter\n[^]*\[simple_bag_reader\]: Publish/,
    ]);
    assert.match(said, /\[generator_py-\d\] read 100 of synthetic, 4950 in all/);
    assert.match(said,
      /\[generator_py-\d\] Topic information: Topic: synthetic \| Type: example_interfaces\/msg\/Int32 \| Count: 100 \| Serialization Format: cdr/);
    assert.match(said, /\[generator_py-\d\] chatter at 1700000000000000001: compressed/);
    assert.match(said, /\[generator_py-\d\] refused: bags of the storage 'sqlite3'/);
    assert.match(said, /\[replayer-\d\] played from the share/);
    const nodes = (name: string): string => said.match(new RegExp(`\\[(${name}-\\d)\\]`))?.[1] ?? '';
    for (const [program, name] of [['recorder', 'my_bag'], ['recorder_py', 'py_bag']] as const) {
      const { messages } = await bagOf(folder, nodes(program), name, 'chatter', 'std_msgs/msg/String');
      assert.ok(messages.length >= 2);
      assert.match(String(messages[0]?.value), /^Hello World: \d+$/);
      assert.match(said, new RegExp(`\\[${program}-\\d\\] wrote ${folder}/${program}-\\d/${name}/metadata\\.yaml`));
    }
    for (const [program, name] of [['generator', 'big_synthetic_bag'], ['generator_py', 'big_synthetic_py']] as const) {
      const { messages } = await bagOf(folder, nodes(program), name, 'synthetic', 'example_interfaces/msg/Int32');
      assert.deepEqual(messages.map(({ value }) => value), [...Array(100).keys()]);
      assert.equal(messages.at(-1)!.logTime - messages[0]!.logTime, 99_000_000_000n);
    }
    const again = await workspace.run(['run', site, '--link', link, '--bags', folder]);
    assert.equal(again.code, 1);
    assert.match(again.stderr, /error\[R2W0721\]: bags are not written to kept-\w+: it is not empty/);
    // Bags of several files too, and those outside of the node's home.
    assert.ok(existsSync(join(workspace.root, folder, nodes('bags'), 'tmp/parts/parts_2.mcap')));
  });
}

// Guarantee, same bytes: the bags that nodes write in stepped runs of one seed
nightlyTest('two stepped runs of one seed write the same bags', watchdog, async () => {
  const bags: Map<string, string>[] = [];
  for (const folder of ['stepped-1', 'stepped-2']) {
    const { code, stderr } = await workspace.run(['run', site, '--stepped', '--seed', '7', '--for', '5s', '--bags', folder]);
    assert.equal(code, 0, stderr);
    bags.push(workspace.files(folder));
  }
  assert.deepEqual(bags[0], bags[1]);
  const names = [...bags[0]!.keys()];
  for (const name of ['my_bag_0.mcap', 'py_bag_0.mcap', 'big_synthetic_bag_0.mcap'])
    assert.ok(names.some((path) => path.endsWith(`/${name}`)), names.join('\n'));
});

for (const link of played('port', 'shared')) {
  test(`${link}: in the page the bag of a node that is stopped is listed, played and downloaded`, watchdog, async () => {
    await withTabs(browser, site, link, async (open) => {
      const layout = encodeURIComponent(
        JSON.stringify({ row: [{ column: ['nodes', 'console'] }, { column: ['bag', 'terminal'] }], sizes: [1, 1], shown: 'bag' }),
      );
      const page = await open(`#layout=${layout}`);
      page.setDefaultTimeout(patience.timeout);
      await shows(page, 'recorded Hello World: ');
      await page.getByRole('button', { name: /^Stop .*recorder_py/ }).click();
      const entry = page.getByRole('button', { name: /^py_bag_0\.mcap .*, written by a node$/ });
      await entry.waitFor();
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download py_bag_0.mcap' }).click()]);
      const { messages } = await openBag(new Uint8Array(readFileSync(await download.path())));
      assert.match(String(messages[0]?.value), /^Hello World: \d+$/);
      await entry.click();
      await page.getByRole('region', { name: 'Play py_bag_0.mcap' }).getByRole('button', { name: 'Play', exact: true }).waitFor();
      await page.locator('.terminal-input input').fill('ros2 bag info py_bag');
      await page.locator('.terminal-input input').press('Enter');
      await shows(page, 'Topic: chatter | Type: std_msgs/msg/String | Count: ');
      // A bag that was written before the panel was opened is listed as well.
      await page.getByRole('button', { name: /^big_synthetic_bag_0\.mcap / }).waitFor();
    });
  });
}
