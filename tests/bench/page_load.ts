// How long a visitor of example 03 waits, measured as by Lighthouse: requests, bytes, first and largest contentful paint, time to
// interactive (the end of the last long task before the first 500 ms without one, after the first paint), total blocking
// time in between, and how soon a button acts after that; cold (new profile) and warm (reload), with the processor as it
// is and slowed down four times. The peer is the limit: a bare page that fetches as many files of the same sizes.
import { mkdirSync, mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import type { Browser, Page } from 'playwright-core';
import { wholeChromium } from '../e2e/support/chromium.ts';
import type { StaticServer } from '../support/static_server.ts';
import { serveFolder } from '../support/static_server.ts';
import { interactive, type Load, QUIET_MS, type Task } from './quiet_time.ts';
import type { BenchContext } from './run.ts';
import { packedExample } from './site_bytes.ts';
import { summary } from './statistics.ts';

const EXAMPLE = '03_turtlesim';
const RUNS = 5;
const WATCHDOG_MS = 60_000;
/** After everything is there: what comes late is seen too. */
const REST_MS = 2 * QUIET_MS;
const AT = '/some/path/';

const FIGURES = ['fcp_ms', 'lcp_ms', 'tti_ms', 'tbt_ms', 'ready_ms', 'button_ms', 'requests', 'bytes'] as const;
type Figures = Record<(typeof FIGURES)[number], number>;

interface Kind {
  readonly server: StaticServer;
  readonly folder: string;
  /** The selector of the element that shows that everything is there. */
  readonly ready: string;
  /** Words of a button that acts: then it looks different. */
  readonly button: string;
}

declare global {
  // Set in the measured page.
  var load: { firstPaint: number; largestPaint: number; tasks: Task[]; };
}

async function watched(browser: Browser, slower: number): Promise<Page> {
  const page = await (await browser.newContext()).newPage();
  page.setDefaultTimeout(WATCHDOG_MS);
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('Emulation.setCPUThrottlingRate', { rate: slower });
  await page.addInitScript(() => {
    globalThis.load = { firstPaint: NaN, largestPaint: NaN, tasks: [] };
    const watch = (type: string, take: (entry: PerformanceEntry) => void): void =>
      new PerformanceObserver((list) => list.getEntries().forEach(take)).observe({ type, buffered: true });
    watch('paint', ({ name, startTime }) => {
      if (name === 'first-contentful-paint') globalThis.load.firstPaint = startTime;
    });
    watch('largest-contentful-paint', ({ startTime }) => {
      globalThis.load.largestPaint = startTime;
    });
    watch('longtask', ({ startTime, duration }) => globalThis.load.tasks.push({ start: startTime, end: startTime + duration }));
  });
  return page;
}

async function figuresOf(page: Page, { server, folder, ready, button }: Kind, go: () => Promise<unknown>): Promise<Figures> {
  const before = server.requests.length;
  await go();
  await page.waitForSelector(ready);
  const readyAt = await page.evaluate(() => performance.now());
  // The copy for when there is no network comes later.
  const asked = server.requests.slice(before).filter((path) => path.startsWith(AT));
  await page.waitForTimeout(REST_MS);
  const load: Load = await page.evaluate(() => globalThis.load);
  const acted = await page.evaluate(async (words) => {
    const element = [...document.querySelectorAll('button')]
      .find((each) => each.textContent.trim() === words || each.getAttribute('aria-label') === words);
    if (element === undefined || element.disabled) throw new Error(`nothing to press: ${words}`);
    const looks = (): string => `${String(element.isConnected)} ${element.outerHTML}`;
    const [start, before] = [performance.now(), looks()];
    element.click();
    // Until another picture is due that shows it.
    do await new Promise((resolve) => requestAnimationFrame(resolve)); while (looks() === before);
    return performance.now() - start;
  }, button);
  const { at, blocked } = interactive(load);
  return {
    fcp_ms: load.firstPaint,
    lcp_ms: load.largestPaint,
    tti_ms: at,
    tbt_ms: blocked,
    ready_ms: readyAt,
    button_ms: acted,
    requests: asked.length,
    bytes: asked.reduce((sum, path) => sum + sizeOf(folder, path), 0),
  };
}

function sizeOf(folder: string, path: string): number {
  const file = join(folder, path.slice(AT.length), path.endsWith('/') ? 'index.html' : '');
  return statSync(file, { throwIfNoEntry: false })?.size ?? 0;
}

async function measured(kind: Kind, slower: number): Promise<{ readonly cold: Figures[]; readonly warm: Figures[]; }> {
  const [cold, warm]: [Figures[], Figures[]] = [[], []];
  for (let run = 0; run < RUNS; run += 1) {
    const browser = await chromium.launch(wholeChromium());
    try {
      const page = await watched(browser, slower);
      cold.push(await figuresOf(page, kind, () => page.goto(kind.server.url, { waitUntil: 'commit' })));
      warm.push(await figuresOf(page, kind, () => page.reload({ waitUntil: 'commit' })));
    } finally {
      await browser.close();
    }
  }
  return { cold, warm };
}

function told(all: readonly Figures[]): Readonly<Record<string, unknown>> {
  return Object.fromEntries(FIGURES.map((name) => [name, summary(all.map((each) => each[name]))]));
}

/** As many files of the same sizes, fetched at once by a page that does nothing else. */
function writePeer(folder: string, sizes: readonly number[]): void {
  mkdirSync(folder);
  for (const [index, size] of sizes.entries()) writeFileSync(join(folder, `${index}.bin`), Buffer.alloc(size, index % 251));
  writeFileSync(join(folder, 'index.html'), `<!doctype html><meta charset="utf-8"><title>peer</title><h1>A page</h1><button>Press</button>
<script type="module">
  document.querySelector('button').onclick = (event) => { event.target.textContent = 'Pressed'; };
  await Promise.all(Array.from({ length: ${sizes.length} }, async (_, i) => (await fetch(i + '.bin')).arrayBuffer()));
  document.body.className = 'there';
</script>`);
}

async function firstSizes(site: Kind): Promise<readonly number[]> {
  const browser = await chromium.launch(wholeChromium());
  try {
    const page = await watched(browser, 1);
    const before = site.server.requests.length;
    await page.goto(site.server.url, { waitUntil: 'commit' });
    await page.waitForSelector(site.ready);
    return site.server.requests.slice(before).filter((path) => path.startsWith(AT)).map((path) => sizeOf(site.folder, path));
  } finally {
    await browser.close();
  }
}

export async function benchPageLoad(context: BenchContext): Promise<void> {
  const root = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const folder = packedExample(context, root, EXAMPLE);
    const site: Kind = {
      folder,
      server: await serveFolder(folder, { isolated: true }),
      ready: '.turtle-keys',
      button: 'Stop all',
    };
    const bare = join(root, 'peer');
    writePeer(bare, await firstSizes(site));
    const peer: Kind = { folder: bare, server: await serveFolder(bare, { isolated: true }), ready: 'body.there', button: 'Press' };
    for (const slower of [1, 4]) {
      const [ours, theirs] = [await measured(site, slower), await measured(peer, slower)];
      for (const state of ['cold', 'warm'] as const) {
        context.emit({
          bench: 'start',
          what: 'page load',
          example: EXAMPLE,
          browser: 'chromium',
          state,
          cpu_slower: slower,
          ...told(ours[state]),
          peer: 'bare page, the same files in number and size',
          peer_figures: told(theirs[state]),
        });
      }
    }
    await Promise.all([site.server.close(), peer.server.close()]);
  } finally {
    rmSync(root, { recursive: true, force: true });
  }
}
