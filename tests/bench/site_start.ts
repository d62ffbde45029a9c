// From navigation to the first message heard, for example 01 in headless Chromium: cold (new browser, new
// profile) and warm (reload). The talker's own timer period is not counted. The peer is the least a page with
// two workers can do: start both, send one message from one to the other, show it.
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { wholeChromium } from '../e2e/support/chromium.ts';
import { treeMemoryKb } from './process_memory.ts';
import { benchPageLoad } from './page_load.ts';
import type { BenchContext } from './run.ts';
import { packedExample } from './site_bytes.ts';
import { serveFolder } from '../support/static_server.ts';
import { summary } from './statistics.ts';

const TALKER_PERIOD_MS = 500;
const RUNS = 7;
const WATCHDOG_MS = 30_000;

const PEER_FILES: Readonly<Record<string, string>> = {
  'index.html': '<!doctype html><meta charset="utf-8"><title>peer</title><script type="module" src="main.js"></script><p></p>',
  'main.js': `
    const channel = new MessageChannel();
    const [a, b] = [0, 1].map(() => new Worker('worker.js', { type: 'module' }));
    b.onmessage = (event) => { document.querySelector('p').textContent = event.data; };
    a.postMessage('send', [channel.port1]);
    b.postMessage('hear', [channel.port2]);`,
  'worker.js': `
    onmessage = ({ data, ports: [port] }) => {
      if (data === 'send') port.postMessage('Hello, world! 0');
      else port.onmessage = (event) => postMessage("I heard: '" + event.data + "'");
    };`,
};

interface StartTimes {
  readonly cold: number[];
  readonly warm: number[];
  /** Whole browser at the first message, in kB. */
  readonly memoryKb: number[];
}

/** Milliseconds since navigation start at which the page first shows a heard message. */
async function startTimes(url: string): Promise<StartTimes> {
  const times: StartTimes = { cold: [], warm: [], memoryKb: [] };
  for (let run = 0; run < RUNS; run++) {
    const server = await chromium.launchServer(wholeChromium());
    const browser = await chromium.connect(server.wsEndpoint());
    try {
      const page = await browser.newPage();
      await page.addInitScript(() => {
        const seen = (): void => {
          const text = document.body?.textContent ?? '';
          if (!text.includes('I heard:')) return;
          observer.disconnect();
          document.documentElement.dataset['heardAt'] = String(performance.now());
        };
        const observer = new MutationObserver(seen);
        observer.observe(document, { childList: true, subtree: true, characterData: true });
      });
      const heardAt = async (): Promise<number> => {
        await page.waitForFunction(() => document.documentElement.dataset['heardAt'] !== undefined, undefined, {
          timeout: WATCHDOG_MS,
        });
        return Number(await page.evaluate(() => document.documentElement.dataset['heardAt']));
      };
      await page.goto(url, { waitUntil: 'commit' });
      times.cold.push(await heardAt());
      times.memoryKb.push(treeMemoryKb(server.process().pid ?? 0));
      await page.reload({ waitUntil: 'commit' });
      times.warm.push(await heardAt());
    } finally {
      await browser.close();
      await server.close();
    }
  }
  return times;
}

export async function benchStart(context: BenchContext): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const peer = join(folder, 'peer');
    mkdirSync(peer);
    for (const [name, text] of Object.entries(PEER_FILES)) writeFileSync(join(peer, name), text);
    const site = packedExample(context, folder);
    for (const isolated of [true, false]) {
      const servers = { site: await serveFolder(site, { isolated }), peer: await serveFolder(peer, { isolated }) };
      const ours = await startTimes(servers.site.url);
      const theirs = await startTimes(servers.peer.url);
      await Promise.all([servers.site.close(), servers.peer.close()]);
      const less = (values: readonly number[]): number[] => values.map((value) => value - TALKER_PERIOD_MS);
      context.emit({
        bench: 'start',
        example: '01_talker_listener',
        browser: 'chromium',
        headers: isolated ? 'COOP/COEP' : 'none',
        cold_ms: summary(less(ours.cold)),
        warm_ms: summary(less(ours.warm)),
        not_counted: 'talker timer period, 500 ms',
        peer: 'bare page, two workers, one message',
        peer_cold_ms: summary(theirs.cold),
        peer_warm_ms: summary(theirs.warm),
        browser_memory_kb: summary(ours.memoryKb).median,
        peer_memory_kb: summary(theirs.memoryKb).median,
      });
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  await benchPageLoad(context);
}
