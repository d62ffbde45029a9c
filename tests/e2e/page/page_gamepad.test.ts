// The visitor's gamepad on a packed site, in Chromium with a gamepad of its own: joy_node, game_controller_node and
// teleop_twist_joy, started by upstream's launch file.

// Compatibility, works: joy: `joy_node`, `game_controller_node`, `joy_enumerate_devices` with the visitor's gamepad, from launch files and
// as components; their parameters, texts and `joy/set_feedback`

// Compatibility, differs: joy: a page that is not in use -> the gamepad comes to rest; browsers read none in the background

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Page } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { packedInBrowser } from '../support/packed_in_browser.ts';
import { withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 240_000 };
const packed = packedInBrowser((workspace) => {
  workspace.addPackage('pad', {});
  workspace.write('src/pad/launch/pad.launch.xml', `<launch>
  <include file="$(find-pkg-share teleop_twist_joy)/launch/teleop-launch.py">
    <arg name="joy_config" value="xbox"/>
  </include>
  <group>
    <push-ros-namespace namespace="composed"/>
    <include file="$(find-pkg-share joy)/launch/joy-composed-launch.py"/>
  </group>
  <group>
    <push-ros-namespace namespace="alone"/>
    <include file="$(find-pkg-share joy)/launch/joy-launch.py"/>
  </group>
  <node_container pkg="rclcpp_components" exec="component_container" name="container" namespace="">
    <composable_node pkg="joy" plugin="joy::GameController" name="game_controller_node">
      <param name="device_name" value="Xbox 360"/>
      <param name="deadzone" value="0.0"/>
      <param name="autorepeat_rate" value="0.0"/>
      <param name="sticky_buttons" value="true"/>
      <remap from="joy" to="controller"/>
      <remap from="joy/set_feedback" to="controller/set_feedback"/>
    </composable_node>
  </node_container>
</launch>
`);
  workspace.write('workspace.yaml', `schema: 1
name: pad
packages: [src/*]
launch: src/pad/launch/pad.launch.xml
programs:
  - {package: joy, executable: joy_enumerate_devices}
`);
});

interface Held {
  readonly axes?: readonly number[];
  /** Values by the buttons' indexes in the standard layout. */
  readonly buttons?: Readonly<Record<number, number>>;
  readonly id?: string;
  readonly rumbles?: boolean;
}

declare global {
  // Set by the test.
  var gamepads: unknown[];
  var effects: unknown[];
  var isUsed: boolean;
}

/** A browser without gamepads, until `hold` plugs one in. */
function unplugged(): void {
  globalThis.gamepads = [];
  globalThis.effects = [];
  globalThis.isUsed = true;
  Object.assign(navigator, { getGamepads: () => globalThis.gamepads });
  Document.prototype.hasFocus = () => globalThis.isUsed;
}

/** The only gamepad of the browser, as it is from now on. */
const hold = (page: Page, held: Held): Promise<void> =>
  page.evaluate(({ axes, buttons, id, rumbles }) => {
    const isNew = globalThis.gamepads.length === 0;
    const all = Array.from({ length: 17 }, (_, index) => ({ value: buttons?.[index] ?? 0, pressed: (buttons?.[index] ?? 0) > 0.5 }));
    const playEffect = (...effect: unknown[]): Promise<string> => {
      globalThis.effects.push(effect);
      return Promise.resolve('complete');
    };
    globalThis.gamepads = [{
      id: id ?? 'Xbox 360',
      index: 0,
      mapping: 'standard',
      connected: true,
      axes: axes ?? [0, 0, 0, 0],
      buttons: all,
      vibrationActuator: rumbles === true ? { playEffect } : null,
    }];
    if (isNew) window.dispatchEvent(new Event('gamepadconnected'));
  }, held);

/** The visitor turns to another window, or comes back. */
const use = (page: Page, isUsed: boolean): Promise<void> =>
  page.evaluate((value) => {
    globalThis.isUsed = value;
    window.dispatchEvent(new Event(value ? 'focus' : 'blur'));
  }, isUsed);

const unplug = (page: Page): Promise<void> =>
  page.evaluate(() => {
    globalThis.gamepads = [];
    window.dispatchEvent(new Event('gamepaddisconnected'));
  });

async function type(page: Page, line: string): Promise<void> {
  await page.waitForSelector('.terminal-input input:not([readonly])');
  const command = page.getByRole('textbox', { name: 'Command' });
  await command.fill(line);
  await command.press('Enter');
}

async function interrupt(page: Page): Promise<void> {
  await page.getByRole('textbox', { name: 'Command' }).press('Control+c');
}

/** The last message that `ros2 topic echo` has printed ends with these numbers. */
const echoes = (page: Page, wanted: string): Promise<unknown> =>
  page.waitForFunction((words) => {
    const text = document.querySelector('.panel-terminal')?.textContent ?? '';
    const numbers = text.split('---').at(-2)?.match(/-?\d+\.?\d*/g) ?? [];
    return numbers.map((number) => Math.round(Number(number) * 1000) / 1000).join(' ').endsWith(words);
  }, wanted);

/** Anywhere on the page, the consoles of nodes included. */
const says = (page: Page, text: string): Promise<unknown> => page.waitForFunction((words) => document.body.innerText.includes(words), text);

const drives = (page: Page, linear: number, angular: number): Promise<unknown> => echoes(page, `${linear} 0 0 0 0 ${angular}`);

for (const link of played('shared', 'port')) {
  test(`${link}: a gamepad drives`, watchdog, () =>
    withTabs(packed.browser, packed.site, link, async (open, context) => {
      await context.addInitScript(unplugged);
      const layout = { row: ['terminal', { column: ['console', { teleop: {} }] }] };
      const page = await open(`#layout=${encodeURIComponent(JSON.stringify(layout))}`);
      page.setDefaultTimeout(25_000);
      await page.getByText('A node waits for a gamepad: connect one and press one of its buttons.').waitFor();
      await says(page, 'No gamepad yet.');

      await type(page, 'ros2 topic echo /cmd_vel');
      await hold(page, {});
      await says(page, 'Gamepad: Xbox 360 (a node reads it)');
      await says(page, 'Opened joystick: Xbox 360.  deadzone: 0.300000');
      await says(page, '[composed.joy_node]: Opened joystick: Xbox 360.  deadzone: 0.500000');
      // The parameters of joy-launch.py are for /joy_node.
      await says(page, '[alone.joy_node]: Opened joystick: Xbox 360.  deadzone: 0.050000');
      await says(page, 'No haptic (rumble) available, skipping initialization');
      await says(page, 'Controller Found: device_id=0, device_name=Xbox 360');
      await says(page, 'Opened game controller: Xbox 360,  deadzone: 0.000000, rumble: No');

      // Half of the way behind the dead zone, with the enable button and then the one of turbo.
      await hold(page, { axes: [-1, -0.65, 0, 0], buttons: { 2: 1 } });
      await drives(page, 0.35, 0.4);
      await hold(page, { axes: [0, 0.65, 0, 0], buttons: { 5: 1 } });
      await drives(page, -0.75, 0);
      await hold(page, {});
      await drives(page, 0, 0);
      // Unplugged while it drives: the robot is stopped.
      await hold(page, { axes: [0, -1, 0, 0], buttons: { 2: 1 } });
      await drives(page, 0.7, 0);
      await unplug(page);
      await drives(page, 0, 0);
      await says(page, 'Game controller Removed: Xbox 360.');
      await page.getByText('A node waits for a gamepad').waitFor();
      await interrupt(page);

      await type(page, 'ros2 topic echo /controller');
      await page.getByRole('button', { name: 'Stop the command (Ctrl-C)' }).waitFor();
      await hold(page, { rumbles: true });
      await says(page, 'Opened game controller: Xbox 360,  deadzone: 0.000000, rumble: Yes');
      await hold(page, { rumbles: true, axes: [0, 0, -0.5, 1], buttons: { 0: 1, 7: 0.5 } });
      const released = Array(20).fill(0).join(' ');
      await echoes(page, `0 0 0.5 -1 0 -0.5 1 ${released}`);
      // The page is left: the sticks and triggers rest, and a sticky button remains what it is.
      await use(page, false);
      await echoes(page, `0 0 0 0 0 0 1 ${released}`);
      await use(page, true);
      await echoes(page, `0 0 0.5 -1 0 -0.5 0 ${released}`);
      await interrupt(page);

      await type(page, `ros2 topic pub --once -w 1 /joy/set_feedback sensor_msgs/msg/JoyFeedback '{type: 1, intensity: 0.5}'`);
      await page.waitForFunction(() => globalThis.effects.length > 0);
      assert.deepEqual(await page.evaluate(() => globalThis.effects), [['dual-rumble', { duration: 1000, strongMagnitude: 0.5, weakMagnitude: 0.5 }]]);
      await type(page, 'ros2 run joy joy_enumerate_devices');
      await says(page, 'Joystick Device ID : Joystick Device Name\n-----------------------------------------\n                 0 : Xbox 360\n');
    }));
}
