// How a console and the log of 100,000 lines scroll: the gaps between the frames while the wheel turns, up and down the whole of it.
// Beside it, in the same browser, a page that only asks for frames, and a plain list of the same lines that the browser
// scrolls by itself.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium, type Page } from 'playwright-core';
import { wholeChromium } from '../e2e/support/chromium.ts';
import { buildFakePage } from '../e2e/support/page_site.ts';
import { serveFolder } from '../support/static_server.ts';
import type { FakeSession } from '../unit/ui/fake_session.ts';
import { AIM_MS, frameFigures, type FrameFigures, gaps } from './frame_gaps.ts';
import { machineLoad } from './machine_load.ts';
import type { BenchContext } from './run.ts';

const LINES = 100_000;
const MS = 6000;
/** Pixels that a fast wheel moves in a frame; each JUMP_EVERY frames it jumps to another place, as with the scroll bar. */
const STEP_PX = 240;
const JUMP_EVERY = 60;

const met = (figures: FrameFigures): boolean => figures.under_20_ms >= 0.95;

/** Scrolls the box with each frame while the gaps are measured. */
async function scrolled(page: Page, box: string): Promise<FrameFigures> {
  await page.evaluate(([selector, step, every]) => {
    const element = document.querySelector(selector as string)!;
    let count = 0;
    const move = (): void => {
      count += 1;
      const room = element.scrollHeight - element.clientHeight;
      // Places that are spread over the whole, the same in each run.
      if (count % (every as number) === 0) element.scrollTop = Math.round(room * ((count * 0.618) % 1));
      else element.scrollTop += count % 600 < 300 ? -(step as number) : step as number;
      requestAnimationFrame(move);
    };
    requestAnimationFrame(move);
  }, [box, STEP_PX, JUMP_EVERY] as const);
  return frameFigures(await gaps(page, MS));
}

export async function benchScroll(context: BenchContext): Promise<void> {
  const folder = await buildFakePage(mkdtempSync(join(tmpdir(), 'ros2wasm-bench-')));
  const host = await serveFolder(folder);
  const browser = await chromium.launch(wholeChromium());
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    await page.goto('about:blank');
    const limit = frameFigures(await gaps(page, MS));
    await page.evaluate((count) => {
      const box = document.createElement('pre');
      box.style.cssText = 'height: 700px; overflow: auto';
      box.textContent = Array.from({ length: count }, (_, i) => `[INFO] [1700000000.000000000] [talker]: Publishing: 'Hello, world! ${i}'`).join('\n');
      document.body.append(box);
    }, LINES);
    const plain = await scrolled(page, 'pre');

    const judge = async (what: string): Promise<void> => {
      const ours = await scrolled(page, '.lines');
      context.emit({
        bench: 'lines',
        what: `frames while ${what} scrolls`,
        lines: LINES,
        step_px: STEP_PX,
        drawn_lines: await page.locator('.line').count(),
        ...ours,
        aim_ms: AIM_MS,
        plain_list: plain,
        bare_page: limit,
        machine_load: machineLoad(),
      });
      if (met(ours)) return;
      const said = `lines: ${ours.under_20_ms * 100} % of the frames are under ${AIM_MS} ms while ${LINES} lines of ${what} scroll, 95 % are the least`;
      if (met(limit)) context.fail(said);
      else console.error(`${said}; not judged: of a page that shows nothing it is ${limit.under_20_ms * 100} %`);
    };
    await page.goto(`${host.url}?scene=signals#layout=${encodeURIComponent(JSON.stringify({ tabs: ['console', 'log'] }))}`);
    await page.waitForSelector('.panel-console .lines');
    await page.evaluate((count) => {
      const { fake } = globalThis as unknown as { readonly fake: FakeSession; };
      const texts = Array.from({ length: count }, (_, i) => `[INFO] [1700000000.000000000] [talker]: Publishing: 'Hello, world! ${i}'`);
      fake.print('robot-1', ...texts);
    }, LINES);
    await page.getByText(`Hello, world! ${LINES - 1}'`).waitFor();
    await judge('a console');
    await page.getByRole('tab', { name: 'Log' }).click();
    // All that the consoles have is read.
    await page.waitForFunction((count) => {
      const all = document.querySelector('.panel-log .lines-all');
      return all !== null && all.clientHeight / document.querySelector('.panel-log .line')!.clientHeight > count - 1;
    }, LINES);
    await judge('the log');
  } finally {
    await browser.close();
    await host.close();
    rmSync(folder, { recursive: true, force: true });
  }
}
