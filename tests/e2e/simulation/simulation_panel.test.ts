// The panel Simulation on a packed site in Chromium: the world in its tree and in the picture, a robot that is driven, time that
// is paused and stepped, objects that are added, pushed, dragged and removed; by mouse and keys, and on a phone.

// Compatibility, works: Gazebo's window: the world with shadows, its models and links, pause, step, reset, real-time factor, objects
// added, dragged, pushed and removed, collisions, contacts, rays and frames drawn, in the panel Simulation

import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import type { Browser, BrowserContextOptions, Locator, Page } from 'playwright-core';
import { FIELD_OF_VIEW } from '../../../runtime/site/ui/model/camera_view.ts';
import { serveFolder } from '../../support/static_server.ts';
import type { StaticServer } from '../../support/static_server.ts';
import { chromiumOptions, SOFTWARE_WEB_GL } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { expectAccessible } from '../support/page_stage.ts';
import { brightness, pixels } from '../support/scene_pixels.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const watchdog = { timeout: 300_000 };

const shape = (geometry: string, color: string): string =>
  `<collision name="c"><geometry>${geometry}</geometry></collision>
  <visual name="v"><geometry>${geometry}</geometry><material><ambient>${color}</ambient><diffuse>${color}</diffuse></material></visual>`;
const inertial = (mass: number, moment: number): string =>
  `<inertial><mass>${mass}</mass><inertia><ixx>${moment}</ixx><iyy>${moment}</iyy><izz>${moment}</izz></inertia></inertial>`;
const wheel = (side: string, y: number): string =>
  `<link name="${side}_wheel"><pose>0 ${y} 0.1 1.5707963 0 0</pose>${inertial(0.3, 0.001)}
  ${shape('<cylinder><radius>0.1</radius><length>0.05</length></cylinder>', '0.1 0.1 0.1 1')}</link>
  <joint name="${side}_joint" type="revolute"><parent>base</parent><child>${side}_wheel</child><axis><xyz>0 0 -1</xyz></axis></joint>`;
const world = `<sdf version="1.6"><world name="yard"><include><uri>model://sun</uri></include><include><uri>model://ground_plane</uri></include>
  <model name="crate"><pose>1.5 0.8 0.25 0 0 0</pose><link name="link">${inertial(5, 0.2)}
    ${shape('<box><size>0.5 0.5 0.5</size></box>', '0 0 1 1')}</link></model>
  <model name="wall"><static>true</static><pose>2.5 0 0.5 0 0 0</pose><link name="link">
    ${shape('<mesh><uri>model://yard/wall.obj</uri></mesh>', '1 0 0 1')}</link></model>
  <model name="rover"><pose>-0.5 -0.5 0 0 0 0</pose>
    <link name="base">${inertial(3, 0.05)}
      <collision name="c"><pose>0 0 0.15 0 0 0</pose><geometry><box><size>0.4 0.26 0.12</size></box></geometry></collision>
      <visual name="v"><pose>0 0 0.15 0 0 0</pose><geometry><box><size>0.4 0.26 0.12</size></box></geometry>
        <material><ambient>0 1 0 1</ambient><diffuse>0 1 0 1</diffuse></material></visual>
      <collision name="caster"><pose>-0.15 0 0.05 0 0 0</pose><geometry><sphere><radius>0.05</radius></sphere></geometry>
        <surface><friction><ode><mu>0.001</mu></ode></friction></surface></collision>
      <visual name="caster"><pose>-0.15 0 0.05 0 0 0</pose><geometry><sphere><radius>0.05</radius></sphere></geometry></visual>
      <sensor name="lidar" type="ray"><pose>0.15 0 0.25 0 0 0</pose><update_rate>10</update_rate>
        <ray><scan><horizontal><samples>91</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan>
          <range><min>0.1</min><max>8</max></range></ray>
        <plugin name="lidar" filename="libgazebo_ros_ray_sensor.so"><ros><remapping>~/out:=scan</remapping></ros>
          <output_type>sensor_msgs/LaserScan</output_type><frame_name>lidar</frame_name></plugin></sensor></link>
    ${wheel('left', 0.16)}${wheel('right', -0.16)}
    <plugin name="drive" filename="libgazebo_ros_diff_drive.so"><left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>
      <wheel_separation>0.32</wheel_separation><wheel_diameter>0.2</wheel_diameter><max_wheel_torque>20</max_wheel_torque></plugin></model>
</world></sdf>
`;
const wallObject = `${[-0.1, 0.1].flatMap((x) => [-2, 2].flatMap((y) => [-0.5, 0.5].map((z) => `v ${x} ${y} ${z}`))).join('\n')}
f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4
`;
const launch = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    return LaunchDescription([IncludeLaunchDescription(
        PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gazebo.launch.py')),
        launch_arguments={'world': os.path.join(get_package_share_directory('yard'), 'yard.world')}.items())])
`;

let workspace: PackWorkspace;
let browser: Browser;
let server: StaticServer;

before(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  workspace = new PackWorkspace('shared');
  workspace.addPackage('yard', {}, {
    cmake: 'install(FILES yard.world wall.obj sim.launch.py DESTINATION share/${PROJECT_NAME})\n',
    depends: ['gazebo_ros', 'geometry_msgs'],
  });
  workspace.write('src/yard/yard.world', world);
  workspace.write('src/yard/wall.obj', wallObject);
  workspace.write('src/yard/sim.launch.py', launch);
  workspace.write('workspace.yaml', 'schema: 1\nname: yard\npackages: [src/*]\nlaunch: src/yard/sim.launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  browser = await chromium.launch(chromiumOptions(SOFTWARE_WEB_GL));
  server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
}, watchdog);
after(async () => {
  await browser.close();
  server.close();
  workspace.close();
});

async function on(options: BrowserContextOptions, hash: string, body: (page: Page, panel: Locator) => Promise<void>): Promise<void> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  const troubles: string[] = [];
  page.on('pageerror', (error) => troubles.push(error.message));
  try {
    await page.goto(`${server.url}${hash}`);
    const panel = page.locator('.panel-simulation');
    await panel.waitFor();
    await panel.getByRole('button', { name: 'rover', exact: true }).waitFor();
    await body(page, panel);
    assert.deepEqual(troubles, []);
  } finally {
    await context.close();
  }
}

/** The place of what is selected, in metres. */
async function place(panel: Locator): Promise<readonly number[]> {
  const words = await panel.locator('.simulation-selection dd').first().textContent();
  return (words ?? '').replace(' m', '').split(', ').map(Number);
}

const PATIENCE_MS = 60_000;

async function until(panel: Locator, what: string, isSo: (place: readonly number[]) => boolean): Promise<void> {
  const since = Date.now();
  for (;;) {
    const found = await place(panel);
    if (isSo(found)) return;
    if (Date.now() - since > PATIENCE_MS) {
      await panel.page().screenshot({ path: join(OUTPUT, 'simulation_failed.png') });
      assert.fail(`${what}: it is at ${found.join(', ')}; ${await panel.innerText()}`);
    }
    await panel.page().waitForTimeout(50);
  }
}

async function select(panel: Locator, name: string): Promise<void> {
  await panel.getByRole('button', { name, exact: true }).click();
  await panel.getByRole('group', { name: `${name} is selected` }).waitFor();
}

async function simulated(panel: Locator): Promise<number> {
  return Number.parseFloat((await panel.locator('.panel-note').textContent()) ?? '');
}

const LAYOUT = `#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', { column: ['simulation', 'terminal'], sizes: [3, 1] }], sizes: [1, 4] }))}`;

test('the world is seen, the robot drives, time is paused and stepped', watchdog, () =>
  on({}, LAYOUT, async (page, panel) => {
    await panel.getByText('4 models').waitFor();
    await panel.getByText(/^\d+\.\d\d s, \d\.\d\d× real time$/).waitFor();
    // The crate, the wall of a mesh, and the robot; each has a colour of its own.
    for (const color of ['blue', 'red', 'green'] as const)
      while ((await pixels(page, color)) < 100) await page.waitForTimeout(100);
    await select(panel, 'rover');
    const start = await place(panel);
    assert.ok(Math.hypot((start[0] ?? 9) + 0.5, (start[1] ?? 9) + 0.5) < 0.02, `it stands where the world says: ${start}`);
    await page.locator('.panel-terminal .terminal-input input:not([readonly])').fill(
      'ros2 topic pub -r 10 /cmd_vel geometry_msgs/msg/Twist "{linear: {x: 0.3}}"',
    );
    await page.keyboard.press('Enter');
    await until(panel, 'the robot drives', ([x = 0]) => x > -0.3);
    await panel.getByRole('button', { name: 'Pause the world' }).click();
    await panel.getByText(/^\d+\.\d\d s, paused$/).waitFor();
    await page.waitForTimeout(500);
    const [time, stood] = [await simulated(panel), await place(panel)];
    await page.waitForTimeout(500);
    assert.equal(await simulated(panel), time);
    assert.deepEqual(await place(panel), stood);
    await panel.getByRole('button', { name: 'Step: 100 steps of the physics' }).click();
    while ((await simulated(panel)) === time) await page.waitForTimeout(50);
    assert.ok(Math.abs((await simulated(panel)) - time - 0.1) < 0.011, `${await simulated(panel)} after ${time}`);
    await until(panel, 'a step of the world moves the robot', ([x = 0]) => x > (stood[0] ?? 0));
    for (const flag of ['Collisions', 'Contacts and their forces', 'Rays of laser scanners', 'Joints and sensors'])
      await panel.getByRole('checkbox', { name: flag }).check();
    await panel.getByRole('button', { name: 'Let the world run' }).click();
    await panel.getByText(/× real time$/).waitFor();
    await page.waitForTimeout(1000);
    assert.equal(await panel.locator('.scene-troubles').count(), 0);
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'simulation.png') });
  }));

test('objects are added, pushed, dragged and removed, and the world is reset', watchdog, () =>
  on({}, '', async (page, panel) => {
    const drawings = (): Promise<number> => panel.locator('.scene-canvas').evaluate((one) => Number((one as HTMLCanvasElement).dataset['drawings']));
    // While nothing moves, the picture is drawn as little as that of the 3D view.
    await page.waitForTimeout(1000);
    const before = await drawings();
    await page.waitForTimeout(1500);
    assert.ok((await drawings()) - before <= 3, `${before} and then ${await drawings()}`);
    await select(panel, 'crate');
    const [x0 = 0, y0 = 0] = await place(panel);
    await panel.getByRole('button', { name: 'Push crate away from you' }).click();
    // 1 m/s on a ground with friction 1: it slides for some centimetres.
    await until(panel, 'the push moves the crate', ([x = 0, y = 0]) => Math.hypot(x - x0, y - y0) > 0.03);
    await panel.getByRole('button', { name: 'Reset the world to its start' }).click();
    await until(panel, 'the reset brings the crate back', ([x = 0, y = 0]) => Math.hypot(x - 1.5, y - 0.8) < 0.02);
    await panel.getByRole('button', { name: 'Add an object in the middle of the picture' }).click();
    await page.getByRole('menuitem', { name: 'Box' }).click();
    await panel.getByText('box was added.').waitFor();
    await panel.getByText('5 models').waitFor();
    await select(panel, 'box');
    // It falls from 20 cm over the ground.
    await until(panel, 'the box falls to the ground', ([x = 9, y = 9, z = 9]) => Math.hypot(x, y) < 0.05 && Math.abs(z - 0.15) < 0.006);
    const canvas = panel.locator('.scene-canvas');
    const box = (await canvas.boundingBox()) ?? assert.fail();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.keyboard.down('Control');
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x, y - 120, { steps: 5 });
    await until(panel, 'the hand lifts the box', ([, , z = 0]) => z > 0.4);
    // The simulator lets go of what it does not hear of for a second; a hand that rests still holds.
    await page.waitForTimeout(1500);
    assert.ok(((await place(panel))[2] ?? 0) > 0.4, `a hand that rests holds the box: ${await place(panel)}`);
    await page.mouse.up();
    await page.keyboard.up('Control');
    await until(panel, 'the box falls out of the hand', ([, , z = 9]) => z < 0.2);
    await panel.getByRole('button', { name: 'Remove box from the world' }).click();
    await panel.getByText('4 models').waitFor();
    assert.equal(await panel.getByRole('button', { name: 'box', exact: true }).count(), 0);
  }));

test('the light of the world casts shadows, where they are wanted', watchdog, () => {
  // Straight from above, 4 m over the picture's height, around a place beside the crate.
  const distance = 2 / Math.tan(FIELD_OF_VIEW / 2);
  const view = { x: 1, y: 0.8, distance, top: true };
  const layout = { row: ['nodes', { simulation: { view, grid: false, list: true } }], sizes: [1, 4] };
  return on({}, `#layout=${encodeURIComponent(JSON.stringify(layout))}`, async (page, panel) => {
    const shadows = panel.getByRole('checkbox', { name: 'Shadows' });
    // The processor draws here, so they are off at first.
    assert.equal(await shadows.isChecked(), false);
    const box = (await panel.locator('.scene-canvas').boundingBox()) ?? assert.fail();
    const at = (x: number, y: number): readonly [number, number] => [0.5 + ((x - 1) * box.height) / 4 / box.width, 0.5 - (y - 0.8) / 4];
    // The sun shines along -0.5, 0.1, -0.9; the crate is half a metre high, and its nearest corners are at x = 1.25 and y = 1.05.
    const [shaded, beside] = [at(1.05, 1.0), at(1.05, 1.4)];
    const until = async (what: string, isSo: (shade: number, light: number) => boolean): Promise<void> => {
      const since = Date.now();
      for (;;) {
        const [shade = NaN, light = NaN] = await brightness(page, [shaded, beside]);
        if (light > 20 && isSo(shade, light)) return;
        if (Date.now() - since > PATIENCE_MS) {
          await page.screenshot({ path: join(OUTPUT, 'simulation_failed.png') });
          assert.fail(`${what}: ${shade} and ${light}`);
        }
        await page.waitForTimeout(200);
      }
    };
    await until('without shadows the ground is even', (shade, light) => Math.abs(shade - light) < 2);
    await shadows.check();
    await until('the crate casts its shadow on the ground', (shade, light) => shade < 0.85 * light);
    await page.screenshot({ path: join(OUTPUT, 'simulation_shadows.png') });
    await shadows.uncheck();
    await until('the shadow is gone', (shade, light) => Math.abs(shade - light) < 2);
  });
});

test('on a phone: the world, its tree and its tools have room, and fingers do what a mouse does', watchdog,
  () =>
    on({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, '', async (page, panel) => {
      await panel.getByRole('button', { name: 'Add an object in the middle of the picture' }).tap();
      await page.getByRole('menuitem', { name: 'Sphere' }).tap();
      await panel.getByText('5 models').waitFor();
      await select(panel, 'sphere');
      await until(panel, 'the sphere falls to the ground', ([, , z = 9]) => Math.abs(z - 0.15) < 0.006);
      await select(panel, 'crate');
      // A press on it in the picture selects it too.
      const canvas = panel.locator('.scene-canvas');
      const box = (await canvas.boundingBox()) ?? assert.fail();
      await page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
      await panel.getByRole('group', { name: 'sphere is selected' }).waitFor();
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.equal(wide, 390);
      await expectAccessible(page);
      await page.screenshot({ path: join(OUTPUT, 'simulation_phone.png') });
      await panel.getByRole('button', { name: 'Remove sphere from the world' }).tap();
      await panel.getByText('4 models').waitFor();
    }));
