// The file that a student hands in (bundler/verify/progress_file.cpp reads it): a record as text, and the signature of
// that text by a key of the browser. Pure.

import type { Progress } from './progress.ts';

const FORMAT = 'ros2wasm progress';
const SCHEMA = 1;
/** Before the record where it is signed: a signature over something else never fits. */
const SIGNED_AS = 'ros2wasm progress 1\n';
export const MOST_NAME = 200;
/** Characters that a terminal or a table does not show as they are. bundler/verify/progress_file.cpp refuses them. */
const STEERING = /[\p{Cc}\u2028-\u202e\u2066-\u2069\ufeff]/gu;

export interface LabRecord {
  readonly title: string;
  /** The hash of the site at the export. */
  readonly sha256: string;
  readonly tasks: Progress;
}

export interface ProgressRecord {
  readonly student: string;
  readonly exportedAt: string;
  /** Its title; undefined: from the page of one lab. */
  readonly course?: string;
  readonly labs: readonly LabRecord[];
}

/** One line without control characters; null when nothing is left of it. */
export function studentName(typed: string): string | null {
  const name = typed.replace(STEERING, ' ').trim().slice(0, MOST_NAME).toWellFormed();
  return name === '' ? null : name;
}

export function recordText({ student, exportedAt, course, labs }: ProgressRecord): string {
  return JSON.stringify({
    student,
    exported_at: exportedAt,
    ...(course === undefined ? {} : { course: plain(course) }),
    labs: labs.map(({ title, sha256, tasks }) => ({
      title: plain(title),
      sha256,
      tasks: tasks.map((task) => ({
        title: plain(task.title),
        ...(task.doneAt === undefined ? {} : { done_at: task.doneAt }),
        ...(task.hintAt === undefined ? {} : { hint_at: task.hintAt }),
        ...(task.solutionAt === undefined ? {} : { solution_at: task.solutionAt }),
        ...(task.doneAt === undefined ? {} : { seen: task.seen }),
      })),
    })),
  });
}

function plain(text: string): string {
  return text.replace(STEERING, ' ');
}

export function signedBytes(record: string): Uint8Array<ArrayBuffer> {
  return new TextEncoder().encode(SIGNED_AS + record);
}

export function fileText(record: string, key: Uint8Array, signature: Uint8Array): string {
  return `${JSON.stringify({ format: FORMAT, schema: SCHEMA, record, key: base64(key), signature: base64(signature) }, null, 1)}\n`;
}

function base64(bytes: Uint8Array): string {
  return btoa(String.fromCharCode(...bytes));
}

/** `progress-Ada_Lovelace.json`. */
export function fileName(student: string): string {
  return `progress-${student.replace(/[^\p{L}\p{N}-]+/gu, '_').slice(0, 60)}.json`;
}
