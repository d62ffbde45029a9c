// Files that Python nodes write below their home: on disk after a headless run that asks for them, and in the panel Bag.

// Compatibility, works: files that Python nodes write below their home (CSV, images, maps; up to 64 MiB each): the panel Bag offers
// them for download, and `ros2wasm run SITE --bags DIR` writes them to disk

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { type Browser, chromium } from 'playwright-core';
import { ownPackage } from '../support/python_nodes.ts';
import { chromiumOptions } from './chromium.ts';
import { makeSite } from './runtime_site.ts';
import { withTabs } from './site_tabs.ts';

const watchdog = { timeout: 240_000 };
const headless = fileURLToPath(new URL('../../runtime/wasm_js/headless.ts', import.meta.url));
const often = Array.from({ length: 500 }, (_, i) => `${i}\n`).join('');
/** What tests/packages/chatter_py/scripts/files writes. */
const wanted: Readonly<Record<string, string>> = {
  'logs/kept_open.csv': 'time,x\r\n', 'often.csv': often, 'map.pgm': 'P5 1 1 255\n\x7f', 'poses.new': 'at home', 'poses.txt': 'at home',
};
let folder = '';
let browser: Browser;

before(async () => {
  folder = makeSite([], {}, {}, { nodes: [{ entry: 'lib/chatter_py/files', executable: 'files' }], packages: ownPackage('chatter_py') });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

for (const link of ['shared', 'port'] as const) {
  test(`${link}, Node.js: --bags has them on disk`, watchdog, async () => {
    const kept = mkdtempSync(join(tmpdir(), 'ros2wasm-output-'));
    try {
      const child = spawn(process.execPath, [headless, folder, '--link', link, '--bags', kept], { stdio: ['ignore', 'pipe', 'inherit'] });
      let out = '';
      child.stdout.on('data', (bytes: Buffer) => { out += bytes.toString(); });
      await new Promise((resolve) => child.on('close', resolve));
      assert.match(out, /^\[files-1\] \/home\/user\/large\.bin is too large to be handed to the page$/m);
      const found = readdirSync(kept, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
        .map((entry) => join(entry.parentPath, entry.name));
      assert.deepEqual(Object.fromEntries(found.map((path) => [path.slice(`${kept}/files-1/`.length), readFileSync(path, 'latin1')]).sort()),
        Object.fromEntries(Object.entries(wanted).sort()));
    } finally {
      rmSync(kept, { recursive: true });
    }
  });
}

test('Chromium: the panel Bag offers the newest of each, also of a second run', watchdog, () =>
  withTabs(browser, folder, 'shared', async (open) => {
    const page = await open(`#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', 'bag'], sizes: [1, 2], shown: 'bag' }))}`);
    page.setDefaultTimeout(120_000);
    const list = page.getByRole('list', { name: 'Files that nodes have written' });
    for (const run of [1, 2]) {
      if (run === 2) await page.getByRole('button', { name: 'Start /files', exact: true }).click();
      await page.getByRole('button', { name: 'Start /files', exact: true }).waitFor();
      await list.getByText('files-1: /home/user/logs/kept_open.csv').waitFor();
      assert.equal(await list.getByRole('listitem').count(), Object.keys(wanted).length);
    }
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download files-1: /home/user/often.csv' }).click()]);
    assert.equal(download.suggestedFilename(), 'often.csv');
    assert.equal(readFileSync(await download.path(), 'utf8'), often);
    await page.getByRole('button', { name: 'Forget files-1: /home/user/often.csv' }).click();
    assert.equal(await list.getByRole('listitem').count(), Object.keys(wanted).length - 1);
  }));
