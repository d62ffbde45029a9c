// The panel that drives, in Chromium with subscriptions on a real graph: keys, buttons, finger, gamepad; one zero when it
// is let go and nothing after it, however it is let go.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import type { Heard } from '../support/page_fake_teleop.ts';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

declare global {
  // Set by page_fake_teleop.ts.
  var driven: Heard[];
  var arrive: (node: string, topic: string, type: string) => void;
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
type Place = readonly [x: number, y: number];

const scene = (state: unknown = {}): string => `teleop#layout=${encodeURIComponent(JSON.stringify({ teleop: state }))}`;

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

const pad = (page: Page) => page.locator('.drive-pad');

/** The panel knows who waits to be driven. */
async function ready(page: Page): Promise<void> {
  await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.panel-teleop input[list]')?.value === '/turtle1/cmd_vel');
  await pad(page).waitFor();
}

/** Until some message since the last look was this one; the looks end when it was a zero, and then nothing comes after it. */
const hears = (page: Page, linear: number, angular: number, topic = '/turtle1/cmd_vel'): Promise<unknown> =>
  page.waitForFunction(
    ([x, z, on]) => driven.some((heard) => heard.topic === on && Math.abs(heard.linear - x) < 1e-9 && Math.abs(heard.angular - z) < 1e-9),
    [linear, angular, topic] as const,
  );

/** It stands still: the last message is a zero, the only one, and no timer sends another. */
async function stopped(page: Page, topic = '/turtle1/cmd_vel'): Promise<void> {
  await page.waitForFunction(() => driven.at(-1)?.linear === 0 && driven.at(-1)?.angular === 0);
  await page.getByText('at rest, nothing is sent').waitFor();
  const before = await page.evaluate(() => driven.length);
  // As long as some messages would have taken, by the timers that would have sent them.
  await page.evaluate(() =>
    new Promise<void>((done) => {
      let rings = 0;
      const timer = fake.node().timer(20, () => {
        rings += 1;
        if (rings < 15) return;
        timer.close();
        done();
      });
    })
  );
  const all = await page.evaluate(() => driven);
  assert.equal(all.length, before, 'it is silent');
  assert.equal(all.filter(({ linear, angular }) => linear === 0 && angular === 0).length, 1, 'one zero');
  assert.ok(all.every((heard) => heard.topic === topic));
  await page.evaluate(() => {
    driven.length = 0;
  });
}

test('keys drive while they are held, together too, and only in the pad', () =>
  stage.on(scene({ linear: 2, angular: 1.5, rate: 50 }), {}, async (page) => {
    await ready(page);
    assert.equal(await page.getByRole('combobox', { name: 'Topic' }).inputValue(), '/turtle1/cmd_vel');
    await page.keyboard.press('ArrowUp');
    await pad(page).focus();
    await page.keyboard.down('ArrowUp');
    await hears(page, 2, 0);
    await page.waitForFunction(() => driven.length > 4);
    await page.keyboard.down('a');
    await hears(page, 2, 1.5);
    await page.getByText('2.00\u00a0m/s, 1.50\u00a0rad/s').waitFor();
    await page.screenshot({ path: join(OUTPUT, 'teleop.png') });
    await expectAccessible(page);
    await page.keyboard.up('ArrowUp');
    await hears(page, 0, 1.5);
    await page.keyboard.up('a');
    await stopped(page);
    await page.keyboard.down('s');
    await hears(page, -2, 0);
    await page.keyboard.press('Space');
    await stopped(page);
  }));

test('it stops when the focus goes, when the window does, when the page is hidden, and when the panel is closed', () =>
  stage.on(scene({ rate: 50 }), {}, async (page) => {
    await ready(page);
    const drive = async (): Promise<void> => {
      await pad(page).focus();
      await page.keyboard.down('ArrowRight');
      await hears(page, 0, -1);
    };
    await drive();
    await page.getByRole('combobox', { name: 'Topic' }).focus();
    await stopped(page);
    await page.keyboard.up('ArrowRight');
    await drive();
    await page.evaluate(() => window.dispatchEvent(new Event('blur')));
    await stopped(page);
    await page.keyboard.up('ArrowRight');
    await drive();
    await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
    await stopped(page);
    await page.keyboard.up('ArrowRight');
    await drive();
    await page.keyboard.down('Control');
    await stopped(page);
    await page.keyboard.up('Control');
    await page.keyboard.up('ArrowRight');
    await drive();
    await page.getByRole('button', { name: 'Move or close Teleop' }).click();
    await page.waitForFunction(() => driven.at(-1)?.angular === 0);
    await page.getByRole('menuitem', { name: 'Close Teleop' }).click();
    await page.waitForFunction(() => fake.broker.link.records().every(({ kind, name }) => kind !== 1 || name !== '/turtle1/cmd_vel'));
    await page.keyboard.up('ArrowRight');
  }));

test('the panel goes while a finger drives: the robot stands still', () =>
  stage.on(scene({ rate: 50 }), {}, async (page) => {
    await ready(page);
    const box = (await pad(page).boundingBox()) ?? assert.fail();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y - 200, { steps: 3 });
    await hears(page, 0.5, 0);
    await page.evaluate(() => {
      location.hash = `layout=${encodeURIComponent('"nodes"')}`;
    });
    await page.locator('.panel-nodes').waitFor();
    await page.waitForFunction(() => driven.at(-1)?.linear === 0);
    await page.waitForFunction(() => fake.broker.link.records().every(({ kind, name }) => kind !== 1 || name !== '/turtle1/cmd_vel'));
    await page.mouse.up();
  }));

test('the knob follows the pointer, and buttons drive while they are held', () =>
  stage.on(scene({ linear: 1, angular: 1, rate: 50 }), {}, async (page) => {
    await ready(page);
    const box = (await pad(page).boundingBox()) ?? assert.fail();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x, y + (box.height / 100) * 16, { steps: 3 });
    await page.waitForFunction(() => driven.some(({ linear, angular }) => linear < -0.4 && linear > -0.6 && Math.abs(angular) < 0.1));
    await page.mouse.move(x - 500, y, { steps: 3 });
    await page.waitForFunction(() => driven.some(({ linear, angular }) => Math.abs(linear) < 0.1 && angular > 0.99));
    await page.mouse.up();
    await stopped(page);
    const left = (await page.getByRole('button', { name: 'Turn left' }).boundingBox()) ?? assert.fail();
    await page.mouse.move(left.x + 10, left.y + 10);
    await page.mouse.down();
    await hears(page, 0, 1);
    await page.mouse.move(5, 5);
    await page.mouse.up();
    await stopped(page);
    await page.getByRole('button', { name: 'Back' }).focus();
    await page.keyboard.down('Enter');
    await hears(page, -1, 0);
    await page.keyboard.up('Enter');
    await stopped(page);
    // Without anything that is held: a short way.
    await page.getByRole('button', { name: 'Ahead' }).evaluate((button: HTMLButtonElement) => button.click());
    await hears(page, 1, 0);
    await stopped(page);
  }));

test('a finger drives by the pad and scrolls nothing; it is let go when it is lifted and when the browser takes it', () =>
  stage.on(scene({ linear: 1, angular: 1, rate: 50 }), { viewport: { width: 360, height: 480 }, hasTouch: true, isMobile: true }, async (page) => {
    await ready(page);
    const devtools = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd' | 'touchCancel', ...touchPoints: { x: number; y: number; }[]) =>
      devtools.send('Input.dispatchTouchEvent', { type, touchPoints });
    const slide = async ([fromX, fromY]: Place, [toX, toY]: Place): Promise<void> => {
      for (let part = 1; part <= 8; part += 1)
        await touch('touchMove', { x: fromX + ((toX - fromX) * part) / 8, y: fromY + ((toY - fromY) * part) / 8 });
    };
    const scrolled = (): Promise<number> => page.evaluate(() => [...document.querySelectorAll('*')].reduce((sum, { scrollTop }) => sum + scrollTop, 0));
    // This page scrolls under a finger, where it is not on the pad.
    const body = (await page.locator('.panel-teleop .panel-body').boundingBox()) ?? assert.fail();
    const top = body.y + 30;
    await touch('touchStart', { x: body.x + 4, y: top + 200 });
    await slide([body.x + 4, top + 200], [body.x + 4, top]);
    await touch('touchEnd');
    await page.waitForFunction(() => [...document.querySelectorAll('*')].some(({ scrollTop }) => scrollTop > 0));
    assert.deepEqual(await page.evaluate(() => driven), []);
    for (const end of ['touchEnd', 'touchCancel'] as const) {
      await pad(page).scrollIntoViewIfNeeded();
      const at = await scrolled();
      const box = (await pad(page).boundingBox()) ?? assert.fail();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      await touch('touchStart', { x, y });
      await slide([x, y], [x, y - box.height]);
      await hears(page, 1, 0);
      // As long as the finger stays, again and again.
      const heard = await page.evaluate(() => driven.length);
      await page.waitForFunction((before) => driven.length > before + 5, heard);
      assert.deepEqual(await page.evaluate(() => driven.at(-1)), { topic: '/turtle1/cmd_vel', linear: 1, angular: 0 });
      // Round the middle, where it would stand still.
      await slide([x, y - box.height], [x + box.width, y]);
      await hears(page, 0, -1);
      await touch(end);
      await stopped(page);
      assert.equal(await scrolled(), at, 'nothing scrolled');
    }
    await devtools.detach();
  }));

test('a gamepad drives by its sticks and its cross', () =>
  stage.on(scene({ linear: 1, angular: 2, rate: 50 }), {}, async (page) => {
    await ready(page);
    const set = (axes: readonly number[], pressed: number): Promise<void> =>
      page.evaluate(
        ([values, button]) => {
          const buttons = Array.from({ length: 17 }, (_, index) => ({ pressed: index === button }));
          Object.assign(navigator, { getGamepads: () => [null, { id: '<b>Pad</b>', connected: true, axes: values, buttons }] });
        },
        [axes, pressed] as const,
      );
    await set([0, 0.02, 0, 0], -1);
    await page.evaluate(() => window.dispatchEvent(new Event('gamepadconnected')));
    await page.getByText('Gamepad: <b>Pad</b>').waitFor();
    await set([0, -1, 0, 0], -1);
    await hears(page, 1, 0);
    await set([0, -1, 1, 0], -1);
    await hears(page, 1, -2);
    // One more robot, the first by its name: it is not driven.
    await page.evaluate(() => arrive('alpha', '/alpha/cmd_vel', 'geometry_msgs/msg/Twist'));
    await page.locator('datalist option[value="/alpha/cmd_vel"]').waitFor({ state: 'attached' });
    assert.equal(await page.getByRole('combobox', { name: 'Topic' }).inputValue(), '/turtle1/cmd_vel');
    await set([0.1, -0.1, 0, 0], -1);
    await stopped(page);
    await set([0, 0, 0, 0], 14);
    await hears(page, 0, 2);
    await page.getByRole('checkbox', { name: /^Gamepad/ }).uncheck();
    await stopped(page);
  }));

test('TwistStamped is taken from the graph or chosen, with the time of the site', () =>
  stage.on(scene({ rate: 50, linear: 3 }), {}, async (page) => {
    await ready(page);
    const topic = page.getByRole('combobox', { name: 'Topic' });
    await topic.fill('z/cmd_vel');
    await topic.press('Enter');
    await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.panel-teleop input[list]')?.value === '/z/cmd_vel');
    await page.getByRole('textbox', { name: 'frame_id' }).fill('base_link');
    await pad(page).focus();
    await page.keyboard.down('w');
    await hears(page, 3, 0, '/z/cmd_vel');
    await page.keyboard.up('w');
    assert.equal(await page.evaluate(() => driven.every(({ frame, sec }) => frame === 'base_link' && (sec ?? 0) > 1_700_000_000)), true);
    await stopped(page, '/z/cmd_vel');
    await page.getByRole('checkbox', { name: 'TwistStamped' }).uncheck();
    await page.getByText('Nobody waits for geometry_msgs/msg/Twist on /z/cmd_vel yet.').waitFor();
    await topic.fill('/no name');
    // A topic that appears in the meantime does not change the text that is being typed.
    await page.evaluate(() => arrive('/more', '/more/cmd_vel', 'geometry_msgs/msg/Twist'));
    await page.waitForFunction(() => document.querySelector('.panel-teleop datalist option[value="/more/cmd_vel"]') !== null);
    assert.equal(await topic.inputValue(), '/no name');
    await topic.press('Enter');
    await pad(page).focus();
    await page.getByRole('alert').getByText(/is not a valid name/).waitFor();
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`a phone of 320 px shows it, and axe finds nothing, ${colorScheme}`, () =>
    stage.on(scene(), { ...phone, viewport: { width: 320, height: 568 }, hasTouch: true, colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await ready(page);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth), false);
      const over = await page.locator('.panel-teleop .panel-body').evaluate((body) => body.scrollWidth - body.clientWidth);
      assert.ok(over <= 0, `${over} px too wide`);
      await expectAccessible(page);
      await page.screenshot({ path: join(OUTPUT, `teleop_phone_${colorScheme}.png`) });
    }));
}
