// The turtle simulator's panel in Chromium: scenes of two simulators that a test sends, and the real simulator of
// example 03, driven by keys and by the pad.
import assert from 'node:assert/strict';
import { cpSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { BrowserContextOptions, Page } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';
import { packExample } from '../support/example_site.ts';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';
import { Scratch, runCli } from '../support/served_site.ts';

declare global {
  // Set by page_fake.tsx in the scene "turtles".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
  var moves: readonly string[];
  // Set by a test here: timers that run.
  var held: number;
}

const EXAMPLE = fileURLToPath(new URL('../../../examples/03_turtlesim', import.meta.url));
const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const ALONE = `#layout=${encodeURIComponent(JSON.stringify('turtlesim'))}`;

const TABS = `#layout=${encodeURIComponent(JSON.stringify({ tabs: ['turtlesim', 'nodes'] }))}`;

const scratch = new Scratch();
let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
  cpSync(EXAMPLE, join(scratch.path, 'example'), { recursive: true });
  const packed = await runCli(['pack', join(scratch.path, 'example/workspace.yaml'), '-o', join(scratch.path, 'site')]);
  assert.equal(packed.code, 0, packed.errors);
});

after(async () => {
  await stage.close();
  scratch[Symbol.dispose]();
});

type Rgb = readonly [number, number, number];

interface Shown {
  readonly turtles?: readonly { readonly name: string; readonly x: number; readonly y: number; readonly theta: number; readonly shape: number; }[];
  readonly picture?: number;
  readonly first?: number;
  readonly strokes?: readonly unknown[];
  readonly background?: Rgb;
}

/** A thick red line across the sheet, 100 pixels below its upper edge. */
const LINE = { x1: 50, y1: 100, x2: 450, y2: 100, r: 255, g: 0, b: 0, width: 20 };
const BLUE: Rgb = [69, 86, 255];
/** The pen of the simulator. Its line is thin: in a small drawing some of the ground shines through. */
const PEN: Rgb = [0xb3, 0xb8, 0xff];
const ONE = [{ name: 'turtle1', x: 5.544445, y: 5.544445, theta: 0, shape: 0 }];

async function show(page: Page, shown: Shown, topic = '/turtlesim/_scene'): Promise<void> {
  await page.evaluate(
    ([where, given]) =>
      send(where, 'turtlesim_scene/msg/Scene', {
        width: 500,
        height: 500,
        meter: 45,
        background: given.background ?? [69, 86, 255],
        picture: given.picture ?? 1,
        first: given.first ?? 0,
        strokes: given.strokes ?? [],
        turtles: (given.turtles ?? []).map((turtle) => ({ ...turtle, pen: [0, 0, 0], pen_width: 3, pen_on: true })),
      }),
    [topic, shown] as const,
  );
}

/** Sends the scene until the panel listens: what is sent before reaches nobody. */
async function begin(page: Page, shown: Shown, topic = '/turtlesim/_scene'): Promise<void> {
  await show(page, shown, topic);
  await page.waitForFunction((name) => heard(name) > 0, topic);
  await show(page, shown, topic);
}

/** The colour of the drawing at a place of the sheet, in its pixels. */
function colorAt(page: Page, x: number, y: number): Promise<Rgb> {
  return page.locator('.turtle-canvas').evaluate((canvas, [left, top]) => {
    if (!(canvas instanceof HTMLCanvasElement)) throw new Error('no canvas');
    const context = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
    const scale = canvas.width / 500;
    context?.drawImage(canvas, Math.round(left * scale), Math.round(top * scale), 1, 1, 0, 0, 1, 1);
    const [r = 0, g = 0, b = 0] = context?.getImageData(0, 0, 1, 1).data ?? [];
    return [r, g, b] as const;
  }, [x, y] as const);
}

async function colored(page: Page, x: number, y: number, wanted: Rgb, tolerance = 3): Promise<void> {
  const end = Date.now() + 100_000;
  for (;;) {
    const found = await colorAt(page, x, y);
    if (found.every((channel, index) => Math.abs(channel - (wanted[index] ?? 0)) <= tolerance)) return;
    assert.ok(Date.now() < end, `${x}, ${y}: ${found.join(' ')} instead of ${wanted.join(' ')}`);
    await page.evaluate(() =>
      new Promise((drawn) => {
        requestAnimationFrame(drawn);
      })
    );
  }
}

const drawing = (page: Page, words: RegExp) => page.getByRole('application', { name: words });

test('background, strokes and turtles are drawn, and a new sheet is empty', () =>
  stage.on(`turtles${ALONE}`, {}, async (page) => {
    await begin(page, { turtles: ONE, strokes: [LINE] });
    await colored(page, 250, 100, [255, 0, 0]);
    await colored(page, 20, 100, BLUE);
    assert.notDeepEqual(await colorAt(page, 249, 249), BLUE);
    await drawing(page, /^Drawing of \/turtlesim: turtle1 at x 5\.5, y 5\.5, heading 0°$/).waitFor();
    await show(page, { turtles: [{ ...ONE[0]!, x: 1, y: 10, theta: Math.PI / 2 }], picture: 2, background: [10, 200, 30] });
    await colored(page, 250, 100, [10, 200, 30]);
    await colored(page, 249, 249, [10, 200, 30]);
    await drawing(page, /turtle1 at x 1\.0, y 10\.0, heading 90°$/).waitFor();
  }));

test('nothing is drawn while nothing changes, and another size is filled', () =>
  stage.on(`turtles${ALONE}`, { deviceScaleFactor: 2 }, async (page) => {
    await begin(page, { turtles: ONE, strokes: [LINE] });
    await colored(page, 250, 100, [255, 0, 0]);
    const drawn = await page.evaluate(async () => {
      let count = 0;
      const real = CanvasRenderingContext2D.prototype.fillRect;
      CanvasRenderingContext2D.prototype.fillRect = function(...box) {
        count += 1;
        real.apply(this, box);
      };
      for (let i = 0; i < 20; i += 1)
        await new Promise((next) => {
          requestAnimationFrame(next);
        });
      CanvasRenderingContext2D.prototype.fillRect = real;
      return count;
    });
    assert.equal(drawn, 0);
    for (const [width, height] of [[800, 900], [1280, 440], [760, 500]] as const) {
      await page.setViewportSize({ width, height });
      await page.waitForFunction(() => {
        const canvas = document.querySelector<HTMLCanvasElement>('.turtle-canvas');
        const box = canvas?.getBoundingClientRect();
        return canvas != null && box !== undefined && box.width > 90 && Math.abs(box.width - box.height) < 1
          && Math.abs(canvas.width - box.width * 2) <= 2 && box.right <= innerWidth && box.bottom <= innerHeight;
      });
      await colored(page, 250, 100, [255, 0, 0]);
      await colored(page, 480, 480, BLUE);
    }
  }));

test('keys and pad drive the turtle as the keys of turtle_teleop_key do', () =>
  stage.on(`turtles${ALONE}`, {}, async (page) => {
    await begin(page, { turtles: ONE });
    await page.getByText('The arrow keys drive turtle1').waitFor();
    const said = (list: readonly string[]): Promise<unknown> =>
      page.waitForFunction((wanted) => moves.join('; ') === wanted, list.map((one) => `/turtle1/cmd_vel ${one}`).join('; '));
    // Nothing has the focus yet.
    await page.keyboard.press('ArrowUp');
    await said(['2 0']);
    await drawing(page, /turtle1/).focus();
    for (const key of ['ArrowLeft', 'ArrowDown', 'ArrowRight', 'Control+ArrowUp', 'x']) await page.keyboard.press(key);
    await said(['2 0', '0 2', '-2 0', '0 -2']);
    await page.getByRole('button', { name: 'Turn turtle1 left' }).press('Enter');
    await said(['2 0', '0 2', '-2 0', '0 -2', '0 2']);
    // Elsewhere the keys do what they do there.
    await page.getByRole('tab', { name: 'Turtlesim' }).focus();
    await page.keyboard.press('ArrowUp');
    await holdForward(page);
    await page.waitForFunction(() => moves.length >= 8);
    await page.mouse.up();
    assert.deepEqual([...new Set((await page.evaluate(() => moves)).slice(5))], ['/turtle1/cmd_vel 2 0']);
  }));

/** Presses there and stays. */
async function holdForward(page: Page): Promise<void> {
  const box = (await page.getByRole('button', { name: 'Drive turtle1 forward' }).boundingBox()) ?? assert.fail();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
}

test('the pad is let go when the window loses the focus or the page is hidden, and by a finger that has slid off it', () =>
  stage.on(`turtles${ALONE}`, {}, async (page) => {
    await begin(page, { turtles: ONE });
    await page.getByText('The arrow keys drive turtle1').waitFor();
    // The timer that would send more is the only one: without it time goes on, and nothing is sent.
    await page.evaluate(() => {
      const node = fake.node();
      const real = node.timer.bind(node);
      Object.assign(globalThis, { held: 0 });
      node.timer = (ms, ring) => {
        const timer = real(ms, ring);
        held += 1;
        return {
          close: () => {
            held -= 1;
            timer.close();
          },
        };
      };
      fake.node = () => node;
    });
    const free = (): Promise<unknown> => page.waitForFunction(() => held === 0);
    for (const event of ['blur', 'visibilitychange'] as const) {
      await holdForward(page);
      await page.waitForFunction(() => held === 1);
      await page.evaluate((name) => (name === 'blur' ? window : document).dispatchEvent(new Event(name)), event);
      await free();
      await page.mouse.up();
    }
    await holdForward(page);
    await page.waitForFunction(() => held === 1);
    await page.mouse.move(5, 5);
    assert.equal(await page.evaluate(() => held), 1);
    await page.mouse.up();
    await free();
  }));

test('several turtles have names and are chosen, several simulators too', () =>
  stage.on(`turtles${ALONE}`, {}, async (page) => {
    await begin(page, { turtles: ONE });
    await drawing(page, /\/turtlesim: turtle1/).waitFor();
    await page.getByRole('combobox', { name: 'Simulator' }).selectOption('/two/turtlesim');
    const two = '/two/turtlesim/_scene';
    const both = [...ONE, { name: 'turtle2', x: 2, y: 2, theta: -1, shape: 4 }];
    await begin(page, { turtles: both, strokes: [LINE] }, two);
    await drawing(page, /^Drawing of \/two\/turtlesim: turtle1 at x 5\.5, y 5\.5, heading 0°; turtle2 at x 2\.0, y 2\.0, heading -57°$/).waitFor();
    const box = (await page.locator('.turtle-sheet').boundingBox()) ?? assert.fail();
    await page.mouse.click(box.x + (box.width * 90) / 500, box.y + (box.height * 409) / 500);
    await page.getByText('The arrow keys drive turtle2').waitFor();
    assert.equal(await page.getByRole('combobox', { name: 'Turtle that the keys drive' }).inputValue(), 'turtle2');
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => moves.join() === '/two/turtle2/cmd_vel 0 -2');
    await page.screenshot({ path: join(OUTPUT, 'turtlesim_two.png') });
    await show(page, { turtles: [], first: 1 }, two);
    await drawing(page, /^Drawing of \/two\/turtlesim: no turtle$/).waitFor();
    await page.evaluate(() => fake.setTopics([{ name: '/two/turtlesim/_scene', type: 'turtlesim_scene/msg/Scene', publishers: 0 }]));
    await page.getByRole('combobox', { name: 'Simulator' }).waitFor({ state: 'detached' });
  }));

test('while time is held the panel says so, and without a simulator too', () =>
  stage.on(`turtles${ALONE}`, {}, async (page) => {
    await begin(page, { turtles: ONE });
    await drawing(page, /turtle1/).waitFor();
    await page.evaluate(() => fake.time.pause());
    await page.getByText('Time is held: turtles stand still').waitFor();
    await page.evaluate(() => fake.time.resume());
    await page.getByText('The arrow keys drive turtle1').waitFor();
    await page.evaluate(() => fake.setTopics([]));
    await page.getByText('No turtle simulator runs.').waitFor();
  }));

test('a site with a simulator and checks has both in its usual layout, and a phone shows the turtle first', async () => {
  await stage.on('turtles', {}, async (page) => {
    await begin(page, { turtles: ONE });
    await drawing(page, /turtle1/).waitFor();
    assert.deepEqual(await page.getByRole('tab').allInnerTexts(), ['Nodes', 'Checks', 'Turtlesim', 'Consoles', 'Topics']);
    await page.screenshot({ path: join(OUTPUT, 'turtlesim_usual.png') });
  });
  await stage.on('turtles', phone, async (page) => {
    await begin(page, { turtles: ONE });
    await drawing(page, /turtle1/).waitFor();
    assert.equal(await page.getByRole('tab', { selected: true }).innerText(), 'Turtlesim');
  });
});

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, on a narrow phone too, ${colorScheme}`, () =>
    stage.on(`turtles${ALONE}`, { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await begin(page, { turtles: [...ONE, { name: 'turtle2', x: 2, y: 2, theta: -1, shape: 4 }], strokes: [LINE] });
      await drawing(page, /turtle2/).waitFor();
      await expectAccessible(page);
      await page.screenshot({ path: join(OUTPUT, `turtlesim_${colorScheme}.png`) });
      await page.setViewportSize({ width: 320, height: 568 });
      await expectAccessible(page);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    }));
}

/** Example 03, open at that address. Fails on any trouble of the page. */
async function onExample(options: BrowserContextOptions, fragment: string, body: (page: Page) => Promise<void>, folder = 'site'): Promise<void> {
  const served = await serveFolder(join(scratch.path, folder));
  const context = await stage.browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  const troubles: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  try {
    await page.goto(`${served.url}${fragment}`);
    await body(page);
    assert.deepEqual(troubles, []);
  } finally {
    await context.close();
    await served.close();
  }
}

test('example 03 opens as its manifest says: beside its lab sheet, and on a phone with the turtle', async () => {
  await onExample({ viewport: { width: 1440, height: 900 } }, '', async (page) => {
    await page.getByRole('heading', { name: 'Drive a turtle' }).waitFor();
    await drawing(page, /turtle1 at x 5\.5/).waitFor();
    await page.locator('.panel-checks').getByText('3 of 3 checks passed').waitFor();
    await page.getByRole('link', { name: 'publish one' }).or(page.getByRole('button', { name: 'publish one' })).click();
    await page.waitForFunction(() => !/heading 0°/.test(document.querySelector('.turtle-sheet')?.getAttribute('aria-label') ?? 'heading 0°'));
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'turtlesim_example.png') });
  });
  await onExample({ ...phone, hasTouch: true, isMobile: true }, '', async (page) => {
    await drawing(page, /turtle1 at x 5\.5/).waitFor();
    await page.getByRole('button', { name: 'Drive turtle1 forward' }).tap();
    await drawing(page, /turtle1 at x [67]\.\d/).waitFor();
  });
});

/** Where the drawing says that turtle1 is. */
async function pose(page: Page): Promise<readonly number[]> {
  const name = await drawing(page, /turtle1 at/).getAttribute('aria-label');
  return [.../at x (\S+), y (\S+), heading (\S+)°/.exec(name ?? '')?.slice(1).map(Number) ?? []];
}

test('the real turtle is driven by keys and leaves a stroke, which those who come late see too', () =>
  onExample({}, TABS, async (page) => {
    await drawing(page, /turtle1 at x 5\.5, y 5\.5, heading 0°$/).waitFor();
    await colored(page, 20, 20, BLUE);
    await page.keyboard.press('ArrowUp');
    await drawing(page, /turtle1 at x [67]\.\d, y 5\.5, heading 0°$/).waitFor();
    // The pen's line, behind the turtle.
    await colored(page, 250, 250, PEN, 45);
    await drawing(page, /turtle1/).press('ArrowLeft');
    await page.waitForFunction(() => !/heading 0°/.test(document.querySelector('.turtle-sheet')?.getAttribute('aria-label') ?? '0'));
    const [, , heading = 0] = await pose(page);
    assert.ok(heading > 0, `${heading}`);
    // The letters around F turn it to headings, as those of turtle_teleop_key do.
    await drawing(page, /turtle1/).press('e');
    await drawing(page, /heading 13[3-7]°$/).waitFor();
    await drawing(page, /turtle1/).press('g');
    await drawing(page, /heading -?[0-2]°$/).waitFor();
    await drawing(page, /turtle1/).press('t');
    await drawing(page, /heading 4[3-7]°$/).waitFor();
    // Many strokes later the panel is opened anew: of the scenes that are kept none has the first stroke any more.
    for (let i = 0; i < 3; i += 1) {
      const before = await page.locator('.turtle-sheet').getAttribute('aria-label');
      await drawing(page, /turtle1/).press('ArrowUp');
      await page.waitForFunction((words) => document.querySelector('.turtle-sheet')?.getAttribute('aria-label') !== words, before);
    }
    await page.getByRole('tab', { name: 'Nodes' }).click();
    await page.locator('.turtle-sheet').waitFor({ state: 'detached' });
    await page.getByRole('tab', { name: 'Turtlesim' }).click();
    await colored(page, 260, 250, PEN, 45);
  }));

test('on a phone the pad drives the turtle; reset brings it back and clears the sheet', () =>
  onExample({ ...phone, hasTouch: true, isMobile: true }, ALONE, async (page) => {
    await drawing(page, /turtle1 at x 5\.5/).waitFor();
    await page.getByRole('button', { name: 'Drive turtle1 forward' }).tap();
    await drawing(page, /turtle1 at x [67]\.\d, y 5\.5, heading 0°$/).waitFor();
    await colored(page, 250, 250, PEN, 45);
    await page.screenshot({ path: join(OUTPUT, 'turtlesim_phone.png') });
    await page.getByRole('button', { name: 'Reset the simulator' }).tap();
    await drawing(page, /turtle1 at x 5\.5, y 5\.5, heading 0°$/).waitFor();
    await colored(page, 350, 249, BLUE);
  }));

test('example 03, squares: one turtle draws squares, and the one of the other simulator does the same', async () => {
  await packExample(scratch, '03_turtlesim', 'squares.yaml', 'squares');
  const both = ['/turtlesim1/turtlesim', '/turtlesim2/turtlesim'].map((node) => ({ turtlesim: { node } }));
  const fragment = `#layout=${encodeURIComponent(JSON.stringify({ row: both }))}`;
  await onExample({}, fragment, async (page) => {
    // draw_square turns at the first corner: both turtles look up there, within the same minute.
    for (const one of ['turtlesim1', 'turtlesim2'])
      await drawing(page, new RegExp(`^Drawing of /${one}/turtlesim: turtle1 at x [67]\\.\\d, y [56]\\.\\d, heading (8[5-9]|9[0-5])`)).waitFor();
    await page.screenshot({ path: join(OUTPUT, 'turtlesim_squares.png') });
  }, 'squares');
});
