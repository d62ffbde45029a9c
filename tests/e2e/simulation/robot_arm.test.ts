// Example 04, packed: its checks without a browser, and its arm in the 3D view of the page, moved by a parameter.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import type { Browser, Page } from 'playwright-core';
import { chromiumOptions, SOFTWARE_WEB_GL } from '../support/chromium.ts';
import { packExample } from '../support/example_site.ts';
import { Scratch, ServedSite, runCli } from '../support/served_site.ts';

const EXAMPLE = fileURLToPath(new URL('../../../examples/04_robot_arm', import.meta.url));
const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const watchdog = { timeout: 600_000 };
const scratch = new Scratch();
let site: string;
let browser: Browser;

before(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  site = await packExample(scratch, '04_robot_arm');
  browser = await chromium.launch(chromiumOptions(SOFTWARE_WEB_GL));
});

after(async () => {
  await browser.close();
  scratch[Symbol.dispose]();
});

test('the arm waves, its checks pass, and it can begin without waving', watchdog, async () => {
  // Stepped, so that a loaded machine changes no rate.
  const stepped = await runCli(['run', site, '--stepped', '--checks']);
  const said = stepped.output + stepped.errors;
  assert.equal(stepped.code, 0, said);
  assert.match(said, /3 of 3 checks passed/);
  for (const line of readFileSync(join(EXAMPLE, 'expected.txt'), 'utf8').trimEnd().split('\n'))
    assert.match(stepped.output, new RegExp(line));
  const waiting = await runCli([
    'run',
    site,
    'wave:=false',
    '--link',
    'port',
    '--for',
    '120s',
    '--until',
    'waiting for a joint to be set',
  ]);
  assert.equal(waiting.code, 0, waiting.output + waiting.errors);
});

test('the page shows the arm, which goes where a parameter says and turns to a goal', watchdog, async () => {
  await using server = await ServedSite.start([site, '--port', '0']);
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(120_000);
  const troubles: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  const meshes: string[] = [];
  page.on('response', (response) => {
    if (response.url().endsWith('/share/robot_arm/meshes/finger.stl')) meshes.push(`${response.status()} ${response.url().replace(server.url, '')}`);
  });
  // Beside the scene, in numbers: where the finger is, which all joints move.
  const finger = { frames: { source: 'left_finger', target: 'world' } };
  const layout = { row: [{ column: ['parameters', finger, 'console'] }, { scene: { names: false, list: false } }], sizes: [2, 3] };
  await page.goto(`${server.url}#layout=${encodeURIComponent(JSON.stringify(layout))}`);
  await page.locator('.panel-scene').getByText('8 frames', { exact: true }).waitFor();
  const canvas = page.locator('.scene-canvas');
  // It waves: the picture changes again and again.
  await drawnMore(page, 20);
  const turn = page.getByRole('textbox', { name: 'turn of /arm/mover', exact: true });
  await turn.fill('1.5');
  await turn.press('Enter');
  await page.getByText('turn goes to 1.50').first().waitFor();
  await turnedTo(page, 1.5);
  await canvas.screenshot({ path: join(OUTPUT, 'robot_arm.png') });
  // The sliders that the README names, as far as they go.
  await page.getByRole('slider', { name: 'turn of /arm/mover, slider', exact: true }).press('End');
  await page.getByText('turn goes to 3.10').first().waitFor();
  await turnedTo(page, 3.1);
  const before = await canvas.screenshot();
  await page.getByRole('button', { name: 'Set a goal' }).click();
  const box = (await canvas.boundingBox()) ?? assert.fail();
  await canvas.click({ position: { x: box.width * 0.2, y: box.height * 0.85 } });
  const said = await page.getByText(/turn goes to -?\d\.(?!50|10)\d\d/).first().textContent();
  await turnedTo(page, Number(/to (-?[\d.]+)/.exec(said ?? '')?.[1]));
  // The numbers and the picture are each drawn at their own pace.
  while ((await canvas.screenshot()).equals(before));
  await page.screenshot({ path: join(OUTPUT, 'robot_arm_page.png') });
  // The fingers are one mesh, asked for once.
  assert.deepEqual(meshes, ['200 share/robot_arm/meshes/finger.stl']);
  const hand = { scene: { names: false, frames: false, frame: 'hand', view: { distance: 0.6, azimuth: 0.9 } } };
  await page.goto(`${server.url}#layout=${encodeURIComponent(JSON.stringify(hand))}`);
  meshes.length = 0;
  await page.reload();
  await page.locator('.panel-scene').getByText('8 frames', { exact: true }).waitFor();
  while (meshes.length === 0) await drawnMore(page, 1);
  await drawnMore(page, 3);
  assert.equal(await page.locator('.scene-problem').count(), 0);
  await canvas.screenshot({ path: join(OUTPUT, 'robot_arm_hand.png') });
  assert.deepEqual(troubles, []);
  await page.close();
});

test('without the waving, sliders of the panel Joints move the arm, and leave it to the mover when they rest', watchdog, async () => {
  await using server = await ServedSite.start([site, '--port', '0']);
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(120_000);
  const finger = { frames: { source: 'left_finger', target: 'world' } };
  const layout = { row: ['parameters', { joints: { topic: '/arm/joint_states' } }, { column: [finger, 'console'] }] };
  await page.goto(`${server.url}?wave:=false#layout=${encodeURIComponent(JSON.stringify(layout))}`);
  await page.getByText('waiting for a joint to be set').waitFor();
  await turnedTo(page, 0);
  const joints = page.locator('.panel-joints');
  await joints.getByRole('slider', { name: 'turn' }).press('Home');
  await turnedTo(page, -3.1);
  // Nobody else pulls it back: it stands there in each of the next pictures.
  const yaws = await page.evaluate(() =>
    new Promise<string[]>((done) => {
      const seen: string[] = [];
      const look = (): void => {
        seen.push([...document.querySelectorAll('.frames-between .frames-number')][9]?.lastChild?.textContent ?? '');
        if (seen.length < 90) requestAnimationFrame(look);
        else done(seen);
      };
      look();
    })
  );
  assert.deepEqual([...new Set(yaws)].filter((yaw) => !/^-3\.(09|10)/.test(yaw)), []);
  await page.screenshot({ path: join(OUTPUT, 'robot_arm_joints.png') });
  await joints.getByRole('checkbox', { name: 'Publish' }).uncheck();
  await page.getByRole('slider', { name: 'turn of /arm/mover, slider', exact: true }).press('End');
  await turnedTo(page, 3.1);
  await page.close();
});

/** Waits until the scene was drawn so many times more. */
async function drawnMore(page: Page, count: number): Promise<void> {
  const now = await page.locator('.scene-canvas').evaluate((canvas) => Number(canvas.dataset['drawings'] ?? 0));
  await page.waitForFunction(
    (wanted) => Number(document.querySelector<HTMLElement>('.scene-canvas')?.dataset['drawings']) >= wanted,
    now + count,
  );
}

/** Waits until the arm stands upright with its hand closed, turned so far: where it comes to rest when only the turn is set. */
async function turnedTo(page: Page, turn: number): Promise<void> {
  await page.waitForFunction((wanted) => {
    // Translation, quaternion, roll, pitch and yaw in radians.
    const [x = NaN, y = NaN, , , , , , roll = NaN, pitch = NaN, yaw = NaN] = [
      ...document.querySelectorAll('.frames-between .frames-number'),
    ].map((each) => Number(each.lastChild?.textContent));
    const isUpright = Math.abs(roll) < 0.001 && Math.abs(pitch) < 0.001;
    // Closed, a finger is a centimetre from the middle.
    return isUpright && Math.abs(Math.hypot(x, y) - 0.01) < 0.0005 && Math.abs(yaw - wanted) < 0.006;
  }, turn);
}
