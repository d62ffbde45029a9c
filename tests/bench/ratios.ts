// Ratios of the figures of ros2wasm to a peer's, landing by landing (ratios.json), and the check that they do not get worse.

export interface Ratio {
  /** The figure, the place where it was measured, and the load beside it. */
  readonly line: string;
  /** Ours divided by the peer's: of all runs the middle one and the worst. */
  readonly median: number;
  readonly worst: number;
}

export interface RatioEntry {
  /** When it was measured, YYYY-MM-DD. */
  readonly date: string;
  /** The change that landed. */
  readonly title: string;
  readonly ratios: readonly Ratio[];
  /** Why lines of this landing may be worse than before: the lines, each with its reason. */
  readonly excused?: Readonly<Record<string, string>>;
}

/** A median that is worse by more than this has regressed: machines of one kind differ by less. */
export const TOLERATED = 1.25;

/** A round trip is a time, so less is better; a throughput is the opposite. */
function worseBy(line: string, before: number, now: number): number {
  return line.startsWith('throughput') ? before / now : now / before;
}

/** The lines that the newest landing made worse than an earlier one, a sentence for each pair. */
export function regressions(entries: readonly RatioEntry[]): readonly string[] {
  const newest = entries.at(-1);
  if (newest === undefined) return [];
  const found: string[] = [];
  for (const { line, median } of newest.ratios) {
    if (newest.excused?.[line] !== undefined) continue;
    for (const { title, ratios } of entries.slice(0, -1)) {
      const before = ratios.find((each) => each.line === line);
      if (before === undefined) continue;
      const factor = worseBy(line, before.median, median);
      if (factor > TOLERATED) found.push(`${line}: ${median} of the peer's, after ${before.median} in "${title}"`);
    }
  }
  return found;
}
