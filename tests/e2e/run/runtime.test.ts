// The runtime in Chromium: both links, hosts with and without headers, offline, and what the policy forbids.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, afterEach, before, test } from 'node:test';
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';

const watchdog = { timeout: 240_000 };

// A worker that tells what it may not do.
const probe = `
  const tell = async () => {
    const out = {};
    try { eval('1'); out.eval = 'allowed'; } catch (error) { out.eval = error.name; }
    try { await fetch('FOREIGN', { mode: 'no-cors' }); out.fetch = 'allowed'; } catch (error) { out.fetch = error.name; }
    postMessage(out);
  };
  tell();
`;

let browser: Browser | undefined;
let foreign: StaticServer;
let folder = '';
const contexts: BrowserContext[] = [];

before(async () => {
  foreign = await serveFolder('/nowhere');
  folder = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }], { 'probe.js': probe.replace('FOREIGN', foreign.url) });
  browser = await chromium.launch(chromiumOptions());
});

// The pages of one test run no longer while the next one goes on.
afterEach(async () => {
  for (const context of contexts.splice(0)) await context.close();
});

after(async () => {
  await browser?.close();
  await foreign.close();
  if (folder !== '') rmSync(folder, { recursive: true });
});

async function open(options: Parameters<Browser['newContext']>[0] = {}): Promise<Page> {
  assert.ok(browser);
  const context = await browser.newContext(options);
  contexts.push(context);
  return context.newPage();
}

async function heard(page: Page): Promise<void> {
  await page.waitForFunction(() => (document.body?.textContent ?? '').includes('I heard: [Hello World'), null, { timeout: 120_000 });
}

/** Runs the probe as a worker from the site's URL, or from a blob: URL as nodes are started. */
function probeWorker(page: Page, way: 'url' | 'blob'): Promise<unknown> {
  return page.evaluate(async (how) => {
    const url = how === 'url' ? 'probe.js' : URL.createObjectURL(await (await fetch('probe.js')).blob());
    return new Promise((resolve, reject) => {
      const worker = new Worker(url);
      worker.onmessage = (event) => resolve(event.data);
      worker.onerror = (event) => reject(new Error(event.message));
    });
  }, way);
}

const refused = { eval: 'EvalError', fetch: 'TypeError' };

// Guarantee, hostile input: a page loads nothing from another host
test('a host with the headers: shared memory, and nothing from elsewhere', watchdog, async () => {
  const host = await serveFolder(folder, { isolated: true });
  try {
    const page = await open();
    const outside: string[] = [];
    page.on('request', (request) => {
      const { href, protocol } = new URL(request.url());
      if (!href.startsWith(host.url) && protocol !== 'blob:') outside.push(href);
    });
    await page.goto(host.url);
    await heard(page);
    assert.equal(await page.evaluate(() => crossOriginIsolated), true);
    assert.match(await page.textContent('body') ?? '', /Shared memory/);
    assert.deepEqual(outside, []);
    assert.deepEqual(host.requests.filter((path) => path.endsWith('.names')), [], 'names are for crash reports');
    assert.deepEqual(await probeWorker(page, 'blob'), refused);
  } finally {
    await host.close();
  }
});

// Guarantee, hostile input: the Content-Security-Policy holds in workers too on a host that sends
// no headers
test('a host without headers: the service worker adds them, and the policy to worker scripts too', watchdog, async () => {
  const host = await serveFolder(folder);
  try {
    const page = await open();
    await page.goto(host.url);
    await heard(page);
    assert.equal(await page.evaluate(() => crossOriginIsolated), true);
    assert.deepEqual(await probeWorker(page, 'url'), refused);
    assert.deepEqual(await probeWorker(page, 'blob'), refused);
    assert.ok(!foreign.requests.some((path) => path.startsWith('/some')), 'the foreign host heard nothing');
  } finally {
    await host.close();
  }
});

// Guarantee, robust: a site works offline after the first visit
test('offline after the first visit', watchdog, async () => {
  const host = await serveFolder(folder);
  const page = await open();
  await page.goto(host.url);
  await heard(page);
  await page.waitForFunction(() => document.documentElement.dataset['offline'] === 'kept', null, { timeout: 120_000 });
  assert.ok(!host.requests.some((path) => path.endsWith('.names')), 'nor are names kept before they are needed');
  await host.close();
  await page.goto(host.url);
  await heard(page);
  assert.equal(await page.evaluate(() => crossOriginIsolated), true);
});

test('a site of which a file does not come is not said to be kept', watchdog, async () => {
  const host = await serveFolder(folder, { broken: /probe\.js$/ });
  try {
    const page = await open();
    await page.goto(host.url);
    await page.waitForFunction(() => document.documentElement.dataset['offline'] !== undefined, null, { timeout: 120_000 });
    assert.equal(await page.evaluate(() => document.documentElement.dataset['offline']), 'not_kept');
  } finally {
    await host.close();
  }
});

test('a page in which no service worker is installed tells that it is not kept', watchdog, async () => {
  const host = await serveFolder(folder, { isolated: true });
  try {
    const page = await open({ serviceWorkers: 'block' });
    await page.goto(host.url);
    await page.waitForFunction(() => document.documentElement.dataset['offline'] === 'not_kept', null, { timeout: 120_000 });
  } finally {
    await host.close();
  }
});

// Guarantee, robust: the next visit shows a new version of a site, whatever the browser may keep
test('a new version of the site is what the next visit shows, whatever the browser may keep', watchdog, async () => {
  const changing = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }]);
  const host = await serveFolder(changing, { maxAge: 3600 });
  try {
    const page = await open();
    await page.goto(host.url);
    await heard(page);
    await page.waitForFunction(() => document.documentElement.dataset['offline'] === 'kept', null, { timeout: 120_000 });
    // Another program under the name of the old one.
    const next = makeSite([{ program: 'echo.c' }]);
    const programs = join(next, 'programs');
    for (const file of readdirSync(programs)) renameSync(join(programs, file), join(programs, file.replace('echo', 'talker')));
    const manifest = join(next, 'site.json');
    writeFileSync(manifest, readFileSync(manifest, 'utf8').replaceAll('programs/echo', 'programs/talker'));
    rmSync(changing, { recursive: true });
    renameSync(next, changing);
    await page.reload();
    await page.waitForFunction(() => (document.body?.textContent ?? '').includes('COLOUR=red'), null, { timeout: 120_000 });
  } finally {
    await host.close();
    rmSync(changing, { recursive: true });
  }
});

// Guarantee, verified: the page runs only programs with the bytes that `site.json` lists
test('a program that was changed on the host is refused, and the others run', watchdog, async () => {
  const changed = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }, { program: 'echo.c' }]);
  const program = join(changed, 'programs/echo.wasm');
  // A module all the same: one more custom section.
  writeFileSync(program, Buffer.concat([readFileSync(program), Buffer.from([0, 2, 1, 120])]));
  // Each link: where there is no service worker, the page itself is the last that looks.
  for (const serviceWorkers of ['allow', 'block'] as const) {
    const host = await serveFolder(changed);
    try {
      const page = await open({ serviceWorkers });
      await page.goto(host.url);
      await heard(page);
      await page.waitForFunction(() => (document.body?.textContent ?? '').includes('programs/echo.wasm is not the file'), null, { timeout: 120_000 });
      assert.match(await page.textContent('body') ?? '', /R2W0724/);
      assert.doesNotMatch(await page.textContent('body') ?? '', /COLOUR=red/);
    } finally {
      await host.close();
    }
  }
  rmSync(changed, { recursive: true });
});

test("where no service worker can run, an old program in the browser's cache is not run with a new site", watchdog, async () => {
  const changing = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }]);
  const host = await serveFolder(changing, { maxAge: 3600 });
  try {
    const page = await open({ serviceWorkers: 'block' });
    await page.goto(host.url);
    await heard(page);
    const next = makeSite([{ program: 'echo.c' }]);
    const programs = join(next, 'programs');
    for (const file of readdirSync(programs)) renameSync(join(programs, file), join(programs, file.replace('echo', 'talker')));
    const manifest = join(next, 'site.json');
    writeFileSync(manifest, readFileSync(manifest, 'utf8').replaceAll('programs/echo', 'programs/talker'));
    rmSync(changing, { recursive: true });
    renameSync(next, changing);
    // As a host that lets programs be kept, but not the list of files.
    await page.route('**/site.json', async (route) => {
      await route.fulfill({ body: readFileSync(join(changing, 'site.json'), 'utf8'), contentType: 'application/json' });
    });
    await page.reload();
    await page.waitForFunction(() => (document.body?.textContent ?? '').includes('COLOUR=red'), null, { timeout: 120_000 });
  } finally {
    await host.close();
    rmSync(changing, { recursive: true });
  }
});

// Guarantee, hostile input: where no service worker can run, node code cannot reach another host
test('where no service worker can run: ports, and the policy holds in workers all the same', watchdog, async () => {
  const host = await serveFolder(folder);
  try {
    const page = await open({ serviceWorkers: 'block' });
    await page.goto(host.url);
    await heard(page);
    assert.equal(await page.evaluate(() => crossOriginIsolated), false);
    assert.match(await page.textContent('body') ?? '', /Message ports/);
    assert.deepEqual(await probeWorker(page, 'blob'), refused);
    const node = page.workers().find((worker) => worker.url().startsWith('blob:'));
    assert.ok(node !== undefined, 'a node worker');
    const answer = await node.evaluate(async (url) => {
      const out = { eval: 'allowed', fetch: 'allowed' };
      try {
        new Function('return 1')();
      } catch (error) {
        out.eval = (error as Error).name;
      }
      try {
        await fetch(url, { mode: 'no-cors' });
      } catch (error) {
        out.fetch = (error as Error).name;
      }
      return out;
    }, foreign.url);
    assert.equal(answer.fetch, 'TypeError');
  } finally {
    await host.close();
  }
});

test('a crash report names the functions, whose names come only then', watchdog, async () => {
  const crashing = makeSite([{ program: 'talker.c' }, { program: 'traps.c' }]);
  const host = await serveFolder(crashing, { isolated: true });
  try {
    const page = await open();
    await page.goto(host.url);
    await page.getByText(/at ratio \(0x[0-9a-f]+\)/).first().waitFor();
    assert.deepEqual(host.requests.filter((path) => path.endsWith('.names')), ['/some/path/programs/traps.names']);
  } finally {
    await host.close();
    rmSync(crashing, { recursive: true });
  }
});

test("the author's theme is shown, and the visitor's choice wins over it", watchdog, async () => {
  const ground = (page: Page): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const seen: Record<string, string> = {};
  for (const [theme, colorScheme] of [['dark', 'light'], ['light', 'dark'], ['auto', 'dark'], ['auto', 'light']] as const) {
    const site = makeSite([{ program: 'talker.c' }], {}, { theme });
    const host = await serveFolder(site, { isolated: true });
    try {
      const page = await open({ colorScheme });
      await page.goto(host.url);
      await page.getByRole('button', { name: /^Theme: / }).waitFor();
      seen[`${theme} on ${colorScheme}`] = await ground(page);
      if (theme !== 'dark') continue;
      await page.getByRole('button', { name: /^Theme: dark/ }).click();
      await page.reload();
      await page.getByRole('button', { name: /^Theme: as the system/ }).waitFor();
      seen['the visitor on light'] = await ground(page);
    } finally {
      await host.close();
      rmSync(site, { recursive: true });
    }
  }
  const dark = seen['auto on dark'];
  const light = seen['auto on light'];
  assert.notEqual(dark, light);
  assert.deepEqual(seen, {
    'dark on light': dark,
    'the visitor on light': light,
    'light on dark': light,
    'auto on dark': dark,
    'auto on light': light,
  });
});

test('a browser that can neither share memory nor suspend is told so', watchdog, async () => {
  const host = await serveFolder(folder, { isolated: true });
  try {
    const page = await open();
    await page.addInitScript(() => {
      Reflect.deleteProperty(globalThis, 'SharedArrayBuffer');
      Reflect.deleteProperty(WebAssembly, 'Suspending');
    });
    await page.goto(host.url);
    await page.getByText('error[R2W0705]').waitFor();
    await page.getByText('open the page in a tab of its own, in a current browser').waitFor();
  } finally {
    await host.close();
  }
});

test('in a frame of a foreign page the port link runs', watchdog, async () => {
  const host = await serveFolder(folder);
  try {
    const page = await open();
    await page.setContent(`<iframe src="${host.url}" width="900" height="700"></iframe>`);
    const frame = page.frameLocator('iframe');
    await frame.getByText('I heard: [Hello World').first().waitFor({ timeout: 120_000 });
  } finally {
    await host.close();
  }
});
