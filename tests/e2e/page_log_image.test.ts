// The log and image panels in Chromium, with messages that pass a real graph.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible } from './page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "signals".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
}

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

const withPanels = (layout: unknown): string =>
  `signals#layout=${encodeURIComponent(JSON.stringify(layout))}`;

const kMarkup = '<img src=x onerror="document.title=\'owned\'">';

async function log(page: Page): Promise<void> {
  const send = (level: number, name: string, msg: string): Promise<void> =>
    page.evaluate(
      ([number, node, text]) =>
        globalThis.send('/rosout', 'rcl_interfaces/msg/Log', {
          stamp: { sec: 1700000000, nanosec: 5 }, level: number, name: node, msg: text, file: '', function: '', line: 0,
        }),
      [level, name, msg] as const,
    );
  await send(20, 'first', 'before anybody listens');
  await page.waitForFunction(() => heard('/rosout') > 0);
  await send(20, 'robot.drive', 'wheels turn');
  await send(30, 'robot.laser', 'a beam is late');
  await send(50, 'robot.drive', kMarkup);
}

test('the log shows all nodes, by level, node and text', () =>
  stage.on(withPanels('log'), {}, async (page) => {
    await log(page);
    const lines = page.getByRole('log', { name: 'Log' });
    await lines.getByText('wheels turn').waitFor();
    await lines.getByText(kMarkup).waitFor();
    assert.match(await lines.innerText(), /\[INFO\] \[1700000000\.000000005\] \[robot\.drive\]: wheels turn/);
    // Where: only those that say so.
    await page.evaluate(() => globalThis.send('/rosout', 'rcl_interfaces/msg/Log', {
      stamp: { sec: 1700000001, nanosec: 0 }, level: 20, name: 'robot.arm', msg: 'arm up', file: 'src/arm.cpp', function: 'lift', line: 42,
    }));
    await lines.getByText('[robot.arm]: arm up', { exact: true }).or(lines.locator('.line', { hasText: /arm up$/ })).first().waitFor();
    await page.getByRole('button', { name: 'Show where each line was logged' }).click();
    await lines.getByText('arm up  [File "src/arm.cpp", line 42, in lift]').waitFor();
    assert.match(await lines.innerText(), /wheels turn\n/);
    const [saved] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save the log' }).click()]);
    assert.equal(saved.suggestedFilename(), 'rosout.log');
    assert.match(readFileSync(await saved.path(), 'utf8'), /^\[INFO\] \[1700000000\.000000005\] \[robot\.drive\]: wheels turn\n[^]*line 42, in lift\]\n$/m);
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('WARN');
    await lines.getByText('wheels turn').waitFor({ state: 'detached' });
    await page.getByRole('combobox', { name: 'Node whose lines' }).selectOption('robot.laser');
    await lines.getByText(kMarkup).waitFor({ state: 'detached' });
    await lines.getByText('a beam is late').waitFor();
    await page.getByRole('searchbox', { name: 'Filter the log' }).fill('nothing like it');
    await page.getByText('None of 1 lines match the filter.').waitFor();
    await page.getByRole('button', { name: 'Clear the log' }).click();
    await page.getByText('Nothing has been logged').waitFor();
    assert.match(await page.title(), /^Talker and listener/);
  }));

async function picture(page: Page): Promise<void> {
  const header = { stamp: { sec: 0, nanosec: 0 }, frame_id: 'camera' };
  const send = (): Promise<void> =>
    page.evaluate(
      (head) =>
        globalThis.send('/camera', 'sensor_msgs/msg/Image', {
          header: head, height: 2, width: 2, encoding: 'rgb8', is_bigendian: 0, step: 6,
          data: [255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 8, 7],
        }),
      header,
    );
  await send();
  await page.waitForFunction(() => heard('/camera') > 0);
  await send();
  await page.getByRole('img', { name: 'Image of /camera, 2 \u00d7 2, rgb8' }).waitFor();
}

test('raw images are drawn as they are, with what was measured under the pointer', () =>
  stage.on(withPanels({ image: { topic: '/camera' } }), {}, async (page) => {
    await picture(page);
    const canvas = page.locator('.image-canvas');
    const data = await canvas.evaluate((element) => {
      const context = new OffscreenCanvas(2, 2).getContext('2d', { willReadFrequently: true });
      if (element instanceof HTMLCanvasElement) context?.drawImage(element, 0, 0);
      return [...(context?.getImageData(0, 0, 2, 2).data ?? [])];
    });
    assert.deepEqual(data, [255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 255]);
    const box = (await canvas.boundingBox()) ?? assert.fail();
    await page.mouse.move(box.x + box.width / 2 + 20, box.y + box.height / 2 + 20);
    await page.getByText('(1, 1): 9 8 7').waitFor();
    await page.evaluate(() =>
      globalThis.send('/camera', 'sensor_msgs/msg/Image', {
        header: { stamp: { sec: 0, nanosec: 0 }, frame_id: '' }, height: 4000000, width: 4000000, encoding: 'rgb8', is_bigendian: 0, step: 6, data: [1],
      }),
    );
    await page.getByText('Cannot be shown: 4000000 \u00d7 4000000 pixels are too many.').waitFor();
  }));

test('compressed images are read by the browser, and what is none is told', () =>
  stage.on(withPanels({ image: { topic: '/camera/compressed' } }), {}, async (page) => {
    const send = (good: boolean): Promise<void> =>
      page.evaluate(async (right) => {
        const drawing = new OffscreenCanvas(8, 4);
        drawing.getContext('2d')?.fillRect(0, 0, 8, 4);
        const png = new Uint8Array(await (await drawing.convertToBlob()).arrayBuffer());
        globalThis.send('/camera/compressed', 'sensor_msgs/msg/CompressedImage', {
          header: { stamp: { sec: 0, nanosec: 0 }, frame_id: '' }, format: 'png', data: right ? [...png] : [1, 2, 3],
        });
      }, good);
    await send(true);
    await page.waitForFunction(() => heard('/camera/compressed') > 0);
    await send(false);
    await page.getByText('this browser cannot read its format, png').waitFor();
    await send(true);
    await page.getByRole('img', { name: 'Image of /camera/compressed, 8 \u00d7 4, png' }).waitFor();
    await page.getByText('cannot read its format').waitFor({ state: 'detached' });
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in log and image, on a phone too, ${colorScheme}`, () =>
    stage.on(
      withPanels({ row: ['log', { image: { topic: '/camera' } }], shown: 'image' }),
      { colorScheme, reducedMotion: 'reduce' },
      async (page) => {
        await log(page);
        await picture(page);
        await expectAccessible(page);
        await page.setViewportSize({ width: 320, height: 568 });
        await page.getByRole('tab', { name: 'Image' }).click();
        await page.locator('.image-canvas').waitFor();
        await expectAccessible(page);
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
        await page.getByRole('tab', { name: 'Log' }).click();
        await page.locator('.panel-log .lines').waitFor();
        await expectAccessible(page);
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
      },
    ));
}
