// Evaluation of a launch file of 200 nodes, with their namespaces, conditions and parameters, in each language: the whole
// of `ros2wasm launch`, start of the program and, for Python, of the interpreter included. Peers: the same programs with a
// launch file of one node, and CPython's own start. Of Python also what is kept of the last time (kept_ms). Then the same
// files evaluated anew in a started site, in Node.js, with another launch argument (bench "launch_start"); and in a page
// (bench "launch_page").
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { evaluateLaunch } from '../../runtime/site/launch/launch_evaluation.ts';
import { openEvaluator } from '../../runtime/site/launch/launch_evaluator.ts';
import { benchLaunchPage } from './launch_page.ts';
import { measure } from './measured_process.ts';
import type { Measured } from './measured_process.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const NODES = 200;
const RUNS = 9;
const AIMS_MS: Readonly<Record<string, number>> = { xml: 100, yaml: 100, py: 2000 };

const numbers = (count: number): number[] => Array.from({ length: count }, (_, i) => i);

function texts(count: number): Readonly<Record<string, string>> {
  return {
    xml: `<launch><arg name="n" default="x"/>${
      numbers(count).map((i) => `
<group><push_ros_namespace namespace="$(var n)${i}"/><node pkg="demo" exec="talker" name="n" if="$(eval '${i} >= 0')">
<param name="p" value="[1, 2, 3]"/><param name="q" value="$(var n)"/><remap from="x" to="y"/></node></group>`).join('')
    }</launch>`,
    yaml: `launch:\n- arg: {name: n, default: x}\n${
      numbers(count).map((i) =>
        `- group:
  - push_ros_namespace: {namespace: "$(var n)${i}"}
  - node: {pkg: demo, exec: talker, name: n, if: "$(eval '${i} >= 0')", param: [{name: p, value: [1, 2, 3]}, {name: q, value: $(var n)}],
      remap: [{from: x, to: y}]}
`
      ).join('')
    }`,
    py: `from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node, PushRosNamespace


def generate_launch_description():
    n = LaunchConfiguration('n')
    return LaunchDescription([DeclareLaunchArgument('n', default_value='x')] + [
        GroupAction([PushRosNamespace([n, str(i)]), Node(
            package='demo', executable='talker', name='n', parameters=[{'p': [1, 2, 3], 'q': n}], remappings=[('x', 'y')],
            condition=IfCondition(PythonExpression([str(i), ' >= 0'])))]) for i in range(${count})])
`,
  };
}

/** Milliseconds that a site takes to evaluate its launch file with another argument; the program is compiled already. */
async function startMs(module: WebAssembly.Module, data: string): Promise<number> {
  const begin = performance.now();
  const evaluate = await openEvaluator(module);
  const answer = await evaluateLaunch(evaluate, data, { given: { n: 'other' }, describe: true }, [], () => Promise.reject(new Error('no file is wanted')));
  const ms = performance.now() - begin;
  const text = JSON.stringify(answer['description']);
  if (text.split('"namespace":"/other').length - 1 !== NODES) throw new Error(`the site evaluates something else: ${text.slice(0, 300)}`);
  return ms;
}

export async function benchLaunch(context: BenchContext): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const environment = { ...process.env, XDG_CACHE_HOME: join(folder, '.cache') };
    const run = (file: string, kept = false): Measured => {
      if (!kept) rmSync(join(folder, '.cache/ros2wasm/launch'), { recursive: true, force: true });
      const command = [join(context.build, 'ros2wasm'), 'launch', join(folder, file), '--workspace', folder];
      const done = measure(command, environment);
      if (done.exitCode !== 0) throw new Error(`launch failed: ${done.stderr}`);
      return done;
    };
    for (const [name, count] of [['all', NODES], ['one', 1]] as const)
      for (const [ending, text] of Object.entries(texts(count))) writeFileSync(join(folder, `${name}.launch.${ending}`), text);
    const first = run('all.launch.py'); // unpacks the interpreter
    const python = summary(numbers(RUNS).map(() => measure(['/usr/bin/python3', '-c', 'pass']).wallMs));
    const kept = (file: string): ReturnType<typeof summary> => {
      run(file);
      return summary(numbers(RUNS).map(() => run(file, true).wallMs));
    };
    for (const [ending, aim] of Object.entries(AIMS_MS)) {
      const [all, one] = [`all.launch.${ending}`, `one.launch.${ending}`].map((file) => numbers(RUNS).map(() => run(file)));
      const wall = summary(all?.map(({ wallMs }) => wallMs) ?? []);
      context.emit({
        bench: 'launch',
        language: ending,
        nodes: NODES,
        wall_ms: wall,
        cpu_ms: summary(all?.map(({ cpuMs }) => cpuMs) ?? []).median,
        peak_kb: summary(all?.map(({ peakKb }) => peakKb) ?? []).median,
        aim_ms: aim,
        ...(ending === 'py' ? { first_ms: Math.round(first.wallMs), kept_ms: kept(`all.launch.${ending}`) } : {}),
        peer: 'one node; python3 that does nothing',
        peer_one_node_ms: summary(one?.map(({ wallMs }) => wallMs) ?? []),
        peer_python3_ms: python,
      });
      if (wall.median > aim) context.fail(`launch: ${NODES} nodes in ${ending} take ${Math.round(wall.median)} ms, the aim is ${aim}`);
    }
    const wasm = readFileSync(join(context.build, 'runtime/launch_evaluator.wasm'));
    const began = performance.now();
    const module = await WebAssembly.compile(wasm);
    const compileMs = performance.now() - began;
    for (const ending of Object.keys(AIMS_MS)) {
      const made = spawnSync(join(context.build, 'ros2wasm'), ['launch', join(folder, `all.launch.${ending}`), '--workspace', folder, '--site-data'], {
        encoding: 'utf8',
        env: environment,
        maxBuffer: 1 << 28,
      });
      if (made.status !== 0) throw new Error(`launch --site-data failed: ${made.stderr}`);
      const data = made.stdout;
      const times: number[] = [];
      for (let i = 0; i < RUNS; i += 1) times.push(await startMs(module, data));
      context.emit({
        bench: 'launch_start',
        language: ending,
        nodes: NODES,
        wall_ms: summary(times),
        compile_ms: Math.round(compileMs),
        wasm_bytes: wasm.length,
        data_bytes: Buffer.byteLength(data),
      });
    }
    await benchLaunchPage(context, folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
