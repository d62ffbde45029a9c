// Several sites of one origin, one after the other in one tab, on a host without headers: each is isolated at its first
// visit. And where a reload does not help, there is one and not another.

import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, type Page, chromium } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 180_000 };
const patience = { timeout: 60_000 };
const host = mkdtempSync(join(tmpdir(), 'ros2wasm-neighbours-'));
let browser: Browser;

before(async () => {
  const site = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }]);
  for (const name of ['one', 'two', 'three', 'stubborn']) cpSync(site, join(host, name), { recursive: true });
  rmSync(site, { recursive: true });
  // It takes the page over, and adds nothing.
  writeFileSync(join(host, 'stubborn/service_worker.js'), `
    self.addEventListener('install', () => self.skipWaiting());
    self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()));
    self.addEventListener('fetch', () => undefined);
  `);
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser.close();
  rmSync(host, { recursive: true });
});

async function heard(page: Page): Promise<boolean> {
  await page.waitForFunction(() => /heard/i.test(document.body?.textContent ?? ''), null, patience);
  return page.evaluate(() => crossOriginIsolated);
}

function loadsOf(page: Page): () => number {
  let loads = 0;
  page.on('request', (request) => {
    if (request.isNavigationRequest() && request.frame() === page.mainFrame()) loads += 1;
  });
  return () => loads;
}

// Guarantee, robust: each of several sites of one origin has shared memory at its first visit, one after the other in one tab, on a host without headers
test('one site after the other in one tab: each is isolated at its first visit', watchdog, async () => {
  const server = await serveFolder(host);
  const context = await browser.newContext();
  try {
    const page = await context.newPage();
    const loads = loadsOf(page);
    for (const name of ['one', 'two', 'three']) {
      const earlier = loads();
      await page.goto(`${server.url}${name}/`);
      assert.equal(await heard(page), true, name);
      assert.equal(loads() - earlier, 2, name);
    }
    // And once more, back and forth, without a reload.
    for (const name of ['one', 'three']) {
      const earlier = loads();
      await page.goto(`${server.url}${name}/#x`);
      assert.equal(await heard(page), true, name);
      assert.equal(loads() - earlier, 1, name);
    }
    await page.goBack();
    assert.equal(await heard(page), true);
  } finally {
    await context.close();
    await server.close();
  }
});

test('where a reload does not isolate the page it runs over ports, and is not reloaded again', watchdog, async () => {
  const server = await serveFolder(host);
  const context = await browser.newContext();
  try {
    const page = await context.newPage();
    const loads = loadsOf(page);
    await page.goto(`${server.url}stubborn/`);
    assert.equal(await heard(page), false);
    assert.equal(loads(), 2);
    // The query and the fragment of the address do not change.
    await page.goto(`${server.url}one/?x=1#y=2`);
    assert.equal(await heard(page), true);
    assert.ok(page.url().endsWith('/one/?x=1#y=2'), page.url());
  } finally {
    await context.close();
    await server.close();
  }
});
