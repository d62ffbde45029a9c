// Both links in Chromium: between workers of TypeScript all scenes, between those and Python programs most.

// Compatibility, works: Python on either side of the middleware's scenes, on both links: matching,
// order, depth, transient_local, backpressure, QoS and its events, services, deaths, the graph,
// time that is held, stepped and scaled

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { type Browser, chromium, type Page } from 'playwright-core';
import { chromiumOptions } from '../../e2e/support/chromium.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';
import { addPyodide } from '../../support/python_nodes.ts';
import { allScenes } from './all_scenes.ts';
import { isPlayed } from './combinations.ts';
import { killScenes } from './kill_scenes.ts';
import { putPeerArchive, tooLarge } from './python_start.ts';

const watchdogMs = 120_000;

let folder: string;
let host: StaticServer;
let browser: Browser;
let page: Page;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'ros2wasm-links-'));
  const here = fileURLToPath(new URL('.', import.meta.url));
  const entryPoints = [join(here, 'browser_page.ts'), join(here, 'browser_peer.ts'), join(here, 'python_browser_peer.ts')];
  await build({ entryPoints, bundle: true, format: 'iife', outdir: folder, target: 'es2022', logLevel: 'warning' });
  writeFileSync(join(folder, 'index.html'), '<!doctype html><title>links</title><script src="browser_page.js"></script>');
  putPeerArchive(folder);
  addPyodide(folder);
  host = await serveFolder(folder, { isolated: true });
  browser = await chromium.launch(chromiumOptions());
  page = await browser.newPage();
  await page.goto(host.url);
});

after(async () => {
  await browser.close();
  await host.close();
  rmSync(folder, { recursive: true });
});

/** Scenes that are not played with Python here: tooLarge, and those that kill a worker with its interpreter (python_links.test.ts). */
const inNode = new Set([tooLarge, ...killScenes.map(({ name }) => name)]);

for (const kind of ['shared', 'port'] as const) {
  for (const between of ['TypeScript', 'Python to TypeScript', 'TypeScript to Python', 'Python to Python']) {
    for (const [index, { name }] of allScenes.entries()) {
      if (between !== 'TypeScript' && (inNode.has(name) || !isPlayed('Chromium', kind, index))) continue;
      test(`Chromium, ${kind}, ${between}: ${name}`, { timeout: watchdogMs }, async () => {
        const outcome = await page.evaluate(([k, n, b]) => {
          const run = (globalThis as unknown as { runScene: (kind: string, name: string, between: string) => Promise<string | undefined>; }).runScene;
          return run(k, n, b);
        }, [kind, name, between] as const);
        assert.equal(outcome, undefined);
      });
    }
  }
}
