// Which lines two texts have in common, in order: the shortest way from one to the other (Myers 1986), as long as they
// do not differ in too many lines; then what lies between their common begin and end is replaced as a whole. Pure.

/** Lines of the old text and of the new one that are to be replaced by each other; both may be empty, not at once. */
export interface Change {
  /** From 0. */
  readonly oldStart: number;
  readonly oldCount: number;
  readonly newStart: number;
  readonly newCount: number;
}

/** Steps of the search, whose memory grows with their square. */
const MOST_STEPS = 1_000;

export function lineChanges(before: readonly string[], after: readonly string[]): readonly Change[] {
  const least = Math.min(before.length, after.length);
  let start = 0;
  while (start < least && before[start] === after[start]) start += 1;
  let tail = 0;
  while (tail < least - start && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail += 1;
  const a = before.slice(start, before.length - tail);
  const b = after.slice(start, after.length - tail);
  if (a.length === 0 && b.length === 0) return [];
  const whole: Change = { oldStart: start, oldCount: a.length, newStart: start, newCount: b.length };
  if (a.length === 0 || b.length === 0) return [whole];
  const kept = keptLines(a, b);
  return kept === null ? [whole] : changesBetween(kept, a.length, b.length, start);
}

/** Pairs of lines that stay, in order; null when the texts differ too much. */
function keptLines(a: readonly string[], b: readonly string[]): (readonly [number, number])[] | null {
  // By diagonal (place in a less place in b): how far one gets in a with so many steps.
  const far = new Map<number, number>([[1, 0]]);
  const trace: Map<number, number>[] = [];
  for (let steps = 0; steps <= Math.min(MOST_STEPS, a.length + b.length); steps += 1) {
    trace.push(new Map(far));
    for (let k = -steps; k <= steps; k += 2) {
      let x = stepsDown(far, k, steps) ? (far.get(k + 1) ?? 0) : (far.get(k - 1) ?? 0) + 1;
      while (x < a.length && x - k < b.length && a[x] === b[x - k]) x += 1;
      far.set(k, x);
      if (x >= a.length && x - k >= b.length) return wayBack(trace, a.length, b.length);
    }
  }
  return null;
}

/** Whether one comes to diagonal k by taking a line of b, not by leaving one of a. */
function stepsDown(far: ReadonlyMap<number, number>, k: number, steps: number): boolean {
  return k === -steps || (k !== steps && (far.get(k - 1) ?? -1) < (far.get(k + 1) ?? -1));
}

function wayBack(trace: readonly ReadonlyMap<number, number>[], aLength: number, bLength: number): (readonly [number, number])[] {
  const kept: (readonly [number, number])[] = [];
  let x = aLength;
  let y = bLength;
  for (let steps = trace.length - 1; steps >= 0; steps -= 1) {
    const far = trace[steps] ?? new Map<number, number>();
    const k = x - y;
    const from = stepsDown(far, k, steps) ? k + 1 : k - 1;
    const fromX = steps === 0 ? 0 : (far.get(from) ?? 0);
    const fromY = steps === 0 ? 0 : fromX - from;
    while (x > fromX && y > fromY) kept.push([x -= 1, y -= 1]);
    x = fromX;
    y = fromY;
  }
  return kept.reverse();
}

function changesBetween(kept: readonly (readonly [number, number])[], aLength: number, bLength: number, start: number): Change[] {
  const changes: Change[] = [];
  let x = 0;
  let y = 0;
  for (const [keptX, keptY] of [...kept, [aLength, bLength] as const]) {
    if (keptX > x || keptY > y) {
      changes.push({ oldStart: start + x, oldCount: keptX - x, newStart: start + y, newCount: keptY - y });
    }
    x = keptX + 1;
    y = keptY + 1;
  }
  return changes;
}
