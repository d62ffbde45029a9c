// The gaps between the frames of a page, and what is told of them.
import type { Page } from 'playwright-core';

/** 60 frames per second, and a little more. */
export const AIM_MS = 20;

const rounded = (value: number): number => Math.round(value * 100) / 100;

/** Gaps between frames in milliseconds, for so long. */
export function gaps(page: Page, ms: number): Promise<number[]> {
  return page.evaluate((duration) =>
    new Promise<number[]>((done) => {
      const found: number[] = [];
      const from = performance.now();
      let last = from;
      const frame = (): void => {
        const now = performance.now();
        found.push(now - last);
        last = now;
        if (now - from < duration) requestAnimationFrame(frame);
        else done(found);
      };
      requestAnimationFrame(frame);
    }), ms);
}

export interface FrameFigures extends Readonly<Record<string, number>> {
  readonly frame_p95_ms: number;
  /** Share of all, 0 to 1. */
  readonly under_20_ms: number;
}

export function frameFigures(found: readonly number[]): FrameFigures {
  const sorted = found.toSorted((a, b) => a - b);
  const at = (share: number): number => rounded(sorted[Math.floor(sorted.length * share)] ?? Number.NaN);
  return {
    frames: found.length,
    frame_p50_ms: at(0.5),
    frame_p95_ms: at(0.95),
    frame_p99_ms: at(0.99),
    frame_longest_ms: rounded(sorted.at(-1) ?? Number.NaN),
    under_20_ms: rounded(found.filter((gap) => gap < AIM_MS).length / found.length),
  };
}
