// The 3D view in Chromium, with messages that pass a real graph, drawn by SwiftShader.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { kSoftwareWebGl } from './chromium.ts';
import { PageStage, expectAccessible, phone } from './page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "world".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
  var goals: readonly unknown[];
}

let stage: PageStage;

before(async () => {
  stage = await PageStage.open(kSoftwareWebGl);
});

after(() => stage.close());

// What the software driver says when a picture of the page is taken.
const kDriver = /GL Driver Message|GPU stall/;

const withScene = (state: unknown): string =>
  `world#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', { scene: state }], sizes: [1, 4], shown: 'scene' }))}`;

function on(state: unknown, body: (page: Page) => Promise<void>): Promise<void> {
  return stage.on(withScene(state), {}, body, kDriver);
}

type Vector = readonly [number, number, number];

function transform(parent: string, child: string, [x, y, z]: Vector, yaw = 0, sec = 1): unknown {
  return {
    header: { stamp: { sec, nanosec: 0 }, frame_id: parent },
    child_frame_id: child,
    transform: { translation: { x, y, z }, rotation: { x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) } },
  };
}

/** Publishes once the panel listens. */
async function publish(page: Page, topic: string, type: string, value: unknown): Promise<void> {
  await page.evaluate(([name, kind, message]) => globalThis.send(name, kind, message), [topic, type, value] as const);
}

async function frames(page: Page, transforms: readonly unknown[]): Promise<void> {
  await publish(page, '/tf_static', 'tf2_msgs/msg/TFMessage', { transforms });
}

/** How many pixels of the drawing have a colour like this. */
async function pixels(page: Page, kind: 'red' | 'green' | 'blue'): Promise<number> {
  const png = (await page.locator('.scene-canvas').screenshot()).toString('base64');
  return page.evaluate(
    async ([data, wanted]) => {
      const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
      const picture = await createImageBitmap(new Blob([bytes]));
      const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d', { willReadFrequently: true });
      context?.drawImage(picture, 0, 0);
      const all = context?.getImageData(0, 0, picture.width, picture.height).data ?? [];
      const place = { red: 0, green: 1, blue: 2 }[wanted];
      let count = 0;
      for (let i = 0; i < all.length; i += 4) {
        const others = [0, 1, 2].filter((one) => one !== place).map((one) => all[i + one] ?? 0);
        if ((all[i + place] ?? 0) > Math.max(...others) + 40) count += 1;
      }
      return count;
    },
    [png, kind] as const,
  );
}

const drawings = (page: Page): Promise<number> =>
  page.locator('.scene-canvas').evaluate((canvas) => Number(canvas.dataset['drawings'] ?? 0));

const tree = [transform('map', 'base', [1, 0, 0]), transform('base', 'laser', [0, 0, 0.5])];

test('frames are drawn as axes where the tree says, and nothing is drawn when nothing moves', () =>
  on(null, async (page) => {
    await frames(page, tree);
    await page.getByText('3 frames').waitFor();
    await page.getByRole('option', { name: 'map (chosen for you)' }).waitFor({ state: 'attached' });
    for (const color of ['red', 'green', 'blue'] as const) assert.ok((await pixels(page, color)) > 30, color);
    // The same again moves nothing. What is sent after it is drawn, so that both have been looked at.
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', { transforms: [transform('map', 'arm', [0, 0, 1])] });
    await page.waitForFunction(() => heard('/tf') > 0);
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', { transforms: [transform('map', 'arm', [0, 0, 1])] });
    await page.getByText('4 frames').waitFor();
    const before = await drawings(page);
    for (let sec = 2; sec < 52; sec += 1)
      await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', { transforms: [transform('map', 'arm', [0, 0, 1], 0, sec)] });
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', { transforms: [transform('map', 'hand', [0, 0, 2])] });
    await page.getByText('5 frames').waitFor();
    assert.ok((await drawings(page)) <= before + 3, `${before} and then ${await drawings(page)}`);
  }));

test('the view turns, moves and zooms by mouse, wheel and keys, and is kept', () =>
  on(null, async (page) => {
    await frames(page, tree);
    await page.getByText('3 frames').waitFor();
    const canvas = page.locator('.scene-canvas');
    const box = (await canvas.boundingBox()) ?? assert.fail();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const changes = async (what: () => Promise<void>): Promise<void> => {
      const before = await canvas.screenshot();
      const drawn = await drawings(page);
      await what();
      await page.waitForFunction(
        (count) => Number(document.querySelector<HTMLElement>('.scene-canvas')?.dataset['drawings']) > count, drawn,
      );
      assert.notDeepEqual(await canvas.screenshot(), before);
    };
    const drag = async (dx: number, dy: number): Promise<void> => {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + dx, y + dy, { steps: 3 });
      await page.mouse.up();
    };
    await changes(() => drag(80, 30));
    await page.keyboard.down('Shift');
    await changes(() => drag(-60, 20));
    await page.keyboard.up('Shift');
    await changes(() => page.mouse.wheel(0, -200));
    for (const key of ['ArrowLeft', 'Shift+ArrowUp', '+', '-', 'Home']) {
      await canvas.focus();
      await changes(() => page.keyboard.press(key));
    }
    const top = page.getByRole('button', { name: 'See it from above' });
    await changes(() => top.click());
    await changes(() => drag(50, 0));
    await page.reload();
    await canvas.waitFor();
    await page.locator('.scene-canvas[data-drawings]').waitFor();
    assert.equal(await top.getAttribute('aria-pressed'), 'true');
  }));

test('scenes of hostile frames neither hang nor throw, and say what is wrong', () =>
  on({ frame: 'nowhere' }, async (page) => {
    await frames(page, [
      transform('b', 'a', [1, 0, 0]), transform('c', 'b', [1, 0, 0]), transform('a', 'c', [1, 0, 0]),
      transform('x', 'x', [1, 0, 0]), transform('', 'y', [1, 0, 0]), transform('z', 'far', [1e300, 0, 0]),
      transform('map', '<img src=x onerror="document.title=1">'.repeat(5), [1, 0, 0]),
      transform('map', 'n', [NaN, 0, 0]),
      ...Array.from({ length: 3000 }, (_, i) => transform(`f${i}`, `f${i + 1}`, [0.001, 0, 0])),
    ]);
    await page.getByText('the parents of a lead back to itself').waitFor();
    await page.getByText('0 frames').waitFor();
    const chosen = page.getByRole('combobox', { name: 'Fixed frame' });
    await page.getByRole('option', { name: 'nowhere (nobody speaks of it)' }).waitFor({ state: 'attached' });
    for (const [frame, words] of [['f0', '1000 frames'], ['a', '0 frames'], ['z', '1 frame'], ['map', '2 frames']] as const) {
      await chosen.selectOption(frame);
      await page.getByText(words, { exact: true }).waitFor();
    }
    const arm = { transforms: [transform('map', 'arm', [0, 0, 1])] };
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', arm);
    await page.waitForFunction(() => heard('/tf') > 0);
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', arm);
    await page.getByText('3 frames', { exact: true }).waitFor();
    // What is latched comes again.
    await page.getByRole('button', { name: 'Forget all frames' }).click();
    await page.getByText('2 frames', { exact: true }).waitFor();
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the 3D view, on a phone too, ${colorScheme}`, () =>
    stage.on(withScene(null), { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await frames(page, tree);
      await page.getByText('3 frames').waitFor();
      await expectAccessible(page);
      await page.setViewportSize({ width: 320, height: 568 });
      await page.getByRole('tab', { name: '3D view' }).click();
      await page.locator('.scene-canvas').waitFor();
      await expectAccessible(page);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
      assert.ok(((await page.locator('.scene-canvas').boundingBox())?.height ?? 0) >= 150);
    }, kDriver));
}

test('without WebGL the panel says so', async () => {
  const plain = await PageStage.open(['--disable-3d-apis']);
  try {
    await plain.on(withScene(null), phone, async (page) => {
      await page.getByRole('alert').getByText('gives the page no WebGL').waitFor();
      await expectAccessible(page);
    }, kDriver);
  } finally {
    await plain.close();
  }
});
