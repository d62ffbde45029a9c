// A site as an app: it can be installed, opens without a network, and a page that is open goes on as it is when the site is
// packed anew.
import assert from 'node:assert/strict';
import { cpSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, type Page, chromium } from 'playwright-core';
import { wholeChromium } from '../support/chromium.ts';
import { packExample } from '../support/example_site.ts';
import { Scratch, ServedSite } from '../support/served_site.ts';

const WATCHDOG = { timeout: 600_000 };
const scratch = new Scratch();
let browser: Browser;
let site: string;

before(async () => {
  site = await packExample(scratch);
  browser = await chromium.launch(wholeChromium());
}, WATCHDOG);

after(async () => {
  await browser.close();
  scratch[Symbol.dispose]();
});

async function kept(page: Page): Promise<void> {
  await page.waitForFunction(() => document.documentElement.dataset['offline'] === 'kept', null, { timeout: 120_000 });
}

async function heard(page: Page): Promise<void> {
  await page.waitForFunction(() => /I heard: 'Hello, world! \d+'/.test(document.body?.innerText ?? ''), null, { timeout: 120_000 });
}

test('Chromium finds nothing that keeps it from being installed', WATCHDOG, async () => {
  await using server = await ServedSite.start([site, '--port', '0']);
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(server.url);
  await kept(page);
  const tools = await context.newCDPSession(page);
  // It cannot be installed from the windows without a profile of their own that tests have; nothing else is found.
  const { installabilityErrors } = await tools.send('Page.getInstallabilityErrors');
  assert.deepEqual(installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== 'in-incognito'), []);
  const { data, errors } = await tools.send('Page.getAppManifest');
  assert.deepEqual(errors, []);
  const manifest = JSON.parse(data ?? '') as { name: string; start_url: string; display: string; };
  const { title } = JSON.parse(readFileSync(join(site, 'site.json'), 'utf8')) as { title: string; };
  assert.deepEqual([manifest.name, manifest.start_url, manifest.display], [title, './', 'standalone']);
  await context.close();
});

// Guarantee, robust: a site that was opened once opens again without a network
test('without a network it opens again, with panels that were never opened', WATCHDOG, async () => {
  await using server = await ServedSite.start([site, '--port', '0', '--no-isolation']);
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(server.url);
  await kept(page);
  await context.setOffline(true);
  await page.reload();
  await heard(page);
  assert.equal(await page.evaluate(() => crossOriginIsolated), true);
  await page.getByRole('button', { name: 'Open a panel here' }).first().click();
  await page.getByRole('menuitem', { name: 'Graph' }).click();
  await page.locator('#panel-graph svg').first().waitFor({ timeout: 60_000 });
  await context.close();
});

interface SiteJson {
  title: string;
  files: { path: string; sha256: string; }[];
}

// Guarantee, robust: a page that is open goes on with the files that it was opened with when the site is packed anew; the next visit
// has the new ones
test('an open page stays as it is when the site changes, until it is loaded again', WATCHDOG, async () => {
  const folder = join(scratch.path, 'changing');
  cpSync(site, folder, { recursive: true });
  await using server = await ServedSite.start([folder, '--port', '0', '--no-isolation']);
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(server.url);
  await kept(page);
  const before = await page.title();
  // The next version has another title, and its graph is in a file of another name.
  const graph = readdirSync(folder).find((name) => /^graph-.*\.js$/.test(name)) ?? assert.fail('no graph');
  rmSync(join(folder, graph));
  const list = join(folder, 'site.json');
  const json = JSON.parse(readFileSync(list, 'utf8')) as SiteJson;
  json.title = 'The next version';
  json.files = json.files.filter(({ path }) => path !== graph);
  writeFileSync(list, JSON.stringify(json));
  const next = await context.newPage();
  await next.goto(server.url);
  await next.waitForFunction(() => document.title.startsWith('The next version'), null, { timeout: 60_000 });
  await kept(next);
  // Files of the old version that the open page has not asked for yet are still cached, and so is its site.json.
  assert.equal(await page.evaluate(async (file) => (await fetch(file)).status, graph), 200);
  assert.equal(await page.evaluate(async () => ((await (await fetch('site.json')).json()) as SiteJson).title === 'The next version'), false);
  await page.getByRole('button', { name: 'Open a panel here' }).first().click();
  await page.getByRole('menuitem', { name: 'Graph' }).click();
  await page.locator('#panel-graph svg').first().waitFor({ timeout: 60_000 });
  assert.equal(await page.title(), before);
  await page.reload();
  await page.waitForFunction(() => document.title.startsWith('The next version'), null, { timeout: 60_000 });
  await next.close();
  await kept(page);
  // Nobody needs the old file any more.
  assert.equal(await page.evaluate(async (file) => (await fetch(file)).status, graph), 404);
  await context.close();
});

test('a file with other bytes than site.json says is not kept', WATCHDOG, async () => {
  const folder = join(scratch.path, 'forged');
  cpSync(site, folder, { recursive: true });
  writeFileSync(join(folder, 'icon.svg'), '<svg xmlns="http://www.w3.org/2000/svg"/>');
  await using server = await ServedSite.start([folder, '--port', '0', '--no-isolation']);
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(server.url);
  await page.waitForFunction(() => document.documentElement.dataset['offline'] === 'not_kept', null, { timeout: 120_000 });
  const names = await page.evaluate(async () => {
    const [name = ''] = await caches.keys();
    return (await (await caches.open(name)).keys()).map(({ url }) => url);
  });
  assert.ok(names.some((url) => url.includes('node_worker.js')));
  assert.deepEqual(names.filter((url) => url.includes('icon.svg')), []);
  await context.close();
});
