// Compiles the small programs of the loader's tests with the site's compiler; results are kept between runs.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const include = join(root, 'runtime/packages/client/ros2wasm_core/include');
const core = join(root, 'runtime/packages/client/ros2wasm_core/src');
const threadSupport = join(root, 'templates/toolchain/src/thread_support.cpp');
const exceptionContext = join(root, 'templates/toolchain/include/ros2wasm/exception_context.h');

const compile = ['-O2', '-fwasm-exceptions', '-pthread', `-I${include}`];
const link = ['-O2', '--profiling-funcs', '-fwasm-exceptions', '-sALLOW_MEMORY_GROWTH=1', '-sERROR_ON_UNDEFINED_SYMBOLS=0', '-sWARN_ON_UNDEFINED_SYMBOLS=0',
  '-Wno-pthreads-mem-growth', '-Wl,--export-if-defined=__cpp_exception', '-Wl,--export-if-defined=ros2wasm_exception_what',
  '-Wl,--export-if-defined=ros2wasm_thread_stack', '-Wl,--export-if-defined=ros2wasm_timed_waits',
  ...['read', 'write', 'seek', 'close', 'is_open'].map((call) => `-Wl,--export-if-defined=ros2wasm_fd_${call}`)];

export interface ProgramKind {
  readonly threads?: boolean;
}

/** Path of the compiled program. */
export function buildProgram(name: string, { threads = false }: ProgramKind = {}): string {
  const source = join(root, 'tests/unit/site/programs', name);
  const extra = [join(core, 'exception_what.cpp'), ...(threads ? [threadSupport] : [])];
  const sources = name.endsWith('.cpp') ? [source, ...extra] : [source];
  const hash = createHash('sha256').update(JSON.stringify([compile, link, threads, 'with last words']));
  for (const file of [...sources, join(include, 'ros2wasm/host.h')]) hash.update(readFileSync(file));
  const folder = join(tmpdir(), 'ros2wasm-test-programs', hash.digest('hex').slice(0, 16));
  const wasm = join(folder, 'program.wasm');
  if (existsSync(wasm)) return wasm;
  const work = `${folder}.${process.pid}`;
  mkdirSync(work, { recursive: true });
  const run = (command: string, args: readonly string[]): void => {
    // The compiler's own wasm-opt, as in pack's links, not the one that npm brings.
    const env = { ...process.env, NODE_PATH: '/usr/share/nodejs', PATH: `/usr/bin:${process.env['PATH'] ?? ''}` };
    execFileSync(command, args, { env, stdio: ['ignore', 'ignore', 'inherit'] });
  };
  const objects = sources.map((file, i) => {
    const object = join(work, `${i}.o`);
    const cpp = file.endsWith('.cpp');
    const context = ['-std=c++17', '-include', exceptionContext];
    run(cpp ? 'em++' : 'emcc', [...compile, ...(cpp ? context : []), '-c', file, '-o', object]);
    return object;
  });
  const kind = threads
    ? ['-pthread', '-sMAXIMUM_MEMORY=1GB', '-o', join(work, 'program.js')]
    : ['-sSTANDALONE_WASM', '-o', join(work, 'program.wasm')];
  run('em++', [...link, ...(name.endsWith('.cpp') ? ['-Wl,--wrap=abort,--wrap=_Unwind_RaiseException'] : []), ...objects, ...kind]);
  try {
    renameSync(work, folder);
  } catch (error) {
    // Another test has built the same meanwhile.
    if (!existsSync(wasm)) throw error;
    rmSync(work, { recursive: true });
  }
  return wasm;
}
