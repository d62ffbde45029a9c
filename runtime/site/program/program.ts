// Loads and runs one program (kind "cpp"): gives it its imports, and tells how it ended. Works in a worker that may
// block (shared link), or suspends the program instead (port link).

import { protocolVersion, type TerminalMode } from '../../protocol/generated/constants.ts';
import { envImports, type ThreadRequest } from './env_imports.ts';
import { hostImports, suspendingHost } from './host_imports.ts';
import { LineWriter } from './line_writer.ts';
import type { Link } from '../bus/link.ts';
import type { DiagnosticCode } from '../contract/diagnostic_codes.ts';
import type { SentMessage } from './message_trace.ts';
import { outputGate } from './output_gate.ts';
import type { ProgramExports } from './program_exports.ts';
import { ProgramMemory } from './program_memory.ts';
import { fileImports, type ReadNow, type SiteFiles } from './site_files.ts';
import type { ThreadMemory } from './thread_waits.ts';
import { trap, unwound } from './trap.ts';
import { type Input, type Leave, ProgramExit, suspendingWasi, wasiImports } from './wasi.ts';

export type ProgramEnd =
  /** A thread that came to its end; the program goes on. */
  | { readonly kind: 'thread'; }
  | { readonly kind: 'exit'; readonly code: number; }
  | { readonly kind: 'crash'; readonly code: DiagnosticCode; readonly message: string; };

export interface ProgramHost {
  readonly link: Link;
  readonly arguments: readonly string[];
  readonly environment: Readonly<Record<string, string>>;
  /** A complete line. */
  readonly line: (stream: 'stdout' | 'stderr', text: string) => void;
  /** The program is about to wait. */
  readonly idle: () => void;
  readonly input: Input;
  /** The program sets what it makes of its input. */
  readonly terminal: (mode: TerminalMode) => void;
  readonly files: SiteFiles;
  readonly readNow: ReadNow;
  /** Fills bytes; undefined: with the browser's random numbers. */
  readonly random: ((bytes: Uint8Array) => void) | undefined;
  /** The kernel of a notebook tells the page something; returns how much of it the page has not dealt with yet. */
  readonly tell: (event: string) => number;
  /** The program has written a file and closed it. The bytes are a copy. */
  readonly give: (path: string, bytes: Uint8Array<ArrayBuffer>) => void;
  /** A message was sent. */
  readonly sent: ((message: SentMessage) => void) | undefined;
  /** In a stepped run programs with threads are refused. */
  readonly stepped: boolean;
  /** A program with threads is about to run; what its timed waits are listed in. */
  readonly loaded: (memory: ThreadMemory) => void;
  readonly startThread: (request: ThreadRequest, memory: WebAssembly.Memory) => void;
}

/** The data that a thread's worker gets: the request, and the memory that it shares with its program. */
export interface ThreadStart extends ThreadRequest {
  readonly memory: WebAssembly.Memory;
}

interface SuspendingConstructor {
  new(f: (...args: never[]) => unknown): WebAssembly.ImportValue;
}

/** JavaScript Promise Integration, as far as this engine has it. */
export function promiseIntegration(): {
  readonly suspending: SuspendingConstructor;
  readonly promising: (f: () => unknown) => () => Promise<unknown>;
} | undefined {
  const wasm = WebAssembly as unknown as {
    Suspending?: SuspendingConstructor;
    promising?: (f: () => unknown) => () => Promise<unknown>;
  };
  if (wasm.Suspending === undefined || wasm.promising === undefined) return undefined;
  return { suspending: wasm.Suspending, promising: wasm.promising.bind(WebAssembly) };
}

/** Does the program bring threads? */
export function isThreaded(module: WebAssembly.Module): boolean {
  return WebAssembly.Module.imports(module).some(({ module: from, kind }) => from === 'env' && kind === 'memory');
}

/** The browser gives at most 64 KiB at once, and none into shared memory. */
function trulyRandom(bytes: Uint8Array): void {
  for (let at = 0; at < bytes.length; at += 65536) crypto.getRandomValues(bytes.subarray(at, at + 65536) as Uint8Array<ArrayBuffer>);
}

const maxThreadedPages = 16384;

function withMemory(env: WebAssembly.ModuleImports | undefined, memory: WebAssembly.Memory): WebAssembly.ModuleImports {
  return new Proxy(env ?? {}, { get: (target, name) => (name === 'memory' ? memory : Reflect.get(target, name)) });
}

/** The memory that a threaded program imports. The module does not tell how much it needs: try upwards. */
export function instantiateThreaded(
  module: WebAssembly.Module,
  imports: WebAssembly.Imports,
  shared: WebAssembly.Memory | undefined,
  use: (memory: WebAssembly.Memory) => void,
): WebAssembly.Instance {
  for (let initial = 256;; initial *= 2) {
    const memory = shared ?? new WebAssembly.Memory({ initial, maximum: maxThreadedPages, shared: true });
    use(memory);
    try {
      return new WebAssembly.Instance(module, { ...imports, env: withMemory(imports['env'], memory) });
    } catch (error) {
      if (!(error instanceof WebAssembly.LinkError) || shared !== undefined || initial >= maxThreadedPages) throw error;
    }
  }
}

function crash(code: DiagnosticCode, message: string): ProgramEnd {
  return { kind: 'crash', code, message };
}

/** Imports that nobody supplies, or undefined. */
function unknownImports(module: WebAssembly.Module, imports: WebAssembly.Imports): string | undefined {
  const missing = WebAssembly.Module.imports(module)
    .filter(({ module: from, name, kind }) => kind !== 'memory' && imports[from]?.[name] === undefined)
    .map(({ module: from, name }) => `${from}.${name}`);
  return missing.length === 0 ? undefined : missing.join(', ');
}

/** Runs the program's main, or one of its threads, to its end. */
export async function runProgram(
  module: WebAssembly.Module,
  host: ProgramHost,
  thread?: ThreadStart,
): Promise<ProgramEnd> {
  const threaded = isThreaded(module);
  const suspend = host.link.kind === 'port' ? promiseIntegration() : undefined;
  if (threaded && host.link.kind === 'port') {
    return crash('R2W0704', 'the program uses threads, and this page has no shared memory for them');
  }
  if (threaded && host.stepped) {
    return crash('R2W0711', 'the program uses threads, and a stepped run cannot say in which order they run');
  }
  if (host.link.kind === 'port' && suspend === undefined) {
    return crash('R2W0705', 'this browser can neither share memory with this page nor suspend a program');
  }

  let memory: ProgramMemory | undefined;
  const getMemory = (): ProgramMemory => {
    if (memory === undefined) throw new TypeError('the program calls out before it has a memory');
    return memory;
  };
  const out = { stdout: new LineWriter((l) => host.line('stdout', l)), stderr: new LineWriter((l) => host.line('stderr', l)) };
  let instance: WebAssembly.Instance | undefined;
  const exports = (): ProgramExports => {
    if (instance === undefined) throw new TypeError('the program calls out before it is loaded');
    return instance.exports as unknown as ProgramExports;
  };

  const gate = outputGate(host);
  let left: ProgramExit | Error | undefined;
  const leave: Leave = (reason) => {
    left = reason;
    return trap();
  };
  const random = host.random ?? trulyRandom;
  const wasi = wasiImports({
    leave,
    random,
    memory: getMemory,
    arguments: host.arguments,
    environment: host.environment,
    clock: host.link.clock,
    write: (stream, bytes) => out[stream].write(bytes),
    input: {
      read: (capacity) => {
        // Prompts end without a newline, so the output is flushed before the read.
        out.stdout.flush();
        out.stderr.flush();
        host.idle();
        return host.input.read(capacity);
      },
      arrives: (milliseconds) => {
        host.idle();
        return host.input.arrives(milliseconds);
      },
    },
    sleep: (milliseconds) => {
      host.idle();
      return host.link.sleep(milliseconds);
    },
    files: exports,
  });
  const wrap = (functions: Record<string, (...args: never[]) => unknown>, names: ReadonlySet<string>) =>
    Object.fromEntries(
      Object.entries(functions).map(([name, f]) => [name, suspend !== undefined && names.has(name) ? new suspend.suspending(f) : f]),
    ) as WebAssembly.ModuleImports;
  let detached = false;
  const env = envImports({
    leave,
    farewell: () => farewell(exports()),
    memory: getMemory,
    exports,
    startThread: (request) => host.startThread(request, getMemory().memory),
    random,
    threaded,
    clock: host.link.clock,
    program: host.arguments[0] ?? '',
    tell: (line) => {
      out.stderr.flush();
      host.line('stderr', line);
    },
    detach: () => {
      detached = true;
    },
  });
  const imports: WebAssembly.Imports = {
    ros2wasm: wrap({
      ...hostImports(host.link, getMemory, host.idle, host.terminal, host.sent),
      ...fileImports(host.files, host.readNow, getMemory, host.give, gate),
    }, suspendingHost),
    wasi_snapshot_preview1: wrap(wasi, suspendingWasi),
    env: env as WebAssembly.ModuleImports,
  };

  const unknown = unknownImports(module, imports);
  if (unknown !== undefined) {
    return crash('R2W0703', `the program asks for functions that this runtime (protocol ${protocolVersion}) has not: ${unknown}`);
  }

  let end: ProgramEnd;
  try {
    if (threaded) {
      instance = instantiateThreaded(module, imports, thread?.memory, (made) => {
        memory = new ProgramMemory(made);
      });
      const waits = exports().ros2wasm_timed_waits?.();
      if (thread === undefined && waits !== undefined) host.loaded({ memory: getMemory().memory, waits });
    } else {
      instance = new WebAssembly.Instance(module, imports);
      const own = exports().memory;
      if (own === undefined) return crash('R2W0703', 'the program exports no memory');
      memory = new ProgramMemory(own);
    }
    if (thread !== undefined) runThread(exports(), thread, () => detached);
    else if (suspend !== undefined) await suspend.promising(exports()._start as () => unknown)();
    else runMain(exports(), getMemory(), host.arguments);
    end = thread === undefined ? { kind: 'exit', code: 0 } : { kind: 'thread' };
  } catch (error) {
    end = explain(left ?? error, instance === undefined ? undefined : exports(), memory);
  }
  if (end.kind !== 'thread' && instance !== undefined) {
    gate.end();
    try {
      exports().ros2wasm_files_rest?.(end.kind === 'exit' ? 1 : 0);
    } catch {
      // There is no memory for a copy, or the program has left its own in disorder.
    }
  }
  out.stdout.flush();
  out.stderr.flush();
  return end;
}

function runMain(exports: ProgramExports, memory: ProgramMemory, args: readonly string[]): void {
  if (exports._start !== undefined) {
    exports._start();
    return;
  }
  if (exports.main === undefined) throw new TypeError('the program exports neither _start nor main');
  exports.__wasm_call_ctors?.();
  const texts = args.map((text) => memory.encode(`${text}\0`));
  const argv = exports.malloc(4 * (texts.length + 1));
  texts.forEach((bytes, i) => {
    const at = exports.malloc(bytes.length);
    memory.u8.set(bytes, at);
    memory.set(argv + 4 * i, at);
  });
  memory.set(argv + 4 * texts.length, 0);
  const code = exports.main(texts.length, argv);
  farewell(exports);
  throw new ProgramExit(code);
}

/**
 * As exit() of a C library does: functions of atexit(), then unflushed output. Not by musl's __stdio_exit, which
 * waits for a thread that reads standard input.
 */
function farewell(exports: ProgramExports): void {
  exports.__funcs_on_exit?.();
  exports.fflush?.(0);
}

const lastStack = 16384;

function runThread(exports: ProgramExports, thread: ThreadStart, detached: () => boolean): void {
  const useStack = (top: number, size: number): void => {
    exports.emscripten_stack_set_limits?.(top, top - size);
    exports.stackRestore(top);
  };
  useStack(thread.stackTop, thread.stackSize);
  exports._emscripten_thread_init?.(thread.thread, 0, 0, 1);
  exports.emscripten_tls_init?.();
  const entry = exports.__indirect_function_table.get(thread.entry) as ((argument: number) => number) | null;
  if (entry === null) throw new TypeError('the thread has no entry');
  try {
    exports._emscripten_thread_exit?.(entry(thread.argument));
  } catch (error) {
    if (error !== unwound) throw error;
  }
  if (!detached()) return;
  // Nobody joins it: it frees its own stack and control block, standing on a small stack that stays.
  useStack((exports.malloc(lastStack) + lastStack) & -16, lastStack - 16);
  exports._emscripten_thread_free_data?.(thread.thread);
}

/** How a throw out of the program reads in the crash report. */
function explain(error: unknown, exports: ProgramExports | undefined, memory: ProgramMemory | undefined): ProgramEnd {
  if (error instanceof ProgramExit) return { kind: 'exit', code: error.code };
  if (error instanceof WebAssembly.Exception) {
    return crash('R2W0702', exceptionText(error, exports, memory) ?? 'an exception left the program');
  }
  if (error instanceof WebAssembly.LinkError || error instanceof WebAssembly.CompileError) {
    return crash('R2W0703', error.message);
  }
  if (error instanceof RangeError && exports === undefined) {
    return crash('R2W0710', 'there is no memory for one more program');
  }
  if (error instanceof RangeError && /stack/i.test(error.message)) {
    return crash('R2W0701', 'the stack is full: too deep a recursion?');
  }
  if (error instanceof Error) {
    const where = frames(error.stack ?? '');
    return crash('R2W0701', where === '' ? error.message : `${error.message}\n${where}`);
  }
  return crash('R2W0701', String(error));
}

function exceptionText(
  error: WebAssembly.Exception,
  exports: ProgramExports | undefined,
  memory: ProgramMemory | undefined,
): string | undefined {
  const tag = exports?.__cpp_exception;
  const what = exports?.ros2wasm_exception_what;
  if (exports === undefined || tag === undefined || what === undefined || memory === undefined || !error.is(tag)) return undefined;
  try {
    const capacity = 4096;
    const at = exports.malloc(capacity);
    const length = what(error.getArg(tag, 0) as number, at, capacity);
    return memory.text(at, Math.min(length, capacity));
  } catch {
    // A program that throws while it describes its exception gets the short report.
    return undefined;
  }
}

/** The wasm frames of a stack trace, as function names or code offsets. */
function frames(stack: string): string {
  return stack.split('\n')
    .filter((line) => line.includes('wasm-function['))
    .slice(0, 12)
    .map((line) => `  ${line.trim().replace(/\(?(wasm|blob|https?):\S*?(wasm-function\[\d+\]:0x[0-9a-f]+)\)?/, '($2)')}`)
    .join('\n');
}
