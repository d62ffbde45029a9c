// Plot and timeline in Chromium: every message of a real graph is a sample, whatever the frame rate.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, phone } from './page_stage.ts';

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

const withPanel = (panel: unknown): string =>
  `signals#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', panel], sizes: [1, 3], shown: 'plot' }))}`;

/** Publishes so many points of /sine once the panel listens. */
async function play(page: Page, count: number): Promise<void> {
  await page.evaluate(() => send('/sine', 'demo/msg/Sine', { value: 0, other: 0, list: [0], mode: 'idle', big: 0 }));
  await page.waitForFunction(() => heard('/sine') > 0);
  await page.evaluate(async (points) => {
    for (let i = 0; i < points; i += 1) {
      send('/sine', 'demo/msg/Sine', {
        value: Math.sin(i / 20),
        other: Math.cos(i / 20),
        list: [i],
        mode: i < points / 2 ? 'idle' : 'driving',
        big: i,
      });
      // Lets the page take what came: its history holds 200.
      if (i % 50 === 49) await new Promise((go) => setTimeout(go, 5));
    }
  }, count);
}

async function saved(page: Page, item: string): Promise<string> {
  await page.getByRole('button', { name: 'Save the plot' }).click();
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('menuitem', { name: item }).click(),
  ]);
  return readFile(await file.path(), 'latin1');
}

const kPlot = { plot: { paths: ['/sine.value', '/sine.list[0]'], mode: 'time', seconds: 60 } };

test('a plot samples every message, and is saved as CSV, SVG and PNG', () =>
  stage.on(withPanel(kPlot), {}, async (page) => {
    await play(page, 1000);
    const values = page.locator('.path-value');
    await values.getByText('999', { exact: true }).waitFor();
    const csv = (await saved(page, 'All values (CSV)')).trimEnd().split('\n');
    assert.equal(csv[0], 'time,"/sine.value","/sine.list[0]"');
    const column = csv.slice(1).map((line) => Number(line.split(',')[2]));
    assert.deepEqual(column.slice(-1000), Array.from({ length: 1000 }, (_, i) => i));
    const svg = await saved(page, 'Drawing (SVG)');
    assert.match(svg, /^<svg .*\/sine\.value.*<\/svg>\n$/s);
    assert.ok((svg.match(/L\d/g) ?? []).length >= 1998);
    assert.match(await saved(page, 'Picture (PNG)'), /^\x89PNG/);
    // The drawing holds while more comes, and goes on when asked.
    await page.getByRole('button', { name: 'Hold the drawing' }).click();
    await play(page, 10);
    await page.getByRole('button', { name: 'Follow what comes' }).click();
    // The second series climbs over the whole drawing, in its colour; the first is flat beside it.
    await page.waitForFunction(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('.plot-canvas canvas');
      if (canvas === null) return false;
      const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
      context?.drawImage(canvas, 0, 0);
      const data = context?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      let red = 0;
      for (let i = 0; i < data.length; i += 4)
        if ((data[i] ?? 0) > (data[i + 2] ?? 0) + 60 && (data[i + 3] ?? 0) > 100) red += 1;
      return red > 40;
    });
  }));

test('a part of time is chosen with the mouse', () =>
  stage.on(withPanel(kPlot), {}, async (page) => {
    await play(page, 100);
    const over = page.locator('.u-over');
    const box = (await over.boundingBox()) ?? assert.fail();
    await page.mouse.move(box.x + box.width / 2, box.y + 40);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 80, box.y + 40, { steps: 3 });
    await page.mouse.up();
    await page.getByRole('button', { name: 'Follow what comes' }).click();
    await page.getByRole('button', { name: 'Hold the drawing' }).waitFor();
  }));

test('fields are added by name or chosen, wrong ones are told, and the link has them', () =>
  stage.on('signals', {}, async (page) => {
    await page.getByRole('button', { name: 'Open a panel here' }).nth(1).click();
    await page.getByRole('menuitem', { name: 'Plot' }).click();
    await page.getByText('Add a field of a topic to plot it.').waitFor();
    const field = page.getByRole('combobox', { name: 'Field to add' });
    await field.fill('sine value');
    await page.keyboard.press('Enter');
    await page.getByRole('alert').getByText('A field is written as').waitFor();
    await page.locator('datalist option[value="/sine.other"]').waitFor({ state: 'attached' });
    await field.fill('/sine.other');
    await page.getByRole('button', { name: 'Leave out /sine.other' }).waitFor();
    await field.fill('/sine.nothing');
    await page.keyboard.press('Enter');
    await play(page, 20);
    await page.getByText('the message has no such field').waitFor();
    await page.getByRole('combobox', { name: 'Axes' }).selectOption('xy');
    await page.reload();
    await page.waitForSelector('.panel-plot');
    assert.equal(await page.getByRole('combobox', { name: 'Axes' }).inputValue(), 'xy');
    await page.getByRole('button', { name: 'Leave out /sine.nothing' }).click();
    await page.getByText('Add another one for the y axis.').waitFor();
    // Another plot is another panel with fields of its own.
    await page.getByRole('button', { name: 'Open a panel here' }).nth(1).click();
    await page.getByRole('menuitem', { name: 'Plot' }).click();
    await page.getByRole('tab', { name: 'Plot 2' }).waitFor();
    await page.getByText('Add a field of a topic to plot it.').waitFor();
    assert.equal(await page.getByRole('button', { name: 'Leave out /sine.other' }).isVisible(), false);
  }));

test('states are bars that last until the next one', () =>
  stage.on(withPanel({ timeline: { paths: ['/sine.mode', '/sine.value'], seconds: 60 } }), {}, async (page) => {
    await play(page, 100);
    await page.getByRole('img', { name: 'States of /sine.mode, now driving' }).waitFor();
    const spans = page.locator('.states').first().locator('.state-span');
    assert.deepEqual(await spans.allInnerTexts(), ['idle', 'driving']);
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in plot and timeline, ${colorScheme}`, () =>
    stage.on(
      `signals#layout=${encodeURIComponent(JSON.stringify({ column: [kPlot, { timeline: { paths: ['/sine.mode', '/sine.big'] } }] }))}`,
      { colorScheme, reducedMotion: 'reduce' },
      async (page) => {
        await play(page, 50);
        await page.getByRole('img', { name: 'States of /sine.mode, now driving' }).waitFor();
        await expectAccessible(page);
      },
    ));
}

test('plot and timeline fit a phone', () =>
  stage.on(withPanel(kPlot), { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await play(page, 50);
    await page.locator('.plot-canvas canvas').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    assert.ok(((await page.locator('.plot-canvas').boundingBox())?.height ?? 0) >= 100);
    await expectAccessible(page);
  }));
