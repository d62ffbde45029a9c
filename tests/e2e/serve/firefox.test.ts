// Packed examples in Firefox: nodes in C++ and in Python hear each other, on both links.

// Compatibility, works: Firefox (Debian's): talker and listener of C++ (example 01) and of Python (example 07), on both
// links

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Firefox } from '../../support/firefox.ts';
import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { packExample } from '../support/example_site.ts';
import { Scratch } from '../support/served_site.ts';

const watchdog = { timeout: 300_000 };
const heardMs = 100_000;

/** Two messages of the talker in its own words, and whether the host isolates the page: the shared link needs it. */
const examples = {
  '01_talker_listener': { heard: /I heard: 'Hello[^]*I heard: 'Hello/, hosts: played(false, true) },
  '07_python': { heard: /I heard: 'Good morning[^]*I heard: 'Good morning/, hosts: played(true, false) },
};

for (const [example, { heard, hosts }] of Object.entries(examples)) {
  test(`Firefox: ${example} runs`, watchdog, async () => {
    using scratch = new Scratch();
    const site = await packExample(scratch, example);
    for (const isolated of hosts) {
      const host = await serveFolder(site, { isolated });
      const firefox = await Firefox.launch({ serviceWorkers: isolated });
      try {
        await firefox.goto(host.url);
        await firefox.seen(heard, heardMs);
        assert.equal(await firefox.evaluate('crossOriginIsolated'), isolated);
      } finally {
        await firefox.close();
        await host.close();
      }
    }
  });
}
