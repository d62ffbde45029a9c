// What a session needs of the place it runs in: a browser page (launcher.ts) or Node.js (headless.ts).

import type { KeptBytes } from './kept_bytes.ts';
import type { KeptTexts } from './kept_texts.ts';
import type { WorkerOrder, WorkerReport } from './node_worker.ts';
import type { SiteFile } from './session.ts';

export interface WorkerHandle {
  post(order: WorkerOrder, transfer: readonly MessagePort[]): void;
  /** Resolves when the worker runs no more: until then it may still change what it shares with others. */
  terminate(): Promise<void>;
}

export interface WorkerEvents {
  readonly report: (report: WorkerReport) => void;
  /** The worker could not start, its script broke, or it sent what is no report (`code`, else R2W0708). */
  readonly failed: (message: string, code?: string) => void;
}

export interface Platform {
  /** Where the site lies: its address, or its folder. */
  readonly place: string;
  /** Throws SiteError R2W0706. */
  readonly json: (path: string) => Promise<unknown>;
  /** From now on files must be as site.json lists them. */
  readonly expect: (files: readonly SiteFile[]) => void;
  /** Fetches and compiles; the same path gives the same module. Throws SiteError R2W0703, R2W0706 or R2W0724. */
  readonly compile: (path: string) => Promise<WebAssembly.Module>;
  /** The whole file. Throws SiteError R2W0706 or R2W0724. */
  readonly bytes: (path: string) => Promise<ArrayBuffer>;
  readonly startWorker: (name: string, events: WorkerEvents) => WorkerHandle;
  /** What is kept for later visits; undefined: nothing is. */
  readonly kept?: KeptBytes | undefined;
  /** What visitors make of the sources, by their paths; undefined: nobody does. */
  readonly texts?: KeptTexts;
  /** Runs a task at the next animation frame, or soon. */
  readonly frame: (task: () => void) => void;
}
