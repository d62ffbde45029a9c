// Entry of every node worker and thread worker, in browsers and (through node_thread.ts) under Node.js.

import { TerminalMode } from '../../protocol/generated/constants.ts';
import { realNanoseconds } from '../bus/clock.ts';
import { ConsoleSender } from '../bus/console_sender.ts';
import type { Link } from '../bus/link.ts';
import { openLink } from '../bus/open_link.ts';
import { type ProgramEnd, type ProgramHost, runProgram } from '../program/program.ts';
import type { LaunchStart } from '../python/launch_run.ts';
import type { ImageStart } from '../python/python_image.ts';
import type { PythonReports, PythonRuntime } from '../python/python_program.ts';
import type { WorkerFiles } from '../python/worker_files.ts';
import { seededRandom } from '../contract/seeded_random.ts';
import type { ReadNow } from '../program/site_files.ts';
import type { Rest } from '../bus/turns.ts';
import { inputReader } from '../program/standard_input.ts';
import { bridgeTabs } from '../bus/tab_bridge.ts';
import type { WorkerOrder, WorkerReport, WorkerStart } from './worker_messages.ts';

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

/** The functions that a worker has besides its messages. */
export interface WorkerPlace {
  readonly files: WorkerFiles;
  /** Fetched only for a node that is a Python program. `base`: as in PythonStart. */
  readonly python: (base: string) => Promise<PythonRuntime>;
  /** A way to other tabs; for orders to bridge alone. */
  readonly openChannel: (name: string) => BroadcastChannel;
}

/** Connects the worker's messages with a program. Returns what to call with each message. */
export function serveWorker(
  post: (report: WorkerReport) => void,
  readNow: ReadNow,
  place: WorkerPlace,
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
      // The node that needs it tries again, and reports the error.
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
