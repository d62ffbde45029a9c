// The panel Joints in Chromium: sliders of a robot description become sensor_msgs/msg/JointState.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible } from '../support/page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "world".
  var joints: readonly { readonly name: readonly string[]; readonly position: ArrayLike<number>; }[];
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

const ROBOT = `<robot name="arm"><link name="base"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="a"/><limit lower="-1" upper="2"/></joint>
  <joint name="finger" type="prismatic"><limit lower="0.2" upper="0.6"/></joint>
  <joint name="other" type="prismatic"><limit lower="-1" upper="1"/><mimic joint="finger" multiplier="-1"/></joint>
  <joint name="&lt;img src=x&gt;" type="continuous"/></robot>`;

/** The newest of what was published, rounded. */
const positions = (page: Page): Promise<readonly number[]> =>
  page.evaluate(() => Array.from(joints.at(-1)?.position ?? [], (value) => Number(value.toFixed(2)) + 0));

async function until(page: Page, isSo: (found: readonly number[]) => boolean): Promise<void> {
  while (!isSo(await positions(page)));
}

// Compatibility, works: joint_state_publisher_gui's work is done by the panel Joints: sliders with limits, mimic and continuous
// joints, center, randomize, ten times a second
test('joints are set by sliders, keys and numbers, and published ten times a second', () =>
  stage.on(`world#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', 'joints'], shown: 'joints' }))}`, {}, async (page) => {
    const panel = page.locator('.panel-joints');
    await panel.getByText('Waits for a robot description on /robot_description.').waitFor();
    await page.evaluate((data) => send('/robot_description', 'std_msgs/msg/String', { data }), ROBOT);
    await panel.getByRole('slider', { name: 'turn' }).waitFor();
    // Upright where that is within bounds, else in the middle.
    const publish = panel.getByRole('checkbox', { name: 'Publish' });
    if (!(await publish.isChecked())) await publish.check();
    await until(page, (found) => found.join(' ') === '0 0.4 -0.4 0');
    assert.deepEqual(await page.evaluate(() => joints.at(-1)?.name), ['turn', 'finger', 'other', '<img src=x>']);
    await panel.getByRole('slider', { name: 'turn' }).press('End');
    await until(page, ([turn]) => turn === 2);
    const number = panel.getByRole('spinbutton', { name: 'Position of finger in m' });
    await number.fill('7');
    await number.press('Enter');
    await until(page, ([, finger, other]) => finger === 0.6 && other === -0.6);
    await panel.getByText('as finger: -0.600 m').waitFor();
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'joints.png') });
    await panel.getByRole('button', { name: 'Randomize' }).click();
    await until(page, ([turn = 9, finger = 9, other]) => turn !== 2 && turn >= -1 && turn <= 2 && finger >= 0.2 && finger <= 0.6 && other === -finger);
    await panel.getByRole('button', { name: 'Center' }).click();
    await until(page, (found) => found.join(' ') === '0 0.4 -0.4 0');
    await publish.uncheck();
    // While the panel does not publish, its sliders follow whoever does; moving one goes on from there.
    await page.waitForFunction(() => {
      // The panel subscribes when the topic is there: said again until it is heard.
      send('/joint_states', 'sensor_msgs/msg/JointState', {
        header: { stamp: { sec: 0, nanosec: 0 }, frame_id: '' },
        name: ['finger', 'nobody', 'turn'],
        position: [0.5, 3, -0.75],
        velocity: [],
        effort: [],
      });
      return document.querySelector<HTMLInputElement>('.panel-joints input[type="number"]')?.value === '-0.75';
    });
    assert.equal(await panel.getByRole('spinbutton', { name: 'Position of finger in m' }).inputValue(), '0.5');
    await panel.getByRole('slider', { name: 'turn' }).press('Home');
    await until(page, ([turn, finger]) => turn === -1 && finger === 0.5);
    await publish.uncheck();
    await page.evaluate(() => send('/robot_description', 'std_msgs/msg/String', { data: '<html/>' }));
    await panel.getByRole('alert').getByText('The message on /robot_description is not a robot description.').waitFor();
  }));
