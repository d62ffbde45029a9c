// The rows of a score board, their table and their summary. Pure.
import type { Failure } from './site.ts';

export interface Row {
  readonly package: string;
  /** The executable's name; for a launch file its path in share/package/. */
  readonly executable: string;
  readonly language: 'cpp' | 'python';
  /** `package`: it was not built, and nothing says which executables and launch files it has. */
  readonly kind: 'executable' | 'launch' | 'package';
  readonly built: boolean;
  readonly started: boolean;
  /** `publisher /topic std_msgs/msg/String`, sorted, without what every node brings. */
  readonly endpoints: readonly string[];
  /** The first ones of its output. */
  readonly log_lines: readonly string[];
  /** As expected; null when nothing says what to expect, so that the row is not green. */
  readonly expected: boolean | null;
  readonly error: Failure | null;
}

const KEPT_LINES = 40;
/** Matches the endpoints that each node has: parameter services, parameter events, logging, its type descriptions. */
const OF_EVERY_NODE =
  /^publisher \/(rosout|parameter_events) |^subscription \/parameter_events |\/(describe_parameters|get_parameter_types|get_parameters|list_parameters|set_parameters|set_parameters_atomically|get_type_description) /;

export function keptLines(lines: readonly string[]): string[] {
  return lines.slice(0, KEPT_LINES);
}

export function ownEndpoints(endpoints: Iterable<string>): string[] {
  return [...endpoints].filter((endpoint) => !OF_EVERY_NODE.test(endpoint)).sort();
}

export function isGreen(row: Row): boolean {
  return row.built && row.started && row.expected === true && row.error === null;
}

export function rowText(row: Row): string {
  const why = row.error === null ? (row.expected === null ? 'nothing says what to expect' : '') : `${row.error.code}: ${row.error.reason}`;
  return `${isGreen(row) ? 'green' : 'red  '}  ${row.package}/${row.executable}${why === '' ? '' : `  ${firstLine(why)}`}`;
}

/** Per package, then per reason, most frequent first. */
export function summary(rows: readonly Row[]): string {
  const packages = new Map<string, readonly [green: number, all: number]>();
  const reasons = new Map<string, string[]>();
  for (const row of rows) {
    const [green, all] = packages.get(row.package) ?? [0, 0];
    packages.set(row.package, [green + (isGreen(row) ? 1 : 0), all + 1]);
    if (isGreen(row)) continue;
    const reason = row.error?.code ?? 'no expectation';
    reasons.set(reason, [...(reasons.get(reason) ?? []), `${row.package}/${row.executable}`]);
  }
  const lines = [...packages].map(([name, [green, all]]) => `${String(green).padStart(4)} of ${String(all).padStart(2)}  ${name}`);
  for (const [reason, names] of [...reasons].sort(([, a], [, b]) => b.length - a.length)) {
    lines.push(`${String(names.length).padStart(4)} red: ${reason} (${names.join(', ')})`);
  }
  const launches = rows.filter(({ kind }) => kind === 'launch');
  const others = rows.filter(({ kind }) => kind !== 'launch');
  const counted = [[others, 'executables'], [launches, 'launch files']] as const;
  return [...lines,
    `${counted.filter(([of]) => of.length > 0).map(([of, what]) => `${of.filter(isGreen).length} of ${of.length} ${what}`).join(' and ')} are green`].join(
      '\n',
    );
}

function firstLine(text: string): string {
  return text.split('\n')[0] ?? '';
}
