// The exports of a C++ program, as its link driver and the C library name it.

import type { FileExports } from './wasi.ts';

export interface ProgramExports extends FileExports {
  readonly memory?: WebAssembly.Memory;
  readonly __indirect_function_table: WebAssembly.Table;
  readonly __cpp_exception?: WebAssembly.Tag;
  readonly _start?: () => void;
  readonly main?: (argc: number, argv: number) => number;
  readonly __wasm_call_ctors?: () => void;
  readonly malloc: (size: number) => number;
  readonly free: (address: number) => void;
  readonly stackRestore: (address: number) => void;
  readonly emscripten_stack_set_limits?: (top: number, end: number) => void;
  readonly _emscripten_thread_init?: (thread: number, main: number, runtime: number, block: number) => void;
  readonly _emscripten_thread_exit?: (result: number) => void;
  readonly _emscripten_thread_free_data?: (thread: number) => void;
  readonly emscripten_tls_init?: () => void;
  readonly pthread_self?: () => number;
  readonly ros2wasm_timed_waits?: () => number;
  readonly ros2wasm_files_rest?: (waits: number) => void;
  readonly ros2wasm_thread_stack?: (thread: number, out: number) => number;
  readonly ros2wasm_exception_what?: (exception: number, out: number, capacity: number) => number;
  readonly __funcs_on_exit?: () => void;
  readonly fflush?: (file: number) => number;
}
