// Compares the observations of an executable with its expectation. Pure.
import type { Expectation, Start } from './expectation.ts';

/** The output and the end of one node of the site. */
export interface SeenNode {
  /** Its output, each line whole. */
  readonly lines: readonly string[];
  /** It came so far as to run. */
  readonly started: boolean;
  /** Its exit code once it has ended; a crash has its code and message instead. */
  readonly exit: number | undefined;
  readonly crash: { readonly code: string; readonly message: string; } | undefined;
}

export interface Seen {
  readonly node: SeenNode;
  readonly beside: readonly SeenNode[];
  /** `publisher /topic std_msgs/msg/String`, all that the executable made. */
  readonly endpoints: ReadonlySet<string>;
  /** Path in a message of a topic -> value, as text; undefined: no message, or none with this field. */
  readonly value: (topic: string, path: string) => string | undefined;
}

export interface Verdict {
  /** Nothing more can make it better or worse. */
  readonly final: boolean;
  /** The differences from the expectation; empty: it is as expected. */
  readonly missing: readonly string[];
}

export function judge(expected: Expectation, seen: Seen): Verdict {
  const missing: string[] = [];
  const { node } = seen;
  if (node.crash !== undefined) return { final: true, missing: [node.crash.message] };
  const pairs: (readonly [Start, SeenNode | undefined])[] = [[expected, node], ...expected.beside.map((one, i) => [one, seen.beside[i]] as const)];
  for (const [start, of] of pairs) {
    const who = start === expected ? '' : `${start.executable}: `;
    const bad = start.never.map((regex) => of?.lines.find((line) => regex.test(line))).find((line) => line !== undefined);
    if (bad !== undefined) return { final: true, missing: [`${who}it must not say: ${bad}`] };
    if (of?.crash !== undefined) return { final: true, missing: [`${who}${of.crash.message}`] };
    missing.push(...unsaid(start, of?.lines ?? []).map((text) => `${who}${text}`));
  }
  for (const endpoint of expected.endpoints) if (!seen.endpoints.has(endpoint)) missing.push(`no ${endpoint}`);
  for (const [topic, fields] of expected.values) {
    for (const [path, regex] of fields) {
      const value = seen.value(topic, path);
      if (value === undefined) missing.push(`no ${path} on ${topic}`);
      else if (!regex.test(value)) missing.push(`${path} on ${topic} is ${value}, not ${written(regex)}`);
    }
  }
  if (expected.exit !== undefined && node.exit !== expected.exit) {
    missing.push(node.exit === undefined ? 'it does not end' : `it ends with ${node.exit}, not ${expected.exit}`);
  } else if (expected.exit === undefined && node.exit !== undefined && node.exit !== 0) {
    missing.push(`it ends with ${node.exit}`);
  }
  return { final: missing.length === 0, missing };
}

/** The first regex of `log` that no line fits in its turn, and those of `anywhere` that none fits. */
function unsaid({ log, anywhere }: Start, lines: readonly string[]): string[] {
  const result: string[] = [];
  let from = 0;
  for (const regex of log) {
    const at = lines.findIndex((line, index) => index >= from && regex.test(line));
    if (at < 0) {
      result.push(`no line fits ${written(regex)}`);
      break;
    }
    from = at + 1;
  }
  for (const regex of anywhere) if (!lines.some((line) => regex.test(line))) result.push(`no line fits ${written(regex)}`);
  return result;
}

/** As the file of expectations has it: `source` escapes the slashes. */
function written(regex: RegExp): string {
  return regex.source.replaceAll('\\/', '/');
}
