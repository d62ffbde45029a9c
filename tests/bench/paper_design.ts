// A peer of `./dev bench link`: the design that the ROS2WASM paper describes, replayed in Chromium (paper_page.ts,
// paper_worker.ts). What it leaves out would make the figures worse.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'esbuild';
import { chromium } from 'playwright-core';
import { wholeChromium } from '../e2e/support/chromium.ts';
import { serveFolder } from '../support/static_server.ts';
import type { PaperTask } from './paper_worker.ts';

const TRIPS = 30;
const SENT_HZ = 100;
const SECONDS = 8;

export interface PaperFigures {
  /** Median, in microseconds. */
  readonly roundTripUs: number;
  /** Messages that one subscriber gets of 100 a second. */
  readonly perSecond: number;
}

/** Figures by size in bytes. */
export async function paperDesign(sizes: readonly number[]): Promise<ReadonlyMap<number, PaperFigures>> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-paper-'));
  try {
    const entryPoints = ['paper_page.ts', 'paper_worker.ts'].map((file) => join(import.meta.dirname, file));
    await build({ entryPoints, bundle: true, format: 'iife', outdir: folder, target: 'es2024', logLevel: 'warning' });
    writeFileSync(join(folder, 'index.html'), '<!doctype html><title>paper</title><script src="paper_page.js"></script>');
    const host = await serveFolder(folder, { isolated: true });
    const browser = await chromium.launch(wholeChromium());
    try {
      const page = await browser.newPage();
      await page.goto(host.url);
      const run = (tasks: PaperTask[]): Promise<readonly number[]> =>
        page.evaluate(
          (given) => (globalThis as unknown as { runPaperDesign(of: readonly PaperTask[]): Promise<readonly number[]>; }).runPaperDesign(given),
          tasks,
        );
      const figures = new Map<number, PaperFigures>();
      for (const bytes of sizes) {
        const trips = await run([{ does: 'ping', bytes, trips: TRIPS }, { does: 'pong' }]);
        const durationMs = SECONDS * 1000;
        const came = await run([{ does: 'count', durationMs }, { does: 'send', bytes, hz: SENT_HZ, durationMs }]);
        figures.set(bytes, {
          roundTripUs: 1000 * (trips.toSorted((a, b) => a - b)[Math.floor(trips.length / 2)] ?? Number.NaN),
          perSecond: ((came.length - 1) * 1000) / ((came.at(-1) ?? Number.NaN) - (came[0] ?? Number.NaN)),
        });
      }
      return figures;
    } finally {
      await browser.close();
      await host.close();
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
