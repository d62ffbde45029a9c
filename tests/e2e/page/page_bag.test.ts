// The panel for bags in Chromium, over messages that really pass a graph: recorded, downloaded, read back, dropped and
// played; keyboard, axe-core, 320 px, and files that are no bags.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { parse } from '@foxglove/rosmsg';
import { MessageReader } from '@foxglove/rosmsg2-serialization';
import { McapIndexedReader } from '@mcap/core';
import type { Page } from 'playwright-core';
import { Recorder } from '../../../runtime/site/bag/recorder.ts';
import { MemorySink, until } from '../../unit/bag/bag_parts.ts';
import { FakeSession } from '../../unit/ui/fake_session.ts';
import { dropFile } from '../support/drop_file.ts';
import { PageStage, expectAccessible } from '../support/page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "signals".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
  // The lengths of the messages that a test receives.
  var lengths: number[];
}

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

const scene = (panel: unknown): string => `signals#layout=${encodeURIComponent(JSON.stringify({ row: ['topics', panel], sizes: [1, 2], shown: 'bag' }))}`;
const SCENE = scene('bag');
const SINE = { value: 0.5, other: 1, list: [1, 2], mode: 'idle', big: 7 };

/** Records as many messages on /sine, and gives the file that the page offers. */
async function record(page: Page, count: number): Promise<Buffer> {
  await page.getByRole('button', { name: 'Record', exact: true }).click();
  await page.getByRole('button', { name: 'Stop recording' }).waitFor();
  await page.evaluate((message) => {
    send('/sine', 'demo/msg/Sine', message);
    fake.graphChanged();
  }, SINE);
  await page.waitForFunction(() => heard('/sine') > 0);
  await page.evaluate(([message, times]) => {
    for (let i = 0; i < times; i += 1) send('/sine', 'demo/msg/Sine', { ...message, value: i });
  }, [SINE, count] as const);
  await page.waitForFunction((most) => document.querySelector('.bag-recording')?.textContent?.includes(`, ${most} messages of `) === true, count);
  await page.getByRole('button', { name: 'Stop recording' }).click();
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: /^Download rosbag2_/ }).click()]);
  assert.match(download.suggestedFilename(), /^rosbag2_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d\.mcap$/);
  return readFileSync(await download.path());
}

// Compatibility, works: recording of topics to MCAP in the page, and playing of bags that are dropped on it
test('what is recorded is downloaded, read by others, dropped on the page and heard again', () =>
  stage.on(SCENE, {}, async (page) => {
    const bytes = await record(page, 20);
    const reader = await McapIndexedReader.Initialize({
      readable: {
        size: () => Promise.resolve(BigInt(bytes.length)),
        read: (offset, size) => Promise.resolve(new Uint8Array(bytes.subarray(Number(offset), Number(offset + size)))),
      },
    });
    const schema = [...reader.schemasById.values()].find(({ name }) => name === 'demo/msg/Sine')!;
    const decode = new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true }));
    const values: number[] = [];
    for await (const { data } of reader.readMessages({ topics: ['/sine'] })) values.push((decode.readMessage(data) as { value: number; }).value);
    assert.deepEqual(values.slice(-20), Array.from({ length: 20 }, (_, i) => i));

    await page.getByRole('button', { name: /^Forget rosbag2_/ }).click();
    await dropFile(page, 'run.mcap', bytes);
    const player = page.getByRole('region', { name: 'Play run.mcap' });
    await player.getByText(/\/sine/).waitFor();
    await player.getByRole('textbox', { name: 'Name that /sine is published under' }).fill('/again');
    await player.getByRole('textbox', { name: 'Name that /sine is published under' }).press('Enter');
    await page.evaluate(() => {
      globalThis.lengths = [];
      fake.node().subscription('/again', 'demo/msg/Sine', { depth: 100 }, (message) => void globalThis.lengths.push(message.length));
    });
    await player.getByRole('button', { name: 'Play', exact: true }).click();
    await page.waitForFunction((count) => globalThis.lengths.length === count, values.length);
    // It is over, and can be played again.
    await player.getByRole('button', { name: 'Play', exact: true }).waitFor();
  }));

test('keyboard alone: seek, speed, loop; and axe-core finds nothing in both themes and at 320 px', async () => {
  for (const colorScheme of ['light', 'dark'] as const) {
    await stage.on(SCENE, { colorScheme, viewport: { width: 320, height: 740 } }, async (page) => {
      await record(page, 5);
      await page.getByRole('button', { name: /^rosbag2_/ }).focus();
      await page.keyboard.press('Enter');
      const slider = page.getByRole('slider', { name: 'Place in the bag' });
      await slider.focus();
      await page.keyboard.press('End');
      await page.waitForFunction(() => {
        const [place, whole] = (document.querySelector('.bag-time')?.textContent ?? '').split(' of ');
        return place === whole;
      });
      await page.keyboard.press('Home');
      await page.waitForFunction(() => document.querySelector('.bag-time')?.textContent?.startsWith('0.0 s of') === true);
      await page.getByRole('combobox', { name: 'Speed', exact: true }).selectOption('0.1');
      await page.getByRole('checkbox', { name: 'Loop' }).focus();
      await page.keyboard.press('Space');
      await page.getByRole('button', { name: 'Play', exact: true }).focus();
      await page.keyboard.press('Enter');
      await page.getByRole('button', { name: 'Pause', exact: true }).waitFor();
      await expectAccessible(page);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320);
    });
  }
});

test('a bag of the site plays by itself, where its panel says so, with types that the site does not have', async () => {
  const session = new FakeSession({ nodes: [], interfaces: new Map([['old/msg/Step', 'old/Length length'], ['old/msg/Length', 'float32 metres']]) });
  const steps = session.node().publisher('/steps', 'old/msg/Step');
  const sink = new MemorySink();
  const recorder = await Recorder.begin(session, sink, { wants: () => true });
  await until(() => steps.matched() === 1);
  steps.publish(Uint8Array.from([0, 1, 0, 0, 0, 0, 32, 63]));
  await until(() => recorder.messages === 1);
  await recorder.stop();
  session.close();
  mkdirSync(`${stage.folder}/bags`);
  writeFileSync(`${stage.folder}/bags/walk.mcap`, sink.bytes());
  const panel = { bag: { file: 'walk.mcap', play: true, loop: true } };
  const layout = JSON.stringify({ column: [panel, 'terminal'], shown: 'bag' });
  await stage.on(`bagged#layout=${encodeURIComponent(layout)}`, {}, async (page) => {
    await page.getByRole('button', { name: /^walk\.mcap .*, part of the site$/ }).waitFor();
    await page.getByRole('button', { name: 'Pause', exact: true }).waitFor();
    await page.waitForFunction(() => fake.graph().nodes.some(({ publishers }) => publishers.some(({ name }) => name === '/steps')));
    await page.getByRole('textbox', { name: 'Command' }).fill('ros2 topic echo --once /steps');
    await page.getByRole('textbox', { name: 'Command' }).press('Enter');
    await page.getByText('metres: 0.625').waitFor();
  });
});

test('what is not a bag says so, and a cut one plays what is there', () =>
  stage.on(SCENE, {}, async (page) => {
    const bytes = await record(page, 3);
    await dropFile(page, '<img src=x onerror=alert(1)>.mcap', Buffer.from('nothing of that kind'));
    await page.getByText('error[R2W0740]').waitFor();
    await dropFile(page, 'cut.mcap', bytes.subarray(0, bytes.length - 30));
    await page.getByText(/Not all of this bag can be read/).waitFor();
    await page.evaluate(() => {
      globalThis.lengths = [];
      fake.node().subscription('/sine', 'demo/msg/Sine', { depth: 100 }, (message) => void globalThis.lengths.push(message.length));
    });
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    await page.waitForFunction(() => globalThis.lengths.length >= 3);
  }));

test('a file that is dropped where no panel for bags is opens one', () =>
  stage.on('signals', {}, async (page) => {
    await dropFile(page, 'some.mcap', Buffer.from('no'));
    await page.getByText('error[R2W0740]').waitFor();
  }));
