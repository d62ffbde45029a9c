// Loads and runs one program of kind "python": Pyodide, the archives of Python files, the node's entry. Python calls the
// same functions as a wasm program (host_imports.ts), with addresses in Pyodide's memory.

import type { PyodideInterface } from 'pyodide';
import type { PyBuffer, PyProxy } from 'pyodide/ffi';
import { SampleInfoLayout, WaitResult } from '../../protocol/generated/constants.ts';
import { hostImports } from '../program/host_imports.ts';
import type { RunLaunch } from './launch_run.ts';
import { type FileSystem, lateFile } from '../program/late_file.ts';
import { LineWriter } from '../program/line_writer.ts';
import type { Link } from '../bus/link.ts';
import type { DiagnosticCode } from '../contract/diagnostic_codes.ts';
import { outputGate } from '../program/output_gate.ts';
import { type ProgramEnd, type ProgramHost, promiseIntegration } from '../program/program.ts';
import type { ProgramMemory } from '../program/program_memory.ts';
import type { PythonParts } from './python_files.ts';
import { type WatchedSystem, watchOutput } from './python_output.ts';
import { type LoadedPyodide, openPyodide } from './pyodide_loader.ts';
import { OpenCv } from './opencv.ts';
import { loadLibraries } from './python_libraries.ts';
import { placeSources } from './python_sources.ts';
import { Interrupts, interrupt, threadFunctions } from './python_threads.ts';
import {
  type MakePythonImage,
  addressOf,
  archivesOf,
  fetchedOf,
  install,
  prefix,
  pythonEnvironment,
  readImage,
  restoreFiles,
  startModule,
} from './python_image.ts';
import type { WorkerFiles } from './worker_files.ts';
import type { PythonProgram } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import type { SourceStart } from '../contract/site_sources.ts';
import type { Arrival } from '../program/wasi.ts';

/** The data with which a worker runs a Python program. */
export interface PythonStart extends PythonProgram {
  /** The folder of the site: a URL, or under Node.js a path; with "/" at the end. */
  readonly base: string;
  /** Pyodide's folder in the site, with "/" at the end. */
  readonly home: string;
  /** Pyodide's files, and the archives that are in no image. */
  readonly parts: PythonParts;
  /** The image with which it begins, and the number of archives in it. */
  readonly image: { readonly bytes: Blob; readonly archives: number; } | undefined;
  readonly sources: SourceStart | undefined;
}

/** The reports of a worker about a Python program, besides those about all programs. */
export interface PythonReports {
  /** The image could not be opened. */
  readonly broken: () => void;
  /** The program has read that source. */
  readonly read: (path: string) => void;
}

/** How python_worker.js is called in a browser to run a program. */
export type RunPython = (
  module: WebAssembly.Module,
  start: PythonStart,
  host: ProgramHost,
  files: WorkerFiles,
  reports: PythonReports,
) => Promise<ProgramEnd>;

/** The functions of python_worker.js. */
export interface PythonRuntime {
  readonly run: RunPython;
  readonly makeImage: MakePythonImage;
  readonly runLaunch: RunLaunch;
}

/** As Python ends when nobody catches KeyboardInterrupt. */
const interruptedCode = -interrupt;

function crash(code: DiagnosticCode, message: string): ProgramEnd {
  return { kind: 'crash', code, message };
}

/** In place of a promise, which Pyodide would wrap: `pending` has it. */
const promised = -(2 ** 31);

/** 1: input is there, 0: none is, 2: a stop came. */
function arrived(arrival: Arrival): number {
  return { input: 1, timeout: 0, stop: 2 }[arrival];
}

/** Behind the wake token and the version of the statuses: where a message is taken to, its SampleInfo, where one is sent from. */
const places = { take: 8, takeRoom: 12, info: 16, publish: 20, readers: 24 } as const;
const infoWords = SampleInfoLayout.size >> 2;

/** A message was sent, and the slice of time is over. */
const sliceOver = 1;

/**
 * A turn of an executor in one call. Writes the wake token, which is read first, and the version of the statuses, skips where
 * messages go (see places), writes the readers that have something, and returns how many. If only the expected one has, and
 * the statuses are as they were, its next message is taken: ~length.
 */
export function look(
  link: Pick<Link, 'wakeToken' | 'ready' | 'statusVersion' | 'take'>,
  heap: ProgramMemory,
  at: number,
  capacity: number,
  expected: number,
  statuses: number,
): number {
  heap.set(at, link.wakeToken());
  const ready = link.ready();
  const version = link.statusVersion() | 0;
  heap.set(at + 4, version);
  if (ready.length === 1 && ready[0] === expected && version === statuses) {
    const room = heap.u32(at + places.takeRoom);
    const length = link.take(expected, heap, heap.u32(at + places.take), room, heap.u32(at + places.info));
    if (length >= 0 && length <= room) return ~length;
  }
  const count = Math.min(ready.length, capacity);
  for (let i = 0; i < count; i += 1) heap.set(at + places.readers + 4 * i, ready[i]!);
  return count;
}

/** Copies a Python object with bytes. */
function copyOf(bytes: PyProxy): Uint8Array<ArrayBuffer> {
  const buffer = (bytes as PyBuffer).getBuffer('u8');
  try {
    return new Uint8Array(buffer.data as Uint8Array);
  } finally {
    buffer.release();
  }
}

/** For the module cv2: see OpenCv, which it opens first, with its WebAssembly. */
function openCvModule(memory: () => Uint8Array): Record<string, unknown> {
  let opened: OpenCv | undefined;
  const cv = (): OpenCv => {
    if (opened === undefined) throw new TypeError('cv2 is not open');
    return opened;
  };
  return {
    open: (wasm: PyProxy): void => {
      opened = new OpenCv(copyOf(wasm), memory);
    },
    names: () => cv().names(),
    call: (text: string) => cv().call(text),
    fetch: (id: number, address: number): void => cv().fetch(id, address),
    release: (id: number): void => cv().release(id),
    decode: (address: number, length: number) => cv().decode(address, length),
    encode: (ending: string, address: number, rows: number, cols: number, type: number, quality: number) =>
      cv().encode(ending, address, rows, cols, type, quality),
  };
}

/** The module `ros2wasm_host` of Python. */
function hostModule(
  host: ProgramHost,
  memory: () => ProgramMemory,
  stop: Interrupts,
  died: (error: unknown) => void,
  showOutput: () => void,
): Record<string, unknown> {
  const { link } = host;
  const imports = hostImports(link, memory, host.idle, host.terminal, host.sent);
  const buffers: PyBuffer[] = [];
  let pending: Promise<unknown> | undefined;
  /** Until Python is back (`resumed`) nobody interrupts it: Pyodide runs code of its own when a promise is kept. */
  const wait = (promise: Promise<unknown>): number => {
    stop.suspended = true;
    pending = promise;
    return promised;
  };
  const settled = <T>(result: T | Promise<T>): T | number => result instanceof Promise ? wait(result) : result;
  // Here and not in Python: an interrupt between the end of a suspension and Python's look at its result would be lost.
  const told = (result: number): number => result === WaitResult.stop && !stop.take() ? WaitResult.woken : result;
  const telling = (result: number | Promise<number>): number => typeof result === 'number' ? told(result) : wait(result.then(told));
  return {
    ...imports,
    wait: (token: number, low: number, high: number) => telling(imports.wait(token, low, high)),
    sleep: (low: number, high: number) => telling(imports.sleep(low, high)),
    write: (endpoint: number, data: number, length: number, info: number) => settled(imports.write(endpoint, data, length, info)),
    read_input: (capacity: number) => {
      host.idle();
      return settled(host.input.read(capacity));
    },
    input_is_there: () => {
      const there = host.input.arrives(0);
      return there instanceof Promise ? wait(there.then(arrived)) : arrived(there);
    },
    // Functions that are called for every message have one argument: each more costs Pyodide a tenth of a microsecond.
    publisher: (endpoint: number, at: number) => (length: number): number => {
      const heap = memory();
      const info = heap.u32(at + places.info);
      heap.i32.fill(0, info >> 2, (info >> 2) + infoWords);
      const result = imports.write(endpoint, heap.u32(at + places.publish), length, info);
      if (typeof result !== 'number') return wait(result);
      return result === 0 && stop.sliceIsOver() ? sliceOver : result;
    },
    hearer: (endpoint: number, at: number, capacity: number) => (statuses: number): number => look(link, memory(), at, capacity, endpoint, statuses),
    ...threadFunctions(stop, wait, died),
    look: (at: number, capacity: number, expected: number, statuses: number): number => look(link, memory(), at, capacity, expected, statuses),
    pending: () => pending,
    resumed: () => {
      stop.suspended = false;
    },
    take_stop: () => stop.take(),
    forget_stop: () => stop.forget(),
    show_output: showOutput,
    has_page: () => 'WorkerGlobalScope' in globalThis,
    tell: host.tell,
    file_give: (path: string, bytes: PyProxy): void => host.give(path, copyOf(bytes)),
    address: (bytes: PyProxy): number => addressOf(bytes, buffers),
    opencv: openCvModule(() => memory().u8),
  };
}

/** Puts the site's share files in place; the bytes of one come when it is first read, all of them or an error. */
export function mountShare(python: PyodideInterface, { files, readNow }: Pick<ProgramHost, 'files' | 'readNow'>): void {
  const system = python['FS'] as unknown as FileSystem;
  for (const [path, size] of files.files) lateFile(system, `${files.prefix}/${path}`, size, () => readNow(files.place, path));
}

/** Where Pyodide has the standard library. */
const libraryPath = '/lib/python312.zip';

/**
 * A started interpreter has imported most of what nodes use: the library's 3.3 MB come when it opens the file. undefined:
 * nobody can read it in the middle of a program here, so that it must be there at once.
 */
function lateLibrary({ base, home, parts }: PythonStart): { readonly address: string; readonly place: (system: FileSystem) => void; } | undefined {
  const path = `${home}python_stdlib.zip`;
  const blob = parts.found.get(path);
  if (blob === undefined || !('FileReaderSync' in globalThis)) return undefined;
  return {
    address: base + path,
    place: (system) => {
      system.unlink(libraryPath);
      lateFile(system, libraryPath, blob.size, () => new Uint8Array(new FileReaderSync().readAsArrayBuffer(blob)));
    },
  };
}

/** The message of the error that os._exit throws. */
const left = /^Program terminated with exit\((-?\d+)\)$/;

/** How what Python could not catch reads. */
export function failure(error: unknown): ProgramEnd {
  const message = error instanceof Error ? error.message : String(error);
  const code = left.exec(message)?.[1];
  if (code !== undefined) return { kind: 'exit', code: Number(code) };
  if (error instanceof SiteError) return crash(error.code, message);
  if (error instanceof RangeError && /stack/i.test(message)) return crash('R2W0701', 'the stack is full: too deep a recursion?');
  if (error instanceof RangeError) return crash('R2W0710', `there is no memory for one more program: ${message}`);
  return crash('R2W0701', message);
}

/**
 * An interpreter with what was unpacked: from the image, if there is one that can be opened; `broken` is told when it cannot.
 * An image that has imported what the visitor changed is none for this start.
 */
async function begin(
  module: WebAssembly.Module,
  start: PythonStart,
  host: ProgramHost,
  files: WorkerFiles,
  functions: Record<string, unknown>,
  broken: () => void,
): Promise<LoadedPyodide> {
  const home = start.base + start.home;
  const environment = pythonEnvironment(host.environment, host.files.prefix);
  const open = await files.pyodide(home);
  const options = { module, home, open, environment, place: { clock: host.link.clock, random: host.random }, toBeKept: false, fetched: fetchedOf(start) };
  const boot = async (): Promise<LoadedPyodide> => {
    const unpacked = archivesOf(start, start.archives, files);
    unpacked.catch(() => undefined);
    const opened = await openPyodide({ ...options, image: undefined });
    opened.python.registerJsModule('ros2wasm_host', functions);
    install(opened.python, await unpacked);
    return opened;
  };
  if (start.image !== undefined) {
    try {
      const more = archivesOf(start, start.archives.slice(start.image.archives), files);
      const image = await readImage(start.image.bytes);
      if (image.loaded.some((path) => start.sources?.changed.has(path))) return await boot();
      const library = lateLibrary(start);
      const opened = await openPyodide({
        ...options,
        fetched: (address) => address === library?.address ? new Blob() : options.fetched(address),
        image: { ...image, host: functions, withFiles: (system) => library?.place(system) },
      });
      await restoreFiles(opened.python, image);
      install(opened.python, await more);
      startModule(opened.python).renew(opened.python.toPy(environment));
      return opened;
    } catch {
      broken();
    }
  }
  return boot();
}

/** Runs the entry to its end. */
export const runPython: RunPython = async (module, start, host, files, reports) => {
  const suspends = promiseIntegration() !== undefined;
  if (host.link.kind === 'port' && !suspends) {
    return crash('R2W0705', 'this browser can neither share memory with this page nor suspend a program');
  }
  const out = { stdout: new LineWriter((l) => host.line('stdout', l)), stderr: new LineWriter((l) => host.line('stderr', l)) };
  const flush = (): void => {
    out.stdout.flush();
    out.stderr.flush();
  };
  const stop = new Interrupts(() => host.link.stops(), !host.stepped);
  let died: (error: unknown) => void = () => undefined;
  const death = new Promise<never>((_resolve, reject) => {
    died = reject;
  });
  // After the program's end nobody asks.
  death.catch(() => undefined);
  let memory: ProgramMemory | undefined;
  let output: ReturnType<typeof watchOutput> | undefined;
  const functions = hostModule(host, () => {
    if (memory === undefined) throw new TypeError('Python calls out before it is loaded');
    return memory;
  }, stop, died, flush);
  try {
    const begun = await begin(module, start, host, files, functions, reports.broken);
    const { python } = begun;
    ({ memory } = begun);
    if (start.sources !== undefined) placeSources(python, start.sources, reports.read);
    await loadLibraries(python, start.libraries ?? [], prefix);
    const writer = (stream: 'stdout' | 'stderr') => ({
      isatty: false,
      write: (bytes: Uint8Array): number => {
        out[stream].write(bytes.slice());
        return bytes.length;
      },
    });
    python.setStdout(writer('stdout'));
    python.setStderr(writer('stderr'));
    mountShare(python, host);
    output = watchOutput(python['FS'] as unknown as WatchedSystem, outputGate(host), host.give);
    const { run } = startModule(python);
    const args = python.toPy(host.arguments) as PyProxy;
    // A stop that came meanwhile: nothing of the user's has begun.
    if (host.link.stopRequested()) return { kind: 'exit', code: interruptedCode };
    python.setInterruptBuffer(stop as unknown as Uint8Array<ArrayBuffer>);
    const end: unknown = suspends ? Promise.race([run.callPromising(start.entry, prefix, args), death]) : run(start.entry, prefix, args);
    return { kind: 'exit', code: await end as number };
  } catch (error) {
    return failure(error);
  } finally {
    output?.rest();
    flush();
  }
};
