// Solving in a channel, side by side with mambajs on the same folder and the same specs.
// Ours is always the whole run of `ros2wasm solve`, from the start of the process to its end: `parse` with an empty
// cache and a request for one package that needs nothing, `first` with an empty cache, `cached` with a kept index.
// mambajs reads and parses the index in every solve(): `parse` and `first` are whole runs of Node.js as well, `warm`
// is the solve() call alone, again and again in a process that has it all in memory.
// The real index is read from the path in ROS2WASM_BENCH_REPODATA (a repodata.json.xz), when it is set.
// SOLVE_RUNS and SOLVE_RECORDS make it smaller.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { measure } from './measured_process.ts';
import type { Measured } from './measured_process.ts';
import type { BenchContext } from './run.ts';
import { largeName, makeLargeChannel, makeRealChannel } from './solve_channels.ts';
import { summary } from './statistics.ts';
import type { Summary } from './statistics.ts';

const RUNS = Number(process.env['SOLVE_RUNS'] ?? 7);
const LARGE = { records: Number(process.env['SOLVE_RECORDS'] ?? 300_000), names: 40_000 };
const LARGE_SPECS = [600, 2_500, 9_000, 17_000, 26_000, 39_999].map(largeName);
const REAL_SPECS = ['r-essentials', 'r-shiny', 'rpy2 >=2.8'];

interface Question {
  readonly label: string;
  readonly channel: string;
  readonly records: number;
  readonly specs: readonly string[];
  /** A package of the channel that depends on nothing. */
  readonly leaf: string;
}

interface Times {
  readonly wallMs: number;
  readonly cpuMs: number;
}

interface Figures {
  readonly wall_ms: Summary;
  readonly cpu_ms: Summary;
  readonly peak_kb?: number;
}

interface Peer {
  readonly solves: readonly Times[];
  readonly packages: readonly string[];
}

function figures(runs: readonly (Times | Measured)[]): Figures {
  const times = { wall_ms: summary(runs.map((run) => run.wallMs)), cpu_ms: summary(runs.map((run) => run.cpuMs)) };
  const peaks = runs.flatMap((run) => ('peakKb' in run ? [run.peakKb] : []));
  return peaks.length === 0 ? times : { ...times, peak_kb: Math.max(...peaks) };
}

function timesFaster(ours: Figures, theirs: Figures): { readonly wall: number; readonly cpu: number; } {
  const ratio = (a: Summary, b: Summary): number => Math.round((b.median / a.median) * 10) / 10;
  return { wall: ratio(ours.wall_ms, theirs.wall_ms), cpu: ratio(ours.cpu_ms, theirs.cpu_ms) };
}

function output(program: string, words: readonly string[], environment: NodeJS.ProcessEnv): string {
  const run = spawnSync(program, words, { encoding: 'utf8', env: environment, maxBuffer: 1 << 28 });
  if (run.status !== 0) throw new Error(`${program} failed: ${run.stderr.slice(-2000)}`);
  return run.stdout;
}

/** Both sides of each ratio, printed so that no figure is taken for more than it is. */
const COMPARED = {
  parse: 'the whole process with an empty cache, one package that needs nothing | the whole process of Node.js, the same',
  first: 'the whole process with an empty cache | the whole process of Node.js',
  cached_than_first: 'the whole process with a kept index | the whole process of Node.js, which keeps none',
  cached_than_warm: 'the whole process with a kept index | solve() alone, again in one process: no start, code compiled',
};

/** Runs of both in turns, so that a machine that is busy is busy for both. */
function compare(context: BenchContext, question: Question): void {
  const { channel, specs, leaf } = question;
  const cache = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-cache-'));
  const environment = { ...process.env, XDG_CACHE_HOME: cache };
  const program = join(context.build, 'ros2wasm');
  const script = join(context.root, 'tests/bench/mambajs_solve.ts');
  const run = (command: readonly string[]): Measured => {
    const measured = measure(command, environment);
    if (measured.exitCode !== 0) throw new Error(measured.stderr);
    return measured;
  };
  const solve = (words: readonly string[]): Measured => run([program, 'solve', '--channel', channel, ...words]);
  const solveFirst = (words: readonly string[]): Measured => {
    rmSync(cache, { recursive: true, force: true });
    return solve(words);
  };
  const peer = (words: readonly string[]): Measured => run([process.execPath, script, channel, '1', ...words]);
  const runs = Array.from({ length: RUNS }, () => ({
    parse: solveFirst([leaf]),
    peerParse: peer([leaf]),
    first: solveFirst(specs),
    peerFirst: peer(specs),
    cached: solve(specs),
  }));
  const shown = output(program, ['solve', '--channel', channel, '--json', ...specs], environment);
  rmSync(cache, { recursive: true, force: true });
  const { packages } = JSON.parse(shown) as { packages: readonly { readonly name: string; readonly version: string; }[]; };
  const lines = output(process.execPath, [script, channel, String(RUNS + 1), ...specs], environment).trim().split('\n');
  const repeated = JSON.parse(lines.at(-1) ?? '') as Peer;
  const ours = {
    parse: figures(runs.map((one) => one.parse)),
    first: figures(runs.map((one) => one.first)),
    cached: figures(runs.map((one) => one.cached)),
  };
  const theirs = {
    parse: figures(runs.map((one) => one.peerParse)),
    first: figures(runs.map((one) => one.peerFirst)),
    warm: figures(repeated.solves.slice(1)),
  };
  const same = new Set(repeated.packages);
  context.emit({
    bench: 'solve',
    channel: question.label,
    records: question.records,
    specs: specs.length,
    packages: packages.length,
    peer: 'mambajs 0.21.6',
    peer_packages: repeated.packages.length,
    same: packages.filter((one) => same.has(`${one.name} ${one.version}`)).length,
    ours,
    theirs,
    compared: COMPARED,
    times_faster: {
      parse: timesFaster(ours.parse, theirs.parse),
      first: timesFaster(ours.first, theirs.first),
      cached_than_first: timesFaster(ours.cached, theirs.first),
      cached_than_warm: timesFaster(ours.cached, theirs.warm),
    },
  });
}

export function benchSolve(context: BenchContext): void {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-channels-'));
  try {
    const source = process.env['ROS2WASM_BENCH_REPODATA'];
    if (source !== undefined) {
      const channel = join(folder, 'real');
      const records = makeRealChannel(channel, source);
      compare(context, { label: 'real, zst', channel, records, specs: REAL_SPECS, leaf: '_r-mutex' });
    }
    for (const form of ['zst', 'shards'] as const) {
      const channel = join(folder, form);
      makeLargeChannel(channel, LARGE, form);
      compare(context, { label: `made, ${form}`, channel, records: LARGE.records, specs: LARGE_SPECS, leaf: largeName(0) });
      rmSync(channel, { recursive: true, force: true });
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
