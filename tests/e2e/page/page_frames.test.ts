// The tree of frames in Chromium, from transforms that really pass the graph.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "world".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

const withFrames = (state: unknown = {}): string =>
  `world#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', { frames: state }], sizes: [1, 3], shown: 'frames' }))}`;

interface Step {
  readonly parent: string;
  readonly child: string;
  readonly x?: number;
  readonly yaw?: number;
}

/** Tells transforms, at the site's time, until the panel has them: its subscription comes a moment after it is drawn. */
async function tell(page: Page, topic: '/tf' | '/tf_static', steps: readonly Step[]): Promise<void> {
  await page.evaluate(
    ([name, list]) => {
      const now = fake.time.view().now;
      const stamp = { sec: Math.floor(now / 1000), nanosec: (now % 1000) * 1e6 };
      const transforms = list.map(({ parent, child, x = 0, yaw = 0 }) => ({
        header: { stamp, frame_id: parent },
        child_frame_id: child,
        transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) } },
      }));
      send(name, 'tf2_msgs/msg/TFMessage', { transforms });
    },
    [topic, steps] as const,
  );
  // The first one was for making the publisher, if nobody heard it.
  await page.waitForFunction((name) => heard(name) > 0, topic);
}

const names = (page: Page): Promise<string[]> => page.locator('.panel-frames .topic-name').evaluateAll((all) => all.map((each) => each.textContent));

const row = (page: Page, name: string) =>
  page.locator('.panel-frames .topic').filter({ has: page.locator('.topic-name').filter({ hasText: new RegExp(`^${name}$`) }) });

async function robot(page: Page): Promise<void> {
  const moving = [{ parent: 'odom', child: 'base_link', x: 2, yaw: Math.PI / 2 }, { parent: 'map', child: 'odom', x: 1 }];
  await tell(page, '/tf', moving);
  await tell(page, '/tf_static', [{ parent: 'base_link', child: 'laser', x: 0.5 }]);
  for (let i = 0; i < 5; i += 1) await tell(page, '/tf', moving);
  await row(page, 'laser').waitFor();
  await row(page, 'odom').waitFor();
}

test('frames stand below their parents, with rate, age and what is static', () =>
  stage.on(withFrames(), {}, async (page) => {
    await page.getByText('No transforms yet.').waitFor();
    await robot(page);
    assert.deepEqual(await names(page), ['map', 'odom', 'base_link', 'laser']);
    await page.getByText('4 frames').waitFor();
    await row(page, 'laser').getByText('static').waitFor();
    await row(page, 'laser').getByText('in base_link').waitFor();
    const timer = await page.evaluate(() =>
      setInterval(() => {
        const now = fake.time.view().now;
        const header = { stamp: { sec: Math.floor(now / 1000), nanosec: (now % 1000) * 1e6 }, frame_id: 'map' };
        send('/tf', 'tf2_msgs/msg/TFMessage', { transforms: [{ header, child_frame_id: 'odom', transform: { rotation: { w: 1 } } }] });
      }, 50) as unknown as number
    );
    await row(page, 'odom').getByText(/Hz$/).waitFor();
    // Nothing more comes: it grows old.
    await page.evaluate((id) => clearInterval(id), timer);
    await row(page, 'odom').getByText(/^[1-9]\S* s ago$/).waitFor();
    await row(page, 'base_link').getByRole('button').click();
    const facts = row(page, 'base_link').locator('dl');
    await facts.getByText('Translation (m)').waitFor();
    assert.match((await facts.textContent()) ?? '', /x 2\.0000.*z 0\.7071.*w 0\.7071.*yaw 1\.5708.*yaw 90\.0000/);
    await page.screenshot({ path: join(OUTPUT, 'frames.png') });
    await page.getByRole('searchbox', { name: 'Filter frames' }).fill('LAS');
    await row(page, 'odom').waitFor({ state: 'detached' });
    assert.deepEqual(await names(page), ['laser']);
  }));

test('two frames are chosen, and the one is shown in the other', () =>
  stage.on(withFrames(), {}, async (page) => {
    await robot(page);
    const between = page.getByRole('region', { name: 'From one frame to another' });
    await between.getByText('Choose two frames').waitFor();
    await between.getByRole('combobox', { name: 'Where is' }).selectOption('laser');
    await between.getByRole('combobox', { name: 'seen from' }).selectOption('map');
    const facts = between.locator('dl');
    await facts.waitFor();
    // One on, two on, then half a metre to the left: turned by the base.
    assert.match((await facts.textContent()) ?? '', /x 3\.0000.*y 0\.5000.*yaw 90\.0000/);
    // The choice is in the link.
    await page.reload();
    await page.waitForSelector('.panel-frames');
    await robot(page);
    await facts.waitFor();
    await tell(page, '/tf', [{ parent: 'world', child: 'other' }]);
    await between.getByRole('combobox', { name: 'seen from' }).selectOption('other');
    await between.getByText('They belong to two trees').waitFor();
  }));

test('several trees, rings of parents and transforms that are none are told', () =>
  stage.on(withFrames(), {}, async (page) => {
    await robot(page);
    assert.equal(await page.locator('.frames-fault').count(), 0);
    await tell(page, '/tf', [{ parent: 'world', child: 'other' }]);
    await page.getByText('2 trees that do not hang together, below map, world.').waitFor();
    await tell(page, '/tf', [{ parent: 'a', child: 'b' }, { parent: 'b', child: 'a' }]);
    await page.getByText('A ring of parents, so the place of these frames is unknown: a in b in a').waitFor();
    await tell(page, '/tf', [{ parent: 'same', child: 'same' }, { parent: 'map', child: 'far', x: Number.NaN }]);
    await page.getByText('2 transforms were refused').waitFor();
    await page.screenshot({ path: join(OUTPUT, 'frames_broken.png') });
  }));

test('hostile names are text', () =>
  stage.on(withFrames(), {}, async (page) => {
    const name = '<img src=x onerror="document.title=\'owned\'">';
    await tell(page, '/tf', [{ parent: 'map', child: 'odom' }]);
    await tell(page, '/tf', [{ parent: name, child: '__proto__' }, { parent: '__proto__', child: 'x'.repeat(250) }]);
    await page.getByText(name, { exact: true }).first().waitFor();
    assert.equal(await page.locator('.panel-frames img').count(), 0);
    assert.notEqual(await page.title(), 'owned');
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the frames, ${colorScheme}`, () =>
    stage.on(withFrames({ source: 'laser', target: 'map' }), { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await robot(page);
      await tell(page, '/tf', [{ parent: 'world', child: 'other' }]);
      await page.getByText('2 trees that do not hang together').waitFor();
      await row(page, 'laser').getByRole('button').click();
      await expectAccessible(page);
    }));
}

test('the frames fit a phone, and are worked by keyboard', () =>
  stage.on(withFrames({ source: 'laser', target: 'map' }), { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await robot(page);
    await row(page, 'laser').getByRole('button').focus();
    await page.keyboard.press('Enter');
    await row(page, 'laser').locator('dl').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    await page.screenshot({ path: join(OUTPUT, 'frames_phone.png') });
    await expectAccessible(page);
  }));
