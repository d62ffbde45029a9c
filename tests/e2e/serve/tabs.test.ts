// Tabs of one site that join one graph, in Chromium: pages of one context.

import { rmSync } from 'node:fs';
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';
import { lacks, shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 240_000 };

let browser: Browser;
let folder = '';

before(async () => {
  folder = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }]);
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

for (const link of ['shared', 'port'] as const) {
  test(`${link}: a listener in one tab hears the talker in another, until that one is gone`, watchdog, async () => {
    await withTabs(browser, folder, link, async (open) => {
      const talker = await open('?graph=g&nodes=talker-1');
      await shows(talker, 'Tab 1 of 1');
      const listener = await open('?graph=g&nodes=listener-2');
      await shows(listener, 'I heard: [Hello World');
      await shows(listener, 'runs in tab 1');
      await shows(talker, 'runs in tab 2');
      await shows(talker, 'Tab 1 of 2');
      assert.equal((await talker.innerText('body')).includes('I heard'), false);

      const idle = await open('?graph=g');
      await shows(idle, 'Tab 3 of 3');
      await shows(idle, '0 of 2 running');
      await idle.close();

      const other = await open('?graph=h&nodes=listener-2');
      await shows(other, 'Tab 1 of 1');
      await shows(other, '1 of 2 running');

      await talker.close();
      await lacks(listener, 'runs in tab 1');
      await shows(listener, 'Tab 2 of 1');
      const next = await open('?graph=g');
      await shows(next, '1 of 2 running');
      await shows(next, 'runs in tab 2');
      assert.equal((await other.innerText('body')).includes('I heard'), false);
    });
  });
}

test('a tab joins while it runs, by the control on the page', watchdog, async () => {
  await withTabs(browser, folder, 'shared', async (open, context) => {
    const page = await open('');
    await shows(page, 'I heard: [Hello World');
    await page.getByRole('button', { name: /Join other tabs/ }).click();
    await shows(page, 'Tab 1 of 1');
    // In one line on a phone too.
    const { width = 0, height = 0 } = page.viewportSize() ?? {};
    await page.setViewportSize({ width: 390, height: 844 });
    const place = await page.getByRole('link', { name: 'Tab 1 of 1' }).boundingBox();
    assert.ok(place !== null && place.height <= 40 && place.x + place.width <= 390, JSON.stringify(place));
    await page.setViewportSize({ width, height });
    const [second] = await Promise.all([context.waitForEvent('page'), page.getByRole('link', { name: 'Tab 1 of 1' }).click()]);
    await shows(second, 'Tab 2 of 2');
    await shows(second, 'runs in tab 1');
    await shows(second, '0 of 2 running');
  });
});
