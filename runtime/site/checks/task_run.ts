// Decides the tasks of a site while it runs. Loaded for sites that have tasks; sees the Session only, as the page does.
// Values from before the student's first act are only noted. From that act on all checks begin again, without a deadline.

import { createCodec } from '../decode/codec.ts';
import { type Look, startLook } from './check_looks.ts';
import { checkTitle } from './check_words.ts';
import type { PageTimer } from '../contract/page_node.ts';
import type { Session, Unsubscribe } from '../contract/session.ts';
import type { SiteTask, SiteTasks, TaskCheck, TaskView } from '../contract/site_tasks.ts';

/** Looked at so often, in ms of the site's time. */
const beatMs = 250;

interface Watched {
  readonly check: TaskCheck;
  look: Look | undefined;
  /** The value that met the check; undefined: it is open. */
  met: string | undefined;
}

interface WatchedTask {
  readonly task: SiteTask;
  readonly checks: readonly Watched[];
}

/** To be awaited before the first node starts. */
export async function runTasks(session: Session): Promise<TaskRun> {
  return new TaskRun(session, createCodec(await session.interfaces()));
}

export class TaskRun implements SiteTasks {
  private readonly session: Session;
  private readonly codec: ReturnType<typeof createCodec>;
  private readonly tasks: readonly WatchedTask[];
  private readonly listeners = new Set<(views: readonly TaskView[]) => void>();
  private readonly timer: PageTimer;
  private hasBegun = false;
  private closed = false;
  /** Changes are told once for all that comes in one turn. */
  private told = true;

  constructor(session: Session, codec: ReturnType<typeof createCodec>) {
    this.session = session;
    this.codec = codec;
    this.tasks = session.site.tasks.map((task) => ({
      task,
      checks: task.checks.map((check) => ({ check, look: undefined, met: undefined })),
    }));
    // So that publishers are known that are gone when it is next looked at.
    session.topics();
    this.lookAnew();
    this.timer = session.node().timer(beatMs, () => this.beat());
  }

  views(): readonly TaskView[] {
    return this.tasks.map(({ task, checks }) => ({
      title: task.title,
      done: this.hasBegun && checks.every(({ met }) => met !== undefined),
      checks: checks.map(({ check, look, met }) => ({
        title: checkTitle(check),
        state: met === undefined ? 'open' : this.hasBegun ? 'passed' : 'already',
        seen: met ?? look?.seen() ?? '',
        ...(check.source === undefined ? {} : { source: check.source }),
      })),
    }));
  }

  acted(): void {
    if (this.hasBegun || this.closed) return;
    this.hasBegun = true;
    this.lookAnew();
    this.tell();
  }

  begun(): boolean {
    return this.hasBegun;
  }

  onChange(listener: (views: readonly TaskView[]) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    this.timer.close();
    for (const watched of this.all()) watched.look?.close();
    this.listeners.clear();
  }

  private all(): Watched[] {
    return this.tasks.flatMap(({ checks }) => checks);
  }

  /** Only what is of this moment or later counts. Times of messages and lines may bear whole ms. */
  private lookAnew(): void {
    const from = Math.floor(this.session.time.view().now);
    for (const watched of this.all()) {
      watched.look?.close();
      watched.met = undefined;
      const look = startLook(watched.check.aim, {
        session: this.session,
        codec: this.codec,
        inTime: (time) => time >= from,
        met: (seen) => this.meet(watched, look, seen),
      });
      watched.look = look;
    }
  }

  private beat(): void {
    for (const { look, met } of this.all()) if (met === undefined) look?.look();
  }

  private meet(watched: Watched, by: Look, seen: string): void {
    // A look of before may still get an answer.
    if (watched.met !== undefined || watched.look !== by || this.closed) return;
    watched.met = seen;
    by.close();
    this.tell();
  }

  private tell(): void {
    if (!this.told) return;
    this.told = false;
    queueMicrotask(() => {
      this.told = true;
      if (this.closed) return;
      const views = this.views();
      for (const listener of [...this.listeners]) listener(views);
    });
  }
}
