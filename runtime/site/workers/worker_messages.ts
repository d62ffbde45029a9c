// The messages between a page and its workers.

import type { TerminalMode } from '../../protocol/generated/constants.ts';
import type { WorkerFile } from '../program/carried_files.ts';
import type { SentLine } from '../bus/console_sender.ts';
import type { ThreadRequest } from '../program/env_imports.ts';
import type { LaunchStart } from '../python/launch_run.ts';
import type { SentMessage } from '../program/message_trace.ts';
import type { LinkTicket } from '../bus/open_link.ts';
import type { ProgramEnd, ThreadStart } from '../program/program.ts';
import type { ImageStart } from '../python/python_image.ts';
import type { PythonStart } from '../python/python_program.ts';
import type { SiteFiles } from '../program/site_files.ts';
import type { ThreadMemory } from '../program/thread_waits.ts';
import type { Rest } from '../bus/turns.ts';

/** To a worker: what to run. */
export interface WorkerStart {
  readonly module: WebAssembly.Module;
  /** For a Python program, whose module is Pyodide's. */
  readonly python: PythonStart | undefined;
  readonly ticket: LinkTicket;
  readonly id: string;
  readonly arguments: readonly string[];
  readonly environment: Readonly<Record<string, string>>;
  readonly files: SiteFiles;
  readonly thread?: ThreadStart;
  /** In a stepped run one participant runs at a time, and random numbers come from the seed. */
  readonly stepped: { readonly seed: number; } | undefined;
  /** Every message that the program sends is told. */
  readonly traced: boolean;
}

/** From a worker. */
export type WorkerReport =
  | { readonly t: 'running'; }
  /** The program waits for the first time: it has made its nodes and spins, or sleeps. */
  | { readonly t: 'waits'; }
  /** How the program has set its standard input. */
  | { readonly t: 'terminal'; readonly mode: TerminalMode; }
  | { readonly t: 'lines'; readonly lines: readonly SentLine[]; readonly dropped: number; }
  /** The program has written a file and closed it. `at`: when, by the time that all workers share, in ns. */
  | { readonly t: 'file'; readonly path: string; readonly bytes: Uint8Array<ArrayBuffer>; readonly at: number; }
  /** An event of a notebook's kernel, as JSON. */
  | { readonly t: 'event'; readonly event: string; }
  | { readonly t: 'thread'; readonly request: ThreadRequest; readonly memory: WebAssembly.Memory; }
  /** With this the page tells the threads of a program about a change of time. */
  | { readonly t: 'memory'; readonly memory: ThreadMemory; }
  /** A stepped run: it waits for its turn. */
  | { readonly t: 'rest'; readonly rest: Rest; }
  | { readonly t: 'sent'; readonly message: SentMessage; }
  /** The result of an order to make an image; undefined: no image can be made. */
  | { readonly t: 'image'; readonly image: Blob | undefined; }
  /** The image that the start named cannot be opened; the program began without it. */
  | { readonly t: 'broken_image'; }
  /** The result of an order to evaluate a launch file. */
  | { readonly t: 'launch'; readonly answer?: unknown; readonly failed?: string; }
  /** The program has read that source of the workspace, for the first time. */
  | { readonly t: 'source'; readonly path: string; }
  /** `closed`: the worker took leave of the graph. */
  | { readonly t: 'end'; readonly end: ProgramEnd; readonly closed: boolean; };

/** In a browser, before all orders: the lock to hold as long as the worker lives (worker_life.ts), and files that lie
 * elsewhere than beside site.json, by the addresses that they would have there. */
export interface HoldOrder {
  readonly t: 'hold';
  readonly life: string;
  readonly files?: ReadonlyMap<string, WorkerFile> | undefined;
}

export type WorkerOrder =
  /** Loads what runs Python while its program and archives are on their way. `base`, `home`: as in PythonStart. */
  | { readonly t: 'python'; readonly base: string; readonly home: string; }
  | { readonly t: 'start'; readonly start: WorkerStart; }
  /** Runs no program, but makes what Python programs begin with. */
  | { readonly t: 'image'; readonly module: WebAssembly.Module; readonly start: ImageStart; }
  /** Runs no program, but evaluates the launch file; `running` is told when Python begins. */
  | { readonly t: 'launch'; readonly module: WebAssembly.Module; readonly start: LaunchStart; }
  /** Runs no program, but carries to and from another tab. */
  | { readonly t: 'bridge'; readonly ticket: LinkTicket; readonly channel: string; };
