// The files of Python in a site run only as they were packed: Pyodide's own, its scripts, the archives; in Chromium and
// headless. No image is kept of others.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { appendFileSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { type Browser, chromium, type Page } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
const patience = { timeout: 100_000 };
const headless = fileURLToPath(new URL('../../../runtime/site/session/headless.ts', import.meta.url));
let folder = '';
let browser: Browser | undefined;

before(async () => {
  const entry = 'lib/chatter_py/fresh';
  folder = makeSite([], {}, {}, {
    nodes: ['one', 'two'].map((name) => ({ entry, executable: 'fresh', arguments: [name] })),
    packages: ownPackage('chatter_py'),
  });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser?.close();
  if (folder !== '') rmSync(folder, { recursive: true });
});

/** With a file that is longer than it was packed, and would work. */
async function withChange(path: string, use: () => Promise<void> | void): Promise<void> {
  const whole = readFileSync(join(folder, path));
  appendFileSync(join(folder, path), '\n');
  try {
    await use();
  } finally {
    writeFileSync(join(folder, path), whole);
  }
}

async function visit(isolated: boolean, use: (page: Page, requests: readonly string[]) => Promise<void>): Promise<void> {
  assert.ok(browser);
  const host = await serveFolder(folder, { isolated });
  // Where there is no service worker, the page itself is the last that looks.
  const context = await browser.newContext({ serviceWorkers: 'block' });
  try {
    const page = await context.newPage();
    await page.goto(host.url);
    await use(page, host.requests);
  } finally {
    await context.close();
    await host.close();
  }
}

function shows(page: Page, pattern: string, count: number): Promise<unknown> {
  return page.waitForFunction(
    ([text, least]) => (document.body?.textContent?.match(new RegExp(text, 'g')) ?? []).length >= least,
    [pattern, count] as const,
    patience,
  );
}

// Guarantee, verified: the page and `ros2wasm run` run Python only with the archives and the Pyodide that `site.json` lists,
// and no image of an interpreter is kept of others; its scripts are looked at first, and then loaded from the host once more
for (const path of ['python/packages.zip', 'pyodide/python_stdlib.zip', 'pyodide/pyodide.asm.js', 'python_worker.js']) {
  test(`${path}, changed on the host, is refused by the page`, watchdog, () =>
    withChange(path, () =>
      visit(path !== 'python_worker.js', async (page) => {
        await shows(page, `${path} is not the file that the site was packed with`, 2);
        const text = await page.evaluate(() => document.body.textContent ?? '');
        assert.match(text, /R2W0724/);
        assert.doesNotMatch(text, /fresh \{"image"/);
        assert.equal(await page.evaluate(async () => (await (await caches.open('ros2wasm-kept')).keys()).length), 0);
      })));
}

for (const link of played('shared', 'port')) {
  for (const path of ['python/packages.zip', 'pyodide/python_stdlib.zip']) {
    test(`${path}, changed in the folder, is refused headless, ${link} link`, watchdog, () =>
      withChange(path, () => {
        const { status, stdout, stderr } = spawnSync(process.execPath, [headless, folder, '--link', link], { encoding: 'utf8', timeout: 200_000 });
        assert.equal(status, 1, stdout);
        assert.match(stderr, new RegExp(`\\[fresh-1\\] error\\[R2W0724\\]: ${path} is not the file`));
        assert.doesNotMatch(stdout, /fresh \{"image"/);
      }));
  }
}

test('what is fetched, and hashed, is so once for all nodes', watchdog, () =>
  visit(true, async (page, requests) => {
    await shows(page, 'fresh \\{"image"', 2);
    for (const path of ['python/rclpy.zip', 'python/packages.zip', 'pyodide/python_stdlib.zip', 'pyodide/pyodide-lock.json', 'pyodide/pyodide.asm.wasm']) {
      assert.equal(requests.filter((asked) => asked.endsWith(`/${path}`)).length, 1, path);
    }
  }));
