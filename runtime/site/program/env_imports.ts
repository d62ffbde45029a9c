// Module "env": what Emscripten's C library wants from its JavaScript side. A single-threaded program needs next to
// nothing of it; a threaded one its thread functions. Thread workers are started by the page: this worker may block.

import type { SiteClock } from '../bus/clock.ts';
import { timeImports } from './env_time.ts';
import type { ProgramMemory } from './program_memory.ts';
import type { ProgramExports } from './program_exports.ts';
import { type Leave, ProgramExit } from './wasi.ts';
import { unwound } from './trap.ts';

/** The data with which the page starts a thread of a program. */
export interface ThreadRequest {
  /** Address of the thread's control block. */
  readonly thread: number;
  /** Index of the function in the program's table, and its argument. */
  readonly entry: number;
  readonly argument: number;
  readonly stackTop: number;
  readonly stackSize: number;
}

export interface EnvHost {
  readonly memory: () => ProgramMemory;
  readonly exports: () => ProgramExports;
  readonly startThread: (request: ThreadRequest) => void;
  readonly leave: Leave;
  /** Before a program with threads leaves: what it has registered for its end. */
  readonly farewell: () => void;
  readonly threaded: boolean;
  readonly clock: SiteClock;
  readonly random: (bytes: Uint8Array) => void;
  /** As the program's first argument says it: `program_invocation_name`. */
  readonly program: string;
  /** A line for the node's console. */
  readonly tell: (line: string) => void;
  /** The calling thread has ended and nobody will join it. */
  readonly detach: () => void;
}

const enosys = -52;
const eagain = 6;
const threadStackSize = 2 << 20;

type EnvFunction = (...args: never[]) => unknown;

export function envImports(host: EnvHost): Record<string, EnvFunction> {
  const { memory, exports } = host;
  const told = new Set<string>();
  const absent = (call: string): void => {
    if (told.has(call)) return;
    told.add(call);
    host.tell(`R2W0761: ${call} failed: a browser has no such thing (ros2wasm explain R2W0761)`);
  };
  const single: Record<string, EnvFunction> = {
    emscripten_notify_memory_growth: () => undefined,
    getentropy: (address: number, length: number): number => {
      const bytes = new Uint8Array(length);
      host.random(bytes);
      memory().u8.set(bytes, address);
      return 0;
    },
    system: (command: number): number => {
      // Without a command it asks whether there is a shell.
      if (command === 0) return 0;
      absent(`system(${JSON.stringify(memory().cString(command))})`);
      return -1;
    },
    _emscripten_get_progname: (out: number, capacity: number): void => {
      const text = new TextEncoder().encode(host.program).subarray(0, Math.max(0, capacity - 1));
      memory().u8.set(text, out);
      memory().u8[out + text.length] = 0;
    },
    abort: (): never => host.leave(new WebAssembly.RuntimeError('abort() was called (SIGABRT, exit code 134)')),
    exit: (code: number): never => {
      host.farewell();
      return host.leave(new ProgramExit(code));
    },
    emscripten_memcpy_big: (to: number, from: number, length: number): number => {
      memory().u8.copyWithin(to >>> 0, from >>> 0, (from >>> 0) + (length >>> 0));
      return to;
    },
    emscripten_get_now: (): number => host.clock.steadyNs() / 1e6,
    emscripten_date_now: (): number => Math.floor(host.clock.systemNs() / 1e6),
    _emscripten_get_now_is_monotonic: (): number => 1,
    emscripten_get_heap_max: (): number => 1 << 30,
    setTempRet0: () => undefined,
    getTempRet0: (): number => 0,
    __assert_fail: (condition: number, file: number, line: number, name: number): never => {
      const text = `${memory().cString(file)}:${line}: ${name === 0 ? '' : `${memory().cString(name)}: `}`;
      return host.leave(new WebAssembly.RuntimeError(`${text}Assertion \`${memory().cString(condition)}' failed.`));
    },
  };
  const threads: Record<string, EnvFunction> = {
    emscripten_resize_heap: (size: number): number => growTo(memory(), size >>> 0),
    __pthread_create_js: (thread: number, _attributes: number, entry: number, argument: number): number => {
      const stackOf = exports().ros2wasm_thread_stack;
      if (stackOf === undefined) return eagain;
      const out = exports().malloc(8);
      stackOf(thread, out);
      const stackTop = memory().u32(out);
      const stackSize = memory().u32(out + 4);
      exports().free(out);
      host.startThread({ thread, entry, argument, stackTop, stackSize });
      return 0;
    },
    __emscripten_init_main_thread_js: (thread: number): void => {
      exports()._emscripten_thread_init?.(thread, 0, 1, 1);
      exports().emscripten_tls_init?.();
    },
    // Called for a thread by the one that joined it, or by a detached thread for itself.
    __emscripten_thread_cleanup: (thread: number): void => {
      if (thread === exports().pthread_self?.()) {
        host.detach();
        return;
      }
      exports()._emscripten_thread_free_data?.(thread);
    },
    emscripten_unwind_to_js_event_loop: (): never => {
      // Nothing but a marker: the thread's frames are left behind on purpose.
      throw unwound as unknown as Error;
    },
    _emscripten_default_pthread_stack_size: (): number => threadStackSize,
    _emscripten_notify_thread_queue: (): number => 0,
    emscripten_check_blocking_allowed: () => undefined,
    emscripten_receive_on_main_thread_js: (): number => 0,
    emscripten_has_threading_support: (): number => 1,
    emscripten_num_logical_cores: (): number => Math.max(2, navigator.hardwareConcurrency),
  };
  const functions = { ...single, ...(host.threaded ? { ...timeImports(memory, host.clock), ...threads } : {}) };
  // System calls that this C library leaves to JavaScript: none of them is there, and the first of each is told. A
  // program whose own code asks for what matters most of them is refused when it is linked (browser_limits.cpp).
  return new Proxy(functions, {
    get: (target, name) => {
      if (typeof name !== 'string') return undefined;
      const known = target[name];
      if (known !== undefined) return known;
      if (name.startsWith('__syscall_')) {
        return () => {
          absent(`${name.slice('__syscall_'.length)}()`);
          return enosys;
        };
      }
      if (/^(emscripten_webgl_|emscripten_set_|emscripten_gl|gl)[A-Za-z_]+$/.test(name)) return () => -1;
      return undefined;
    },
  });
}

function growTo(memory: ProgramMemory, bytes: number): number {
  const more = bytes - memory.u8.length;
  if (more <= 0) return 1;
  return memory.grow(Math.max(more, Math.min(memory.u8.length, 16 << 20))) || memory.grow(more) ? 1 : 0;
}
