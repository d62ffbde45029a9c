// The tools, settings and pictures of the 3D view in Chromium, by mouse and by keys, with messages that pass a real graph.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { SOFTWARE_WEB_GL } from '../support/chromium.ts';
import { PageStage, expectAccessible } from '../support/page_stage.ts';
import { pixels } from '../support/scene_pixels.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
// Warnings of the software driver when a picture of the page is taken.
const DRIVER = /GL Driver Message|GPU stall/;
let stage: PageStage;

before(async () => {
  stage = await PageStage.open(SOFTWARE_WEB_GL);
});

after(() => stage.close());

function on(state: unknown, body: (page: Page) => Promise<void>): Promise<void> {
  const layout = encodeURIComponent(JSON.stringify({ row: ['nodes', { scene: state }], sizes: [1, 4], shown: 'scene' }));
  return stage.on(`world#layout=${layout}`, {}, body, DRIVER);
}

const header = (frame: string): unknown => ({ stamp: { sec: 1, nanosec: 0 }, frame_id: frame });
const TOP = { view: { top: true }, grid: false, frames: false, names: false };

/** Again and again until the page has it: volatile messages find who listens. */
async function tell(page: Page, topic: string, type: string, value: unknown): Promise<void> {
  await page.evaluate(([name, kind, message]) => globalThis.send(name, kind, message), [topic, type, value] as const);
  await page.waitForFunction((name) => heard(name) > 0, topic);
  await page.evaluate(([name, kind, message]) => globalThis.send(name, kind, message), [topic, type, value] as const);
}

async function mapFrame(page: Page): Promise<void> {
  const transform = { translation: { x: 0, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } };
  await page.evaluate((transforms) => globalThis.send('/tf_static', 'tf2_msgs/msg/TFMessage', { transforms }), [
    { header: header('map'), child_frame_id: 'base', transform: { ...transform, translation: { x: 1, y: 0, z: 0 } } },
  ]);
  await page.getByText('2 frames').waitFor();
}

/** The words beside the tools may have moved the canvas: asked for when a tool is in hand. */
async function middle(page: Page): Promise<readonly [number, number]> {
  const box = (await page.locator('.scene-canvas').boundingBox()) ?? assert.fail();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

const drawings = (page: Page): Promise<number> => page.locator('.scene-canvas').evaluate((canvas) => Number(canvas.dataset['drawings'] ?? 0));

const told = (page: Page, count: number): Promise<unknown> => page.waitForFunction((wanted) => goals.length === wanted, count);
const goal = (page: Page, index: number): Promise<Record<string, unknown>> =>
  page.evaluate(
    (at) =>
      JSON.parse(JSON.stringify(goals[at], (_, value: unknown) => (ArrayBuffer.isView(value) ? [...(value as Float64Array)] : value))) as Record<string,
        unknown>,
    index,
  );

// Compatibility, works: RViz's tools 2D Goal Pose, 2D Pose Estimate (with its covariance) and Publish Point, by mouse and keys
test("the pose is estimated with RViz's covariance, and points are published, by mouse and by keys", () =>
  on(TOP, async (page) => {
    await mapFrame(page);
    const canvas = page.locator('.scene-canvas');
    await page.getByRole('button', { name: 'Estimate the pose: publishes on /initialpose' }).click();
    await page.getByText('Press where the robot is').waitFor();
    const [x, y] = await middle(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 90, y, { steps: 3 });
    await page.mouse.up();
    await page.locator('.scene-said').getByText(/^Estimate published: -?0\.\d\d, -?0\.\d\d, -?180\u00b0$/).waitFor();
    await told(page, 1);
    const { header: { frame_id: frame }, pose } = await goal(page, 0) as {
      header: { frame_id: string; };
      pose: { pose: { orientation: { z: number; }; }; covariance: readonly number[]; };
    };
    assert.equal(frame, 'map');
    assert.ok(Math.abs(Math.abs(pose.pose.orientation.z) - 1) < 0.01);
    assert.deepEqual(pose.covariance.flatMap((value, index) => (value === 0 ? [] : [[index, value]])), [[0, 0.25], [7, 0.25], [35, 0.06853891909122467]]);
    // Keys: a quarter of a turn to the left of what is ahead.
    for (let i = 0; i < 6; i += 1) await canvas.press('[');
    await canvas.press('Enter');
    await page.locator('.scene-said').getByText(/, 90\u00b0$/).waitFor();
    await told(page, 2);
    await canvas.press('Escape');
    await page.getByText('2 frames').waitFor();
    await page.getByRole('button', { name: 'Publish a point on /clicked_point' }).click();
    await page.getByText('Press on a place.').waitFor();
    await page.mouse.click(...await middle(page));
    await told(page, 3);
    const { point } = await goal(page, 2) as { point: { x: number; y: number; z: number; }; };
    assert.ok(Math.hypot(point.x, point.y, point.z) < 0.05, JSON.stringify(point));
    await canvas.press('Enter');
    await told(page, 4);
    await page.locator('.scene-said').getByText(/^Point published: -?0\.0\d, -?0\.0\d, 0\.00$/).waitFor();
  }));

async function cloud(page: Page): Promise<void> {
  const points: (readonly [number, number, number, number])[] = Array.from({ length: 200 }, (_, i) => [Math.cos(i), Math.sin(i), 0.5, i]);
  points.push([0, 0, 0.25, 42]);
  await tell(page, '/points', 'sensor_msgs/msg/PointCloud2', {
    header: header('map'),
    height: 1,
    width: points.length,
    is_bigendian: false,
    point_step: 16,
    row_step: 16 * points.length,
    is_dense: true,
    fields: ['x', 'y', 'z', 'ring'].map((name, index) => ({ name, offset: index * 4, datatype: 7, count: 1 })),
    data: [...new Uint8Array(Float32Array.from(points.flat()).buffer)],
  });
}

test('what is pressed on says its topic, frame, stamp and values, and so does the list; two points are measured', () =>
  on(TOP, async (page) => {
    await mapFrame(page);
    await cloud(page);
    const canvas = page.locator('.scene-canvas');
    while ((await pixels(page, 'blue')) + (await pixels(page, 'green')) < 5);
    await page.getByRole('button', { name: 'Inspect something' }).click();
    await page.getByText('Press on something.').waitFor();
    await page.mouse.click(...await middle(page));
    const details = page.getByRole('region', { name: 'Details of /points' });
    const words = (await details.locator('dl').innerText()).replaceAll('\n', ' ');
    for (const part of ['/points (sensor_msgs/msg/PointCloud2)', 'Frame map', 'Stamp 1.000000', 'ring 42', 'point 200', '0.250'])
      assert.ok(words.includes(part), `${part} in ${words}`);
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'scene_details.png') });
    await page.getByRole('button', { name: 'Close the details' }).click();
    // By keys: the middle of the picture.
    await canvas.press('Enter');
    await details.waitFor();
    await page.getByRole('button', { name: 'Close the details' }).click();
    await page.getByRole('button', { name: 'Details of /points' }).press('Enter');
    await details.getByText('Newest message').click();
    await details.getByText('point_step').waitFor();
    await page.getByRole('button', { name: 'Measure between two points' }).click();
    await page.getByText('Press on two places.').waitFor();
    const [x, y] = await middle(page);
    const perMetre = await page.locator('.scene-canvas').evaluate((element) => element.clientHeight / (2 * 6 * Math.tan(Math.PI / 8)));
    await page.mouse.click(x, y + perMetre * 1.5);
    await page.locator('.scene-said').getByText('press on the other place').waitFor();
    const [nextX, nextY] = await middle(page);
    await page.mouse.click(nextX + perMetre * 2, nextY + perMetre * 1.5);
    const said = await page.locator('.scene-said').getByText(/ m; along the axes /).innerText();
    assert.ok(Math.abs(Number.parseFloat(said) - 2) < 0.03, said);
    await page.screenshot({ path: join(OUTPUT, 'scene_measure.png') });
  }));

test('the view goes with a frame', () =>
  on({ ...TOP, frames: true, follow: 'base' }, async (page) => {
    await mapFrame(page);
    await page.getByRole('button', { name: 'Publish a point' }).click();
    await page.getByText('Press on a place.').waitFor();
    await page.mouse.click(...await middle(page));
    await told(page, 1);
    const { point } = await goal(page, 0) as { point: { x: number; }; };
    assert.ok(Math.abs(point.x - 1) < 0.05, JSON.stringify(point));
    const before = await drawings(page);
    await page.getByRole('combobox', { name: 'The view goes with' }).selectOption('');
    // Drawn from where it stands now, and at rest.
    await page.waitForFunction((count) => Number(document.querySelector<HTMLElement>('.scene-canvas')?.dataset['drawings']) > count, before);
    for (let seen = -1; seen !== await drawings(page); await page.waitForTimeout(100)) seen = await drawings(page);
    await page.mouse.click(...await middle(page));
    await told(page, 2);
    assert.ok(Math.abs((await goal(page, 1) as { point: { x: number; }; }).point.x) < 0.05);
  }));

test('points get the size and colour that are set, which a link carries', () =>
  on(TOP, async (page) => {
    await mapFrame(page);
    await cloud(page);
    const settings = page.getByRole('button', { name: 'How /points looks' });
    await settings.click();
    const group = page.getByRole('group', { name: 'How /points looks' });
    await group.getByRole('combobox', { name: 'Coloured by' }).selectOption('flat');
    await group.getByLabel('Colour', { exact: true }).fill('#00b020');
    while ((await pixels(page, 'green')) < 50);
    const small = await pixels(page, 'green');
    await group.getByRole('spinbutton', { name: 'Size of points, in pixels' }).fill('9');
    await group.getByRole('spinbutton', { name: 'Size of points, in pixels' }).press('Enter');
    while ((await pixels(page, 'green')) < small * 2);
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'scene_settings.png') });
    await page.reload();
    await settings.click();
    assert.equal(await group.getByRole('spinbutton', { name: 'Size of points, in pixels' }).inputValue(), '9');
    assert.equal(await group.getByLabel('Colour', { exact: true }).inputValue(), '#00b020');
    await group.getByRole('button', { name: 'As usual' }).click();
    assert.equal(await group.getByRole('spinbutton', { name: 'Size of points, in pixels' }).inputValue(), '');
  }));

test('a map takes updates, and has the colours of costmaps', () =>
  on({ ...TOP, looks: { '/map': { scheme: 'costmap', alpha: 1 } } }, async (page) => {
    await mapFrame(page);
    await page.evaluate((message) => globalThis.send('/map', 'nav_msgs/msg/OccupancyGrid', message), {
      header: header('map'),
      info: {
        map_load_time: { sec: 0, nanosec: 0 },
        resolution: 0.25,
        width: 8,
        height: 8,
        origin: { position: { x: -1, y: -1, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } },
      },
      data: Array.from({ length: 64 }, () => 0),
    });
    const update = (cost: number): unknown => ({ header: header('map'), x: 2, y: 2, width: 4, height: 4, data: Array.from({ length: 16 }, () => cost) });
    await tell(page, '/map_updates', 'map_msgs/msg/OccupancyGridUpdate', update(1));
    while ((await pixels(page, 'blue')) < 1000);
    await tell(page, '/map_updates', 'map_msgs/msg/OccupancyGridUpdate', update(98));
    while ((await pixels(page, 'red')) < 1000);
    assert.equal(await pixels(page, 'blue'), 0);
  }));

test('pictures stand over the view in three sizes, by keys too, and problems are said while the list is closed', () =>
  on({ images: [{ topic: '/camera', size: 'small' }], list: false }, async (page) => {
    await mapFrame(page);
    const picture = page.locator('.scene-image');
    await picture.getByText('waits for a picture').waitFor();
    await tell(page, '/camera', 'sensor_msgs/msg/Image', {
      header: header('camera'),
      height: 30,
      width: 40,
      encoding: 'rgb8',
      is_bigendian: 0,
      step: 120,
      data: Array.from({ length: 3600 }, (_, i) => (i % 3 === 0 ? 255 : 20)),
    });
    await page.getByRole('img', { name: /^Picture of \/camera, 40/ }).waitFor();
    const widths: number[] = [];
    for (const size of ['small', 'medium', 'large']) {
      const button = page.getByRole('button', { name: `Size of /camera: ${size}` });
      await button.waitFor();
      widths.push((await picture.boundingBox())?.width ?? 0);
      await button.press('Enter');
    }
    assert.ok((widths[0] ?? 0) < (widths[1] ?? 0) && (widths[1] ?? 0) < (widths[2] ?? 0), widths.join(' '));
    await page.evaluate(() => globalThis.send('/robot_description', 'std_msgs/msg/String', { data: '<html/>' }));
    await page.locator('.scene-troubles').getByText('/robot_description: no robot description: it has no robot').waitFor();
    await page.locator('.scene-troubles').getByText('1 problem', { exact: true }).waitFor();
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'scene_images.png') });
    // A picture as it is sent by cameras with little bandwidth, chosen from the list.
    await page.getByRole('button', { name: 'What is shown', exact: true }).click();
    await page.getByRole('checkbox', { name: '/camera/compressed' }).check();
    const png = await page.evaluate(async () => {
      const canvas = new OffscreenCanvas(8, 8);
      canvas.getContext('2d')?.fillRect(0, 0, 8, 8);
      return [...new Uint8Array(await (await canvas.convertToBlob({ type: 'image/png' })).arrayBuffer())];
    });
    await tell(page, '/camera/compressed', 'sensor_msgs/msg/CompressedImage', { header: header('camera'), format: 'png', data: png });
    await page.getByRole('img', { name: /^Picture of \/camera\/compressed, 8/ }).waitFor();
    await page.getByRole('button', { name: 'Take /camera away' }).click();
    assert.equal(await picture.count(), 1);
  }));

test('what stands in for rviz2 and joint_state_publisher_gui is open at first, as the file says', () =>
  stage.on('world', {}, async (page) => {
    await page.route('**/share/meshes/view.rviz', (route) =>
      route.fulfill({
        body: `Visualization Manager:
  Displays:
    - {Class: rviz_default_plugins/Image, Enabled: true, Name: Camera, Topic: {Value: /camera}}
  Global Options: {Fixed Frame: odom}
`,
      }));
    await page.reload();
    await page.locator('.panel-joints').getByText('Waits for a robot description').waitFor();
    await page.locator('.scene-image').getByText('/camera', { exact: true }).waitFor();
    assert.equal(await page.getByRole('combobox', { name: 'Fixed frame' }).inputValue(), 'odom');
  }, DRIVER));
