// Solving in a channel, side by side with mambajs on the same folder and the same specs: the whole run of
// `ros2wasm solve` with an empty cache and with a kept index, against the solve call of mambajs alone.
// The real index is read from the path in ROS2WASM_BENCH_REPODATA (a repodata.json.xz), when it is set.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { measure } from './measured_process.ts';
import type { Measured } from './measured_process.ts';
import type { BenchContext } from './run.ts';
import { largeName, makeLargeChannel, makeRealChannel } from './solve_channels.ts';
import { summary } from './statistics.ts';

const RUNS = 9;
const LARGE = { records: 300_000, names: 40_000 };
const REAL_SPECS = ['r-essentials', 'r-shiny', 'rpy2 >=2.8'];
const LARGE_SPECS = [600, 2_500, 9_000, 17_000, 26_000, 39_999].map(largeName);

interface Peer {
  readonly solveMs: readonly number[];
  readonly packages: readonly string[];
  readonly peakKb: number;
}

function peerSolve(context: BenchContext, channel: string, specs: readonly string[]): Peer {
  const script = join(context.root, 'tests/bench/mambajs_solve.ts');
  const run = spawnSync(process.execPath, [script, channel, '3', ...specs], { encoding: 'utf8', cwd: context.root });
  if (run.status !== 0) throw new Error(`mambajs failed: ${run.stderr.slice(-2000)}`);
  return JSON.parse(run.stdout.trim().split('\n').at(-1) ?? '{}') as Peer;
}

function ourPackages(context: BenchContext, channel: string, specs: readonly string[], environment: NodeJS.ProcessEnv): string[] {
  const run = spawnSync(join(context.build, 'ros2wasm'), ['solve', '--channel', channel, '--json', ...specs],
    { encoding: 'utf8', env: environment, maxBuffer: 1 << 28 });
  const { packages } = JSON.parse(run.stdout) as { packages: readonly { readonly name: string; readonly version: string }[] };
  return packages.map((one) => `${one.name} ${one.version}`).sort();
}

function compare(context: BenchContext, label: string, channel: string, records: number, specs: readonly string[]): void {
  const cache = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-cache-'));
  const environment = { ...process.env, XDG_CACHE_HOME: cache };
  const solve = (): Measured => {
    const run = measure([join(context.build, 'ros2wasm'), 'solve', '--channel', channel, ...specs], environment);
    if (run.exitCode !== 0) throw new Error(`solve failed: ${run.stderr}`);
    return run;
  };
  const first = solve();
  const kept = Array.from({ length: RUNS }, solve);
  const ours = ourPackages(context, channel, specs, environment);
  const peer = peerSolve(context, channel, specs);
  rmSync(cache, { recursive: true, force: true });
  const cachedMs = summary(kept.map((run) => run.wallMs));
  const peerMs = summary(peer.solveMs);
  const theirs = new Set(peer.packages);
  context.emit({
    bench: 'solve', channel: label, records, specs: specs.length,
    first_ms: Math.round(first.wallMs), first_peak_kb: first.peakKb,
    cached_ms: cachedMs, cached_peak_kb: Math.max(...kept.map((run) => run.peakKb)),
    packages: ours.length, same_as_peer: ours.filter((one) => theirs.has(one)).length,
    peer: 'mambajs 0.21.6, solve() in a warm process', peer_ms: peerMs, peer_peak_kb: peer.peakKb, peer_packages: peer.packages.length,
    times_faster: Math.round((peerMs.median / cachedMs.median) * 10) / 10,
    times_faster_first: Math.round((peerMs.median / first.wallMs) * 10) / 10,
  });
}

export function benchSolve(context: BenchContext): void {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-channels-'));
  try {
    const source = process.env['ROS2WASM_BENCH_REPODATA'];
    if (source !== undefined) {
      const records = makeRealChannel(join(folder, 'real'), source);
      compare(context, 'real', join(folder, 'real'), records, REAL_SPECS);
    }
    makeLargeChannel(join(folder, 'large'), LARGE);
    compare(context, 'made', join(folder, 'large'), LARGE.records, LARGE_SPECS);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
