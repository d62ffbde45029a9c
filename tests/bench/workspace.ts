// Time and memory of `ros2wasm build` for the C++ packages of a folder of which the score board expects something, from an
// empty cache (as of ros2/demos and ros2/examples: give a folder with both by --source). Peer: the bare compiler with the
// same commands for the same programs.
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, relative, resolve } from 'node:path';
import { readExpectations } from '../scoreboard/expectation.ts';
import { closure, findPackages } from '../scoreboard/packages.ts';
import { bareCompiler } from './bare_compiler.ts';
import { measure } from './measured_process.ts';
import type { BenchContext } from './run.ts';

/** For the 97 C++ programs of ros2/demos and ros2/examples, on two cores. */
const AIM_MS = 15 * 60_000;

export function benchWorkspace(context: BenchContext): void {
  if (context.source === undefined) {
    context.fail('workspace: say by --source DIR which folder of ROS 2 packages shall be built');
    return;
  }
  const source = resolve(context.source);
  const board = join(context.root, 'tests/scoreboard/expectations');
  const files = readdirSync(board).filter((name) => name.endsWith('.yaml')).map((name) => join(board, name));
  const all = findPackages([source]);
  const expected = [...readExpectations(files).values()].filter((one) => all.get(one.package)?.language === 'cpp');
  if (expected.length === 0) {
    context.fail(`workspace: the score board knows no C++ package below ${source}`);
    return;
  }
  const names = [...new Set(expected.map((one) => one.package))].sort();
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const cache = join(folder, '.cache');
    const environment = { ...process.env, XDG_CACHE_HOME: cache };
    writeFileSync(join(folder, 'workspace.yaml'), JSON.stringify({
      schema: 1,
      name: 'bench',
      distro: 'jazzy',
      packages: closure(names, all).map((one) => relative(folder, one.folder)),
      launch: [{ package: expected[0]?.package, executable: expected[0]?.executable }],
    }));
    const whole = measure([join(context.build, 'ros2wasm'), 'build', join(folder, 'workspace.yaml')], environment);
    if (whole.exitCode !== 0) throw new Error(`build failed: ${whole.stderr}`);
    const built = readdirSync(cache, { recursive: true, encoding: 'utf8' }).filter((path) => /\/built\/.*\.wasm$/.test(path));
    const bare = measure(bareCompiler(cache), environment);
    if (bare.exitCode !== 0) throw new Error(`the compiler failed: ${bare.stderr}`);
    context.emit({
      bench: 'workspace',
      packages: names.length,
      programs: built.length,
      build_ms: Math.round(whole.wallMs),
      build_aim_ms: AIM_MS,
      build_cpu_ms: Math.round(whole.cpuMs),
      build_peak_kb: whole.peakKb,
      peer: 'em++ alone for the same programs: the same compile commands, its own link with -O2, two packages at a time',
      peer_ms: Math.round(bare.wallMs),
      peer_cpu_ms: Math.round(bare.cpuMs),
      peer_peak_kb: bare.peakKb,
    });
    if (whole.wallMs > AIM_MS) context.fail(`the build took ${String(Math.round(whole.wallMs / 1000))} s, ${String(AIM_MS / 1000)} are the aim`);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
