// The topics panel as a tool in Chromium: messages held and compared, fields chosen for their path or a plot, messages
// as commands, QoS of both sides, and pairs that do not fit.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, focused, phone } from '../support/page_stage.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

/** A LaserScan: the angle, and as many ranges. */
async function scan(page: Page, angle: number, ranges: readonly number[], frame = 'laser'): Promise<void> {
  await page.evaluate(
    ([least, list, name]) => {
      const text = new TextEncoder().encode(`${name}\0`);
      const at = (16 + text.length + 3) & ~3;
      const bytes = new Uint8Array(at + 12 + list.length * 4);
      const view = new DataView(bytes.buffer);
      bytes[1] = 1;
      view.setInt32(4, 1_700_000_000, true);
      view.setUint32(12, text.length, true);
      bytes.set(text, 16);
      view.setFloat32(at, least, true);
      view.setFloat32(at + 4, 3, true);
      view.setUint32(at + 8, list.length, true);
      list.forEach((range, index) => view.setFloat32(at + 12 + index * 4, range, true));
      fake.publish('/scan', bytes);
      fake.setTopics([{ name: '/scan', type: 'sensor_msgs/msg/LaserScan', count: fake.lastMessage('/scan')?.count ?? 0 }]);
    },
    [angle, ranges, frame] as const,
  );
}

const openScan = async (page: Page): Promise<void> => {
  await scan(page, 1, [1, 2, 3]);
  await page.getByRole('button', { name: /^\/scan/ }).click();
  await page.locator('.tree').getByText('angle_min:').waitFor();
};

const clipboard = { permissions: ['clipboard-read', 'clipboard-write'] };
const copied = (page: Page): Promise<string> => page.evaluate(() => navigator.clipboard.readText());

test('what has changed since the message before is marked, and can be all that is shown', () =>
  stage.on('quiet', {}, async (page) => {
    await openScan(page);
    const tree = page.locator('.tree');
    await page.getByRole('checkbox', { name: 'Mark changes' }).check();
    await page.getByText('There is no message before this one.').waitFor();
    await scan(page, 1, [1, 2.5, 3]);
    await page.getByText('compared with the message before').waitFor();
    assert.deepEqual(await tree.locator('.tree-changed').allInnerTexts(), ['- 2.5 was 2.0']);
    // The branch says that something in it has changed, also where it is closed.
    assert.match(await tree.locator('summary').filter({ hasText: 'ranges' }).innerText(), /changed/);
    assert.doesNotMatch(await tree.locator('summary').filter({ hasText: 'header' }).innerText(), /changed/);
    await tree.getByText('angle_max:').waitFor();
    await page.getByRole('checkbox', { name: 'Only changes' }).check();
    await tree.getByText('angle_max:').waitFor({ state: 'detached' });
    assert.equal((await tree.innerText()).replace(/\s+/g, ' '), 'ranges: 3 × float32 changed - 1: 2.5 was 2.0');
    await scan(page, -1, [1, 2.5, 3], 'lidar');
    await tree.getByText('was laser').waitFor();
    assert.deepEqual(await tree.locator('.tree-changed').allInnerTexts(), ['frame_id: lidar was laser', 'angle_min: -1.0 was 1.0']);
    await scan(page, -1, [1, 2.5, 3], 'lidar');
    await page.getByText('Nothing has changed. (compared with the message before)').waitFor();
    // Some came that were not shown.
    await page.evaluate(() => {
      const last = fake.lastMessage('/scan');
      if (last !== undefined) { for (let i = 0; i < 2; i += 1) fake.publish('/scan', last.bytes); }
    });
    await scan(page, 7, [1, 2.5, 3], 'lidar');
    await page.getByText('compared with the one 3 messages before, which was shown').waitFor();
    await expectAccessible(page);
  }));

test('messages with a stamp say how late they were', () =>
  stage.on('quiet', {}, async (page) => {
    /** ms after its stamp; null: nobody has set that. */
    const late = (ms: number | null): Promise<void> =>
      page.evaluate((delay) => {
        const bytes = new Uint8Array(32);
        const view = new DataView(bytes.buffer);
        bytes[1] = 1;
        if (delay !== null) {
          const at = Date.now() - delay;
          view.setInt32(4, Math.floor(at / 1000), true);
          view.setUint32(8, (at % 1000) * 1e6, true);
        }
        view.setUint32(12, 1, true);
        fake.publish('/scan', bytes);
        fake.setTopics([{ name: '/scan', type: 'sensor_msgs/msg/LaserScan', count: fake.lastMessage('/scan')?.count ?? 0 }]);
      }, ms);
    await late(null);
    await page.getByRole('button', { name: /^\/scan/ }).click();
    const facts = page.locator('.message-facts').first();
    await facts.getByText(/, 32 bytes$/).waitFor();
    await late(250);
    await facts.getByText(/, delay 2[5-9]\d\sms$/).waitFor();
    await late(-2500);
    await facts.getByText(/, delay -1\.[01]\d\ss \(-2\.[45]\d\ss to 2[5-9]\d\sms\)$/).waitFor();
  }));

test('a message that is held stays, with what it is compared with, while others come', () =>
  stage.on('quiet', {}, async (page) => {
    await openScan(page);
    await page.getByRole('checkbox', { name: 'Mark changes' }).check();
    await scan(page, 2, [1, 2, 3]);
    const tree = page.locator('.tree');
    await tree.getByText('was 1.0').waitFor();
    await page.getByRole('button', { name: 'Hold this message' }).click();
    await scan(page, 3, [9]);
    await page.getByRole('button', { name: 'Show the newest message again' }).waitFor();
    assert.deepEqual(await tree.locator('.tree-changed').allInnerTexts(), ['angle_min: 2.0 was 1.0']);
    await page.getByRole('button', { name: 'Show the newest message again' }).click();
    await tree.getByText('angle_min: 3.0', { exact: false }).first().waitFor();
  }));

test('a field is chosen by keyboard; its path is copied, and Plot or States open with it', () =>
  stage.on('quiet', clipboard, async (page) => {
    await openScan(page);
    await page.locator('.tree').focus();
    for (let i = 0; i < 6; i += 1) await page.keyboard.press('ArrowDown');
    assert.equal(await focused(page), '/scan.angle_min');
    await page.keyboard.press('ArrowUp');
    assert.equal(await focused(page), '/scan.header.frame_id');
    await page.keyboard.press('Enter');
    const bar = page.getByRole('group', { name: 'Field /scan.header.frame_id' });
    // A text has states and no numbers.
    await bar.getByRole('button', { name: 'Show its states' }).waitFor();
    assert.equal(await bar.getByRole('button', { name: 'Plot it' }).count(), 0);
    await page.getByRole('button', { name: '/scan.ranges[1]' }).click();
    const range = page.getByRole('group', { name: 'Field /scan.ranges[1]' });
    await range.getByRole('button', { name: 'Copy its path' }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    assert.equal(await copied(page), '/scan.ranges[1]');
    await range.getByRole('button', { name: 'Plot it' }).click();
    await page.getByRole('button', { name: 'Remove /scan.ranges[1]' }).waitFor();
    assert.equal(await page.getByRole('tab', { name: /^Plot/ }).getAttribute('aria-selected'), 'true');
  }));

test('a message is copied as the command that publishes it', () =>
  stage.on('quiet', clipboard, async (page) => {
    await openScan(page);
    await page.getByRole('button', { name: 'Copy a command of ros2 for /scan' }).click();
    await page.getByRole('menuitem', { name: 'ros2 topic pub, with this message' }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    assert.equal(
      await copied(page),
      `ros2 topic pub --once /scan sensor_msgs/msg/LaserScan '{header: {stamp: {sec: 1700000000, nanosec: 0}, frame_id: "laser"}, angle_min: 1.0, angle_max: 3.0, ranges: [1.0, 2.0, 3.0]}'`,
    );
  }));

const BESIDE = `graph#layout=${encodeURIComponent(JSON.stringify({ row: ['topics', 'graph'] }))}`;

const misfit = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const { graphNode, endpoint } = globalThis as unknown as {
      graphNode: (name: string, process: string, has: object) => never;
      endpoint: (name: string, type: string) => { readonly qos: object; };
    };
    const scan = endpoint('/robot/scan', 'sensor_msgs/msg/LaserScan');
    fake.setGraph({
      nodes: [
        graphNode('/robot/laser', 'laser-1', { publishers: [{ ...scan, qos: { ...scan.qos, reliability: 'best_effort', deadlineNs: 1e8 } }] }),
        graphNode('/planner', 'planner-3', { subscriptions: [scan] }),
        graphNode('/safety', 'safety-5', { subscriptions: [{ ...scan, qos: { ...scan.qos, reliability: 'best_effort', depth: 5 } }] }),
      ],
    });
  });

for (const colorScheme of ['light', 'dark'] as const) {
  test(`QoS of both sides, and a pair that does not fit with its policy, in Topics and Graph, ${colorScheme}`, () =>
    stage.on(BESIDE, { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await misfit(page);
      const row = page.getByRole('button', { name: /^\/robot\/scan/ });
      await row.getByText('1 pair does not fit').waitFor();
      assert.equal(await page.locator('.topic-misfits').count(), 1);
      await row.click();
      const parts = page.getByRole('list', { name: 'Who takes part in /robot/scan' });
      await parts.getByRole('listitem').first().waitFor();
      assert.deepEqual((await parts.getByRole('listitem').allInnerTexts()).map((text) => text.replace(/\s+/g, ' ')), [
        '/robot/laser publishes best effort, volatile, keep last 10, deadline 100 ms, no lifespan, automatic liveliness, no lease',
        '/planner subscribes reliable, volatile, keep last 10, no deadline, no lifespan, automatic liveliness, no lease',
        '/safety subscribes best effort, volatile, keep last 5, no deadline, no lifespan, automatic liveliness, no lease',
      ]);
      const told = '/planner gets nothing from /robot/laser: reliability (it wants reliable, best effort is offered)';
      await page.locator('.panel-topics').getByText(told).waitFor();
      await page.locator('.graph-box[aria-label^="Topic /robot/scan"]').click();
      await page.locator('.panel-graph').getByText(told).waitFor();
      await page.screenshot({ path: join(OUTPUT, `topics_${colorScheme}.png`) });
      await expectAccessible(page);
    }));
}

test('an opened topic fits a phone', () =>
  stage.on('quiet', { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await page.getByRole('tab', { name: 'Topics' }).click();
    await openScan(page);
    await page.getByRole('checkbox', { name: 'Mark changes' }).check();
    await scan(page, 2, [1, 2, 3]);
    await page.getByRole('button', { name: '/scan.angle_min' }).click();
    await page.getByRole('group', { name: 'Field /scan.angle_min' }).waitFor();
    await page.screenshot({ path: join(OUTPUT, 'topics_phone.png') });
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
  }));
