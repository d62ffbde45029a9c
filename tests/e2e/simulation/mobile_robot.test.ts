// Example 05, packed: its checks without a browser, and in the page a goal that is pressed in the 3D view and reached, gains
// that links of the lab sheet set, and walls of the simulated rooms that stop the robot.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import type { Browser, Locator, Page } from 'playwright-core';
import { chromiumOptions, SOFTWARE_WEB_GL } from '../support/chromium.ts';
import { packExample } from '../support/example_site.ts';
import { Scratch, ServedSite, runCli } from '../support/served_site.ts';

const EXAMPLE = fileURLToPath(new URL('../../../examples/05_mobile_robot', import.meta.url));
const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const watchdog = { timeout: 600_000 };
const scratch = new Scratch();
let site: string;
let browser: Browser;

before(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  site = await packExample(scratch, '05_mobile_robot');
  browser = await chromium.launch(chromiumOptions(SOFTWARE_WEB_GL));
});

after(async () => {
  await browser.close();
  scratch[Symbol.dispose]();
});

test('the robot drives to its first goal, its checks pass, and it can begin standing still', watchdog, async () => {
  // Stepped, so that a loaded machine changes no rate.
  const stepped = await runCli(['run', site, '--stepped', '--checks']);
  assert.equal(stepped.code, 0, stepped.output + stepped.errors);
  assert.match(stepped.output + stepped.errors, /4 of 4 checks passed/);
  let rest = stepped.output;
  for (const line of readFileSync(join(EXAMPLE, 'expected.txt'), 'utf8').trimEnd().split('\n')) {
    const found = new RegExp(line).exec(rest);
    assert.ok(found, `${line} not in\n${rest}`);
    rest = rest.slice(found.index);
  }
  assert.doesNotMatch(stepped.output, /no further|given up|WARN/);
  const waiting = await runCli(['run', site, 'drive:=false', '--link', 'port', '--for', '120s', '--until', 'Waiting for a goal']);
  assert.equal(waiting.code, 0, waiting.output + waiting.errors);
  // A robot that goes nowhere is not right.
  const still = await runCli(['run', site, 'drive:=false', '--stepped', '--checks']);
  assert.equal(still.code, 1, still.output + still.errors);
  assert.match(still.output + still.errors, /3 of 4 checks passed/);
});

test('in the page a goal is pressed and reached, with gains of the lab sheet', watchdog, async () => {
  await using server = await ServedSite.start([site, '--port', '0']);
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  page.setDefaultTimeout(120_000);
  const troubles: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  await page.goto(server.url);
  await page.getByRole('heading', { name: 'Tune a controller' }).waitFor();
  await page.getByRole('tab', { name: 'Console' }).click();
  await reached(page, 1);
  // Its plots: how far it is from where it goes, by how much it looks aside, and how fast it turns.
  const plotted = page.locator('.panel-plot .path');
  await page.waitForFunction(() =>
    [...document.querySelectorAll('.panel-plot .path-value')].filter((each) => /^-?\d/.test(each.textContent ?? '')).length === 3
  );
  assert.deepEqual(await plotted.locator('.path-name').allInnerTexts(), ['/distance.data', '/heading_error.data', '/odom.twist.twist.angular.z']);
  // Near the goal at last: the plot is drawn a moment after the console.
  await page.waitForFunction(() => {
    const near = Number.parseFloat(document.querySelector('.panel-plot .path-value')?.textContent ?? '');
    return near >= 0 && near < 0.5;
  });
  const canvas = page.locator('.scene-canvas');
  await page.getByRole('button', { name: 'Set a goal' }).click();
  const box = (await canvas.boundingBox()) ?? assert.fail();
  await canvas.click({ position: { x: box.width * 0.62, y: box.height * 0.62 } });
  await page.getByText(/Driving to/).nth(1).waitFor();
  await reached(page, 2);
  await page.screenshot({ path: join(OUTPUT, 'mobile_robot.png') });
  await follow(page, 'without damping');
  await follow(page, 'Turn harder');
  await follow(page, 'west');
  await reached(page, 3);
  // Behind the wall: the laser stops the robot; with that taken away the wall does.
  await follow(page, 'to the middle');
  await reached(page, 4);
  await follow(page, 'behind the wall');
  await page.getByText(/Something is 0\.\d\d m ahead: no further/).first().waitFor();
  await follow(page, 'without its eyes');
  // The tasks: what was done above counts, what was not done does not.
  await page.getByRole('tab', { name: 'Tasks' }).click();
  await task(page, 'Drive into a wall').getByText(/^Done/).waitFor();
  await page.screenshot({ path: join(OUTPUT, 'mobile_robot_wall.png') });
  assert.equal(await task(page, 'Odometry that errs').getByText(/^Done/).count(), 0);
  await page.screenshot({ path: join(OUTPUT, 'mobile_robot_tasks.png') });
  assert.deepEqual(troubles, []);
  await page.close();
});

// Compatibility, works: an `.rviz` file as RViz saves it, which a launch file gives to `rviz2 -d`: its displays, groups, fixed frame, view and tools
test('the 3D view shows what the launch file gives to rviz2', watchdog, async () => {
  const { ui } = JSON.parse(readFileSync(join(site, 'site.json'), 'utf8')) as { readonly ui: { readonly opens: unknown; }; };
  assert.deepEqual(ui.opens, [{ panel: 'scene', file: 'share/mobile_robot/rviz/robot.rviz' }, { panel: 'simulation' }]);
  await using server = await ServedSite.start([site, '--port', '0']);
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  page.setDefaultTimeout(120_000);
  // As the author has it, with the list of what is shown.
  await page.goto(server.url);
  await page.locator('.scene-said').getByText('As in robot.rviz').waitFor();
  await page.getByRole('button', { name: 'What is shown' }).click();
  assert.equal(await page.getByRole('combobox', { name: 'Fixed frame' }).inputValue(), 'map');
  const ticked = async (wanted: readonly string[]): Promise<void> => {
    await page.waitForFunction((names) => {
      const shown = [...document.querySelectorAll<HTMLInputElement>('.scene-topics input:checked')].map((box) => {
        const label = box.labels?.[0];
        return (label?.textContent ?? '').slice(0, -(label?.querySelector('.scene-type')?.textContent?.length ?? 0));
      });
      return JSON.stringify(shown.toSorted()) === JSON.stringify(names);
    }, wanted);
  };
  const displays = ['/goal_pose', '/map', '/robot_description', '/scan', '/trail'];
  await ticked(displays);
  const list = page.locator('.scene-list');
  assert.equal(await list.getByRole('checkbox', { name: '/odom' }).isChecked(), false);
  assert.deepEqual(await list.locator(':scope > .check input[type=checkbox]').evaluateAll((boxes) => boxes.map((box) => (box as HTMLInputElement).checked)), [
    true,
    false,
    true,
  ]);
  assert.equal(await list.locator('.scene-problem').count(), 0);
  await page.screenshot({ path: join(OUTPUT, 'mobile_robot_rviz.png') });
  // Others may be ticked, and the menu brings back what the file says.
  await list.getByRole('checkbox', { name: '/odom' }).check();
  await list.getByRole('checkbox', { name: '/map' }).uncheck();
  await ticked(['/goal_pose', '/odom', '/robot_description', '/scan', '/trail']);
  await page.getByRole('button', { name: 'Show what an RViz file says' }).click();
  await page.getByRole('menuitem', { name: 'robot.rviz' }).click();
  await ticked(displays);
  await page.close();
});

/** Waits until the controller has said so often that it is there. */
async function reached(page: Page, times: number): Promise<void> {
  await page.getByText(/Goal reached/).nth(times - 1).waitFor();
}

/** The state of a task beside its title. */
function task(page: Page, title: string): Locator {
  return page.locator('.task').filter({ hasText: title }).locator('.task-title + .node-state');
}

/** A link of the lab sheet that acts. */
async function follow(page: Page, name: string): Promise<void> {
  await page.locator('.panel-text').getByRole('button', { name }).click();
}
