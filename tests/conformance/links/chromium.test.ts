// Both links in Chromium.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { type Browser, chromium, type Page } from 'playwright-core';
import { chromiumOptions } from '../../e2e/chromium.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';
import { allScenes } from './all_scenes.ts';

const watchdogMs = 120_000;

let folder: string;
let host: StaticServer;
let browser: Browser;
let page: Page;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'ros2wasm-links-'));
  const here = fileURLToPath(new URL('.', import.meta.url));
  const entryPoints = [join(here, 'browser_page.ts'), join(here, 'browser_peer.ts')];
  await build({ entryPoints, bundle: true, format: 'iife', outdir: folder, target: 'es2022', logLevel: 'warning' });
  writeFileSync(join(folder, 'index.html'), '<!doctype html><title>links</title><script src="browser_page.js"></script>');
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

for (const kind of ['shared', 'port'] as const) {
  for (const { name } of allScenes) {
    test(`Chromium, ${kind}: ${name}`, { timeout: watchdogMs }, async () => {
      const outcome = await page.evaluate(([k, n]) => {
        const run = (globalThis as unknown as { runScene: (kind: string, name: string) => Promise<string | undefined> }).runScene;
        return run(k, n);
      }, [kind, name] as const);
      assert.equal(outcome, undefined);
    });
  }
}
