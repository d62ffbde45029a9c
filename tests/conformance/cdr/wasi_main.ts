// Runs a WASI program with this process's stdin and stdout: `node wasi_main.ts PROGRAM.wasm`.
import { readFileSync } from 'node:fs';
import { WASI } from 'node:wasi';

const [, , program] = process.argv;
if (program === undefined) throw new Error('usage: wasi_main.ts PROGRAM.wasm');
const wasi = new WASI({ version: 'preview1', args: [program], env: {}, returnOnExit: true });
const module = new WebAssembly.Module(readFileSync(program));
const instance = new WebAssembly.Instance(module, {
  wasi_snapshot_preview1: wasi.wasiImport,
  env: { emscripten_notify_memory_growth: () => undefined },
});
process.exitCode = wasi.start(instance);
