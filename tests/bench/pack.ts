// Time and memory of `ros2wasm pack` for example 01: cold (empty cache), warm (nothing changed) and after a
// change of one file; and of `pack --quick` after such a change. Peers: the bare compiler with the same commands for the
// same programs, the compiler's start, and the same quick pack with nothing kept of rclcpp's header.
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { bareCompiler } from './bare_compiler.ts';
import { measure } from './measured_process.ts';
import { machineLoad } from './machine_load.ts';
import type { Measured } from './measured_process.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const WARM_RUNS = 9;
const CHANGED_RUNS = 3;
const QUICK_RUNS = 5;
/** On a machine like CI's with nothing else to do: a fresh workspace, and one file of it changed. */
const COLD_AIM_MS = 15_000;
const CHANGE_AIM_MS = 3_000;
const TALKER = 'src/tutorial_talker/src/publisher_member_function.cpp';

export function benchPack(context: BenchContext): void {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    cpSync(join(context.root, 'examples/01_talker_listener'), folder, { recursive: true });
    const environment = { ...process.env, XDG_CACHE_HOME: join(folder, '.cache') };
    const command = [join(context.build, 'ros2wasm'), 'pack', join(folder, 'workspace.yaml'), '-o', join(folder, 'site')];
    const pack = (): Measured => {
      const run = measure(command, environment);
      if (run.exitCode !== 0) throw new Error(`pack failed: ${run.stderr}`);
      return run;
    };
    const cold = pack();
    const warm = Array.from({ length: WARM_RUNS }, pack);
    const file = join(folder, TALKER);
    const source = readFileSync(file, 'utf8');
    const changed = Array.from({ length: CHANGED_RUNS }, (_, i) => {
      writeFileSync(file, source.replace('Hello, world!', `Hello, bench ${i}!`));
      return pack();
    });
    const changedMs = summary(changed.map((run) => run.wallMs));
    const bare = measure(bareCompiler(join(folder, '.cache')), environment);
    if (bare.exitCode !== 0) throw new Error(`the compiler failed: ${bare.stderr}`);
    const quick = (cache: string, launcher: string): readonly Measured[] => {
      const other = { ...process.env, XDG_CACHE_HOME: join(folder, cache), CMAKE_CXX_COMPILER_LAUNCHER: launcher };
      const runs = Array.from({ length: 1 + QUICK_RUNS }, (_, i) => {
        writeFileSync(file, source.replace('Hello, world!', `Hello, ${cache} ${i}!`));
        const run = measure([...command, '--quick'], other);
        if (run.exitCode !== 0) throw new Error(`pack --quick failed: ${run.stderr}`);
        return run;
      });
      return runs.slice(1);
    };
    const kept = quick('.kept', '');
    const plain = quick('.plain', '/usr/bin/env');
    const empty = join(folder, 'empty.cpp');
    writeFileSync(empty, '');
    const compiler = measure(['em++', '-O2', '-c', empty, '-o', join(folder, 'empty.o')]);
    context.emit({
      bench: 'pack',
      example: '01_talker_listener',
      cold_ms: Math.round(cold.wallMs),
      cold_aim_ms: COLD_AIM_MS,
      cold_cpu_ms: Math.round(cold.cpuMs),
      cold_peak_kb: cold.peakKb,
      cold_peer: 'em++ alone for the same two programs: the same compile commands, its own link with -O2, both programs at once',
      cold_peer_ms: Math.round(bare.wallMs),
      cold_peer_cpu_ms: Math.round(bare.cpuMs),
      cold_peer_peak_kb: bare.peakKb,
      warm_ms: summary(warm.map((run) => run.wallMs)),
      warm_peak_kb: summary(warm.map((run) => run.peakKb)).median,
      one_file_changed_ms: changedMs,
      one_file_changed_aim_ms: CHANGE_AIM_MS,
      one_file_changed_cpu_ms: summary(changed.map((run) => run.cpuMs)).median,
      quick_change_ms: summary(kept.map((run) => run.wallMs)),
      quick_change_cpu_ms: summary(kept.map((run) => run.cpuMs)).median,
      quick_change_header_not_kept_ms: summary(plain.map((run) => run.wallMs)),
      quick_change_header_not_kept_cpu_ms: summary(plain.map((run) => run.cpuMs)).median,
      peer: 'one start of the compiler on an empty file',
      peer_ms: Math.round(compiler.wallMs),
      peer_peak_kb: compiler.peakKb,
      load: machineLoad(),
    });
    const missed = (what: string, ms: number, aim: number): void => {
      if (ms > aim) context.fail(`${what} took ${(ms / 1000).toFixed(1)} s, ${String(aim / 1000)} are the aim (load ${String(machineLoad())})`);
    };
    missed('a fresh workspace', cold.wallMs, COLD_AIM_MS);
    missed('one changed file', changedMs.median, CHANGE_AIM_MS);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
