// The interface between a session and the place where it runs: a browser page (launcher.ts) or Node.js (headless.ts).

import type { DiagnosticCode } from '../contract/diagnostic_codes.ts';
import type { SiteHost } from '../program/site_host.ts';
import type { WorkerOrder, WorkerReport } from './worker_messages.ts';

export interface WorkerHandle {
  post(order: WorkerOrder, transfer: readonly MessagePort[]): void;
  /** Resolves when the worker runs no more: until then it may still change what it shares with others. */
  terminate(): Promise<void>;
}

export interface WorkerEvents {
  readonly report: (report: WorkerReport) => void;
  /** The worker could not start, its script broke, or it sent something that is not a report (`code`, else R2W0708). */
  readonly failed: (message: string, code?: DiagnosticCode) => void;
}

export interface Platform extends SiteHost {
  readonly startWorker: (name: string, events: WorkerEvents) => WorkerHandle;
  /** Runs a task at the next animation frame, or soon. */
  readonly frame: (task: () => void) => void;
}
