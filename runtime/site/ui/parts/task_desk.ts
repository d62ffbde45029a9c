// A student's progress in the site's tasks: the present state of the tasks, and the browser's record of earlier visits. One
// desk per session; it continues while the panel of tasks is closed.

import { carriedFiles } from '../../program/carried_files.ts';
import type { Session, TaskCheckView, Unsubscribe } from '../../contract/session.ts';
import { readText, writePreference } from '../model/preferences.ts';
import type { Store } from '../model/preferences.ts';
import { merged, progressName, progressText, readProgress } from '../model/progress.ts';
import type { Progress, TaskProgress } from '../model/progress.ts';
import { taskTexts } from '../texts_tasks.ts';

export interface DeskTask {
  readonly title: string;
  readonly text: string;
  readonly hint: string;
  readonly solution: string;
  readonly checks: readonly TaskCheckView[];
  /** Kept: when it was done first, and when the student asked for its hint and its solution. */
  readonly kept: TaskProgress;
}

/** Path of the lab's folder; of the page, when it carries its files. */
function labPlace(): string {
  return carriedFiles() === undefined ? new URL('.', document.baseURI).pathname : location.pathname;
}

export class TaskDesk {
  private readonly session: Session;
  private readonly store: Store | null;
  private readonly name: string;
  private readonly now: () => Date;
  private kept: Progress;
  private readonly listeners = new Set<() => void>();
  private readonly newsListeners = new Set<(words: string) => void>();
  private readonly stops: Unsubscribe[];

  /** `place`: under which the browser keeps it. */
  constructor(session: Session, store: Store | null, place: string, now: () => Date) {
    this.session = session;
    this.store = store;
    this.name = progressName(place);
    this.now = now;
    this.kept = this.read();
    const onStorage = (): void => {
      this.kept = merged(this.kept, this.read());
      this.tell();
    };
    globalThis.addEventListener?.('storage', onStorage);
    this.stops = [
      session.tasks?.onChange(() => this.look()) ?? (() => undefined),
      () => globalThis.removeEventListener?.('storage', onStorage),
    ];
    this.look();
  }

  tasks(): readonly DeskTask[] {
    const views = this.session.tasks?.views() ?? [];
    return this.session.site.tasks.map(({ title, text, hint, solution }, at) => ({
      title,
      text,
      hint,
      solution,
      checks: views[at]?.checks ?? [],
      kept: this.of(title),
    }));
  }

  /** In the order of the tasks; only of those that the site has. */
  progress(): Progress {
    return this.session.site.tasks.map(({ title }) => this.of(title));
  }

  /** The student asks for it: that is kept, and shown from then on. */
  reveal(title: string, what: 'hintAt' | 'solutionAt'): void {
    this.keep([{ ...this.of(title), [what]: this.of(title)[what] ?? this.time() }]);
  }

  forget(): void {
    this.kept = [];
    writePreference(this.store, this.name, progressText([]));
    // A check that passes now counts as done now.
    this.look();
    this.tell();
  }

  /** Something that is shown has changed. */
  onChange(listener: () => void): Unsubscribe {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  /** A task was just done, in words. */
  onNews(listener: (words: string) => void): Unsubscribe {
    this.newsListeners.add(listener);
    return () => void this.newsListeners.delete(listener);
  }

  close(): void {
    for (const stop of this.stops) stop();
  }

  private of(title: string): TaskProgress {
    return this.kept.find((one) => one.title === title) ?? { title, seen: [] };
  }

  private time(): string {
    return this.now().toISOString();
  }

  private read(): Progress {
    return readProgress(readText(this.store, this.name));
  }

  private look(): void {
    const fresh = (this.session.tasks?.views() ?? []).filter(({ title, done }) => done && this.of(title).doneAt === undefined);
    if (fresh.length > 0) {
      this.keep(fresh.map(({ title, checks }) => ({
        ...this.of(title),
        doneAt: this.time(),
        seen: checks.map((check) => ({ title: check.title, seen: check.seen })),
      })));
      for (const { title } of fresh) for (const listener of [...this.newsListeners]) listener(taskTexts.nowDone(title));
    }
    this.tell();
  }

  private keep(changed: Progress): void {
    // Another tab may have written meanwhile. Titles that the site has no more go.
    const all = merged(merged(this.kept, changed), this.read());
    const titles = new Set(this.session.site.tasks.map(({ title }) => title));
    this.kept = all.filter(({ title }) => titles.has(title));
    writePreference(this.store, this.name, progressText(this.kept));
    this.tell();
  }

  private tell(): void {
    for (const listener of [...this.listeners]) listener();
  }
}

const desks = new WeakMap<Session, TaskDesk>();

export function taskDesk(session: Session, store: Store | null): TaskDesk {
  const known = desks.get(session);
  if (known !== undefined) return known;
  const made = new TaskDesk(session, store, labPlace(), () => new Date());
  desks.set(session, made);
  return made;
}
