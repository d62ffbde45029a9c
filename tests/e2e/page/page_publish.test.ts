// The panel that publishes, in Chromium on a real graph: form, YAML, once, at a rate, and what is refused.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

const scene = (state: unknown): string =>
  `publish#layout=${encodeURIComponent(JSON.stringify({ row: ['topics', { publish: state }], sizes: [1, 2], shown: 'publish' }))}`;
const twist = { topic: '/cmd_vel', type: 'geometry_msgs/msg/Twist', rate: 50 };

/** Counts what comes on a topic, as sizes of messages with their x of the first vector. */
async function listen(page: Page, topic: string, type: string): Promise<void> {
  await page.evaluate(
    ([name, of]) => {
      const heard: number[] = [];
      Object.assign(globalThis, { got: heard });
      fake.node().subscription(name, of, { depth: 100 }, (bytes) => heard.push(new DataView(bytes.buffer, bytes.byteOffset).getFloat64(4, true)));
    },
    [topic, type] as const,
  );
}

const got = (page: Page): Promise<number[]> => page.evaluate(() => (globalThis as unknown as { got: number[]; }).got);
const heard = (page: Page, most: number): Promise<unknown> =>
  page.waitForFunction((count) => (globalThis as unknown as { got: number[]; }).got.length >= count, most);

test('a form made from the type publishes once, and the same as YAML', () =>
  stage.on(scene(twist), {}, async (page) => {
    await listen(page, twist.topic, twist.type);
    const x = page.getByRole('textbox', { name: 'linear.x of /cmd_vel' });
    await x.fill('1.5');
    await page.screenshot({ path: join(OUTPUT, 'publish.png') });
    await page.getByRole('button', { name: 'Publish once' }).click();
    await heard(page, 1);
    await page.getByRole('button', { name: 'YAML' }).click();
    const yaml = page.getByRole('textbox', { name: 'YAML of the message for /cmd_vel' });
    assert.match(await yaml.inputValue(), /^linear:\n {2}x: 1\.5\n/);
    await yaml.fill('{linear: {x: -2}}');
    await page.getByRole('button', { name: 'Publish once' }).click();
    await heard(page, 2);
    await page.getByRole('button', { name: 'Form' }).click();
    await x.waitFor();
    assert.equal(await x.inputValue(), '-2');
    assert.deepEqual(await got(page), [1.5, -2]);
    await page.getByText('2 messages sent').waitFor();
    await expectAccessible(page);
  }));

test('what does not fit is refused with its place, and nothing is sent', () =>
  stage.on(scene(twist), {}, async (page) => {
    await page.getByRole('textbox', { name: 'angular.z of /cmd_vel' }).fill('fast');
    await page.getByRole('textbox', { name: 'angular.z of /cmd_vel' }).press('Enter');
    await page.getByRole('alert').getByText(/^angular\.z: /).waitFor();
    await page.getByText('0 messages sent').waitFor();
    await page.getByRole('combobox', { name: 'Type' }).fill('no/msg/Such');
    await page.getByText('the site has no definition of no/msg/Such').waitFor();
    await page.getByRole('combobox', { name: 'Type' }).fill('std_msgs/msg/Header');
    await page.getByRole('checkbox', { name: 'stamp of /cmd_vel is the time of sending' }).check();
    await expectAccessible(page);
  }));

test('at a rate it goes on, until it is stopped or the topic is another one', () =>
  stage.on(scene(twist), {}, async (page) => {
    await listen(page, twist.topic, twist.type);
    await page.getByRole('textbox', { name: 'linear.x of /cmd_vel' }).fill('3');
    const repeat = page.getByRole('button', { name: 'Publish at the rate' });
    await repeat.click();
    await heard(page, 5);
    // With another topic the publisher is gone, and nothing goes on there.
    await page.getByRole('combobox', { name: 'Topic' }).fill('/other');
    await repeat.waitFor();
    await page.waitForFunction(() => fake.broker.link.records().every(({ kind, name }) => kind !== 1 || name !== '/cmd_vel'));
    const before = (await got(page)).length;
    await listen(page, '/other', twist.type);
    await page.getByRole('textbox', { name: 'linear.x of /other' }).fill('4');
    await repeat.click();
    await heard(page, 3);
    await page.getByRole('button', { name: 'Stop publishing' }).click();
    assert.ok((await got(page)).every((value) => value === 4), String(before));
  }));

test('a phone shows the form, and axe finds nothing in the dark', () =>
  stage.on(scene(twist), { ...phone, colorScheme: 'dark' }, async (page) => {
    await page.getByRole('textbox', { name: 'linear.x of /cmd_vel' }).waitFor();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth), false);
    await expectAccessible(page);
  }));
