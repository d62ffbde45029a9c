// Sites of one origin share the browser's storage. A site whose nodes or whose page are hostile does not become another
// site: not one that was never visited, nor one that was, with a network and without, now or at later visits.
//
// Guarantee, hostile input: a program in a site reaches no storage, service worker or open page of other sites of its origin, in whatever language, on both links
//
// Guarantee, hostile input: what another page of the origin writes into the cache of a site is never run while there is a network: bytes are hashed when they are taken out

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, type BrowserContext, type Page, chromium } from 'playwright-core';
import { taken } from '../../../runtime/site/workers/worker_realm.ts';
import { eventually } from '../../support/eventually.ts';
import { Firefox } from '../../support/firefox.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
const patience = { timeout: 100_000 };
const host = mkdtempSync(join(tmpdir(), 'ros2wasm-origin-'));
const python = makeSite([], {}, {}, {
  nodes: [{ entry: 'lib/chatter_py/reaches', executable: 'reaches', arguments: ['start.js'] }],
  packages: ownPackage('chatter_py'),
});
let browser: Browser;

before(async () => {
  const programs = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }, { program: 'threads.cpp', threads: true }]);
  cpSync(programs, join(host, 'victim'), { recursive: true });
  cpSync(python, join(host, 'nodes'), { recursive: true });
  rmSync(programs, { recursive: true });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser.close();
  rmSync(host, { recursive: true });
  rmSync(python, { recursive: true });
});

interface Reached {
  readonly scope: readonly string[];
  readonly navigator: readonly string[];
  readonly script: string;
  readonly code: string;
  readonly order: string;
  readonly worker: string;
  readonly cache: string;
}

/** Names of doors that a browser may add one day: what they lead to has to be looked at, and they be taken or listed here. */
const doorNames =
  /cache|storage|idb|indexed|lock|worker$|channel|socket|transport|eventsource|rtc(?!p|enc|t)|filesystem|bucket|usb|serial|hid|broadcast|realm|cookie/i;
/** `MessageChannel` leads to who has the other port; the others are values and have no way to make what they are of. */
const harmless = /^(MessageChannel|AbortController)$|(Event|Error|Result|Packet|Stream|Interface|Configuration|Endpoint|Transformer)$/;

function assertNothing({ scope, navigator }: Pick<Reached, 'scope' | 'navigator'>): void {
  assert.ok(scope.includes('postMessage') && navigator.includes('hardwareConcurrency'), 'the names are those of a worker');
  for (const { scope: ofScope = [], navigator: ofNavigator = [] } of taken) {
    assert.deepEqual(scope.filter((name) => ofScope.includes(name)), []);
    assert.deepEqual(navigator.filter((name) => ofNavigator.includes(name)), []);
  }
  const doors = [...scope, ...navigator].filter((name) => doorNames.test(name) && !harmless.test(name));
  assert.deepEqual(doors, []);
  const named = ['caches', 'indexedDB', 'Worker', 'SharedWorker', 'BroadcastChannel', 'WebTransport', 'EventSource', 'WebSocket'];
  assert.deepEqual(scope.filter((name) => named.includes(name)), []);
  assert.deepEqual(navigator.filter((name) => ['storage', 'locks', 'serviceWorker', 'storageBuckets'].includes(name)), []);
}

/** `text`: a page with the output of the node that tried. */
function assertReachesNothing(text: string): void {
  const reached = JSON.parse(/reaches (\{.*?\})/.exec(text)?.[1] ?? '') as Reached;
  assertNothing(reached);
  const { script, code, order, worker, cache } = reached;
  assert.deepEqual({ script, code, worker, cache }, { script: 'JsException', code: 'JsException', worker: 'AttributeError', cache: 'AttributeError' });
  assert.notEqual(order, 'done', 'the worker has no handler any more that an order could be given to');
}

for (const [link, isolated] of played(['shared', true], ['port', false])) {
  test(`Firefox, ${link}: no node's worker has what leads to other sites`, watchdog, async () => {
    const server = await serveFolder(host, { isolated });
    const firefox = await Firefox.launch({ serviceWorkers: false });
    try {
      await firefox.goto(`${server.url}nodes/`);
      await firefox.seen(/reaches \{[^]*\}/, patience.timeout);
      assertReachesNothing(String(await firefox.evaluate('document.body.textContent')));
    } finally {
      await firefox.close();
      await server.close();
    }
  });
}

for (const [link, isolated] of [['shared', true], ['port', false]] as const) {
  test(`${link}: no node's worker has what leads to other sites`, watchdog, async () => {
    const server = await serveFolder(host, { isolated });
    const context = await browser.newContext({ serviceWorkers: 'block' });
    try {
      const page = await context.newPage();
      await page.goto(`${server.url}nodes/`);
      await page.waitForFunction(() => /reaches \{.*\}/.test(document.body?.textContent ?? ''), null, patience);
      const text = await page.evaluate(() => document.body.textContent ?? '');
      assertReachesNothing(text);
      if (isolated) return;
      // Programs of C++ and threads; on the shared link they sleep where no debugger wakes them, in the same worker.
      await page.goto(`${server.url}victim/`);
      await page.waitForFunction(() => /heard/i.test(document.body?.textContent ?? ''), null, patience);
      assert.ok(page.workers().length >= 2);
      for (const each of page.workers()) {
        const names = await each.evaluate(() => {
          const all = (place: object): string[] => {
            const found = new Set<string>();
            for (let at: object | null = place; at !== null; at = Object.getPrototypeOf(at) as object | null) {
              for (const name of Object.getOwnPropertyNames(at)) found.add(name);
            }
            return [...found].sort();
          };
          return { scope: all(globalThis), navigator: all(navigator) };
        });
        assertNothing(names);
      }
    } finally {
      await context.close();
      await server.close();
    }
  });
}

const sha256 = (text: string | Buffer): string => createHash('sha256').update(text).digest('hex');

/** A page that plants its own script under every name that the victim's service worker looks for. */
function hostilePage(): void {
  const folder = join(host, 'evil');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'index.html'), '<!doctype html><title>evil</title><script src="evil.js"></script>');
  writeFileSync(join(folder, 'evil.js'), `(async () => {
    const own = "document.title = 'OWNED'; localStorage.owned = Number(localStorage.owned ?? 0) + 1;";
    const page = '<!doctype html><title>OWNED</title>';
    const victim = new URL('../victim/', location.href);
    const text = await (await fetch(new URL('site.json', victim))).text();
    const site = JSON.parse(text);
    const cache = await caches.open('ros2wasm ' + victim.href);
    const typed = (body, type) => new Response(body, { headers: { 'content-type': type } });
    for (const { path, sha256 } of site.files) {
      const url = new URL(path, victim).href + '?sha256=' + sha256;
      if (path.endsWith('.js')) await cache.put(url, typed(own, 'text/javascript'));
      if (path.endsWith('.html')) await cache.put(url, typed(page, 'text/html'));
    }
    const hash = async (body) => Array.from(new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(body))), (b) => b.toString(16).padStart(2, '0')).join('');
    const files = [];
    for (const file of site.files) {
      const body = file.path.endsWith('.js') ? own : file.path.endsWith('.html') ? page : undefined;
      files.push(body === undefined ? file : { ...file, sha256: await hash(body) });
      if (body !== undefined) await cache.put(new URL(file.path, victim).href + '?sha256=' + await hash(body), typed(body, file.path.endsWith('.js') ? 'text/javascript' : 'text/html'));
    }
    const list = JSON.stringify({ ...site, files });
    for (const key of await cache.keys()) if (key.url.includes('site.json')) await cache.put(key, typed(list, 'application/json'));
    await cache.put(new URL('site.json', victim).href, typed(list, 'application/json'));
    const images = await caches.open('ros2wasm-kept');
    for (const key of await images.keys()) await images.put(key, new Response(own));
    document.title = 'planted';
  })().catch((error) => { document.title = String(error); });`);
}

interface Visit {
  readonly page: Page;
  readonly title: string;
}

/** Until messages are heard. */
async function visit(context: BrowserContext, url: string): Promise<Visit> {
  const page = await context.newPage();
  await page.goto(url);
  await page.waitForFunction(() => /OWNED/.test(document.title) || /heard/i.test(document.body?.textContent ?? ''), null, patience);
  return { page, title: await page.title() };
}

async function offlineReady(page: Page): Promise<void> {
  await page.waitForFunction(() => document.documentElement.dataset['offline'] === 'kept', null, patience);
}

async function assertOwn(context: BrowserContext, url: string): Promise<Page> {
  const { page, title } = await visit(context, url);
  assert.doesNotMatch(title, /OWNED/);
  assert.equal(await page.evaluate(() => localStorage.getItem('owned')), null);
  return page;
}

async function attack(context: BrowserContext, url: string): Promise<void> {
  const page = await context.newPage();
  await page.goto(`${url}evil/`);
  await page.waitForFunction(() => document.title !== 'evil', null, patience);
  assert.equal(await page.title(), 'planted');
  await page.close();
}

async function withHost(run: (context: BrowserContext, server: StaticServer) => Promise<void>): Promise<void> {
  hostilePage();
  const server = await serveFolder(host);
  const context = await browser.newContext();
  try {
    await run(context, server);
  } finally {
    await context.close();
    await server.close();
  }
}

test('a hostile page, then the victim for the first time and again', watchdog, async () => {
  await withHost(async (context, { url }) => {
    await attack(context, url);
    for (let i = 0; i < 3; i += 1) {
      const page = await assertOwn(context, `${url}victim/`);
      assert.equal(await page.evaluate(() => crossOriginIsolated), true);
      await page.close();
    }
  });
});

test('the victim, then a hostile page beside it, and later visits', watchdog, async () => {
  await withHost(async (context, server) => {
    const first = await assertOwn(context, `${server.url}victim/`);
    await offlineReady(first);
    await attack(context, server.url);
    // Files that the page loads later are those of its host, too.
    const script = JSON.parse(readFileSync(join(host, 'victim/site.json'), 'utf8')) as { files: { path: string; sha256: string; }[]; };
    const later = script.files.filter(({ path }) => path.endsWith('.js'));
    for (const { path, sha256: hash } of later.slice(0, 8)) {
      const text = await first.evaluate(async (name) => (await fetch(name)).text(), path);
      assert.equal(sha256(text), hash, path);
    }
    await first.close();
    for (let i = 0; i < 2; i += 1) {
      await attack(context, server.url);
      const page = await assertOwn(context, `${server.url}victim/`);
      await page.close();
    }
  });
});

test('a hostile node, then the victim without a network: as it was packed', watchdog, async () => {
  await withHost(async (context, server) => {
    const first = await assertOwn(context, `${server.url}victim/`);
    await offlineReady(first);
    await first.close();
    const page = await context.newPage();
    await page.goto(`${server.url}nodes/`);
    await page.waitForFunction(() => /reaches \{.*\}/.test(document.body?.textContent ?? ''), null, patience);
    await page.close();
    await context.setOffline(true);
    await server.close();
    for (let i = 0; i < 2; i += 1) await (await assertOwn(context, `${server.url}victim/`)).close();
  });
});

/** Whether the node of that visit began with an image. */
async function imageOf(context: BrowserContext, url: string, meanwhile: (page: Page) => Promise<void>): Promise<boolean> {
  const page = await context.newPage();
  await page.goto(`${url}nodes/`);
  await page.waitForFunction(() => /reaches \{.*\}/.test(document.body?.textContent ?? ''), null, patience);
  const text = await page.evaluate(() => document.body.textContent ?? '');
  await meanwhile(page);
  await page.close();
  return (JSON.parse(/reaches (\{.*?\})/.exec(text)?.[1] ?? '') as { image: boolean; }).image;
}

async function imageIsKept(page: Page): Promise<void> {
  await eventually('an image is kept', () =>
    page.evaluate(async () => {
      const cache = await caches.open('ros2wasm-kept');
      const found = await Promise.all((await cache.keys()).map(async (key) => (await (await cache.match(key))?.blob())?.size ?? 0));
      return found.some((size) => size > 1 << 20) && Object.keys(localStorage).some((key) => key.startsWith('ros2wasm.kept '));
    }));
}

/** One bit of each image, near its end: what reads images cannot notice it. */
async function changeImages(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const cache = await caches.open('ros2wasm-kept');
    for (const key of await cache.keys()) {
      const bytes = new Uint8Array(await (await cache.match(key))!.arrayBuffer());
      bytes[bytes.length - 5]! ^= 1;
      await cache.put(key, new Response(bytes));
    }
  });
}

test("an interpreter's image that somebody has changed in the cache is not begun with", watchdog, async () => {
  await withHost(async (context, { url }) => {
    assert.equal(await imageOf(context, url, imageIsKept), false);
    assert.equal(await imageOf(context, url, changeImages), true);
    // It boots, and a new image is made for the next visit.
    assert.equal(await imageOf(context, url, imageIsKept), false);
    assert.equal(await imageOf(context, url, async () => undefined), true);
  });
});
