// The page of example 01, packed, in Chromium: from a plain static host without any header of its own.
// ROS2WASM_SITE names a packed site; without it the example is packed with ROS2WASM_CLI.
// The picture for the README is taken here: tests/output/page.png, and with ROS2WASM_BLESS=1 docs/images/page.png.

// Compatibility, works: the talker and listener of the ROS 2 tutorial, unchanged, in Chromium and
// Node.js

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { packExample } from '../support/example_site.ts';
import { expectAccessible } from '../support/page_stage.ts';
import { Scratch } from '../support/served_site.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const WATCHDOG_MS = 120_000;

const scratch = new Scratch();
let site: string;
let served: StaticServer;
let browser: Browser;

before(async () => {
  site = process.env['ROS2WASM_SITE'] ?? (await packExample(scratch));
  served = await serveFolder(site);
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser?.close();
  await served?.close();
  scratch[Symbol.dispose]();
});

async function onSite(
  options: BrowserContextOptions,
  body: (page: Page) => Promise<void>,
): Promise<void> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, ...options });
  const page = await context.newPage();
  const troubles: string[] = [];
  page.setDefaultTimeout(WATCHDOG_MS);
  page.on('console', (message) => {
    if (message.type() === 'error') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  context.on('request', (request) => {
    if (!request.url().startsWith(served.url) && !request.url().startsWith('blob:'))
      troubles.push(`request to ${request.url()}`);
  });
  try {
    await page.goto(served.url);
    await body(page);
    assert.deepEqual(troubles, []);
  } finally {
    await context.close();
  }
}

const listener = (page: Page) => page.getByRole('log', { name: 'Console of listener' });

test('the listener hears the talker, in the exact format', () =>
  onSite({}, async (page) => {
    await listener(page)
      .getByText(/I heard: 'Hello, world! 2'/)
      .waitFor();
    const lines = await listener(page).locator('.line').allInnerTexts();
    for (const line of lines)
      assert.match(
        line,
        /^\[INFO\] \[\d{10}\.\d{9}\] \[minimal_subscriber\]: I heard: 'Hello, world! \d+'$/,
      );
    await page.getByText('2 of 2 running').waitFor();
    // For authors, on request.
    assert.equal(await page.getByText('workspace.yaml:14:17').isVisible(), false);
    await page.getByRole('button', { name: 'Layout of the page' }).click();
    await page.getByRole('menuitem', { name: 'Show where the manifest declares nodes' }).click();
    await page.getByText('workspace.yaml:14:17').waitFor();
  }));

test('the graph shows the two nodes and their topic, with its rate', () =>
  onSite({}, async (page) => {
    await page.getByText('2 of 2 running').waitFor();
    await page.getByRole('button', { name: 'Open a panel here' }).nth(1).click();
    await page.getByRole('menuitem', { name: 'Graph' }).click();
    for (const name of ['Node /minimal_publisher', 'Node /minimal_subscriber', 'Topic /topic'])
      await page.locator(`.graph-box[aria-label^="${name}"]`).waitFor();
    await page.locator('.graph-wire .graph-rate').getByText(/^[12]\.\d\d Hz$/).waitFor();
    assert.equal(await page.locator('.graph-box').count(), 3);
  }));

test('a link says whether nodes start by themselves', () =>
  onSite({}, async (page) => {
    await listener(page).getByText(/I heard/).first().waitFor();
    await page.goto('about:blank');
    await page.goto(`${served.url}#autorun=0`);
    await page.getByText('0 of 2 running').waitFor();
    await page.getByRole('button', { name: 'Start all', exact: true }).click();
    await listener(page).getByText(/I heard/).first().waitFor();
  }));

test('the first view is small: page, scripts and styles under 127 kB, without what runs the nodes', () =>
  onSite({}, async (page) => {
    await page.getByText('2 of 2 running').waitFor();
    // The panel of checks comes last; without it the sum would depend on the moment.
    await page.getByText(/of \d+ checks? (passed|seen)|checks? passed/).first().waitFor();
    const loaded = await page.evaluate(() => performance.getEntriesByType('resource').map((entry) => new URL(entry.name).pathname.split('/').at(-1) ?? ''));
    const view = ['index.html', ...new Set(loaded)].filter(
      (name) => /\.(html|js|css|svg)$/.test(name) && !name.endsWith('_worker.js'),
    );
    assert.ok(view.includes('start.js') && view.includes('mount.js') && view.includes('styles.css'), view.join(' '));
    const bytes = view
      .map((name) => gzipSync(readFileSync(join(site, name)), { level: 9 }).length)
      .reduce((sum, size) => sum + size, 0);
    assert.ok(bytes < 127_000, `${bytes} bytes gzipped: ${view.join(' ')}`);
  }));

test('the topic has its type, its rate and its last message', () =>
  onSite({}, async (page) => {
    const row = page.getByRole('button', { name: /^\/topic std_msgs\/msg\/String/ });
    await row.getByText(/^(1\.[89]|2\.[01])\d* Hz$/).waitFor();
    await row.getByText('1 publisher, 1 subscription').waitFor({ state: 'attached' });
    await row.click();
    await page
      .locator('.tree')
      .getByText(/Hello, world! \d+/)
      .waitFor();
  }));

test('what was published stays when the publisher stops, and when all nodes do', () =>
  onSite({}, async (page) => {
    await page.getByRole('button', { name: /^\/topic/ }).click();
    await page
      .locator('.tree')
      .getByText(/Hello, world! [3-9]/)
      .waitFor();
    await page.locator('.node').first().getByRole('button', { name: /^Stop/ }).click();
    await page.getByText('0 pub \u2192 1 sub').waitFor();
    const lines = await page.getByRole('log', { name: 'Console of talker' }).locator('.line').allInnerTexts();
    const published = lines.filter((line) => line.includes('Publishing:'));
    const inside = page.locator('.topic-inside');
    assert.match(await inside.innerText(), new RegExp(`Messages\\s+${published.length}\\s`));
    await inside.getByText(`Hello, world! ${published.length - 1}`, { exact: true }).waitFor();
    await page.getByRole('button', { name: 'Stop all' }).click();
    await page.getByText('0 pub \u2192 0 sub').waitFor();
    await inside.getByText(`Hello, world! ${published.length - 1}`, { exact: true }).waitFor();
    assert.equal(await page.getByText('No message has been published yet.').count(), 0);
  }));

test('the log shows /rosout of the nodes, with the place in their sources', () =>
  onSite({}, async (page) => {
    const layout = encodeURIComponent(JSON.stringify({ row: ['nodes', { log: { places: 'shown', node: 'minimal_publisher' } }] }));
    await page.goto(`${served.url}?#layout=${layout}`);
    const log = page.getByRole('log', { name: 'Log' });
    // One from before the panel was there, which /rosout keeps, and one from after.
    await log.getByText(/^\[INFO\] \[\d+\.\d{9}\] \[minimal_publisher\]: Publishing: 'Hello, world! 0' {2}\[File "[^"]*\.cpp", line \d+, in \S+\]$/).waitFor();
    const seen = await log.locator('.line').count();
    await log.locator('.line').nth(seen + 1).waitFor();
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('WARN');
    await page.getByText(/None of \d+ lines match the filter/).waitFor();
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('');
    await page.screenshot({ path: join(ROOT, 'tests/output/log_site.png') });
    // Opened later, when /rosout holds only the newest seconds, it has all from the beginning, each line once.
    await page.goto(`${served.url}?later#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', { tabs: ['console', 'log'] }] }))}`);
    await page.getByText(/Publishing: 'Hello, world! 24'/).first().waitFor();
    await page.getByRole('tab', { name: 'Log', exact: true }).click();
    await log.getByText(/Publishing: 'Hello, world! 26'$/).waitFor();
    const [saved] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save the log' }).click()]);
    const numbers = [...readFileSync(await saved.path(), 'utf8').matchAll(/Publishing: 'Hello, world! (\d+)'/g)].map(([, number]) => Number(number));
    assert.deepEqual(numbers, numbers.map((_, i) => i));
    assert.ok(numbers.length > 26);
  }));

test('stop, start, restart', () =>
  onSite({}, async (page) => {
    const talker = page.locator('.node').first();
    await listener(page)
      .getByText(/I heard/)
      .first()
      .waitFor();
    await talker.getByRole('button', { name: /^Stop/ }).click();
    await page.getByText('1 of 2 running').waitFor();
    await talker.getByRole('button', { name: /^Start/ }).click();
    await page.getByText('2 of 2 running').waitFor();
    await listener(page)
      .getByText(/world! 0'/)
      .nth(1)
      .waitFor();
    await page.getByRole('button', { name: 'Stop all' }).click();
    await page.getByText('0 of 2 running').waitFor();
    await page.getByRole('button', { name: 'Start all', exact: true }).click();
    await page.getByText('2 of 2 running').waitFor();
    const beginnings = (): Promise<number> => listener(page).getByText(/world! 0'/).count();
    const before = await beginnings();
    await page.getByRole('button', { name: 'Restart all' }).click();
    await listener(page).getByText(/world! 0'/).nth(before).waitFor();
    await page.getByText('2 of 2 running').waitFor();
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing on the running site, ${colorScheme}`, () =>
    onSite({ colorScheme }, async (page) => {
      await listener(page)
        .getByText(/I heard/)
        .first()
        .waitFor();
      await expectAccessible(page);
    }));
}

test('on a phone everything is there, one thing at a time', () =>
  onSite({ viewport: { width: 360, height: 740 } }, async (page) => {
    await listener(page)
      .getByText(/I heard/)
      .first()
      .waitFor();
    await page.getByRole('tab', { name: 'Topics' }).click();
    await page.getByRole('button', { name: /^\/topic/ }).waitFor();
    await page.getByRole('tab', { name: 'Nodes' }).click();
    await page.getByText('2 of 2 running').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360);
  }));

test('the picture of the page', () =>
  onSite({ colorScheme: 'light' }, async (page) => {
    await page.getByRole('button', { name: /^\/topic/ }).click();
    await listener(page)
      .getByText(/world! 9'/)
      .waitFor();
    await page.locator('.tree').waitFor();
    mkdirSync(join(ROOT, 'tests/output'), { recursive: true });
    await page.screenshot({ path: join(ROOT, 'tests/output/page.png') });
    if (process.env['ROS2WASM_BLESS'] === '1') {
      mkdirSync(join(ROOT, 'docs/images'), { recursive: true });
      await page.screenshot({ path: join(ROOT, 'docs/images/page.png') });
    }
  }));
