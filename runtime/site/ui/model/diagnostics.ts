// The health of a robot's parts, as published on /diagnostics: the newest status of each by name. Pure; the input may be
// hostile.

import { asNumber } from './field_path.ts';
import { member, textMember } from './json.ts';

export const LEVELS = ['error', 'warn', 'stale', 'ok'] as const;
export type DiagnosticLevel = (typeof LEVELS)[number];

export interface DiagnosticStatus {
  readonly name: string;
  /** The level as it was published; an unknown number counts as an error. */
  readonly told: DiagnosticLevel;
  readonly message: string;
  readonly hardwareId: string;
  readonly values: readonly { readonly key: string; readonly value: string; }[];
  /** How many more values it had. */
  readonly more: number;
  /** Seconds, of the site's time. */
  readonly at: number;
}

export interface DiagnosticRow extends DiagnosticStatus {
  readonly level: DiagnosticLevel;
}

const STALE_SECONDS = 5;
const MOST_NAMES = 2000;
const MOST_VALUES = 200;
const LONGEST = 2000;

const BY_NUMBER: readonly DiagnosticLevel[] = ['ok', 'warn', 'error', 'stale'];

export class Diagnostics {
  private readonly known = new Map<string, DiagnosticStatus>();
  private leftOutCount = 0;

  /** Statuses that were skipped because there are too many names. */
  get leftOut(): number {
    return this.leftOutCount;
  }

  /** Takes a diagnostic_msgs/msg/DiagnosticArray that was published at `at`. */
  add(message: unknown, at: number): void {
    const list = member(message, 'status');
    if (!Array.isArray(list)) return;
    for (const status of list as readonly unknown[]) {
      const name = textOf(status, 'name');
      if (!this.known.has(name) && this.known.size >= MOST_NAMES) {
        this.leftOutCount += 1;
        continue;
      }
      const values = member(status, 'values');
      const pairs: readonly unknown[] = Array.isArray(values) ? values : [];
      this.known.set(name, {
        name,
        told: BY_NUMBER[asNumber(member(status, 'level'))] ?? 'error',
        message: textOf(status, 'message'),
        hardwareId: textOf(status, 'hardware_id'),
        values: pairs.slice(0, MOST_VALUES).map((pair) => ({ key: textOf(pair, 'key'), value: textOf(pair, 'value') })),
        more: Math.max(0, pairs.length - MOST_VALUES),
        at,
      });
    }
  }

  /** The worst first, then by name. `now`: seconds, of the site's time. */
  rows(now: number): readonly DiagnosticRow[] {
    return [...this.known.values()]
      .map((status): DiagnosticRow => ({ ...status, level: now - status.at > STALE_SECONDS ? 'stale' : status.told }))
      .sort((a, b) => LEVELS.indexOf(a.level) - LEVELS.indexOf(b.level) || (a.name < b.name ? -1 : 1));
  }

  clear(): void {
    this.known.clear();
    this.leftOutCount = 0;
  }
}

export function countLevels(rows: readonly DiagnosticRow[]): Readonly<Record<DiagnosticLevel, number>> {
  const counts = { error: 0, warn: 0, stale: 0, ok: 0 };
  for (const { level } of rows) counts[level] += 1;
  return counts;
}

function textOf(value: unknown, name: string): string {
  return textMember(value, name).slice(0, LONGEST);
}
