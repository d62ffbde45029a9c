// When a page that loads has become quiet, from its long tasks, as Lighthouse counts it. All times in milliseconds since
// navigation began.

const LONG_TASK_MS = 50;
export const QUIET_MS = 500;

export interface Task {
  readonly start: number;
  readonly end: number;
}

export interface Load {
  readonly firstPaint: number;
  readonly largestPaint: number;
  readonly tasks: readonly Task[];
}

/** When the first quiet time begins, and how long input would have waited until then. */
export function interactive({ firstPaint, tasks }: Load): { readonly at: number; readonly blocked: number; } {
  let at = firstPaint;
  let blocked = 0;
  for (const { start, end } of tasks.toSorted((a, b) => a.start - b.start)) {
    if (end <= firstPaint) continue;
    if (start - at >= QUIET_MS) break;
    at = Math.max(at, end);
    blocked += Math.max(0, end - Math.max(start, firstPaint) - LONG_TASK_MS);
  }
  return { at, blocked };
}
