// Time of `ros2wasm channel build` for 20 packages (messages, C++ and Python) with the packages of the embedded channel unpacked:
// cold, after a change of one package, and with nothing changed. Peer of the cold run: the bare compiler with the same commands.
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { bareCompiler } from './bare_compiler.ts';
import { machineLoad } from './machine_load.ts';
import { measure, type Measured } from './measured_process.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const MESSAGES = 4;
const PROGRAMS = 12;
const SCRIPTS = 4;
const UNCHANGED_RUNS = 9;
const CHANGED_RUNS = 3;
/** How much longer the cold run may take than the bare compiler. */
const COLD_RATIO_AIM = 1.5;
const UNCHANGED_AIM_MS = 1_000;

const packageXml = (name: string, type: string, depends: readonly string[], more = ''): string =>
  `<package format="3">
  <name>${name}</name><version>1.0.0</version><description>A package of a bench</description>
  <maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license>
  ${depends.map((one) => `<depend>${one}</depend>`).join('')}${more}<export><build_type>${type}</build_type></export>
</package>
`;
const node = (i: number, says: string): string =>
  `#include <rclcpp/rclcpp.hpp>
#include <bench_msgs_${i % MESSAGES}/msg/reading.hpp>
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node_${i}");
  auto publisher = node->create_publisher<bench_msgs_${i % MESSAGES}::msg::Reading>("reading", 10);
  auto timer = node->create_wall_timer(std::chrono::milliseconds(100), [&]() {
    bench_msgs_${i % MESSAGES}::msg::Reading message;
    message.label = "${says}";
    publisher->publish(message);
  });
  rclcpp::spin(node);
}
`;

function writePackages(folder: string): void {
  const write = (path: string, text: string): void => {
    const file = join(folder, path);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, text);
  };
  for (let i = 0; i < MESSAGES; ++i) {
    const name = `bench_msgs_${i}`;
    write(`${name}/package.xml`,
      packageXml(name, 'ament_cmake', ['rosidl_default_generators', 'rosidl_default_runtime'], '<member_of_group>rosidl_interface_packages</member_of_group>'));
    write(`${name}/CMakeLists.txt`, `cmake_minimum_required(VERSION 3.8)\nproject(${name})\nfind_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)\nrosidl_generate_interfaces(\${PROJECT_NAME} "msg/Reading.msg")\nament_package()\n`);
    write(`${name}/msg/Reading.msg`, 'string label\nfloat64[] values\n');
  }
  for (let i = 0; i < PROGRAMS; ++i) {
    const name = `bench_node_${i}`;
    write(`${name}/package.xml`, packageXml(name, 'ament_cmake', ['rclcpp', `bench_msgs_${i % MESSAGES}`]));
    write(`${name}/CMakeLists.txt`, `cmake_minimum_required(VERSION 3.8)\nproject(${name})\nfind_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)\nfind_package(bench_msgs_${i % MESSAGES} REQUIRED)\nadd_executable(node src/node.cpp)
ament_target_dependencies(node rclcpp bench_msgs_${i % MESSAGES})\ninstall(TARGETS node DESTINATION lib/\${PROJECT_NAME})\nament_package()\n`);
    write(`${name}/src/node.cpp`, node(i, 'first'));
  }
  for (let i = 0; i < SCRIPTS; ++i) {
    const name = `bench_script_${i}`;
    write(`${name}/package.xml`, packageXml(name, 'ament_python', ['rclpy']));
    write(`${name}/setup.py`, `from setuptools import setup\nsetup(name='${name}', version='1.0.0', packages=['${name}'],
      entry_points={'console_scripts': ['go = ${name}.go:main']})\n`);
    write(`${name}/setup.cfg`, `[develop]\nscript_dir=$base/lib/${name}\n[install]\ninstall_scripts=$base/lib/${name}\n`);
    write(`${name}/${name}/__init__.py`, '');
    write(`${name}/${name}/go.py`, 'def main():\n    print("it goes")\n');
  }
}

export function benchChannelBuild(context: BenchContext): void {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    writePackages(join(folder, 'src'));
    const cache = join(folder, '.cache');
    const environment = { ...process.env, XDG_CACHE_HOME: cache };
    const run = (words: readonly string[]): Measured => {
      const done = measure([join(context.build, 'ros2wasm'), ...words], environment);
      if (done.exitCode !== 0) throw new Error(`ros2wasm ${words[0] ?? ''} failed: ${done.stderr}`);
      return done;
    };
    // The packages of the embedded channel, and rclcpp's header compiled: what any earlier pack leaves.
    cpSync(join(folder, 'src/bench_node_0'), join(folder, 'first/bench_node_0'), { recursive: true });
    cpSync(join(folder, 'src/bench_msgs_0'), join(folder, 'first/bench_msgs_0'), { recursive: true });
    run(['build', join(folder, 'first')]);
    rmSync(join(cache, 'ros2wasm/build'), { recursive: true });
    const build = (): Measured => run(['channel', 'build', join(folder, 'src'), '-o', join(folder, 'channel')]);
    const cold = build();
    const unchanged = Array.from({ length: UNCHANGED_RUNS }, build);
    const changed = Array.from({ length: CHANGED_RUNS }, (_, i) => {
      writeFileSync(join(folder, 'src/bench_node_0/src/node.cpp'), node(0, `change ${i}`));
      return build();
    });
    const bare = measure(bareCompiler(cache), environment);
    if (bare.exitCode !== 0) throw new Error(`the compiler failed: ${bare.stderr}`);
    const unchangedMs = summary(unchanged.map((one) => one.wallMs));
    const ratio = cold.wallMs / bare.wallMs;
    context.emit({
      bench: 'channel_build',
      packages: MESSAGES + PROGRAMS + SCRIPTS,
      cold_ms: Math.round(cold.wallMs),
      cold_cpu_ms: Math.round(cold.cpuMs),
      cold_peak_kb: cold.peakKb,
      peer: 'em++ alone for the same sources: the same compile commands, its own link with -O2, two packages at a time',
      peer_ms: Math.round(bare.wallMs),
      peer_cpu_ms: Math.round(bare.cpuMs),
      cold_ratio: Number(ratio.toFixed(2)),
      cold_ratio_aim: COLD_RATIO_AIM,
      one_changed_ms: summary(changed.map((one) => one.wallMs)),
      unchanged_ms: unchangedMs,
      unchanged_aim_ms: UNCHANGED_AIM_MS,
      load: machineLoad(),
    });
    if (ratio > COLD_RATIO_AIM)
      context.fail(`channel_build: the cold run took ${ratio.toFixed(2)} times the bare compiler, ${String(COLD_RATIO_AIM)} is the aim`);
    if (unchangedMs.median > UNCHANGED_AIM_MS)
      context.fail(`channel_build: nothing changed took ${String(Math.round(unchangedMs.median))} ms, ${String(UNCHANGED_AIM_MS)} are the aim`);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
