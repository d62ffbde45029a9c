// The panel that drives on a packed site, in Chromium on both links: it finds the turtle of the simulator, which goes
// while a key is held and stands when it is let go.

// Compatibility, works: driving a node from the page by Twist: keys, buttons, finger, gamepad

import { test } from 'node:test';
import type { Page } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { packedInBrowser } from '../support/packed_in_browser.ts';
import { withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 400_000 };
const packed = packedInBrowser((workspace) => {
  workspace.write('workspace.yaml', `schema: 1
name: turtle
dependencies: [turtlesim]
launch:
  - {package: turtlesim, executable: turtlesim_node}
`);
});

/** The pose's field says so, as the topic's last message shows it. */
const poses = (page: Page, line: RegExp): Promise<unknown> =>
  page.waitForFunction(
    (wanted) => new RegExp(wanted).test(document.querySelector('.panel-topics .tree')?.textContent ?? ''),
    line.source,
    { timeout: 120_000 },
  );

for (const link of played('port', 'shared')) {
  test(`${link}: a key drives the turtle`, watchdog, () =>
    withTabs(packed.browser, packed.site, link, async (open) => {
      const layout = { row: [{ topics: { topic: '/turtle1/pose' } }, { teleop: { linear: 1.5 } }] };
      const page = await open(`#layout=${encodeURIComponent(JSON.stringify(layout))}`);
      page.setDefaultTimeout(120_000);
      await poses(page, /linear_velocity: 0\.0/);
      await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.panel-teleop input[list]')?.value === '/turtle1/cmd_vel');
      await page.waitForFunction(() => !(document.querySelector('.panel-teleop')?.textContent ?? '').includes('Nobody waits'));
      await page.locator('.drive-pad').focus();
      await page.keyboard.down('ArrowUp');
      await poses(page, /linear_velocity: 1\.5/);
      await page.keyboard.down('ArrowLeft');
      await poses(page, /angular_velocity: 1\.0/);
      await page.keyboard.up('ArrowUp');
      await page.keyboard.up('ArrowLeft');
      await poses(page, /linear_velocity: 0\.0.*angular_velocity: 0\.0|angular_velocity: 0\.0.*linear_velocity: 0\.0/);
      await page.getByText('at rest, nothing is sent').waitFor();
    }));
}
