// Bags over a packed site with example 01's talker and listener and a turtlesim: the commands of `ros2 bag` on both links and
// from a shell; in Chromium what the page records is downloaded, read by others, dropped on it and heard by the listener.

// Compatibility, works: `ros2 bag record`, `info` and `play`, in the page's terminal and as `ros2wasm ros2 SITE bag ...`, with
// upstream's output

// Compatibility, differs: `ros2 bag record` -> it writes one file (`-o NAME` becomes NAME.mcap), not a folder with metadata.yaml; there
// are no keys to pause it, and services are recorded by their event topics only when those are named

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { parse } from '@foxglove/rosmsg';
import { MessageReader } from '@foxglove/rosmsg2-serialization';
import { McapIndexedReader } from '@mcap/core';
import { type Browser, chromium, type Page } from 'playwright-core';
import { Recorder } from '../../../runtime/site/bag/recorder.ts';
import { bagFiles, textOfFile } from '../../../runtime/site/ros2cli/shell_files.ts';
import { runCommand } from '../../../runtime/site/ros2cli/run.ts';
import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import type { Session } from '../../../runtime/site/contract/session.ts';
import { MemorySink, until } from '../../unit/bag/bag_parts.ts';
import { FakeSession, stringBytes } from '../../unit/ui/fake_session.ts';
import { played } from '../../support/nightly.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { dropFile } from '../support/drop_file.ts';
import { finished, PackWorkspace } from '../support/pack_workspace.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 400_000 };
const patience = { timeout: 120_000 };
const entry = new URL('../../../runtime/site/session/headless.ts', import.meta.url);
let workspace: PackWorkspace;
let site: string;
let browser: Browser;

before(async () => {
  workspace = new PackWorkspace('shared');
  cpSync(resolve(import.meta.dirname, '../../../examples/01_talker_listener/src'), join(workspace.root, 'src'), { recursive: true });
  mkdirSync(join(workspace.root, 'bags'));
  writeFileSync(join(workspace.root, 'bags/walk.mcap'), await oneMessage('/topic', 'from the bag'));
  workspace.write('workspace.yaml', `schema: 1
name: bags
ui: {bags: [bags/walk.mcap]}
packages: [src/*]
dependencies: [turtlesim]
launch:
  - {package: tutorial_talker, executable: talker}
  - {package: tutorial_listener, executable: listener}
  - {package: turtlesim, executable: turtlesim_node}
`);
  const packed = await workspace.run(['pack', '--quick', 'workspace.yaml', '--output', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  site = join(workspace.root, 'site');
  browser = await chromium.launch(chromiumOptions());
}, { timeout: 500_000 });

after(async () => {
  await browser.close();
  workspace.close();
});

/** A bag with one std_msgs/msg/String. */
async function oneMessage(topic: string, text: string): Promise<Uint8Array> {
  const session = new FakeSession({ nodes: [] });
  const publisher = session.node().publisher(topic, 'std_msgs/msg/String');
  const sink = new MemorySink();
  const recorder = await Recorder.begin(session, sink, { wants: () => true });
  await until(() => publisher.matched() === 1);
  publisher.publish(stringBytes(text));
  await until(() => recorder.messages === 1);
  await recorder.stop();
  session.close();
  return sink.bytes();
}

interface Running {
  readonly out: string[];
  readonly warned: string[];
  readonly code: Promise<number>;
  stop(): void;
}

function start(session: Session, ...words: string[]): Running {
  const abort = new AbortController();
  const [out, warned]: [string[], string[]] = [[], []];
  const code = runCommand(session, ['bag', ...words], {
    signal: abort.signal,
    bags: bagFiles,
    readText: textOfFile,
    takeInput: () => undefined,
    print: (text) => void out.push(text),
    warn: (text) => void warned.push(text),
  });
  return { out, warned, code, stop: () => abort.abort() };
}

interface Contents {
  readonly reader: McapIndexedReader;
  /** As values, in order. */
  messages(topic: string): Promise<Record<string, unknown>[]>;
}

/** As others read it. */
async function contents(bytes: Uint8Array): Promise<Contents> {
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: () => Promise.resolve(BigInt(bytes.length)),
      read: (offset, size) => Promise.resolve(bytes.slice(Number(offset), Number(offset + size))),
    },
  });
  return {
    reader,
    async messages(topic) {
      const channel = [...reader.channelsById.values()].find((one) => one.topic === topic);
      const schema = reader.schemasById.get(channel?.schemaId ?? 0);
      assert.ok(channel !== undefined && schema !== undefined, `${topic} is not in the bag`);
      const decode = new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true }));
      const found: Record<string, unknown>[] = [];
      for await (const { data } of reader.readMessages({ topics: [topic] })) found.push(decode.readMessage(data) as Record<string, unknown>);
      return found;
    },
  };
}

for (const link of played('port', 'shared')) {
  test(`${link}: record, info and play`, watchdog, async () => {
    const folder = mkdtempSync(join(workspace.root, 'bags-'));
    const { session, close } = await openHeadless(site, link, entry);
    try {
      session.startAll();
      await session.settled;
      const bag = join(folder, 'run');
      const recording = start(session, 'record', '-o', bag, '/topic', '/turtle1/pose');
      let came = 0;
      await until(() => recording.warned.some((line) => line.endsWith("Subscribed to topic '/topic'")));
      const counted = session.node().subscription('/topic', 'std_msgs/msg/String', {}, () => {
        came += 1;
      });
      await until(() => came >= 3);
      recording.stop();
      assert.equal(await recording.code, 0);
      counted.close();
      const said = recording.warned.map((line) => line.replace(/^\[INFO\] \[\d+\.\d{9}\] \[rosbag2_recorder\]: /, ''));
      assert.equal(said[0], 'Listening for topics...');
      assert.deepEqual(said.slice(-2), ['Pausing recording.', 'Recording stopped']);
      assert.ok(said.includes('Recording...'));

      const info = start(session, 'info', `${bag}.mcap`);
      assert.equal(await info.code, 0, info.warned.join('\n'));
      assert.match(info.out.join('\n'), new RegExp(
        ['^', `Files: {13}${bag}\\.mcap`, 'Bag size: {10}\\d+\\.\\d KiB', 'Storage id: {8}mcap', 'ROS Distro: {8}jazzy', 'Duration: {10}\\d+\\.\\d{9}s',
          'Start: {13}[A-Z][a-z]{2} [ \\d]\\d \\d{4} \\d\\d:\\d\\d:\\d\\d\\.\\d{9} \\(\\d{10}\\.\\d{9}\\)',
          'End: {15}[A-Z][a-z]{2} [ \\d]\\d \\d{4} \\d\\d:\\d\\d:\\d\\d\\.\\d{9} \\(\\d{10}\\.\\d{9}\\)', 'Messages: {10}\\d+',
          'Topic information: Topic: /topic \\| Type: std_msgs/msg/String \\| Count: \\d+ \\| Serialization Format: cdr',
          ' {19}Topic: /turtle1/pose \\| Type: turtlesim/msg/Pose \\| Count: \\d+ \\| Serialization Format: cdr', 'Service: {11}0', 'Service information: ',
          '$'].join('\n'),
      ));
      const names = start(session, 'info', '-t', `${bag}.mcap`);
      await names.code;
      assert.deepEqual(names.out, ['/topic', '/turtle1/pose']);

      const { messages } = await contents(new Uint8Array(readFileSync(`${bag}.mcap`)));
      const texts = (await messages('/topic')).map(({ data }) => String(data));
      assert.ok(texts.length >= 3);
      assert.ok(Math.abs(Number((await messages('/turtle1/pose'))[0]?.['x']) - 5.544445) < 1e-4);

      const heard: string[] = [];
      const listening = session.node().subscription('/again', 'std_msgs/msg/String', { depth: 100 }, (bytes) =>
        void heard.push(new TextDecoder().decode(bytes.subarray(8, -1))));
      const played = start(session, 'play', `${bag}.mcap`, '-r', '20', '--topics', '/topic', '--remap', '/topic:=/again');
      assert.equal(await played.code, 0, played.warned.join('\n'));
      await until(() => heard.length === texts.length);
      assert.deepEqual(heard, texts);
      assert.match(played.warned[0]!, /^\[INFO\] \[\d+\.\d{9}\] \[rosbag2_player\]: Set rate to 20$/);
      listening.close();

      const none = start(session, 'info', join(folder, 'none'));
      assert.equal(await none.code, 2);
      assert.match(none.warned.join(), /argument bag_path: Bag path '.*none' does not exist!$/);
      const again = start(session, 'record', '-o', bag, '-a');
      assert.equal(await again.code, 1);
      assert.match(again.warned.join(), /already exists\.$/);
      const nothing = start(session, 'record');
      assert.equal(await nothing.code, 1);
      assert.match(nothing.warned.join(), /^\[ERROR\] \[ros2bag\]: Need to specify at least one option out of --all/);
      const wrong = start(session, 'play', join(site, 'index.html'));
      assert.equal(await wrong.code, 1);
      assert.match(wrong.warned.join(), /^error\[R2W0740\]/);
      assert.equal(session.graph().nodes.find(({ name }) => name === session.node().name)?.subscriptions.length, 0, 'commands leave nothing behind');
    } finally {
      close();
    }
  });
}

// Compatibility, works: bags that the manifest packs into a site (`ui: bags:`)
test('a bag of the manifest is a file of the site, with its hash', watchdog, () => {
  const { ui, files } = JSON.parse(readFileSync(join(site, 'site.json'), 'utf8')) as {
    ui: unknown;
    files: { path: string; sha256: string; reason: string; }[];
  };
  assert.deepEqual(ui, { bags: ['bags/bags/walk.mcap'] });
  const bytes = readFileSync(join(workspace.root, 'bags/walk.mcap'));
  const listed = files.find(({ path }) => path === 'bags/bags/walk.mcap');
  assert.equal(listed?.sha256, createHash('sha256').update(bytes).digest('hex'));
  assert.equal(listed?.reason, '`ui: bags:` of the manifest');
  assert.deepEqual(readFileSync(join(site, 'bags/bags/walk.mcap')), bytes);
});

test('from a shell: Ctrl-C ends a recording, which is whole', watchdog, async () => {
  const child = workspace.start(['ros2', site, 'bag', 'record', '-o', 'shell', '-a']);
  const ended = finished(child);
  let said = '';
  child.stderr!.on('data', (text: Buffer) => {
    const before = said;
    said += text.toString();
    if (/Recording\.\.\./.test(said) && !/Recording\.\.\./.test(before)) child.kill('SIGINT');
  });
  const { code } = await ended;
  assert.equal(code, 0, said);
  const { reader } = await contents(new Uint8Array(workspace.read('shell.mcap')));
  const topics = [...reader.channelsById.values()].map(({ topic }) => topic);
  assert.ok(['/rosout', '/topic', '/turtle1/pose'].every((topic) => topics.includes(topic)), topics.join());
  const info = await workspace.run(['ros2', site, 'bag', 'info', 'shell.mcap']);
  assert.equal(info.code, 0, info.stderr);
  assert.match(info.stdout, /^\nFiles: {13}shell\.mcap\n/);
});

/** Says so when the listener has printed it so often. */
const heardTimes = (page: Page, text: string, times: number): Promise<unknown> =>
  page.waitForFunction(([wanted, count]) => (document.querySelector('.panel-console')?.textContent ?? '').split(wanted).length > count, [text, times] as const,
    patience);

for (const link of played('shared', 'port')) {
  test(`${link}: the page records talker and turtlesim; dropped on it, the listener hears the bag`, watchdog, async () => {
    await withTabs(browser, site, link, async (open) => {
      const layout = encodeURIComponent(
        JSON.stringify({ row: [{ column: ['nodes', 'console'] }, { column: ['bag', 'terminal'] }], sizes: [1, 1], shown: 'bag' }),
      );
      const page = await open(`#layout=${layout}`);
      page.setDefaultTimeout(patience.timeout);
      await shows(page, "Publishing: 'Hello, world! 0'");
      await page.getByRole('button', { name: 'Record', exact: true }).click();
      await page.waitForFunction(() =>
        Number(/(\d+) messages of/.exec(document.querySelector('.bag-recording')?.textContent?.replaceAll('\u202f', '') ?? '')?.[1]) > 150
      );
      await page.getByRole('button', { name: 'Stop recording' }).click();
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: /^Download rosbag2_/ }).click()]);
      const bytes = new Uint8Array(readFileSync(await download.path()));
      const { reader, messages } = await contents(bytes);
      assert.equal(reader.header.profile, 'ros2');
      const texts = (await messages('/topic')).map(({ data }) => String(data));
      assert.ok(texts.length > 0);
      assert.ok((await messages('/turtle1/pose')).length > 50);

      await page.locator('.terminal-input input').fill('ros2 bag info run');
      await page.getByRole('button', { name: 'Stop all' }).click();
      await page.getByRole('button', { name: /^Start .*listener/ }).click();
      await dropFile(page, 'run.mcap', bytes);
      const player = page.getByRole('region', { name: 'Play run.mcap' });
      await player.getByRole('button', { name: 'Play', exact: true }).click();
      await heardTimes(page, `I heard: '${texts.at(-1)}'`, 1);
      await page.locator('.terminal-input input').press('Enter');
      await shows(page, 'Topic: /turtle1/pose | Type: turtlesim/msg/Pose | Count: ');

      // The author's own, which is a file of the site with its hash.
      await page.getByRole('button', { name: /^walk\.mcap .*, part of the site$/ }).click();
      await page.getByRole('region', { name: 'Play walk.mcap' }).getByRole('button', { name: 'Play', exact: true }).click();
      await shows(page, "I heard: 'from the bag'");
    });
  });
}
