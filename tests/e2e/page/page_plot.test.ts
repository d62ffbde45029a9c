// Plot and timeline in Chromium: every message of a real graph is a sample, whatever the frame rate.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { eventually } from '../../support/eventually.ts';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

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

const withPanel = (panel: unknown): string => `signals#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', panel], sizes: [1, 3], shown: 'plot' }))}`;

/** Publishes so many points of /sine once the panel listens. */
async function play(page: Page, count: number, apartMs = 0): Promise<void> {
  await page.evaluate(() => send('/sine', 'demo/msg/Sine', { value: 0, other: 1, list: [0], mode: 'idle', big: 0 }));
  await page.waitForFunction(() => heard('/sine') > 0);
  await page.evaluate(async ([points, pause]) => {
    for (let i = 0; i < points; i += 1) {
      send('/sine', 'demo/msg/Sine', {
        value: Math.sin(i / 20),
        other: Math.cos(i / 20),
        list: [i],
        mode: i < points / 2 ? 'idle' : 'driving',
        big: i,
      });
      // Lets the page take what came: its history holds 200.
      if (pause > 0 || i % 50 === 49) await new Promise((go) => setTimeout(go, Math.max(pause, 5)));
    }
  }, [count, apartMs] as const);
}

async function saved(page: Page, item: string): Promise<string> {
  await page.getByRole('button', { name: 'Save the plot' }).click();
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('menuitem', { name: item }).click(),
  ]);
  return readFile(await file.path(), 'latin1');
}

const PLOT = { plot: { paths: ['/sine.value', '/sine.list[0]'], mode: 'time', seconds: 60 } };

test('a plot samples every message, and is saved as CSV, SVG and PNG', () =>
  stage.on(withPanel(PLOT), {}, async (page) => {
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

test('a plot behind another tab has all that came since the page was opened, and draws nothing before', () =>
  stage.on(
    `signals#layout=${
      encodeURIComponent(JSON.stringify({ row: ['nodes', { tabs: ['console', PLOT, { plot: { paths: [] } }, 'log'], front: 1 }], shown: 'console' }))
    }`,
    {},
    async (page) => {
      // It hears the topic though nobody has looked at it; the one without fields is not even loaded.
      await play(page, 300);
      await page.locator('#tab-panel-plot').waitFor({ state: 'attached' });
      assert.equal(await page.locator('#tab-panel-plot').isVisible(), false);
      await page.locator('#tab-panel-log .panel-log').waitFor({ state: 'attached' });
      assert.equal(await page.locator('#tab-panel-plot-2').count(), 0);
      await page.getByRole('tab', { name: 'Plot', exact: true }).click();
      await page.locator('.path-value').getByText('299', { exact: true }).waitFor();
      const csv = (await saved(page, 'All values (CSV)')).trimEnd().split('\n');
      const column = csv.slice(1).map((line) => Number(line.split(',')[2]));
      assert.deepEqual(column.slice(-300), Array.from({ length: 300 }, (_, i) => i));
      await page.waitForFunction(() => (document.querySelector<HTMLCanvasElement>('.plot-canvas canvas')?.width ?? 0) > 300);
    },
  ));

test('a part of time is chosen with the mouse', () =>
  stage.on(withPanel(PLOT), {}, async (page) => {
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

/** Where the second series is drawn, in pixels of the canvas: it is red in the light theme. */
async function drawn(page: Page): Promise<{ width: number; height: number; all: { width: number; height: number; }; middle: number; }> {
  // Two drawings later all that was asked for is there.
  await page.waitForTimeout(150);
  return page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('.plot-canvas canvas') ?? new HTMLCanvasElement();
    const { width, height } = canvas;
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    context?.drawImage(canvas, 0, 0);
    const data = context?.getImageData(0, 0, width, height).data ?? [];
    const red = (x: number, y: number): boolean => {
      const i = 4 * (y * width + x);
      return (data[i] ?? 0) > (data[i + 2] ?? 0) + 60 && (data[i + 3] ?? 0) > 100;
    };
    let [left, right, top, bottom] = [width, -1, height, -1];
    for (let y = 0; y < height; y += 1)
      for (let x = 0; x < width; x += 1)
        if (red(x, y)) [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
    let middle = 0;
    for (let y = -20; y < 20; y += 1) for (let x = -20; x < 20; x += 1) if (red(((left + right) >> 1) + x, ((top + bottom) >> 1) + y)) middle += 1;
    return { width: right - left, height: bottom - top, all: { width, height }, middle };
  });
}

async function valueBeside(page: Page, index: number): Promise<number> {
  return Number(await page.locator('.path-value').nth(index).innerText());
}

function plotOf(page: Page) {
  return page.getByRole('application', { name: /^Plot of/ });
}

/**
 * The part of /sine.list[0] that the saved drawing shows: its height in values and its width in samples. The values rise by one
 * from sample to sample.
 */
async function seen(page: Page): Promise<{ values: number; samples: number; }> {
  // The changes by keys and pointer are drawn by then.
  await page.waitForTimeout(150);
  const path = /d="([^"]*)" fill="none" stroke="#b3261e"/.exec(await saved(page, 'Drawing (SVG)'))?.[1] ?? '';
  const heights = [...path.matchAll(/[ML][\d.-]+ ([\d.-]+)/g)].map(([, y]) => Number(y));
  const [first = 0, last = 0] = [heights[0], heights.at(-1)];
  // 343 pixels are the height of the drawing.
  return { values: (343 * (heights.length - 1)) / (first - last), samples: heights.length };
}

function near(value: number, expected: number, what: string): void {
  assert.ok(Math.abs(value - expected) < 0.05 * expected, `${what}: ${value}, not ${expected}`);
}

test('by keys: values at a moment, zoom of time and of values, and back', () =>
  stage.on(withPanel({ plot: { ...PLOT.plot, seconds: 1 } }), {}, async (page) => {
    await play(page, 120, 8);
    const plot = plotOf(page);
    await plot.focus();
    await page.keyboard.press('ArrowRight');
    await page.getByText(/^At \d+\.\d{3}\u00a0s$/).waitFor();
    const first = await valueBeside(page, 1);
    assert.ok(first > 10 && first < 118, `${first} is in the middle of what is seen`);
    await page.keyboard.press('ArrowRight');
    assert.equal(await valueBeside(page, 1), first + 1);
    await page.keyboard.press('PageUp');
    await page.keyboard.press('ArrowLeft');
    assert.equal(await valueBeside(page, 1), first - 10);
    // The other series at the same moment, to six digits; both are told to those who hear the page.
    const sine = Number(Math.sin((first - 10) / 20).toPrecision(6));
    assert.equal(await valueBeside(page, 0), sine);
    await page.locator('[role=status]', { hasText: `: /sine.value ${sine}, /sine.list[0] ${first - 10}` }).first().waitFor({ state: 'attached' });
    // The drawing is held: it stays while more comes.
    await page.getByRole('button', { name: 'Follow what comes' }).waitFor();
    const whole = await seen(page);
    await plot.focus();
    for (let i = 0; i < 3; i += 1) await page.keyboard.press('ArrowUp');
    const tall = await seen(page);
    near(tall.values, whole.values / 1.5 ** 3, 'zoomed in three times');
    assert.equal(tall.samples, whole.samples);
    await plot.focus();
    for (let i = 0; i < 4; i += 1) await page.keyboard.press('ArrowDown');
    near((await seen(page)).values, whole.values * 1.5, 'and out four times');
    // Time alone, about the chosen moment.
    await plot.focus();
    for (let i = 0; i < 3; i += 1) await page.keyboard.press('+');
    const narrow = await seen(page);
    assert.ok(narrow.samples > 3 && narrow.samples < 0.6 * whole.samples, `${narrow.samples} of ${whole.samples}`);
    assert.equal(await valueBeside(page, 1), first - 10);
    await plot.focus();
    await page.keyboard.press('-');
    assert.ok((await seen(page)).samples > narrow.samples);
    await plot.focus();
    await page.keyboard.press('0');
    const all = page.getByRole('button', { name: 'Show all values and follow' });
    assert.equal(await all.getAttribute('aria-disabled'), 'true');
    await page.getByText(/^At \d/).waitFor({ state: 'detached' });
    assert.ok(await plot.evaluate((element) => element === document.activeElement));
  }));

test('all values of messages that came at one moment are told', () =>
  stage.on(withPanel({ plot: { ...PLOT.plot, seconds: 1 } }), {}, async (page) => {
    await play(page, 3, 20);
    await page.evaluate(() => {
      const { now } = performance;
      const moment = performance.now();
      performance.now = () => moment;
      for (const value of [101, 102, 103]) send('/sine', 'demo/msg/Sine', { value: 0.5, other: 1, list: [value], mode: 'idle', big: 0 });
      performance.now = now;
    });
    await page.locator('.path-value').nth(1).getByText('103', { exact: true }).waitFor();
    await plotOf(page).focus();
    for (let i = 0; i < 6; i += 1) await page.keyboard.press('ArrowRight');
    await page.locator('.path-value').nth(1).getByText('101 102 103', { exact: true }).waitFor();
  }));

test('by pointer: values under it, and a drag up and down chooses values', () =>
  stage.on(withPanel({ plot: { ...PLOT.plot, seconds: 1 } }), {}, async (page) => {
    await play(page, 120, 8);
    await page.getByRole('button', { name: 'Hold the drawing' }).click();
    const whole = await seen(page);
    const box = (await page.locator('.u-over').boundingBox()) ?? assert.fail();
    assert.equal(await valueBeside(page, 1), 119);
    const center = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    await page.mouse.move(center.x, center.y);
    await page.getByText(/^At \d+\.\d{3}\u00a0s$/).waitFor();
    const under = await valueBeside(page, 1);
    assert.ok(under > 10 && under < 119, String(under));
    await page.mouse.move(center.x, center.y - box.height / 6);
    await page.mouse.down();
    await page.mouse.move(center.x + 3, center.y + box.height / 6, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(5, 5);
    await page.getByText(/^At \d/).waitFor({ state: 'detached' });
    const part = await seen(page);
    near(part.values, whole.values / 3, 'a third of the height');
    assert.equal(part.samples, whole.samples);
    assert.equal(await valueBeside(page, 1), 119);
    await page.getByRole('button', { name: 'Show all values and follow' }).click();
    await page.getByRole('button', { name: 'Hold the drawing' }).waitFor();
  }));

test('one field against another is a circle where it is one, with its values at each point', () =>
  stage.on(withPanel({ plot: { paths: ['/sine.value', '/sine.other'], mode: 'xy', seconds: 3600 } }), { colorScheme: 'light', reducedMotion: 'reduce' },
    async (page) => {
      // 126 steps of 1/20 are once round. Apart, so that each is a moment of its own.
      await play(page, 127, 5);
      await page.locator('.path-value').first().getByText(String(Number(Math.sin(126 / 20).toPrecision(6))), { exact: true }).waitFor();
      const ring = await drawn(page);
      assert.ok(ring.width > 0.6 * ring.all.width && ring.height > 0.6 * ring.all.height, JSON.stringify(ring));
      assert.equal(ring.middle, 0);
      const svg = await saved(page, 'Drawing (SVG)');
      assert.match(svg, />\/sine\.value<.*\/sine\.other/s);
      const points = [...(/d="([^"]*)" fill="none" stroke="#b3261e"/.exec(svg)?.[1] ?? '').matchAll(/[ML]([\d.]+) ([\d.]+)/g)].map(([, x, y]) =>
        [Number(x), Number(y)] as const
      );
      assert.ok(points.length >= 127, String(points.length));
      const middle = (axis: 0 | 1): readonly [number, number] => {
        const values = points.map((point) => point[axis]);
        const [least, most] = [Math.min(...values), Math.max(...values)];
        return [(least + most) / 2, (most - least) / 2];
      };
      const [[cx, rx], [cy, ry]] = [middle(0), middle(1)];
      for (const [x, y] of points.slice(-127)) {
        const away = Math.hypot((x - cx) / rx, (y - cy) / ry);
        assert.ok(Math.abs(away - 1) < 0.02, `${x} ${y}: ${away}`);
      }
      await plotOf(page).focus();
      for (const key of ['ArrowRight', 'ArrowRight', 'PageDown']) {
        await page.keyboard.press(key);
        const away = Math.hypot(await valueBeside(page, 0), await valueBeside(page, 1));
        assert.ok(Math.abs(away - 1) < 1e-4, String(away));
      }
      // The nearest point under the pointer: on the right, x is its most.
      const box = (await page.locator('.u-over').boundingBox()) ?? assert.fail();
      await page.mouse.move(box.x + box.width * 0.945, box.y + box.height / 2);
      await page.waitForFunction(() => Number(document.querySelector('.path-value')?.textContent) > 0.98);
      await page.mouse.move(5, 5);
      await page.keyboard.press('-');
      const small = await drawn(page);
      assert.ok(Math.abs(small.width - ring.width / 1.5) < 0.06 * ring.width && Math.abs(small.height - ring.height / 1.5) < 0.06 * ring.height,
        JSON.stringify([ring, small]));
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
    await page.getByRole('button', { name: 'Remove /sine.other' }).waitFor();
    await field.fill('/sine.nothing');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'Remove /sine.nothing' }).waitFor();
    // The panel follows what it shows from its next frame on: what was sent before is not for the new field.
    await eventually('the new field is followed', async () => {
      await play(page, 1);
      return page.getByText('the message has no such field').isVisible();
    });
    await page.getByRole('combobox', { name: 'Axes' }).selectOption('xy');
    await page.reload();
    await page.waitForSelector('.panel-plot');
    assert.equal(await page.getByRole('combobox', { name: 'Axes' }).inputValue(), 'xy');
    await page.getByRole('button', { name: 'Remove /sine.nothing' }).click();
    await page.getByText('Add another one for the y axis.').waitFor();
    // Another plot is another panel with fields of its own.
    await page.getByRole('button', { name: 'Open a panel here' }).nth(1).click();
    await page.getByRole('menuitem', { name: 'Plot' }).click();
    await page.getByRole('tab', { name: 'Plot 2' }).waitFor();
    await page.getByText('Add a field of a topic to plot it.').waitFor();
    assert.equal(await page.getByRole('button', { name: 'Remove /sine.other' }).isVisible(), false);
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
      `signals#layout=${encodeURIComponent(JSON.stringify({ column: [PLOT, { timeline: { paths: ['/sine.mode', '/sine.big'] } }] }))}`,
      { colorScheme, reducedMotion: 'reduce' },
      async (page) => {
        await play(page, 50);
        await page.getByRole('img', { name: 'States of /sine.mode, now driving' }).waitFor();
        await expectAccessible(page);
      },
    ));
}

test('fields stand beside each other, so that the drawing keeps its height', () =>
  stage.on(withPanel({ plot: { paths: ['/sine.value', '/sine.other', '/sine.big', '/sine.list[0]'] } }), { viewport: { width: 1000, height: 500 } },
    async (page) => {
      await play(page, 50);
      await page.locator('.path').nth(3).waitFor();
      const rows = new Set(await page.locator('.path').evaluateAll((paths) => paths.map((path) => Math.round(path.getBoundingClientRect().top))));
      assert.ok(rows.size <= 2, `${rows.size} rows`);
      assert.ok(((await page.locator('.plot-canvas').boundingBox())?.height ?? 0) > 200);
    }));

test('plot and timeline fit a phone', () =>
  stage.on(withPanel(PLOT), { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await play(page, 50);
    await page.locator('.plot-canvas canvas').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    assert.ok(((await page.locator('.plot-canvas').boundingBox())?.height ?? 0) >= 100);
    await expectAccessible(page);
  }));
