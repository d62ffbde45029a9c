// The template `course`, as somebody sees it who has just made it: its lab sheet beside its machine, and each link of the
// sheet does what it says.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium, type Locator } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 400_000 };
let workspace: PackWorkspace;
let browser: Browser;

before(async () => {
  workspace = new PackWorkspace('shared');
  for (const args of [['init', 'course', 'lab'], ['pack', 'lab/workspace.yaml', '-o', 'site']]) {
    const { code, stderr } = await workspace.run(args);
    assert.equal(code, 0, stderr);
  }
  browser = await chromium.launch(chromiumOptions());
}, { timeout: 500_000 });

after(async () => {
  await browser.close();
  workspace.close();
});

test('each link of the lab sheet acts', watchdog, () =>
  withTabs(browser, join(workspace.root, 'site'), 'shared', async (open) => {
    // Beside the sheet what the turtle does, so that a parameter is seen to act.
    const layout = { row: ['text', { topics: { topic: '/turtle1/pose' } }] };
    const page = await open(`#layout=${encodeURIComponent(JSON.stringify(layout))}`);
    page.setDefaultTimeout(120_000);
    const sheet = page.locator('.panel-text .text');
    const said = page.locator('.text-said');
    const clicked: string[] = [];
    const click = async (name: string): Promise<void> => {
      await sheet.getByRole('button', { name, exact: true }).click();
      clicked.push(name);
    };
    /** How fast it turns, in the newest message. */
    const turns = (rate: RegExp): Promise<unknown> =>
      page.waitForFunction(
        (wanted) => new RegExp(wanted).test(document.querySelector('.panel-topics .tree')?.textContent ?? ''),
        rate.source,
      );

    await turns(/angular_velocity: 0\.666/);
    await click('to 3.0');
    await said.getByText('Set radius of /circle').waitFor();
    await turns(/angular_velocity: 0\.333/);
    await click('back to 1.5');
    await turns(/angular_velocity: 0\.666/);

    await click('Look again');
    await said.getByText('Passed: The turtle drives a circle').waitFor();
    await said.getByText('Passed: The odometer measures its way').waitFor();

    await click('Plot the pose');
    for (const path of ['/turtle1/pose.x', '/turtle1/pose.y']) {
      await page.getByRole('button', { name: `Remove ${path}` }).waitFor();
    }
    await page.waitForFunction(() => /pose\.x\s*\d/.test(document.querySelector('.panel-plot')?.textContent ?? ''));

    await click('ask for its rate');
    await page.locator('.panel-terminal').getByText(/^average rate: \d/).first().waitFor();

    await click('the odometer');
    await page.locator('.panel-source').getByText('class Odometer').waitFor();

    await click('the tasks');
    await page.locator('.panel-tasks .task').nth(2).waitFor();

    // None is skipped.
    assert.deepEqual(clicked.toSorted(), (await sheet.getByRole('button').allTextContents()).toSorted());
  }));

test('each task is open at first, and its solution does it', watchdog, () =>
  withTabs(browser, join(workspace.root, 'site'), 'shared', async (open) => {
    const layout = { row: ['tasks', { column: ['terminal', 'source'] }] };
    const page = await open(`#layout=${encodeURIComponent(JSON.stringify(layout))}`);
    page.setDefaultTimeout(120_000);
    const task = (title: string): Locator => page.locator('.task', { hasText: title });
    await page.getByText('0 of 3 tasks done').waitFor();
    // The circle is driven by itself; what it does is none of the tasks.
    await page.locator('.panel-tasks').getByText(/Seen: 0\.66/).first().waitFor();
    assert.equal(await page.getByText('Already so before you began').count(), 0);
    await page.getByRole('button', { name: 'Show hint: Draw a wider circle' }).click();
    await page.getByRole('button', { name: 'Show solution: Draw a wider circle' }).click();
    await page.locator('.task-solution .text-action').click();
    await task('Draw a wider circle').locator('.task-title + .node-state').getByText(/^Done/).waitFor();
    const input = page.locator('.panel-terminal input');
    await page.getByRole('button', { name: 'Show hint: Call a second turtle' }).click();
    await page.getByRole('button', { name: 'Show solution: Call a second turtle' }).click();
    const command = (await task('Call a second turtle').locator('.task-solution pre').textContent()) ?? '';
    await input.fill(command.trim());
    await input.press('Enter');
    await page.getByText('2 of 3 tasks done').waitFor();
  }));
