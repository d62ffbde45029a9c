// A node in Python that sends the page reports of its own making: it is ended with its own code; the page has no fault of its
// own to show, and the other nodes go on.

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { eventually } from '../../support/eventually.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
const patience = { timeout: 100_000 };
const forged = ['null', '{"t":"lines"}', '{"t":"end"}', '{"t":"lines","lines":[[1,1e300,""]],"dropped":0}', '{"t":"memory","memory":{}}'];
let browser: Browser;
let folder = '';

before(async () => {
  const entry = 'lib/chatter_py/forges';
  folder = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }], {}, {}, {
    nodes: forged.map((text) => ({ entry, executable: 'forges', arguments: [text] })),
    packages: ownPackage('chatter_py'),
  });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

for (const [link, isolated] of played(['shared', true], ['port', false])) {
  // Guarantee, hostile input: what a program sends to the page in its worker's place ends that node (R2W0727), and no other one
  test(`${link}: each node that forges reports is ended, and nothing else`, watchdog, async () => {
    const server = await serveFolder(folder, { isolated });
    const context = await browser.newContext({ serviceWorkers: 'block' });
    try {
      const page = await context.newPage();
      const faults: string[] = [];
      page.on('pageerror', (error) => faults.push(error.message));
      await page.goto(server.url);
      await page.waitForFunction((count) => (document.body?.textContent?.match(/R2W0727/g) ?? []).length >= count, forged.length, patience);
      assert.equal(await page.locator('.mistake').count(), 0);
      assert.doesNotMatch(await page.evaluate(() => document.body.textContent ?? ''), /R2W0792/);
      // The others are heard after that.
      const heard = (): Promise<number> =>
        page.evaluate(() => Math.max(0, ...[...(document.body.textContent ?? '').matchAll(/heard: \[Hello World: (\d+)/g)].map(([, n]) => Number(n))));
      const sofar = await heard();
      await eventually('another message is heard', async () => await heard() > sofar);
      assert.deepEqual(faults, []);
    } finally {
      await context.close();
      await server.close();
    }
  });
}
