// The tasks of a student in a site, and their progress. Types only; task_run.ts evaluates them, acting_session.ts reports to it
// the student's actions.

import type { CheckAim } from './site_checks.ts';
import type { SourcePlace, Unsubscribe } from './site_nodes.ts';

export interface TaskCheck {
  /** The author's words; empty: none. */
  readonly title: string;
  readonly aim: CheckAim;
  readonly source?: SourcePlace;
}

/** Texts are Markdown; empty: none. */
export interface SiteTask {
  /** Each once in a site. */
  readonly title: string;
  readonly text: string;
  readonly hint: string;
  readonly solution: string;
  /** One or more. */
  readonly checks: readonly TaskCheck[];
}

export interface TaskCheckView {
  /** The author's, or made of what is looked for. */
  readonly title: string;
  /** "already": it was seen before the student did anything, and so proves nothing yet. */
  readonly state: 'open' | 'already' | 'passed';
  /** The last observed value, or the one that decided the check. */
  readonly seen: string;
  readonly source?: SourcePlace;
}

export interface TaskView {
  readonly title: string;
  /** All its checks have passed. */
  readonly done: boolean;
  readonly checks: readonly TaskCheckView[];
}

export interface SiteTasks {
  /** In the manifest's order, as in `tasks` of the site. */
  views(): readonly TaskView[];
  /** The student has done something: from the first time on checks can pass. */
  acted(): void;
  /** Has the student done something since the page was opened? */
  begun(): boolean;
  /** Called when a check changes its state, and when the student begins. */
  onChange(listener: (views: readonly TaskView[]) => void): Unsubscribe;
}
