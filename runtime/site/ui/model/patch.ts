// A unified diff of changed files, as `git apply` and `patch -p1` take it. Pure.

import type { Change } from './line_diff.ts';
import { lineChanges } from './line_diff.ts';

export interface ChangedFile {
  /** Relative, with "/". */
  readonly path: string;
  readonly before: string;
  readonly after: string;
}

const CONTEXT = 3;
const NO_END = '\\ No newline at end of file';

/** Empty when nothing differs. */
export function makePatch(files: readonly ChangedFile[]): string {
  return files.map(patchOf).join('');
}

function patchOf({ path, before, after }: ChangedFile): string {
  const old = linesOf(before);
  const fresh = linesOf(after);
  const changes = lineChanges(old, fresh);
  if (changes.length === 0) return '';
  const hunks = grouped(changes).map((group) => hunk(old, fresh, group));
  return [`--- ${patchName(`a/${path}`)}\n`, `+++ ${patchName(`b/${path}`)}\n`, ...hunks].join('');
}

/** Each with its "\n", but for a last one that has none. "\r" and other separators are part of a line. */
function linesOf(text: string): string[] {
  return text.match(/[^\n]*\n|[^\n]+$/g) ?? [];
}

/** Changes whose contexts touch are one hunk. */
function grouped(changes: readonly Change[]): (readonly Change[])[] {
  const groups: Change[][] = [];
  for (const change of changes) {
    const group = groups.at(-1);
    const last = group?.at(-1);
    if (group === undefined || last === undefined || change.oldStart - last.oldStart - last.oldCount > 2 * CONTEXT) groups.push([change]);
    else group.push(change);
  }
  return groups;
}

function hunk(old: readonly string[], fresh: readonly string[], changes: readonly Change[]): string {
  const first = changes[0];
  const last = changes.at(-1);
  if (first === undefined || last === undefined) return '';
  const before = Math.min(CONTEXT, first.oldStart);
  const oldStart = first.oldStart - before;
  const newStart = first.newStart - before;
  const oldEnd = Math.min(old.length, last.oldStart + last.oldCount + CONTEXT);
  const newEnd = last.newStart + last.newCount + (oldEnd - last.oldStart - last.oldCount);
  const lines: string[] = [`@@ -${range(oldStart, oldEnd)} +${range(newStart, newEnd)} @@\n`];
  const add = (sign: string, line: string): void => {
    lines.push(line.endsWith('\n') ? sign + line : `${sign}${line}\n${NO_END}\n`);
  };
  let at = oldStart;
  for (const change of changes) {
    for (; at < change.oldStart; at += 1) add(' ', old[at] ?? '');
    for (const line of old.slice(at, at + change.oldCount)) add('-', line);
    for (const line of fresh.slice(change.newStart, change.newStart + change.newCount)) add('+', line);
    at += change.oldCount;
  }
  for (; at < oldEnd; at += 1) add(' ', old[at] ?? '');
  return lines.join('');
}

/** An empty range stands after the line that it names. */
function range(start: number, end: number): string {
  const count = end - start;
  return `${count === 0 ? start : start + 1},${count}`;
}

/** In quotes, with escapes, where it would break the line or end too early; a tab ends a name with spaces. */
function patchName(path: string): string {
  if (!/["\\\u0000-\u001f\u007f]/.test(path)) return path.includes(' ') ? `${path}\t` : path;
  const bytes = new TextEncoder().encode(path);
  const quoted = Array.from(bytes, (byte) => {
    const isPlain = byte >= 0x20 && byte < 0x7f && byte !== 0x22 && byte !== 0x5c;
    return isPlain ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, '0')}`;
  });
  return `"${quoted.join('')}"`;
}
