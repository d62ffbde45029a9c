// The memory that a browser still uses for lines of a node after the page has dropped them: next to nothing. A worker that
// is blocked all the time must not collect anything. And how a console of 100,000 lines scrolls (scroll.ts).
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { inBrowser } from './browser_site.ts';
import { machineLoad } from './machine_load.ts';
import { packLaunch } from './packed_launch.ts';
import { treePrivateKb } from './process_memory.ts';
import type { BenchContext } from './run.ts';
import { benchScroll } from './scroll.ts';

const HZ = 2000;
/** Until then caches and heaps find their size. */
const WARM_UP = 20_000;
const LINES = 80_000;
const MOST_KB_PER_10_000 = 1000;

/** The number in the newest line; the consoles are emptied. */
async function newest(page: Page): Promise<number> {
  const text = await page.evaluate(() => document.body.innerText);
  await page.getByRole('button', { name: /^Clear/ }).first().click();
  return Math.max(0, ...[...text.matchAll(/number (\d+)/g)].map(([, number]) => Number(number)));
}

/** Comes back when the node has logged so many lines; says how many it were, and what memory is used. */
async function after(page: Page, lines: number, pid: number): Promise<readonly [number, number]> {
  let seen = 0;
  while (seen < lines) seen = await newest(page);
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('HeapProfiler.collectGarbage');
  await devtools.detach();
  return [seen, treePrivateKb(pid)];
}

export async function benchLines(context: BenchContext): Promise<void> {
  await benchScroll(context);
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const site = packLaunch(context, folder, ['soak_bench'], 'lines', [
      `{package: soak_bench, executable: pulse, parameters: {bytes: 16, hz: ${HZ}, log: true, report_s: 3600}}`,
    ]);
    await inBrowser(site, async (page, pid, url) => {
      await page.goto(url);
      const [from, before] = await after(page, WARM_UP, pid);
      const [to, now] = await after(page, WARM_UP + LINES, pid);
      const growth = Math.round(((now - before) * 10_000) / (to - from));
      context.emit({
        bench: 'lines',
        what: 'memory of the browser after lines of a node',
        lines: to - from,
        kb_before: before,
        kb_after: now,
        kb_per_10_000_lines: growth,
        machine_load: machineLoad(),
      });
      if (growth > MOST_KB_PER_10_000) context.fail(`lines: the browser grows by ${growth} kB in 10,000 lines, ${MOST_KB_PER_10_000} are the most`);
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
