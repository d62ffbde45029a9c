// Nav2: the navigation function over a large map in a site, beside the same code compiled natively, in turns; cycles of DWB in a site; and
// the size of the servers in a site.
import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { machineLoad } from './machine_load.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const RUNS = 10;
/** The time in the site divided by the native time. */
const RATIO_AIM = 2.5;
const LEAST_POSES = 980;
/** A cycle of DWB takes at most this many ms. */
const CYCLE_AIM = 15;
const SIZE_AIM = 250_000;
const PROGRAMS = ['nav2_planner/planner_server', 'nav2_controller/controller_server', 'nav2_behaviors/behavior_server', 'nav2_bt_navigator/bt_navigator',
  'nav2_smoother/smoother_server', 'nav2_velocity_smoother/velocity_smoother', 'nav2_collision_monitor/collision_monitor',
  'nav2_waypoint_follower/waypoint_follower', 'nav2_amcl/amcl', 'robot_localization/ekf_node', 'slam_toolbox/async_slam_toolbox_node'] as const;
const PACKAGE = 'tests/bench/packages/stacks_bench';
const NAVFN = 'runtime/packages/navigation/nav2_navfn_planner';

function run(command: string, words: readonly string[]): string {
  const done = spawnSync(command, words, { encoding: 'utf8' });
  if (done.status !== 0) throw new Error(`${command} ${words.join(' ')} failed: ${done.stderr}${done.stdout}`);
  return done.stdout;
}

/** The median of times in ms, sorted, as a program prints them. */
function middle(list: string | undefined, text: string): number {
  const times = list?.trim().split(' ').map(Number) ?? [];
  const found = times[Math.floor(times.length / 2)];
  if (found === undefined) throw new Error(`no times: ${text}`);
  return found;
}

/** The rounds of NavFn in a run. A plan straight across the map has at least so many poses as it has rows. */
function navfnTime(text: string): number {
  const [, poses, list] = /navfn (\d+) poses ((?:[\d.]+ ?)+)/.exec(text) ?? [];
  if (Number(poses) < LEAST_POSES) throw new Error(`no plan: ${text}`);
  return middle(list, text);
}

/** The cycles of DWB in a run, which must have found a velocity. */
function dwbTime(text: string): number {
  const [, speed, list] = /dwb ([\d.]+) m\/s ((?:[\d.]+ ?)+)/.exec(text) ?? [];
  if (!(Number(speed) > 0.1)) throw new Error(`no velocity: ${text}`);
  return middle(list, text);
}

export function benchStacks(context: BenchContext): void {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    cpSync(join(context.root, PACKAGE), join(folder, 'stacks_bench'), { recursive: true });
    const programs = PROGRAMS.map((path) => {
      const [name, executable] = path.split('/');
      return `  - {package: ${String(name)}, executable: ${String(executable)}}`;
    });
    // Only these run, one after the other; the servers are there to be weighed.
    writeFileSync(join(folder, 'workspace.yaml'),
      `schema: 1\nname: stacks\npackages: [stacks_bench]\nlaunch: stacks_bench/stacks.launch.py\nprograms:\n${programs.join('\n')}\n`);
    const site = join(folder, 'site');
    run(join(context.build, 'ros2wasm'), ['pack', join(folder, 'workspace.yaml'), '-o', site]);
    const native = join(folder, 'native');
    run('g++', ['-O2', '-std=c++17', `-I${join(context.root, NAVFN, 'include')}`, join(context.root, NAVFN, 'src/navfn.cpp'),
      join(context.root, PACKAGE, 'src/native.cpp'), '-o', native]);
    const ours: number[] = [];
    const peers: number[] = [];
    const cycles: number[] = [];
    for (let i = 0; i < RUNS; ++i) {
      peers.push(navfnTime(run(native, [])));
      ours.push(navfnTime(run(join(context.build, 'ros2wasm'), ['run', site, '--for', '8s'])));
      cycles.push(dwbTime(run(join(context.build, 'ros2wasm'), ['run', site, '--for', '8s', 'what:=dwb'])));
    }
    const ratios = summary(ours.map((time, i) => time / (peers[i] ?? Number.NaN)));
    context.emit({
      bench: 'stacks',
      what: 'ms of NavFn on 1000 x 1000 cells, Node.js',
      ...summary(ours),
      peer: 'native, g++ -O2',
      ms: summary(peers),
      ratios,
      aim: RATIO_AIM,
      load: machineLoad(),
    });
    if (ratios.median > RATIO_AIM) context.fail(`stacks: NavFn takes ${String(ratios.median)} times as long as natively, the aim is ${String(RATIO_AIM)}`);
    const cycle = summary(cycles);
    context.emit({ bench: 'stacks', what: 'ms of a cycle of DWB, 20 x 20 velocities, 60 x 60 cells, Node.js', ...cycle, aim: CYCLE_AIM, load: machineLoad() });
    if (cycle.median > CYCLE_AIM) context.fail(`stacks: a cycle of DWB takes ${String(cycle.median)} ms, the aim is ${String(CYCLE_AIM)}`);
    for (const path of PROGRAMS) {
      const program = readFileSync(join(site, `programs/${path}.wasm`));
      const brotli = brotliCompressSync(program).length;
      context.emit({ bench: 'stacks', what: `${path}.wasm`, raw: program.length, brotli, aim: SIZE_AIM });
      if (brotli > SIZE_AIM) context.fail(`stacks: ${path} has ${String(brotli)} bytes, the aim is ${String(SIZE_AIM)}`);
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
