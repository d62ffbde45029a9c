// The student's progress in a lab as the browser stores it, by the titles of tasks. Other sites of the origin can write
// there too, so it is read as hostile. Pure.

import { isRecord, textMember } from './json.ts';

/** Times are ISO 8601 in UTC, by the browser's clock. */
export interface TaskProgress {
  readonly title: string;
  readonly doneAt?: string;
  readonly hintAt?: string;
  readonly solutionAt?: string;
  /** The value that decided each check, once the task is done. */
  readonly seen: readonly { readonly title: string; readonly seen: string; }[];
}

export type Progress = readonly TaskProgress[];

const SCHEMA = 1;
const MOST_TEXT = 262_144;
const MOST_TASKS = 1000;
const MOST_CHECKS = 100;
const MOST_WORDS = 500;
const TIME = /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,3})?Z$/;
const MOMENTS = ['doneAt', 'hintAt', 'solutionAt'] as const;

/** Name under which it is kept: `place` is the path of the lab's folder, or of a page that carries its files. */
export function progressName(place: string): string {
  return `progress ${place}`;
}

/** Nothing of what is not as progressText() writes it. */
export function readProgress(text: string | null): Progress {
  if (text === null || text.length > MOST_TEXT) return [];
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return [];
  }
  if (!isRecord(json) || json['schema'] !== SCHEMA || !Array.isArray(json['tasks'])) return [];
  const found = new Map<string, TaskProgress>();
  for (const item of (json['tasks'] as readonly unknown[]).slice(0, MOST_TASKS)) {
    const title = textMember(item, 'title');
    if (title !== '') found.set(title, readTask(item, title));
  }
  return [...found.values()];
}

function readTask(item: unknown, title: string): TaskProgress {
  const moments: { doneAt?: string; hintAt?: string; solutionAt?: string; } = {};
  for (const name of MOMENTS) {
    const time = textMember(item, name);
    if (TIME.test(time) && !Number.isNaN(Date.parse(time))) moments[name] = time;
  }
  const seen = isRecord(item) && Array.isArray(item['seen']) ? (item['seen'] as readonly unknown[]) : [];
  return {
    title,
    ...moments,
    seen: seen.slice(0, MOST_CHECKS).map((one) => ({
      title: textMember(one, 'title').slice(0, MOST_WORDS),
      seen: textMember(one, 'seen').slice(0, MOST_WORDS),
    })),
  };
}

export function progressText(progress: Progress): string {
  return JSON.stringify({ schema: SCHEMA, tasks: progress });
}

/** Two tabs of one lab: what either has done is done, since the earlier time. In the order of the first, then the second. */
export function merged(one: Progress, other: Progress): Progress {
  const all = new Map<string, TaskProgress>(one.map((task) => [task.title, task]));
  for (const task of other) {
    const known = all.get(task.title);
    all.set(task.title, known === undefined ? task : mergedTask(known, task));
  }
  return [...all.values()];
}

function mergedTask(one: TaskProgress, other: TaskProgress): TaskProgress {
  const moments: { doneAt?: string; hintAt?: string; solutionAt?: string; } = {};
  for (const name of MOMENTS) {
    const times = [one[name], other[name]].filter((time) => time !== undefined).sort();
    if (times[0] !== undefined) moments[name] = times[0];
  }
  const first = moments.doneAt !== undefined && moments.doneAt === one.doneAt ? one : other;
  return { title: one.title, ...moments, seen: first.seen.length > 0 ? first.seen : one.seen };
}
