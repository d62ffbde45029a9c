// Python nodes begin with the image of an interpreter: what is a node's own is its own, and where there can be no image,
// or a kept one is broken, they boot.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';
import { eventually } from '../../support/eventually.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { serveFolder } from '../../support/static_server.ts';

const watchdog = { timeout: 240_000 };
const patience = { timeout: 100_000 };
const headless = fileURLToPath(new URL('../../../runtime/site/session/headless.ts', import.meta.url));
let folder = '';
let browser: Browser | undefined;

interface Told {
  readonly image: boolean;
  readonly who: string | null;
  readonly arguments: readonly string[];
  readonly random: readonly [number, string];
  readonly now: number;
  readonly begun: number;
  readonly hash: number;
  readonly array: string;
}

before(async () => {
  const entry = 'lib/chatter_py/fresh';
  folder = makeSite([], {}, {}, {
    nodes: [
      { entry, executable: 'fresh', arguments: ['one'] },
      { entry, executable: 'fresh', arguments: ['two', 'more'], environment: { WHO: 'second' }, numpy: true },
      { entry, executable: 'fresh', environment: { PYTHONHASHSEED: '7' } },
    ],
    packages: ownPackage('chatter_py'),
  });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser?.close();
  if (folder !== '') rmSync(folder, { recursive: true });
});

/** The report that each node printed, by the order of the nodes in the site. */
function toldIn(text: string): (Told | undefined)[] {
  const told = [...text.matchAll(/fresh (\{"image".*?\})/g)].map(([, json = '']) => JSON.parse(json) as Told);
  const first = (fits: (one: Told) => boolean): Told | undefined => told.find(fits);
  return [first((one) => one.arguments[0] === 'one'), first((one) => one.arguments[0] === 'two'), first((one) => one.arguments.length === 0)];
}

/** Checks the reports of a run. `images`: whether the first two nodes began with an image. */
function check(nodes: readonly (Told | undefined)[], images: boolean, since: number): Told[] {
  const [one, two, three] = nodes;
  assert.ok(one !== undefined && two !== undefined && three !== undefined, JSON.stringify(nodes));
  assert.deepEqual([one.image, two.image, three.image], [images, images, false]);
  assert.deepEqual([one.who, two.who, three.who], [null, 'second', null]);
  assert.deepEqual([one.arguments, two.arguments, three.arguments], [['one'], ['two', 'more'], []]);
  // The second has numpy, which no image has.
  assert.deepEqual([one.array, two.array, three.array], ['array', 'ndarray', 'array']);
  assert.equal(new Set([one, two, three].flatMap(({ random }) => random)).size, 6);
  for (const { now, begun } of [one, two, three]) {
    assert.ok(now * 1000 >= since && begun * 1000 >= since - 1, `${now} ${begun} ${since}`);
    assert.ok(now >= begun);
  }
  return [one, two, three];
}

function runHeadless(...more: readonly string[]): (Told | undefined)[] {
  const { status, stdout, stderr } = spawnSync(process.execPath, [headless, folder, ...more], { encoding: 'utf8', timeout: 200_000 });
  assert.equal(status, 0, `${stdout}\n${stderr}`);
  return toldIn(stdout);
}

for (const link of played('shared', 'port')) {
  test(`${link}, Node.js: what is a node's own is no other's`, watchdog, () => {
    const since = Date.now();
    const [, , seeded] = check(runHeadless('--link', link), true, since);
    assert.equal(check(runHeadless('--link', link), true, since)[2]?.hash, seeded?.hash);
  });
}

test('a stepped run has no image, and the same random numbers each time', watchdog, () => {
  const runs = [0, 1].map(() => runHeadless('--stepped', '--seed', '5'));
  const [one, again] = runs.map((nodes) => nodes.map((told) => [told?.image, told?.random, told?.hash]));
  assert.deepEqual(one, again);
  assert.equal(one?.[0]?.[0], false);
});

/** Opens the page and waits until so many nodes have told. */
async function visit(context: BrowserContext, url: string, count = 3): Promise<{ readonly page: Page; readonly nodes: (Told | undefined)[]; }> {
  const page = await context.newPage();
  await page.goto(url);
  await page.waitForFunction((least) => (document.body?.textContent?.match(/fresh \{"image".*?\}/g) ?? []).length >= least, count, patience);
  return { page, nodes: toldIn(await page.evaluate(() => document.body.textContent ?? '')) };
}

/** The bytes of each kept thing. */
function keptSizes(page: Page): Promise<number[]> {
  return page.evaluate(async () => {
    const cache = await caches.open('ros2wasm-kept');
    const found = await Promise.all((await cache.keys()).map(async (key) => (await (await cache.match(key))?.blob())?.size ?? 0));
    return found;
  });
}

for (const [link, isolated] of played(['port', false], ['shared', true])) {
  test(`${link}, Chromium: an image is kept, one that is broken is dropped`, watchdog, async () => {
    assert.ok(browser);
    const host = await serveFolder(folder, { isolated });
    const context = await browser.newContext({ serviceWorkers: 'block' });
    try {
      let since = Date.now();
      const first = await visit(context, host.url);
      check(first.nodes, true, since);
      await eventually('it is kept', async () => (await keptSizes(first.page)).some((size) => size > 1 << 20));
      await first.page.close();
      // As on another day.
      since = Date.now();
      const second = await visit(context, host.url);
      const told = [...check(first.nodes, true, 0), ...check(second.nodes, true, since)];
      assert.equal(new Set(told.flatMap(({ random }) => random)).size, 12);
      await second.page.evaluate(async () => {
        const cache = await caches.open('ros2wasm-kept');
        // As if it had been made so: with its hash.
        const sum = new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode('broken')));
        const hash = Array.from(sum, (byte) => byte.toString(16).padStart(2, '0')).join('');
        for (const key of await cache.keys()) {
          await cache.put(key, new Response('broken'));
          localStorage.setItem(`ros2wasm.kept ${key.url}`, hash);
        }
      });
      await second.page.close();
      const third = await visit(context, host.url);
      check(third.nodes, false, since);
      await eventually('it is dropped', async () => (await keptSizes(third.page)).length === 0);
    } finally {
      await context.close();
      await host.close();
    }
  });
}

test('a node that is alone boots by itself at the first visit, and begins with an image at the next one', watchdog, async () => {
  assert.ok(browser);
  const alone = makeSite([], {}, {}, {
    nodes: [{ entry: 'lib/chatter_py/fresh', executable: 'fresh', arguments: ['one'] }],
    packages: ownPackage('chatter_py'),
  });
  const host = await serveFolder(alone, { isolated: true });
  const context = await browser.newContext({ serviceWorkers: 'block' });
  try {
    const first = await visit(context, host.url, 1);
    assert.equal(first.nodes[0]?.image, false);
    await eventually('it is kept', async () => (await keptSizes(first.page)).some((size) => size > 1 << 20));
    await first.page.close();
    const second = await visit(context, host.url, 1);
    assert.equal(second.nodes[0]?.image, true);
  } finally {
    await context.close();
    await host.close();
    rmSync(alone, { recursive: true });
  }
});
