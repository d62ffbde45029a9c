// The 3D view in Chromium, with messages that pass a real graph, drawn by SwiftShader.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { SOFTWARE_WEB_GL } from '../support/chromium.ts';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';
import { pixels } from '../support/scene_pixels.ts';

declare global {
  // Set by page_fake.tsx in the scene "world".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
  var goals: readonly unknown[];
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
let stage: PageStage;

before(async () => {
  stage = await PageStage.open(SOFTWARE_WEB_GL);
});

after(() => stage.close());

// Warnings of the software driver when a picture of the page is taken.
const DRIVER = /GL Driver Message|GPU stall/;

const withScene = (state: unknown): string =>
  `world#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', { scene: state }], sizes: [1, 4], shown: 'scene' }))}`;

function on(state: unknown, body: (page: Page) => Promise<void>): Promise<void> {
  return stage.on(withScene(state), {}, body, DRIVER);
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

const drawings = (page: Page): Promise<number> => page.locator('.scene-canvas').evaluate((canvas) => Number(canvas.dataset['drawings'] ?? 0));

const tree = [transform('map', 'base', [1, 0, 0]), transform('base', 'laser', [0, 0, 0.5])];

test('frames are drawn as axes where the tree says, and nothing is drawn when nothing moves', () =>
  on(null, async (page) => {
    await frames(page, tree);
    await page.getByText('3 frames').waitFor();
    await page.getByRole('option', { name: 'automatic: map' }).waitFor({ state: 'attached' });
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
        (count) => Number(document.querySelector<HTMLElement>('.scene-canvas')?.dataset['drawings']) > count,
        drawn,
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

// Guarantee, hostile input: frames in loops, robot descriptions and maps whose texts or sizes lie, and markers without
// number neither hang nor stop the 3D view
test('scenes of hostile frames neither hang nor throw, and say what is wrong', () =>
  on({ frame: 'nowhere' }, async (page) => {
    await frames(page, [
      transform('b', 'a', [1, 0, 0]),
      transform('c', 'b', [1, 0, 0]),
      transform('a', 'c', [1, 0, 0]),
      transform('x', 'x', [1, 0, 0]),
      transform('', 'y', [1, 0, 0]),
      transform('z', 'far', [1e300, 0, 0]),
      transform('map', '<img src=x onerror="document.title=1">'.repeat(5), [1, 0, 0]),
      transform('map', 'n', [NaN, 0, 0]),
      ...Array.from({ length: 3000 }, (_, i) => transform(`f${i}`, `f${i + 1}`, [0.001, 0, 0])),
    ]);
    await page.getByText('the parents of a lead back to itself').waitFor();
    await page.getByText('0 frames').waitFor();
    const chosen = page.getByRole('combobox', { name: 'Fixed frame' });
    await page.getByRole('option', { name: 'nowhere (unknown frame)' }).waitFor({ state: 'attached' });
    for (const [frame, words] of [['f0', '1000 frames'], ['a', '0 frames'], ['z', '1 frame'], ['map', '2 frames']] as const) {
      await chosen.selectOption(frame);
      await page.getByText(words, { exact: true }).waitFor();
    }
    const arm = { transforms: [transform('map', 'arm', [0, 0, 1])] };
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', arm);
    await page.waitForFunction(() => heard('/tf') > 0);
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', arm);
    await page.getByText('3 frames', { exact: true }).waitFor();
    // Latched transforms come again.
    await page.getByRole('button', { name: 'Forget all frames' }).click();
    await page.getByText('2 frames', { exact: true }).waitFor();
  }));

const COLORS = { r: 0, g: 0, b: 1, a: 1 };
const still = { x: 0, y: 0, z: 0, w: 1 };
const pose = (x: number, y: number, z = 0): unknown => ({ position: { x, y, z }, orientation: still });
const header = (frame: string): unknown => ({ stamp: { sec: 1, nanosec: 0 }, frame_id: frame });

const ROBOT = `<?xml version="1.0"?>
<robot name="arm">
  <material name="orange"><color rgba="1 0.5 0.1 1"/></material>
  <link name="base"><visual><geometry><cylinder radius="0.3" length="0.1"/></geometry><material name="orange"/></visual></link>
  <link name="laser">
    <visual><origin xyz="0 0 0.2" rpy="0 0 0.4"/><geometry><box size="0.2 0.3 0.4"/></geometry><material><color rgba="0.1 0.7 0.2 1"/></material></visual>
    <visual><geometry><mesh filename="package://arm/hand.stl"/></geometry></visual>
  </link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="laser"/></joint>
</robot>`;

/** Publishes again and again until the panel has heard it: volatile messages find who listens. */
async function heardOnce(page: Page, topic: string, type: string, value: unknown): Promise<void> {
  await publish(page, topic, type, value);
  await page.waitForFunction((name) => heard(name) > 0, topic);
  await publish(page, topic, type, value);
}

const inTheme = (page: Page, name: string): Promise<void> =>
  page.evaluate((theme) => {
    document.documentElement.dataset['theme'] = theme;
  }, name);

const marker = (id: number, type: number, more: object): unknown => ({
  header: header('map'),
  ns: 'things',
  id,
  type,
  action: 0,
  pose: pose(-1 + id / 2, -1.5, 0.25),
  scale: { x: 0.3, y: 0.3, z: 0.3 },
  color: COLORS,
  lifetime: { sec: 0, nanosec: 0 },
  frame_locked: false,
  points: [],
  colors: [],
  texture_resource: '',
  texture: { header: header(''), format: '', data: [] },
  uv_coordinates: [],
  text: '',
  mesh_resource: '',
  mesh_file: { filename: '', data: [] },
  mesh_use_embedded_materials: false,
  ...more,
});

async function fillWorld(page: Page): Promise<void> {
  await frames(page, tree);
  await publish(page, '/robot_description', 'std_msgs/msg/String', { data: ROBOT });
  await publish(page, '/map', 'nav_msgs/msg/OccupancyGrid', {
    header: header('map'),
    info: { map_load_time: { sec: 0, nanosec: 0 }, resolution: 0.25, width: 16, height: 16, origin: pose(-2, -2, 0) },
    data: Array.from({ length: 256 }, (_, i) => (i < 16 || i % 16 === 0 ? 100 : i % 7 === 0 ? -1 : 0)),
  });
  await heardOnce(page, '/scan', 'sensor_msgs/msg/LaserScan', {
    header: header('laser'),
    angle_min: -1,
    angle_max: 1,
    angle_increment: 0.01,
    time_increment: 0,
    scan_time: 0,
    range_min: 0.1,
    range_max: 10,
    ranges: Array.from({ length: 200 }, (_, i) => 1.5 + Math.sin(i / 9) / 5),
    intensities: [],
  });
  const points = Array.from({ length: 400 }, (_, i) => [Math.sin(i / 10), Math.cos(i / 10), i / 400] as const);
  await heardOnce(page, '/points', 'sensor_msgs/msg/PointCloud2', {
    header: header('map'),
    height: 1,
    width: points.length,
    is_bigendian: false,
    point_step: 12,
    row_step: 12 * points.length,
    is_dense: true,
    fields: ['x', 'y', 'z'].map((name, index) => ({ name, offset: index * 4, datatype: 7, count: 1 })),
    data: [...new Uint8Array(Float32Array.from(points.flat()).buffer)],
  });
  await heardOnce(page, '/plan', 'nav_msgs/msg/Path', {
    header: header('map'),
    poses: [[0, 0], [1, 1], [2, 1], [2, -1]].map(([x = 0, y = 0]) => ({ header: header('map'), pose: pose(x, y, 0.02) })),
  });
  await heardOnce(page, '/odom', 'nav_msgs/msg/Odometry', {
    header: header('map'),
    child_frame_id: 'base',
    pose: { pose: pose(1, 0), covariance: Array(36).fill(0) },
    twist: { twist: { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } }, covariance: Array(36).fill(0) },
  });
  await heardOnce(page, '/particles', 'geometry_msgs/msg/PoseArray', {
    header: header('map'),
    poses: Array.from({ length: 30 }, (_, i) => pose(-1 - (i % 6) / 5, 1 + Math.floor(i / 6) / 5)),
  });
  await heardOnce(page, '/markers', 'visualization_msgs/msg/MarkerArray', {
    markers: [
      marker(0, 0, {}),
      marker(1, 1, {}),
      marker(2, 2, {}),
      marker(3, 3, {}),
      marker(4, 9, { text: '<b>goal</b>' }),
      marker(5, 4, { pose: pose(0, 0), scale: { x: 0.05, y: 0, z: 0 }, points: [[0, 2, 0], [1, 2, 1], [2, 2, 0]].map(([x, y, z]) => ({ x, y, z })) }),
    ],
  });
}

test('robots, maps, scans, clouds, paths, poses and markers are drawn, and each can be omitted', () =>
  on(null, async (page) => {
    await fillWorld(page);
    const panel = page.locator('.panel-scene');
    await panel.getByText('the site has no file share/arm/hand.stl (R2W0743)').waitFor();
    await page.waitForFunction(() => document.querySelectorAll('.scene-problem').length === 1);
    const boxes = panel.locator('.scene-topics input');
    assert.equal(await boxes.count(), 8);
    const all = await panel.locator('.scene-canvas').screenshot({ path: `${OUTPUT}/scene.png` });
    // Markers and particles alone are blue; without them much less is.
    const blue = await pixels(page, 'blue');
    const redrawn = async (what: () => Promise<void>): Promise<void> => {
      const drawn = await drawings(page);
      await what();
      await page.waitForFunction(
        (count) => Number(document.querySelector<HTMLElement>('.scene-canvas')?.dataset['drawings']) > count,
        drawn,
      );
    };
    // Messages that came once stay drawn when other topics go and come, and in other colours.
    const scan = panel.getByRole('checkbox', { name: '/scan' });
    await redrawn(() => scan.uncheck());
    assert.ok((await pixels(page, 'blue')) > blue * 0.7);
    await redrawn(() => scan.check());
    for (const theme of ['dark', 'light']) {
      await redrawn(() => inTheme(page, theme));
      assert.ok((await pixels(page, 'blue')) > blue * 0.7, theme);
    }
    for (const name of ['/markers', '/plan', '/particles', '/odom', '/scan', '/points'])
      await redrawn(() => panel.getByRole('checkbox', { name }).uncheck());
    assert.ok((await pixels(page, 'blue')) < blue / 2);
    assert.notDeepEqual(await panel.locator('.scene-canvas').screenshot(), all);
    // The choice of topics is the same after a reload.
    await page.reload();
    await panel.getByRole('checkbox', { name: '/scan' }).waitFor();
    assert.equal(await panel.getByRole('checkbox', { name: '/scan' }).isChecked(), false);
    assert.equal(await panel.getByRole('checkbox', { name: '/map' }).isChecked(), true);
  }));

test('markers of many large texts are drawn as far as there is room', () =>
  on(null, async (page) => {
    await frames(page, tree);
    const text = `${'W'.repeat(150)}${'\n'.repeat(19)}`;
    const markers = Array.from({ length: 300 }, (_, id) => marker(id, 9, { text, pose: pose(0, 0) }));
    await heardOnce(page, '/markers', 'visualization_msgs/msg/MarkerArray', { markers });
    await page.locator('.scene-problem').getByText('too many markers').waitFor();
    assert.ok((await pixels(page, 'blue')) > 30);
  }));

test('what cannot be drawn is said beside its topic', () =>
  on(null, async (page) => {
    await frames(page, [...tree, transform('moon', 'crater', [0, 0, 0])]);
    await publish(page, '/robot_description', 'std_msgs/msg/String', { data: '<robot><link></robot>' });
    await publish(page, '/map', 'nav_msgs/msg/OccupancyGrid', {
      header: header('map'),
      info: { map_load_time: { sec: 0, nanosec: 0 }, resolution: 1, width: 4000000000, height: 9, origin: pose(0, 0) },
      data: [1],
    });
    await heardOnce(page, '/plan', 'nav_msgs/msg/Path', {
      header: header('crater'),
      poses: [{ header: header(''), pose: pose(1, 1) }, { header: header(''), pose: pose(2, 1) }],
    });
    await heardOnce(page, '/odom', 'nav_msgs/msg/Odometry', {
      header: header('nowhere'),
      child_frame_id: '',
      pose: { pose: pose(1, 0), covariance: Array(36).fill(0) },
      twist: { twist: { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } }, covariance: Array(36).fill(0) },
    });
    for (
      const words of [
        'no robot description: the text is not XML',
        'its cells do not fit its size',
        'no transform from crater to map',
        'no transform says where nowhere is',
      ]
    )
      await page.locator('.scene-problem').getByText(words, { exact: true }).waitFor();
    await publish(page, '/robot_description', 'std_msgs/msg/String', { data: '<html/>' });
    await page.getByText('no robot description: it has no robot').waitFor();
    const entities = `<!DOCTYPE r [<!ENTITY a "${'x'.repeat(1000)}">${
      Array.from({ length: 9 }, (_, i) => `<!ENTITY a${i} "${`&a${i === 0 ? '' : i - 1};`.repeat(10)}">`).join('')
    }]><robot name="&a8;"/>`;
    await publish(page, '/robot_description', 'std_msgs/msg/String', { data: entities });
    await page.getByText('no robot description: the text is not XML').waitFor();
  }));

test('robots are read under Trusted Types without a policy', () =>
  stage.on('world', {}, async (page) => {
    await page.route('**/?scene=*', async (route) => {
      const response = await route.fetch();
      const policy = "require-trusted-types-for 'script'; trusted-types 'none'";
      await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': policy } });
    });
    await page.goto(`${stage.served.url}?scene=${withScene(null)}`);
    await page.reload(); // with another fragment alone nothing is loaded
    await page.locator('.scene-canvas').waitFor();
    await fillWorld(page);
    await page.getByText('the site has no file share/arm/hand.stl (R2W0743)').waitFor();
  }, DRIVER));

test('a goal is set with the pointer or by keys, in the fixed frame', () =>
  on({ view: { top: true } }, async (page) => {
    await frames(page, tree);
    await page.getByText('3 frames').waitFor();
    await page.getByRole('button', { name: 'Set a goal: publishes on /goal_pose' }).click();
    await page.getByText('Press where to go').waitFor();
    const canvas = page.locator('.scene-canvas');
    const box = (await canvas.boundingBox()) ?? assert.fail();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x, y - 90, { steps: 3 });
    await page.mouse.up();
    await page.locator('.scene-said').getByText(/^Goal published: -?0\.\d\d, -?0\.\d\d, 90\u00b0$/).waitFor();
    await page.waitForFunction(() => goals.length === 1);
    const goal = await page.evaluate(() =>
      JSON.parse(JSON.stringify(goals[0])) as {
        header: { frame_id: string; };
        pose: { position: { x: number; y: number; }; orientation: { z: number; w: number; }; };
      }
    );
    assert.equal(goal.header.frame_id, 'map');
    assert.ok(Math.hypot(goal.pose.position.x, goal.pose.position.y) < 0.05, JSON.stringify(goal));
    assert.ok(Math.abs(goal.pose.orientation.z - Math.SQRT1_2) < 0.01 && Math.abs(goal.pose.orientation.w - Math.SQRT1_2) < 0.01);
    await canvas.press('Enter');
    await page.waitForFunction(() => goals.length === 2);
    await canvas.press('Escape');
    await page.getByText('3 frames').waitFor();
  }));

test('odometry leaves a trail as long as is kept, and a covariance an ellipse', () =>
  on({ view: { top: true, distance: 8 }, grid: false, frames: false, names: false }, async (page) => {
    await frames(page, [transform('map', 'base', [0, 0, 0])]);
    await page.getByText('2 frames').waitFor();
    const odometry = async (x: number, variance: number): Promise<void> => {
      const covariance = Array.from({ length: 36 }, (_, i) => (i === 0 || i === 7 ? variance : 0));
      const none = { x: 0, y: 0, z: 0 };
      await publish(page, '/odom', 'nav_msgs/msg/Odometry', {
        header: { stamp: { sec: 1, nanosec: 0 }, frame_id: 'map' },
        child_frame_id: 'base',
        pose: { pose: { position: { x, y: 0, z: 0 }, orientation: { ...none, w: 1 } }, covariance },
        twist: { twist: { linear: none, angular: none }, covariance: Array.from({ length: 36 }, () => 0) },
      });
    };
    for (const x of [-2, -1, 0, 1]) {
      const before = await drawings(page);
      while ((await drawings(page)) === before) await odometry(x, 0);
    }
    const long = await pixels(page, 'blue');
    await page.getByRole('combobox', { name: 'Arrows of odometry that stay' }).selectOption('1');
    // Said again and again, as odometry is: what is shown begins anew with another choice.
    let short = 0;
    while (short === 0 || short >= long) {
      await odometry(1, 0);
      short = await pixels(page, 'blue');
    }
    const canvas = page.locator('.scene-canvas');
    const plain = await canvas.screenshot();
    await odometry(1, 0.25);
    while ((await canvas.screenshot()).equals(plain));
    await canvas.screenshot({ path: join(OUTPUT, 'scene_odometry.png') });
  }));

test('an .rviz file says what is shown', () =>
  on(null, async (page) => {
    await fillWorld(page);
    const open = async (name: string, text: string): Promise<void> => {
      await page.getByRole('button', { name: 'Show what an RViz file says' }).click();
      const [chooser] = await Promise.all([
        page.waitForEvent('filechooser'),
        page.getByRole('menuitem', { name: 'Open an .rviz file' }).click(),
      ]);
      await chooser.setFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
    };
    const note = page.locator('.scene-said');
    await open('notes.rviz', '<b>no</b>');
    await note.getByText('notes.rviz is not an RViz file').waitFor();
    await open('arm.rviz', `Visualization Manager:
  Displays:
    - {Class: rviz_default_plugins/Path, Enabled: true, Name: Plan, Topic: {Value: /plan}}
    - {Class: rviz_default_plugins/Camera, Enabled: true, Name: Camera, Topic: {Value: /camera}}
    - {Class: rviz_default_plugins/Axes, Enabled: true, Name: Axes}
    - {Class: rviz_default_plugins/Map, Enabled: false, Name: Map, Topic: {Value: /map}}
  Global Options: {Fixed Frame: base, Background Color: 255; 230; 200}
  Tools: [{Class: rviz_default_plugins/SetGoal, Topic: {Value: /there}}]
`);
    await note.getByText('As in arm.rviz, without Axes').waitFor();
    await page.waitForFunction(() => getComputedStyle(document.querySelector('.scene-canvas')!).backgroundColor === 'rgb(255, 230, 200)');
    const checked = page.locator('.scene-topics input:checked');
    await page.waitForFunction(() => document.querySelectorAll('.scene-topics input:checked').length === 1);
    assert.equal(await checked.evaluate((input) => input.closest('label')?.textContent), '/planPath');
    assert.equal(await page.getByRole('combobox', { name: 'Fixed frame' }).inputValue(), 'base');
    await page.getByRole('button', { name: 'Set a goal: publishes on /there' }).waitFor();
    await page.locator('.scene-image').getByText('/camera', { exact: true }).waitFor();
  }));

test('a picture that was coarse while things moved is scaled smoothly, and fades into the fine one at rest', () =>
  on(null, async (page) => {
    await frames(page, tree);
    await page.getByText('3 frames').waitFor();
    await page.evaluate(() => {
      const seen = Object.assign(globalThis, { faded: 0 });
      document.addEventListener('animationstart', ({ animationName, target }) => {
        if (animationName === 'fade-away' && target instanceof HTMLCanvasElement && target.width > 0) seen.faded += 1;
      });
    });
    const slow = await page.context().newCDPSession(page);
    await slow.send('Emulation.setCPUThrottlingRate', { rate: 20 });
    const canvas = page.locator('.scene-canvas');
    const share = (): Promise<number> => canvas.evaluate((element) => Number(element.dataset['resolution'] ?? 1));
    for (let sec = 2; (await share()) === 1; sec += 1)
      await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', { transforms: [transform('map', 'arm', [0, 0, sec % 7], 0, sec)] });
    await slow.send('Emulation.setCPUThrottlingRate', { rate: 1 });
    // One more picture, which is a coarse one.
    await publish(page, '/tf', 'tf2_msgs/msg/TFMessage', { transforms: [transform('map', 'arm', [0, 0, 9], 0, 1e6)] });
    await page.waitForFunction(() => (globalThis as unknown as { faded: number; }).faded > 0);
    await page.waitForFunction(() => {
      const element = document.querySelector<HTMLCanvasElement>('.scene-canvas');
      const veil = document.querySelector<HTMLCanvasElement>('.scene-veil');
      return element !== null && element.width === Math.floor(element.clientWidth * devicePixelRatio) && veil?.getAnimations().length === 0;
    });
    assert.deepEqual(
      await page.evaluate(() => [...document.querySelectorAll('.scene-canvas, .scene-veil')].map((one) => getComputedStyle(one).imageRendering)),
      ['auto', 'auto'],
    );
    assert.equal(await page.locator('.scene-veil').evaluate((veil) => getComputedStyle(veil).opacity), '0');
  }));

test('on a phone each icon of the 3D view has its word', () =>
  stage.on(withScene(null), { viewport: { width: 390, height: 844 }, reducedMotion: 'reduce' }, async (page) => {
    await page.locator('.scene-canvas').waitFor();
    const words = await page.locator('.panel-scene .panel-tools .icon-button').allInnerTexts();
    assert.ok(words.length > 8 && words.every((text) => text.trim() !== ''), words.join('|'));
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'scene_phone.png') });
  }, DRIVER));

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
    }, DRIVER));
}

test('without WebGL the panel says so', async () => {
  const plain = await PageStage.open(['--disable-3d-apis']);
  try {
    await plain.on(withScene(null), phone, async (page) => {
      await page.getByRole('alert').getByText('gives the page no WebGL').waitFor();
      await expectAccessible(page);
    }, DRIVER);
  } finally {
    await plain.close();
  }
});
