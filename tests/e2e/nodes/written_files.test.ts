// Files that nodes write below their home: on disk after a headless run that asks for them, and in the panel Bag.

// Compatibility, works: files that nodes write below their home (CSV, images, maps; up to 64 MiB each): the panel Bag offers
// them for download, and `ros2wasm run SITE --bags DIR` writes them to disk

// Compatibility, works: C++ programs that use nothing of ROS: files, standard streams, threads, sleep by the site's time, what is
// static destroyed and what was not flushed written at the end

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { type Browser, chromium } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { makeSite } from '../support/runtime_site.ts';
import { withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 240_000 };
const headless = fileURLToPath(new URL('../../../runtime/site/session/headless.ts', import.meta.url));
const often = Array.from({ length: 500 }, (_, i) => `${i}\n`).join('');
/** The files that tests/packages/chatter_py/scripts/files writes. */
const wanted: Readonly<Record<string, string>> = {
  'logs/kept_open.csv': 'time,x\r\n',
  'often.csv': often,
  'map.pgm': 'P5 1 1 255\n\x7f',
  'poses.new': 'at home',
  'poses.txt': 'at home',
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

/** The output of a headless run, and the files in the folder of `--bags` after it. */
async function runWithBags(site: string, link: string): Promise<{ readonly out: string; readonly files: Readonly<Record<string, string>>; }> {
  const kept = mkdtempSync(join(tmpdir(), 'ros2wasm-output-'));
  try {
    const child = spawn(process.execPath, [headless, site, '--link', link, '--bags', kept], { stdio: ['pipe', 'pipe', 'inherit'] });
    let out = '';
    child.stdout.on('data', (bytes: Buffer) => {
      out += bytes.toString();
    });
    await new Promise((resolve) => child.on('close', resolve));
    const found = readdirSync(kept, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
      .map((entry) => join(entry.parentPath, entry.name));
    return { out, files: Object.fromEntries(found.map((path) => [path.slice(kept.length + 1), readFileSync(path, 'latin1')])) };
  } finally {
    rmSync(kept, { recursive: true });
  }
}

function ofNode(name: string, files: Readonly<Record<string, string>>): Readonly<Record<string, string>> {
  return Object.fromEntries(Object.entries(files).map(([path, text]) => [`${name}/${path}`, text]));
}

for (const link of played('port', 'shared')) {
  test(`${link}, Node.js: --bags has those of a Python node on disk`, watchdog, async () => {
    const { out, files } = await runWithBags(folder, link);
    assert.match(out, /^\[files-1\] \/home\/user\/large\.bin is too large to be handed to the page$/m);
    assert.deepEqual(files, ofNode('files-1', wanted));
  });
}

test('--bags has those of C++ nodes, also of threads', { timeout: 500_000 }, async () => {
  const workspace = new PackWorkspace('shared');
  try {
    cpSync(resolve(import.meta.dirname, '../../packages/file_checks'), join(workspace.root, 'src/file_checks'), { recursive: true });
    cpSync(resolve(import.meta.dirname, '../../packages/rclcpp_checks'), join(workspace.root, 'src/rclcpp_checks'), { recursive: true });
    for (const [link, nodes] of [['shared', ['written-1', 'written_in_a_thread-2']], ['port', ['written-1']]] as const) {
      workspace.write('w.yaml', `schema: 1
name: files
title: Files
version: 1.0.0
license: Apache-2.0
distro: jazzy
packages: [src/file_checks]
launch:
${nodes.map((name) => `  - {package: file_checks, executable: ${name.replace(/-.*/, '')}}\n`).join('')}`);
      const packed = await workspace.run(['pack', 'w.yaml', '--output', `site_${link}`]);
      assert.equal(packed.code, 0, packed.stderr);
      const { out, files } = await runWithBags(join(workspace.root, `site_${link}`), link);
      for (const name of nodes) {
        assert.match(out, new RegExp(`^\\[${name}\\] /home/user/large\\.bin is too large to be handed to the page$`, 'm'));
        // Static objects are destroyed.
        assert.match(out, new RegExp(`^\\[${name}\\] farewell$`, 'm'));
      }
      const all = { ...wanted, 'read_later.txt': 'not yet, but now' };
      assert.deepEqual(files, Object.assign({}, ...nodes.map((name) => ofNode(name, all))));
    }
  } finally {
    workspace.close();
  }
});

test('a C++ program that uses nothing of ROS sleeps by the time of the site', { timeout: 500_000 }, async () => {
  const workspace = new PackWorkspace('shared');
  try {
    workspace.addPackage('sleeper', {
      hour: `#include <chrono>
#include <cstdio>
#include <thread>
int main() {
  std::this_thread::sleep_for(std::chrono::hours(1));
  std::puts("an hour later");
}
`,
    });
    workspace.write('w.yaml', `schema: 1
name: sleeper
title: Sleeper
distro: jazzy
packages: [src/sleeper]
launch:
  - {package: sleeper, executable: hour}
`);
    const packed = await workspace.run(['pack', 'w.yaml', '--output', 'site']);
    assert.equal(packed.code, 0, packed.stderr);
    const ran = await workspace.run(['run', 'site', '--stepped', '--for', '120m']);
    assert.equal(ran.code, 0, ran.stderr);
    assert.match(ran.stdout, /^\[hour-1\] an hour later$/m);
  } finally {
    workspace.close();
  }
});

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
