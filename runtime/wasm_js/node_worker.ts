// Entry of every node worker and thread worker, in browsers and (through node_thread.ts) under Node.js.

import { TerminalMode } from '../protocol/generated/constants.ts';
import type { WorkerFile } from './carried_files.ts';
import { realNanoseconds } from './clock.ts';
import { ConsoleSender, type SentLine } from './console_sender.ts';
import type { ThreadRequest } from './env_imports.ts';
import type { Link } from './link.ts';
import type { SentMessage } from './message_trace.ts';
import { type LinkTicket, openLink } from './open_link.ts';
import { type ProgramEnd, type ProgramHost, runProgram, type ThreadStart } from './program.ts';
import type { LaunchStart } from './launch_python.ts';
import type { ImageStart } from './python_image.ts';
import type { PythonReports, PythonRuntime, PythonStart, WorkerFiles } from './python_program.ts';
import { seededRandom } from './seeded_random.ts';
import type { ReadNow, SiteFiles } from './site_files.ts';
import type { ThreadMemory } from './thread_waits.ts';
import type { Rest } from './turns.ts';
import { inputReader } from './standard_input.ts';
import { bridgeTabs } from './tab_bridge.ts';

/** To a worker: what to run. */
export interface WorkerStart {
  readonly module: WebAssembly.Module;
  /** Of a Python program, whose module is Pyodide's. */
  readonly python: PythonStart | undefined;
  readonly ticket: LinkTicket;
  readonly id: string;
  readonly arguments: readonly string[];
  readonly environment: Readonly<Record<string, string>>;
  readonly files: SiteFiles;
  readonly thread?: ThreadStart;
  /** Of a stepped run: one participant runs at a time, and random numbers come from the seed. */
  readonly stepped: { readonly seed: number } | undefined;
  /** Every message that the program sends is told. */
  readonly traced: boolean;
}

/** From a worker. */
export type WorkerReport =
  | { readonly t: 'running' }
  /** The program waits for the first time: it has made its nodes and spins, or sleeps. */
  | { readonly t: 'waits' }
  /** What the program makes of its standard input. */
  | { readonly t: 'terminal'; readonly mode: TerminalMode }
  | { readonly t: 'lines'; readonly lines: readonly SentLine[]; readonly dropped: number }
  /** The program has written a file and closed it. `at`: when, by the time that all workers share, in ns. */
  | { readonly t: 'file'; readonly path: string; readonly bytes: Uint8Array<ArrayBuffer>; readonly at: number }
  /** What the kernel of a notebook says, as JSON. */
  | { readonly t: 'event'; readonly event: string }
  | { readonly t: 'thread'; readonly request: ThreadRequest; readonly memory: WebAssembly.Memory }
  /** What the page needs to tell the threads of a program of a change of time. */
  | { readonly t: 'memory'; readonly memory: ThreadMemory }
  /** A stepped run: it waits for its turn. */
  | { readonly t: 'rest'; readonly rest: Rest }
  | { readonly t: 'sent'; readonly message: SentMessage }
  /** What an order to make an image came to; undefined: there can be none. */
  | { readonly t: 'image'; readonly image: Blob | undefined }
  /** The image that the start named cannot be opened; the program began without it. */
  | { readonly t: 'broken_image' }
  /** What an order to evaluate a launch file came to. */
  | { readonly t: 'launch'; readonly answer?: unknown; readonly failed?: string }
  /** The program has read that source of the workspace, for the first time. */
  | { readonly t: 'source'; readonly path: string }
  /** `closed`: the worker took leave of the graph. */
  | { readonly t: 'end'; readonly end: ProgramEnd; readonly closed: boolean };

/** In a browser, before all orders: the lock to hold as long as the worker lives (worker_life.ts), and files that lie
 * elsewhere than beside site.json, by the addresses that they would have there. */
export interface HoldOrder {
  readonly t: 'hold';
  readonly life: string;
  readonly files?: ReadonlyMap<string, WorkerFile> | undefined;
}

export type WorkerOrder =
  /** Loads what runs Python while its program and archives are on their way. `base`, `home`: as in PythonStart. */
  | { readonly t: 'python'; readonly base: string; readonly home: string }
  | { readonly t: 'start'; readonly start: WorkerStart }
  /** Runs no program, but makes what Python programs begin with. */
  | { readonly t: 'image'; readonly module: WebAssembly.Module; readonly start: ImageStart }
  /** Runs no program, but evaluates the launch file; `running` is told when Python begins. */
  | { readonly t: 'launch'; readonly module: WebAssembly.Module; readonly start: LaunchStart }
  /** Runs no program, but carries to and from another tab. */
  | { readonly t: 'bridge'; readonly ticket: LinkTicket; readonly channel: string };

async function runStart(start: WorkerStart, host: ProgramHost, place: WorkerPlace, reports: PythonReports): Promise<ProgramEnd> {
  const { module, python, thread } = start;
  if (python === undefined) return runProgram(module, host, thread);
  let runtime: PythonRuntime;
  try {
    runtime = await place.python(python.base);
  } catch (error) {
    return { kind: 'crash', code: 'R2W0706', message: error instanceof Error ? error.message : String(error) };
  }
  return runtime.run(module, python, host, place.files, reports);
}

/** What a worker has beside its messages. */
export interface WorkerPlace {
  readonly files: WorkerFiles;
  /** Fetched only for a node that is a Python program. `base`: as in PythonStart. */
  readonly python: (base: string) => Promise<PythonRuntime>;
  /** A way to other tabs; for orders to bridge alone. */
  readonly openChannel: (name: string) => BroadcastChannel;
}

/** Connects the worker's messages with a program. Returns what to call with each message. */
export function serveWorker(
  post: (report: WorkerReport) => void, readNow: ReadNow, place: WorkerPlace,
): (order: WorkerOrder) => void {
  const run = async (start: WorkerStart): Promise<void> => {
    let link: Link;
    try {
      const rest = (of: Rest): void => post({ t: 'rest', rest: of });
      link = openLink(start.ticket, true, start.stepped === undefined ? undefined : rest);
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      post({ t: 'end', end: { kind: 'crash', code: 'R2W0709', message }, closed: false });
      return;
    }
    const console = new ConsoleSender(link, (lines, dropped) => post({ t: 'lines', lines, dropped }));
    let waited = start.thread !== undefined;
    const typed = inputReader(link, start.id);
    let mode: TerminalMode = TerminalMode.cooked;
    let toldMode: TerminalMode = mode;
    // Programs change it before and after each key: what it is between two looks at the input is nobody's concern.
    const tellMode = (): void => {
      if (mode === toldMode) return;
      toldMode = mode;
      post({ t: 'terminal', mode });
    };
    if (start.thread === undefined) post({ t: 'running' });
    link.awaitTurn?.();
    const host: ProgramHost = {
      link,
      arguments: start.arguments,
      environment: start.environment,
      line: (stream, text) => console.line(stream, text),
      idle: () => {
        tellMode();
        console.flush();
        if (waited) return;
        waited = true;
        post({ t: 'waits' });
      },
      input: {
        read: (capacity) => {
          tellMode();
          return typed.read(capacity);
        },
        arrives: (milliseconds) => {
          tellMode();
          return typed.arrives(milliseconds);
        },
      },
      terminal: (now) => {
        mode = now;
      },
      files: start.files,
      readNow,
      random: start.stepped === undefined ? undefined : seededRandom(start.stepped.seed, start.id),
      tell: (event) => {
        link.consoleCredit.posted();
        post({ t: 'event', event });
        return link.consoleCredit.ahead();
      },
      give: (path, bytes) => {
        link.consoleCredit.posted();
        post({ t: 'file', path, bytes, at: realNanoseconds() });
      },
      sent: start.traced ? (message) => post({ t: 'sent', message }) : undefined,
      loaded: (memory) => post({ t: 'memory', memory }),
      stepped: start.stepped !== undefined,
      startThread: (request, memory) => post({ t: 'thread', request, memory }),
    };
    const end = await runStart(start, host, place, {
      broken: () => post({ t: 'broken_image' }),
      read: (path) => post({ t: 'source', path }),
    });
    // A program that ended by itself takes leave, so that what it sent last is still delivered.
    if (end.kind === 'exit') link.close();
    console.flush();
    post({ t: 'end', end, closed: end.kind === 'exit' });
  };
  const makeImage = async (module: WebAssembly.Module, start: ImageStart): Promise<void> => {
    let image: Blob | undefined;
    try {
      image = await (await place.python(start.base)).makeImage(module, start, place.files);
    } catch {
      // Nodes start without it.
    }
    post({ t: 'image', image });
  };
  const evaluate = async (module: WebAssembly.Module, start: LaunchStart): Promise<void> => {
    try {
      const runtime = await place.python(start.base);
      const answer = await runtime.runLaunch(module, start, place.files, readNow, () => post({ t: 'running' }));
      post({ t: 'launch', answer });
    } catch (error) {
      post({ t: 'launch', failed: error instanceof Error ? error.message : String(error) });
    }
  };
  const loadPython = async (base: string, home: string): Promise<void> => {
    try {
      await place.python(base);
      await place.files.pyodide(base + home);
    } catch {
      // What needs it tries again, and tells.
    }
  };
  return (order) => {
    switch (order.t) {
      case 'python':
        void loadPython(order.base, order.home);
        return;
      case 'launch':
        void evaluate(order.module, order.start);
        return;
      case 'image':
        void makeImage(order.module, order.start);
        return;
      case 'start':
        void run(order.start);
        return;
      case 'bridge':
        void bridgeTabs(order.ticket, place.openChannel(order.channel));
        return;
    }
  };
}
