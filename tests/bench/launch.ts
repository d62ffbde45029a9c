// Evaluation of a launch file of 200 nodes, with their namespaces, conditions and parameters, in each language: the whole
// of `ros2wasm launch`, start of the program and, for Python, of the interpreter included. Peers: the same programs with a
// launch file of one node, and CPython's own start.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
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
    xml: `<launch><arg name="n" default="x"/>${numbers(count).map((i) => `
<group><push_ros_namespace namespace="$(var n)${i}"/><node pkg="demo" exec="talker" name="n" if="$(eval '${i} >= 0')">
<param name="p" value="[1, 2, 3]"/><param name="q" value="$(var n)"/><remap from="x" to="y"/></node></group>`).join('')}</launch>`,
    yaml: `launch:\n- arg: {name: n, default: x}\n${numbers(count).map((i) => `- group:
  - push_ros_namespace: {namespace: "$(var n)${i}"}
  - node: {pkg: demo, exec: talker, name: n, if: "$(eval '${i} >= 0')", param: [{name: p, value: [1, 2, 3]}, {name: q, value: $(var n)}],
      remap: [{from: x, to: y}]}
`).join('')}`,
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

export function benchLaunch(context: BenchContext): void {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const environment = { ...process.env, XDG_CACHE_HOME: join(folder, '.cache') };
    const run = (file: string): Measured => {
      const command = [join(context.build, 'ros2wasm'), 'launch', join(folder, file), '--workspace', folder];
      const done = measure(command, environment);
      if (done.exitCode !== 0) throw new Error(`launch failed: ${done.stderr}`);
      return done;
    };
    for (const [name, count] of [['all', NODES], ['one', 1]] as const)
      for (const [ending, text] of Object.entries(texts(count))) writeFileSync(join(folder, `${name}.launch.${ending}`), text);
    const first = run('all.launch.py');  // unpacks the interpreter
    const python = summary(numbers(RUNS).map(() => measure(['/usr/bin/python3', '-c', 'pass']).wallMs));
    for (const [ending, aim] of Object.entries(AIMS_MS)) {
      const [all, one] = [`all.launch.${ending}`, `one.launch.${ending}`].map((file) => numbers(RUNS).map(() => run(file)));
      const wall = summary(all?.map(({ wallMs }) => wallMs) ?? []);
      context.emit({
        bench: 'launch', language: ending, nodes: NODES, wall_ms: wall, cpu_ms: summary(all?.map(({ cpuMs }) => cpuMs) ?? []).median,
        peak_kb: summary(all?.map(({ peakKb }) => peakKb) ?? []).median, aim_ms: aim,
        ...(ending === 'py' ? { first_ms: Math.round(first.wallMs) } : {}),
        peer: 'one node; python3 that does nothing', peer_one_node_ms: summary(one?.map(({ wallMs }) => wallMs) ?? []),
        peer_python3_ms: python,
      });
      if (wall.median > aim) context.fail(`launch: ${NODES} nodes in ${ending} take ${Math.round(wall.median)} ms, the aim is ${aim}`);
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
