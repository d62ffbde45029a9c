// Runs the benchmarks and prints one JSON object a line. Figures are medians of several runs; each line
// names its peer, measured in the same run on the same machine. Nothing here judges.
//   node tests/bench/run.ts --build BUILD_DIR [NAME ...]
import { resolve } from 'node:path';
import { benchCrowd } from './crowd.ts';
import { benchFetch } from './fetch.ts';
import { benchLink } from './link.ts';
import { benchPack } from './pack.ts';
import { benchSolve } from './solve.ts';
import { benchBytes } from './site_bytes.ts';
import { benchStart } from './site_start.ts';

export interface BenchContext {
  /** Absolute path of the build directory (ros2wasm, runtime/, channel/). */
  readonly build: string;
  /** Absolute path of the checkout. */
  readonly root: string;
  /** Prints one result line. */
  emit(line: Readonly<Record<string, unknown>>): void;
}

const BENCHES: Readonly<Record<string, (context: BenchContext) => Promise<void> | void>> = {
  bytes: benchBytes,
  crowd: benchCrowd,
  fetch: benchFetch,
  link: benchLink,
  pack: benchPack,
  solve: benchSolve,
  start: benchStart,
};

const words = process.argv.slice(2);
const at = words.indexOf('--build');
const build = resolve(at >= 0 ? (words[at + 1] ?? 'build') : 'build');
const names = words.filter((_, index) => at < 0 || (index !== at && index !== at + 1));
const unknown = names.filter((name) => !(name in BENCHES));
if (unknown.length > 0) {
  console.error(`no such benchmark: ${unknown.join(', ')}; there are ${Object.keys(BENCHES).join(', ')}`);
  process.exit(2);
}
const context: BenchContext = {
  build,
  root: resolve(import.meta.dirname, '../..'),
  emit: (line) => console.log(JSON.stringify(line)),
};
for (const [name, bench] of Object.entries(BENCHES)) {
  if (names.length === 0 || names.includes(name)) await bench(context);
}
