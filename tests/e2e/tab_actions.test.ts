// An action whose client and server run in different tabs of one graph, in Chromium: goal, feedback, result, cancelling,
// and what the client learns when the server's tab is closed.

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { chromiumOptions } from './chromium.ts';
import { PackWorkspace } from './pack_workspace.ts';
import { shows, withTabs } from './site_tabs.ts';

const name = 'tab_actions';

let browser: Browser;
let workspace: PackWorkspace;

before(async () => {
  workspace = new PackWorkspace('shared');
  cpSync(resolve(import.meta.dirname, '../packages', name), join(workspace.root, 'src', name), { recursive: true });
  workspace.write('workspace.yaml', `schema: 1
name: ${name}
packages: [src/*]
launch:
  - {package: ${name}, executable: counter}
  - {package: ${name}, executable: asker}
`);
  await workspace.packed();
  browser = await chromium.launch(chromiumOptions());
}, { timeout: 500_000 });

after(async () => {
  await browser.close();
  workspace.close();
});

for (const link of ['shared', 'port'] as const) {
  test(`${link}: an action reaches across tabs`, { timeout: 400_000 }, async () => {
    await withTabs(browser, join(workspace.root, 'site'), link, async (open) => {
      const asker = await open('?graph=g&nodes=asker-2');
      await shows(asker, 'waiting');
      const counter = await open('?graph=g&nodes=counter-1');
      await shows(asker, 'result succeeded with 200 numbers, feedback in order');
      await shows(asker, 'cancelled: yes');
      await shows(counter, 'cancelled at ');
      assert.equal((await asker.innerText('body')).includes('cancelled at '), false, 'the server runs in its own tab');
      await counter.close();
      await shows(asker, 'the counter is gone');
    });
  });
}
