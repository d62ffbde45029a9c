// ros2 launch on a packed site: its launch file's nodes once more, from a shell and from the page's terminal.

// Compatibility, works: `ros2 launch PACKAGE FILE name:=value`, `-s`, in the page's terminal and as `ros2wasm ros2 SITE ...`

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { after, before, test } from 'node:test';
import { type Browser, chromium, type Page } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { packExample } from '../support/example_site.ts';
import { CLI, finished } from '../support/pack_workspace.ts';
import { Scratch } from '../support/served_site.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 300_000 };
const file = ['two_robots', 'bringup.launch.xml'] as const;
let scratch: Scratch;
let site: string;
let browser: Browser;

before(async () => {
  scratch = new Scratch();
  site = await packExample(scratch, '02_launch');
  browser = await chromium.launch(chromiumOptions());
}, { timeout: 500_000 });

after(async () => {
  await browser.close();
  scratch[Symbol.dispose]();
});

for (const link of played('shared', 'port')) {
  test(`${link}: from a shell: the nodes of the launch file alone, until Ctrl-C`, watchdog, async () => {
    const ros2 = (...words: string[]) => spawn(CLI, ['ros2', '--link', link, site, ...words], { stdio: ['ignore', 'pipe', 'pipe'] });
    const shown = await finished(ros2('launch', '-s', ...file));
    assert.equal(shown.code, 0, shown.stderr);
    assert.match(shown.stdout, /'speed':\n {8}metres per second\n {8}\(default: '1\.0'\)/);
    for (
      const [words, message] of [
        [['nobody', 'bringup.launch.xml'], "Package 'nobody' not found\n"],
        [['two_robots', 'other.launch.py'], "'two_robots other.launch.py': of launch files the site has: ros2 launch two_robots bringup.launch.xml\n"],
      ] as const
    ) {
      assert.deepEqual(await finished(ros2('launch', ...words)), { code: 1, stdout: '', stderr: message });
    }
    const wrong = await finished(ros2('launch', ...file, 'sped:=2.0'));
    assert.equal(wrong.code, 1);
    assert.match(wrong.stderr, /sped/);

    const launched = ros2('launch', ...file, 'with_station:=false', 'speed:=0.5');
    const ended = finished(launched);
    let printed = '';
    let stopped = false;
    launched.stdout.on('data', (part: Buffer) => {
      printed += part.toString();
      if (stopped || !/alpha\.robot\]: starting/.test(printed) || !/beta\.robot\]: starting/.test(printed)) return;
      stopped = true;
      launched.kill('SIGINT');
    });
    const { code, stdout, stderr } = await ended;
    assert.equal(code, 0, stderr);
    assert.equal(stderr, '');
    assert.match(stdout, /^\[INFO\] \[robot-\d+\]: process started$/m);
    assert.match(stdout, /^\[robot-\d+\] \[INFO\] \[[\d.]+\] \[beta\.robot\]: starting at 0\.5 m\/s$/m);
    assert.match(stdout, /^\[WARNING\] \[launch\]: user interrupted with ctrl-c \(SIGINT\)$/m);
    assert.equal(stdout.match(/^\[INFO\] \[robot-\d+\]: process has finished cleanly$/gm)?.length, 2);
    assert.doesNotMatch(stdout, /station/);
  });

  test(`${link}: in the page's terminal: beside the nodes of the site, and away again`, watchdog, async () => {
    await withTabs(browser, site, link, async (open) => {
      const layout = encodeURIComponent(JSON.stringify({ row: ['nodes', 'terminal'], sizes: [1, 1], shown: 'terminal' }));
      const page: Page = await open(`#layout=${layout}`);
      const input = page.locator('.terminal-input input');
      await page.waitForSelector('.terminal-input input:not([readonly])', { timeout: 120_000 });
      await input.fill('ros2 launch t');
      await input.press('Tab');
      await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.terminal-input input')?.value === 'ros2 launch two_robots ');
      await input.fill(`ros2 launch ${file.join(' ')} with_station:=false speed:=3.0`);
      await input.press('Enter');
      await shows(page, 'beside what is launched these run already');
      await shows(page, 'starting at 3.0 m/s');
      await page.locator('.panel-nodes').getByText('robot (/beta)').nth(1).waitFor();
      await input.press('Control+c');
      await shows(page, 'user interrupted with ctrl-c (SIGINT)');
      await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.terminal-input input')?.placeholder === 'ros2 topic list');
    });
  });
}
