// An action whose client and server run in different tabs of one graph, in Chromium: goal, feedback, result, cancelling,
// and what the client learns when the server's tab is closed.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { played } from '../../support/nightly.ts';
import { packedInBrowser } from '../support/packed_in_browser.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const name = 'tab_actions';

const packed = packedInBrowser((workspace) => {
  workspace.copyPackages(name);
  workspace.write('workspace.yaml', `schema: 1
name: ${name}
packages: [src/*]
launch:
  - {package: ${name}, executable: counter}
  - {package: ${name}, executable: asker}
`);
});

for (const link of played('shared', 'port')) {
  test(`${link}: an action reaches across tabs`, { timeout: 400_000 }, async () => {
    await withTabs(packed.browser, packed.site, link, async (open) => {
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
