// The log and image panels in Chromium, with messages that pass a real graph.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible } from '../support/page_stage.ts';
import type { FakeSession } from '../../unit/ui/fake_session.ts';

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

const withPanels = (layout: unknown): string => `signals#layout=${encodeURIComponent(JSON.stringify(layout))}`;

const MARKUP = '<img src=x onerror="document.title=\'owned\'">';

async function log(page: Page): Promise<void> {
  const send = (level: number, name: string, msg: string): Promise<void> =>
    page.evaluate(
      ([number, node, text]) =>
        globalThis.send('/rosout', 'rcl_interfaces/msg/Log', {
          stamp: { sec: 1700000000, nanosec: 5 },
          level: number,
          name: node,
          msg: text,
          file: '',
          function: '',
          line: 0,
        }),
      [level, name, msg] as const,
    );
  await send(20, 'first', 'before anybody listens');
  await page.waitForFunction(() => heard('/rosout') > 0);
  await send(20, 'robot.drive', 'wheels turn');
  await send(30, 'robot.laser', 'a beam is late');
  await send(50, 'robot.drive', MARKUP);
}

test('the log shows all nodes, by level, node and text', () =>
  stage.on(withPanels('log'), {}, async (page) => {
    await log(page);
    const lines = page.getByRole('log', { name: 'Log' });
    await lines.getByText('wheels turn').waitFor();
    await lines.getByText(MARKUP).waitFor();
    assert.match(await lines.innerText(), /\[INFO\] \[1700000000\.000000005\] \[robot\.drive\]: wheels turn/);
    // Where: only those that say so.
    await page.evaluate(() =>
      globalThis.send('/rosout', 'rcl_interfaces/msg/Log', {
        stamp: { sec: 1700000001, nanosec: 0 },
        level: 20,
        name: 'robot.arm',
        msg: 'arm up',
        file: 'src/arm.cpp',
        function: 'lift',
        line: 42,
      })
    );
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
    await lines.getByText(MARKUP).waitFor({ state: 'detached' });
    await lines.getByText('a beam is late').waitFor();
    await page.getByRole('searchbox', { name: 'Filter the log' }).fill('nothing like it');
    await page.getByText('None of 1 lines match the filter.').waitFor();
    await page.getByRole('button', { name: 'Clear the log' }).click();
    await page.getByText('Nothing has been logged').waitFor();
    assert.match(await page.title(), /^Talker and listener/);
  }));

test('a hundred thousand lines that consoles have are in the log, and few of them in the document', () =>
  stage.on(withPanels('nodes'), {}, async (page) => {
    await page.locator('.node-head').first().waitFor();
    await page.evaluate(() => {
      const session = fake as FakeSession;
      const texts = (from: number): string[] =>
        Array.from({ length: 10_000 }, (_, i) => `[INFO] [1700000000.${String(from + i).padStart(9, '0')}] [talker]: line ${from + i}`);
      for (let from = 0; from < 100_000; from += 10_000) session.print('robot-1', ...texts(from), 'printed only');
    });
    // One of the layout would have collected before there was anything on a console.
    await page.getByRole('button', { name: 'Open a panel here' }).first().click();
    await page.getByRole('menuitem', { name: 'Log', exact: true }).click();
    const lines = page.getByRole('log', { name: 'Log' });
    await lines.getByText('line 99999', { exact: true }).waitFor();
    await page.getByRole('searchbox', { name: 'Filter the log' }).fill('nothing like it');
    await page.getByText('None of 100\u202f000 lines match the filter.').waitFor();
    await page.getByRole('searchbox', { name: 'Filter the log' }).fill('');
    await lines.getByText('line 99999', { exact: true }).waitFor();
    assert.ok((await lines.locator('.line').count()) < 100);
    await lines.focus();
    await page.keyboard.press('Home');
    await lines.getByText('line 0', { exact: true }).waitFor();
    // New lines come after them; the view does not scroll away from the reader's place.
    const say = (msg: string): Promise<void> =>
      page.evaluate((text) =>
        globalThis.send('/rosout', 'rcl_interfaces/msg/Log', {
          stamp: { sec: 1700000001, nanosec: 0 },
          level: 20,
          name: 'talker',
          msg: text,
          file: '',
          function: '',
          line: 0,
        }), msg);
    await say('before anybody listens');
    await page.waitForFunction(() => heard('/rosout') > 0);
    await say('fresh');
    await page.getByRole('button', { name: / new$/ }).click();
    await lines.getByText('fresh', { exact: true }).waitFor();
    await page.getByRole('searchbox', { name: 'Filter the log' }).fill('line 4242');
    await lines.getByText('line 42424', { exact: true }).waitFor();
  }));

async function picture(page: Page): Promise<void> {
  const header = { stamp: { sec: 0, nanosec: 0 }, frame_id: 'camera' };
  const send = (): Promise<void> =>
    page.evaluate(
      (head) =>
        globalThis.send('/camera', 'sensor_msgs/msg/Image', {
          header: head,
          height: 2,
          width: 2,
          encoding: 'rgb8',
          is_bigendian: 0,
          step: 6,
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
    const canvas = page.locator('.picture-canvas');
    const data = await canvas.evaluate((element) => {
      const context = new OffscreenCanvas(2, 2).getContext('2d', { willReadFrequently: true });
      if (element instanceof HTMLCanvasElement) context?.drawImage(element, 0, 0);
      return [...(context?.getImageData(0, 0, 2, 2).data ?? [])];
    });
    assert.deepEqual(data, [255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 255]);
    const box = (await canvas.boundingBox()) ?? assert.fail();
    await page.mouse.move(box.x + box.width / 2 + 20, box.y + box.height / 2 + 20);
    await page.getByText('(1, 1): R 9 G 8 B 7').waitFor();
    await page.evaluate(() =>
      globalThis.send('/camera', 'sensor_msgs/msg/Image', {
        header: { stamp: { sec: 0, nanosec: 0 }, frame_id: '' },
        height: 4000000,
        width: 4000000,
        encoding: 'rgb8',
        is_bigendian: 0,
        step: 6,
        data: [1],
      })
    );
    await page.getByText('Cannot be shown: 4000000 \u00d7 4000000 pixels are too many.').waitFor();
  }));

interface Frame {
  readonly encoding: string;
  readonly width: number;
  readonly data: readonly number[];
}

/** Sends it until the panel has it: who subscribes later gets the next one. */
async function show(page: Page, topic: string, frame: Frame, shown: string): Promise<void> {
  const send = (): Promise<void> =>
    page.evaluate(([name, { encoding, width, data }]) => {
      const height = Math.floor(data.length / width / (encoding === '16UC1' ? 2 : 1));
      globalThis.send(name, 'sensor_msgs/msg/Image', {
        header: { stamp: { sec: 0, nanosec: 0 }, frame_id: '' },
        height,
        width,
        encoding,
        is_bigendian: 0,
        step: data.length / height,
        data: [...data],
      });
    }, [topic, frame] as const);
  await send();
  await page.waitForFunction((name) => heard(name) > 0, topic);
  await send();
  await page.getByRole('img', { name: shown }).waitFor();
}

/** The picture's own pixels. */
function pixels(page: Page): Promise<readonly number[]> {
  return page.locator('.picture-canvas').evaluate((element) => {
    if (!(element instanceof HTMLCanvasElement)) return [];
    const context = new OffscreenCanvas(element.width, element.height).getContext('2d', { willReadFrequently: true });
    context?.drawImage(element, 0, 0);
    return [...(context?.getImageData(0, 0, element.width, element.height).data ?? [])];
  });
}

/** How large a pixel of the picture is, and where its corner stands in the view. */
function camera(page: Page): Promise<{ scale: number; x: number; y: number; }> {
  return page.locator('.picture-canvas').evaluate((element) => {
    const matrix = new DOMMatrix(getComputedStyle(element).transform);
    return { scale: matrix.a, x: matrix.e, y: matrix.f };
  });
}

test('a picture is zoomed and moved by keys, buttons, wheel and pointer, and keys tell its pixels', () =>
  stage.on(withPanels({ image: { topic: '/camera' } }), {}, async (page) => {
    const data = Array.from({ length: 64 * 32 }, (_, i) => (i * 7) % 256);
    await show(page, '/camera', { encoding: 'mono8', width: 64, data }, 'Image of /camera, 64 \u00d7 32, mono8');
    const view = page.getByRole('application', { name: /^Picture\. Arrow keys/ });
    const box = (await view.boundingBox()) ?? assert.fail();
    const whole = await camera(page);
    assert.ok(Math.abs(whole.scale - Math.min(box.width / 64, box.height / 32)) < 0.1, JSON.stringify(whole));
    const words = page.locator('.picture-words');
    const expected = (x: number, y: number): string => `(${x}, ${y}): ${((y * 64 + x) * 7) % 256}`;

    await view.focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await words.innerText(), expected(32, 16));
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowLeft');
    assert.equal(await words.innerText(), expected(31, 15));
    // Told to those who hear the page, too.
    await page.locator('[role=status]', { hasText: expected(31, 15) }).first().waitFor({ state: 'attached' });
    await page.keyboard.press('1');
    assert.ok(Math.abs((await camera(page)).scale - 1) < 1e-6);
    await page.keyboard.press('+');
    await page.keyboard.press('+');
    assert.ok(Math.abs((await camera(page)).scale - 2.25) < 1e-6);
    await page.keyboard.press('-');
    const before = await camera(page);
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('Shift+ArrowDown');
    const after = await camera(page);
    assert.deepEqual([Math.round(after.x - before.x), Math.round(after.y - before.y)], [-40, -40]);
    await page.keyboard.press('0');
    assert.deepEqual(await camera(page), whole);
    await page.keyboard.press('Escape');
    await words.waitFor({ state: 'detached' });

    await page.getByRole('button', { name: '1:1, each pixel as one' }).click();
    assert.ok(Math.abs((await camera(page)).scale - 1) < 1e-6);
    await page.getByText('100\u00a0%', { exact: true }).waitFor();
    await page.getByRole('button', { name: 'Zoom in' }).click();
    await page.getByRole('button', { name: 'Zoom in' }).click();
    await page.getByRole('button', { name: 'Zoom out' }).click();
    assert.ok(Math.abs((await camera(page)).scale - 1.5) < 1e-6);
    await page.getByRole('button', { name: 'Show the whole picture' }).click();
    assert.deepEqual(await camera(page), whole);

    // The pixel under the pointer stays there.
    const at = { x: box.x + whole.x + 10.5 * whole.scale, y: box.y + whole.y + 20.5 * whole.scale };
    await page.mouse.move(at.x, at.y);
    await words.getByText(expected(10, 20)).waitFor();
    await page.mouse.wheel(0, -200);
    await page.waitForFunction((scale) => {
      const canvas = document.querySelector('.picture-canvas');
      return canvas !== null && new DOMMatrix(getComputedStyle(canvas).transform).a > 1.3 * scale;
    }, whole.scale);
    await page.mouse.move(at.x + 1, at.y);
    await words.getByText(expected(10, 20)).waitFor();
    await page.mouse.down();
    await page.mouse.move(at.x + 61, at.y + 30, { steps: 4 });
    await page.mouse.up();
    await words.getByText(expected(10, 20)).waitFor();
    // A click chooses a pixel, which stays while the pointer goes elsewhere; a drag chooses none.
    await page.mouse.move(0, 0);
    await words.waitFor({ state: 'detached' });
    await page.mouse.click(at.x + 61, at.y + 30);
    await page.mouse.move(0, 0);
    await words.getByText(expected(10, 20)).waitFor();
    await page.locator('.picture-mark').waitFor();

    const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save the picture (PNG)' }).click()]);
    assert.equal(file.suggestedFilename(), 'camera.png');
    const png = readFileSync(await file.path());
    assert.equal(png.subarray(1, 4).toString('latin1'), 'PNG');
    // The whole picture, however it is zoomed: width and height stand at 16 and 20 of a PNG.
    assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [64, 32]);
  }));

test('depth has a range, automatic or as it is set, which links carry', () =>
  stage.on(withPanels({ image: { topic: '/camera' } }), {}, async (page) => {
    // 1000, 2000, 3000 and 4000 mm.
    const data = [1000, 2000, 3000, 4000].flatMap((mm) => [mm & 255, mm >> 8]);
    await show(page, '/camera', { encoding: '16UC1', width: 2, data }, 'Image of /camera, 2 \u00d7 2, 16UC1');
    const greys = async (): Promise<readonly number[]> => (await pixels(page)).filter((_, i) => i % 4 === 0);
    assert.deepEqual(await greys(), [0, 85, 170, 255]);
    const least = page.getByRole('spinbutton', { name: 'Black at' });
    const most = page.getByRole('spinbutton', { name: 'White at' });
    const automatic = page.getByRole('checkbox', { name: 'Automatic' });
    assert.equal(await automatic.isChecked(), true);
    assert.deepEqual([await least.getAttribute('placeholder'), await most.getAttribute('placeholder')], ['1000', '4000']);
    const drawn = async (wanted: readonly number[]): Promise<void> => {
      while ((await greys()).join() !== wanted.join()) await page.waitForTimeout(20);
    };
    // The image that stands there is drawn anew: no further one comes.
    await most.fill('6000');
    await most.press('Enter');
    await drawn([0, 51, 102, 153]);
    await least.fill('2000');
    await least.press('Enter');
    await drawn([0, 0, 64, 128]);
    assert.equal(await automatic.isChecked(), false);
    await page.reload();
    await page.waitForSelector('.panel-image');
    await show(page, '/camera', { encoding: '16UC1', width: 2, data }, 'Image of /camera, 2 \u00d7 2, 16UC1');
    assert.deepEqual([await least.inputValue(), await most.inputValue()], ['2000', '6000']);
    await drawn([0, 0, 64, 128]);
    await automatic.check();
    await drawn([0, 85, 170, 255]);
    await page.getByRole('application', { name: /^Picture/ }).focus();
    await page.keyboard.press('ArrowRight');
    await page.locator('.picture-words').getByText('(1, 1): 4000').waitFor();
  }));

test('compressed images are read by the browser, and what is none is told', () =>
  stage.on(withPanels({ image: { topic: '/camera/compressed' } }), {}, async (page) => {
    const send = (good: boolean): Promise<void> =>
      page.evaluate(async (right) => {
        const drawing = new OffscreenCanvas(8, 4);
        drawing.getContext('2d')?.fillRect(0, 0, 8, 4);
        const png = new Uint8Array(await (await drawing.convertToBlob()).arrayBuffer());
        globalThis.send('/camera/compressed', 'sensor_msgs/msg/CompressedImage', {
          header: { stamp: { sec: 0, nanosec: 0 }, frame_id: '' },
          format: 'png',
          data: right ? [...png] : [1, 2, 3],
        });
      }, good);
    await send(true);
    await page.waitForFunction(() => heard('/camera/compressed') > 0);
    await send(false);
    await page.getByText('this browser cannot read its format, png').waitFor();
    await send(true);
    await page.getByRole('img', { name: 'Image of /camera/compressed, 8 \u00d7 4, png' }).waitFor();
    await page.getByText('cannot read its format').waitFor({ state: 'detached' });
    await page.getByRole('application', { name: /^Picture/ }).focus();
    await page.keyboard.press('ArrowRight');
    await page.locator('.picture-words').getByText('(4, 2): R 0 G 0 B 0').waitFor();
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
        await picture(page);
        await expectAccessible(page);
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
        await page.getByRole('tab', { name: 'Log' }).click();
        await page.locator('.panel-log .lines').waitFor();
        await expectAccessible(page);
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
      },
    ));
}
