// A failure in the words people read everywhere in ros2wasm: code, what, where, why, way out.
// Turns whatever was thrown into that shape; never throws itself.

import type { DiagnosticCode } from '../../contract/diagnostic_codes.ts';

export interface Problem {
  readonly code: DiagnosticCode;
  readonly what: string;
  readonly place: string | null;
  readonly why: readonly string[];
  readonly fix: readonly string[];
}

const UNKNOWN = 'R2W0792';

/** Reads an unknown thrown value. Errors of the launcher carry `code`, `why`, `fix` and `place`. */
export function problemOf(thrown: unknown): Problem {
  if (typeof thrown === 'object' && thrown !== null) {
    const field = (name: string): unknown => name in thrown ? (thrown as Record<string, unknown>)[name] : undefined;
    const code = field('code');
    return {
      code: typeof code === 'string' && /^R2W\d{4}$/.test(code) ? code as DiagnosticCode : UNKNOWN,
      what: textOf(field('what')) ?? textOf(field('message')) ?? String(thrown),
      place: placeOf(field('place') ?? field('source')),
      why: textsOf(field('why')),
      fix: textsOf(field('fix')),
    };
  }
  return { code: UNKNOWN, what: String(thrown), place: null, why: [], fix: [] };
}

/** The text of a problem, as the terminal would print it. */
export function problemText(problem: Problem): string {
  return [
    `error[${problem.code}]: ${problem.what}`,
    ...(problem.place === null ? [] : [`  --> ${problem.place}`]),
    ...problem.why.map((why) => `   = why: ${why}`),
    ...problem.fix.map((fix) => `   = fix: ${fix}`),
  ].join('\n');
}

/** `workspace.yaml:12:11` */
export function placeText(place: {
  readonly file: string;
  readonly line: number;
  readonly column: number;
}): string {
  return `${place.file}:${place.line}:${place.column}`;
}

function placeOf(value: unknown): string | null {
  if (typeof value === 'string') return value;
  if (typeof value !== 'object' || value === null) return null;
  const place = value as Record<string, unknown>;
  return typeof place['file'] === 'string'
    ? [place['file'], place['line'], place['column']].filter((part) => part !== undefined).join(':')
    : null;
}

function textOf(value: unknown): string | null {
  return typeof value === 'string' && value !== '' ? value : null;
}

function textsOf(value: unknown): readonly string[] {
  if (Array.isArray(value)) return value.filter((item): item is string => typeof item === 'string');
  return typeof value === 'string' && value !== '' ? [value] : [];
}
