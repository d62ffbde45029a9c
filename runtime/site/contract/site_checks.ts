// The checks of a site, which must pass while it runs, and their progress. Types only; check_run.ts evaluates them.

import type { SourcePlace, Unsubscribe } from './site_nodes.ts';

/** The conditions for a value: all that are given must hold. */
export interface Comparison {
  readonly above?: number;
  readonly below?: number;
  readonly equals?: boolean | number | string;
  /** A regular expression. */
  readonly matches?: string;
}

/** Node ids are those of SiteNode, but of a parameter's node, which is a full ROS name. */
export type CheckAim =
  /** Messages a second; without bounds: at least one message. */
  | { readonly kind: 'rate'; readonly topic: string; readonly above?: number; readonly below?: number; }
  | { readonly kind: 'message'; readonly topic: string; readonly field: string; readonly value: Comparison; }
  | { readonly kind: 'log'; readonly node?: string; readonly log: string; }
  | { readonly kind: 'parameter'; readonly node: string; readonly parameter: string; readonly value: Comparison; }
  | { readonly kind: 'state'; readonly node: string; readonly state: 'running' | 'exited' | 'crashed'; }
  | { readonly kind: 'exit_code'; readonly node: string; readonly exitCode: number; };

export interface SiteCheck {
  /** The author's words; empty: none. */
  readonly title: string;
  readonly aim: CheckAim;
  /** ms of site time, from the start of the first node. */
  readonly withinMs: number;
  readonly source?: SourcePlace;
}

export interface CheckView {
  /** The author's, or made of what is looked for. */
  readonly title: string;
  readonly state: 'waiting' | 'passed' | 'failed';
  /** The value seen last, or the one that decided it. */
  readonly seen: string;
  /** ms of the site's time from the begin until it was decided. */
  readonly afterMs?: number;
  readonly withinMs: number;
  readonly source?: SourcePlace;
}

export interface SiteChecks {
  /** In the manifest's order. */
  views(): readonly CheckView[];
  /** Called when one is decided, and when all begin again. */
  onChange(listener: (views: readonly CheckView[]) => void): Unsubscribe;
  /** Forgets what was seen and looks again from now on: at all, or at the one of that place in views(). */
  again(at?: number): void;
}
