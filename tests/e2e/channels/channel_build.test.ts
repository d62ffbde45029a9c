// `ros2wasm channel build`: packages of a workspace become a channel, from which a site is as from their sources.
import assert from 'node:assert/strict';
import { cpSync, readdirSync, renameSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { commitAll, type GitServer, serveGit } from '../../support/git_server.ts';
import { type Finished, PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

interface Report {
  readonly added: number;
  readonly unchanged: number;
  readonly failed: number;
  readonly skipped: number;
  readonly causes: readonly { readonly code: string; readonly message: string; readonly packages: readonly string[]; }[];
  readonly packages: readonly {
    readonly name: string;
    readonly state: string;
    readonly archive?: string;
    readonly cause?: string;
    readonly source?: string;
  }[];
}
interface PackageRow {
  readonly depends: readonly string[];
  readonly license: string;
  readonly noarch?: string;
}

const SHAPE = `#pragma once
namespace room_shapes {
class Shape {
 public:
  virtual ~Shape() = default;
  virtual double area() = 0;
};
inline const char* file() { return __FILE__; }
}
`;
const SHOW = `#include <cstdio>
#include <pluginlib/class_loader.hpp>
#include <room_shapes/shape.hpp>
int main() {
  pluginlib::ClassLoader<room_shapes::Shape> loader("room_shapes", "room_shapes::Shape");
  for (const auto& name : loader.getDeclaredClasses()) std::printf("%s has %.1f\\n", name.c_str(), loader.createSharedInstance(name)->area());
  std::puts("these are all");
  std::fflush(stdout);
}
`;
const DRIVER = `#include <fstream>
#include <ament_index_cpp/get_package_share_directory.hpp>
#include <rclcpp/rclcpp.hpp>
#include <room_msgs/msg/room.hpp>
#include <room_shapes/shape.hpp>
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("driver");
  auto publisher = node->create_publisher<room_msgs::msg::Room>("room", rclcpp::QoS(1).transient_local());
  room_msgs::msg::Room message;
  std::ifstream(ament_index_cpp::get_package_share_directory("room_driver") + "/config/area.txt") >> message.area;
  publisher->publish(message);
  RCLCPP_INFO(node->get_logger(), "shapes are of %s", room_shapes::file());
  rclcpp::spin(node);
}
`;
const LOGGER = `import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from room_msgs.msg import Room


def main():
    rclpy.init()
    node = rclpy.create_node('logger')
    quality = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(Room, 'room', lambda heard: print(f'{heard.area} square metres', flush=True), quality)
    rclpy.spin(node)
`;

let ws: PackWorkspace;

function addPackages(): void {
  ws.addPackage('room_msgs', {}, {
    depends: ['rosidl_default_generators', 'rosidl_default_runtime'],
    cmake: 'find_package(rosidl_default_generators REQUIRED)\nrosidl_generate_interfaces(${PROJECT_NAME} "msg/Room.msg")',
  });
  const messages = 'src/room_msgs/package.xml';
  ws.write(messages, ws.read(messages).toString().replace('  <export>', '  <member_of_group>rosidl_interface_packages</member_of_group>\n  <export>'));
  ws.write('src/room_msgs/msg/Room.msg', 'float64 area\n');
  ws.write('src/room_msgs/LICENSE', 'Redistribution and use in source and binary forms are permitted.\n');
  ws.addPackage('room_driver', { driver: DRIVER }, {
    depends: ['rclcpp', 'room_msgs', 'room_shapes', 'ament_index_cpp'],
    cmake: `find_package(rclcpp REQUIRED)
find_package(room_msgs REQUIRED)
find_package(room_shapes REQUIRED)
find_package(ament_index_cpp REQUIRED)
ament_target_dependencies(driver rclcpp room_msgs room_shapes ament_index_cpp)
install(DIRECTORY config DESTINATION share/\${PROJECT_NAME})`,
  });
  ws.write('src/room_driver/config/area.txt', '12.5\n');
  ws.addPythonPackage('room_logger', { logger: LOGGER }, ['rclpy']);
  const logger = 'src/room_logger/package.xml';
  ws.write(logger,
    ws.read(logger).toString().replace('  <export>', '  <exec_depend version_gte="1.0.0" version_lt="2.0.0">room_msgs</exec_depend>\n  <export>'));
  ws.addPackage('room_shapes', { show: SHOW }, {
    depends: ['pluginlib'],
    cmake: `find_package(pluginlib REQUIRED)
target_include_directories(show PRIVATE include)
ament_target_dependencies(show pluginlib)
install(DIRECTORY include/ DESTINATION include)
ament_export_include_directories(include)`,
  });
  ws.write('src/room_shapes/include/room_shapes/shape.hpp', SHAPE);
  ws.addPackage('room_broken', { broken: 'int main() { return missing; }\n' });
  ws.addPackage('room_follow', { follow: 'int main() {}\n' }, { depends: ['room_broken'], cmake: 'find_package(room_broken REQUIRED)' });
}

async function build(...words: readonly string[]): Promise<Finished & { readonly report: Report; }> {
  const done = await ws.run(['--json', 'channel', 'build', ...words]);
  const line = done.stdout.trim().split('\n').at(-1) ?? '';
  return { ...done, report: JSON.parse(line) as Report };
}

async function succeeds(...words: readonly string[]): Promise<string> {
  const { code, stdout, stderr } = await ws.run(words);
  assert.equal(code, 0, stderr);
  return stdout + stderr;
}

const archives = (channel: string): readonly string[] =>
  readdirSync(join(ws.root, channel), { recursive: true }).map(String).filter((name) => name.endsWith('.conda')).sort();

/** All files but the notes by which the next index is made faster. */
const published = (channel: string): ReadonlyMap<string, string> =>
  new Map([...ws.files(channel)].filter(([path]) => !path.split('/').at(-1)?.startsWith('.')));

function record(channel: string, name: string): PackageRow {
  for (const subdir of ['noarch', 'emscripten-wasm32']) {
    const index = JSON.parse(ws.read(`${channel}/${subdir}/repodata.json`).toString()) as Readonly<Record<string, Readonly<Record<string, PackageRow>>>>;
    for (const [file, row] of Object.entries(index['packages.conda'] ?? {})) if (file.startsWith(`${name}-1.2.3-`)) return row;
  }
  throw new Error(`there is no ${name} in ${channel}`);
}

before(() => {
  ws = new PackWorkspace();
  addPackages();
});
after(() => ws.close());

test('packages are built, described and indexed; one that fails stops only those that need it', watchdog, async () => {
  const { code, stderr, report } = await build('src', '-o', 'room', '--report', 'report.md');
  assert.equal(code, 1, stderr);
  assert.deepEqual([report.added, report.unchanged, report.failed, report.skipped], [4, 0, 1, 1], stderr);
  assert.deepEqual(report.causes.map((one) => [one.code, one.packages]), [['R2W0502', ['room_broken']]]);
  assert.match(report.packages.find((one) => one.name === 'room_follow')?.cause ?? '', /needs `room_broken`/);
  const names = archives('room');
  assert.equal(names.length, 4);
  assert.match(names.join('\n'), /^emscripten-wasm32\/ros-jazzy-room-driver-1\.2\.3-em\d+_h[0-9a-f]{8}_0\.conda$/m);
  assert.match(names.join('\n'), /^noarch\/ros-jazzy-room-logger-1\.2\.3-h[0-9a-f]{8}_0\.conda$/m);
  const markdown = ws.read('report.md').toString();
  assert.match(markdown, /\| R2W0502 \| .*missing.* \| room_broken \|/);
  assert.match(markdown, /\| room_driver \| 1\.2\.3 \| added \| emscripten-wasm32\//);
  const driver = record('room', 'ros-jazzy-room-driver');
  assert.ok(driver.depends.includes('ros-jazzy-room-msgs >=1.2.3'), driver.depends.join());
  assert.ok(driver.depends.includes('ros-jazzy-rclcpp'));
  assert.match(driver.depends.join('\n'), /^emscripten-abi \d+\.\d+\.\d+ clang[\d.]+_h[0-9a-f]+_0$/m);
  assert.match(driver.depends.join('\n'), /^ros2wasm-abi \* h[0-9a-f]{12}_0$/m);
  assert.equal(driver.license, 'Apache-2.0');
  const logger = record('room', 'ros-jazzy-room-logger');
  assert.equal(logger.noarch, 'generic');
  assert.ok(logger.depends.includes('ros-jazzy-room-msgs >=1.2.3,>=1.0.0,<2.0.0'), logger.depends.join());
  assert.ok(logger.depends.includes('ros-jazzy-rclpy') && logger.depends.includes('pyodide'));
  assert.equal((await ws.run(['channel', 'check', 'room'])).code, 0);
});

test('a run in which nothing has changed writes nothing', watchdog, async () => {
  rmSync(join(ws.root, 'src/room_broken'), { recursive: true });
  rmSync(join(ws.root, 'src/room_follow'), { recursive: true });
  const files = published('room');
  const { code, report, stderr } = await build('src', '-o', 'room');
  assert.equal(code, 0, stderr);
  assert.deepEqual([report.added, report.unchanged], [0, 4]);
  assert.deepEqual(published('room'), files);
});

// Guarantee, same bytes: a channel of the same sources, whatever folder they are in and whatever cache is used
test('other folders and another cache give the same archives', watchdog, async () => {
  cpSync(join(ws.root, 'src'), join(ws.root, 'elsewhere/deep/packages'), { recursive: true });
  const done = await ws.run(['channel', 'build', 'elsewhere/deep/packages', '-o', 'again'], { XDG_CACHE_HOME: join(ws.root, 'other_cache') });
  assert.equal(done.code, 0, done.stderr);
  assert.doesNotMatch(done.stderr, /R2W0533/);
  assert.deepEqual(published('again'), published('room'));
  rmSync(join(ws.root, 'other_cache'), { recursive: true });
});

test('a site of the channel runs the same programs as one of the sources', watchdog, async () => {
  ws.write('from_sources/workspace.yaml', `schema: 1
name: lab
packages: [../src/*]
launch: &nodes
  - {package: room_driver, executable: driver}
  - {package: room_logger, executable: logger}
`);
  ws.write('from_channel/workspace.yaml', `schema: 1
name: lab
channels: [../room, embedded]
launch:
  - {package: room_driver, executable: driver}
  - {package: room_logger, executable: logger}
`);
  ws.write('from_channel/README', '');
  await succeeds('pack', 'from_sources', '-o', 'sources_site');
  const said = await succeeds('pack', 'from_channel', '-o', 'channel_site');
  assert.doesNotMatch(said, /built /);
  assert.match(await succeeds('run', 'channel_site', '--for', '20s', '--until', '12.5 square'), /12\.5 square metres/);
  const programs = (site: string): readonly string[] => [...ws.files(site)].filter(([path]) => /driver[^/]*\.wasm$/.test(path)).map(([, bytes]) => bytes);
  assert.equal(programs('channel_site').length, 1);
  assert.deepEqual(programs('channel_site'), programs('sources_site'));
});

test('a program of the channel loads plugins of a workspace', watchdog, async () => {
  ws.addPackage('room_square', {}, {
    depends: ['room_shapes', 'pluginlib'],
    cmake: `find_package(room_shapes REQUIRED)
find_package(pluginlib REQUIRED)
add_library(square SHARED src/square.cpp)
ament_target_dependencies(square room_shapes pluginlib)
pluginlib_export_plugin_description_file(room_shapes plugins.xml)
install(TARGETS square ARCHIVE DESTINATION lib LIBRARY DESTINATION lib)`,
  });
  renameSync(join(ws.root, 'src/room_square'), join(ws.root, 'from_channel/room_square'));
  ws.write('from_channel/room_square/src/square.cpp', `#include <pluginlib/class_list_macros.hpp>
#include <room_shapes/shape.hpp>
namespace room_square {
class Square : public room_shapes::Shape {
 public:
  double area() override { return 6.25; }
};
}
PLUGINLIB_EXPORT_CLASS(room_square::Square, room_shapes::Shape)
`);
  ws.write('from_channel/room_square/plugins.xml', `<library path="square">
  <class type="room_square::Square" base_class_type="room_shapes::Shape"><description>Four sides</description></class>
</library>
`);
  ws.write('from_channel/workspace.yaml', `schema: 1
name: lab
packages: [room_square]
channels: [../room, embedded]
launch:
  - {package: room_shapes, executable: show}
`);
  await succeeds('pack', 'from_channel', '-o', 'plugin_site');
  assert.match(await succeeds('run', 'plugin_site', '--for', '20s', '--until', 'these are all'), /room_square::Square has 6\.2/);
});

test('a program with a folder of its sources in it is named', watchdog, async () => {
  ws.addPackage('room_fixed', { fixed: '#include <cstdio>\nint main() { std::puts(HERE); }\n' }, {
    cmake: 'target_compile_definitions(fixed PRIVATE HERE="${CMAKE_CURRENT_SOURCE_DIR}/data")',
  });
  renameSync(join(ws.root, 'src/room_fixed'), join(ws.root, 'fixed'));
  const { code, stderr } = await build('fixed', '-o', 'of_fixed');
  assert.equal(code, 0, stderr);
  assert.match(stderr, /R2W0533.*package `room_fixed` of the channel names folders of this machine.*lib\/room_fixed\/fixed\.wasm/);
});

test('a package that has changed is added with the next build number, and the earlier one stays', watchdog, async () => {
  const before = archives('room');
  ws.write('src/room_driver/config/area.txt', '20\n');
  const { report, stderr } = await build('src', '-o', 'room');
  assert.deepEqual([report.added, report.unchanged, report.failed], [1, 3, 0], stderr);
  const more = archives('room').filter((name) => !before.includes(name));
  assert.match(more.join(), /^emscripten-wasm32\/ros-jazzy-room-driver-1\.2\.3-em\d+_h[0-9a-f]{8}_1\.conda$/);
  assert.equal(archives('room').length, before.length + 1);
});

test('what other headers of the client libraries were compiled for is refused by name', watchdog, async () => {
  const meta = {
    name: 'ros-jazzy-room-foreign',
    version: '1.0.0',
    build: 'h1_0',
    subdir: 'emscripten-wasm32',
    depends: ['ros2wasm-abi * h000000000000_0'],
    license: 'MIT',
  };
  ws.write('foreign.json', JSON.stringify(meta));
  ws.write('foreign/share/room_foreign/package.xml', '<package/>\n');
  await succeeds('channel', 'add', 'other', '--prefix', 'foreign', '--metadata', 'foreign.json');
  await succeeds('channel', 'index', 'other');
  ws.write('with_foreign/workspace.yaml',
    'schema: 1\nname: lab\nchannels: [../other, embedded]\ndependencies: [room_foreign]\nlaunch:\n  - {package: demo_nodes_cpp, executable: talker}\n');
  const { code, stderr } = await ws.run(['pack', 'with_foreign', '-o', 'no_site']);
  assert.equal(code, 1);
  assert.match(stderr, /ros2wasm-abi/);
  assert.match(stderr, /h000000000000_0/);
});

test('a package of a channel may need one that only the workspace has, in the version that it has', watchdog, async () => {
  const add = async (version: string): Promise<Finished> => {
    const meta = {
      name: 'ros-jazzy-room-plan',
      version: '1.0.0',
      build: 'h1_0',
      subdir: 'noarch',
      depends: [`ros-jazzy-room-msgs ${version}`],
      license: 'MIT',
    };
    ws.write('plan.json', JSON.stringify(meta));
    ws.write('plan/share/room_plan/package.xml', '<package/>\n');
    await succeeds('channel', 'add', `plans${version.slice(2)}`, '--prefix', 'plan', '--metadata', 'plan.json');
    await succeeds('channel', 'index', `plans${version.slice(2)}`);
    ws.write('with_plan/workspace.yaml', `schema: 1
name: lab
packages: [../src/room_msgs, ../src/room_driver, ../src/room_shapes]
channels: [../plans${version.slice(2)}, embedded]
dependencies: [room_plan]
launch:
  - {package: room_driver, executable: driver}
`);
    return ws.run(['pack', 'with_plan', '-o', 'plan_site']);
  };
  const fits = await add('>=1');
  assert.equal(fits.code, 0, fits.stderr);
  assert.doesNotMatch(ws.read('with_plan/ros2wasm.lock').toString(), /name: ros-jazzy-room-msgs/);
  assert.match(ws.read('with_plan/ros2wasm.lock').toString(), /^built_here:\n {2}- ros-jazzy-room-msgs 1\.2\.3$/m);
  assert.equal((await ws.run(['pack', 'with_plan', '-o', 'plan_site', '--frozen'])).code, 0);
  assert.match(await succeeds('inspect', 'lock', 'with_plan/ros2wasm.lock'), /"faults":\[\]/);
  const refused = await add('>=2');
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /R2W0301[\s\S]*ros-jazzy-room-msgs >=2/);
});

test('a workspace.yaml with sources needs no `launch`', watchdog, async () => {
  ws.write('of_manifest/workspace.yaml', 'schema: 1\nname: parts\nsources:\n  - folder: ../src\n    packages: [room_msgs]\n');
  const { code, report, stderr } = await build('of_manifest', '-o', 'parts');
  assert.equal(code, 0, stderr);
  assert.deepEqual(report.packages.map((one) => one.name), ['room_msgs']);
});

test('a .repos file, and packages of a distribution by name, become a channel without a workspace', watchdog, async () => {
  const server: GitServer = await serveGit(join(ws.root, 'git'));
  try {
    cpSync(join(ws.root, 'src'), join(ws.root, 'git/room'), { recursive: true });
    const commit = commitAll(join(ws.root, 'git/room'), '1.0');
    ws.write('course.repos', `repositories:\n  room: {type: git, url: "${server.address}/room", version: "1.0"}\n`);
    const all = await build('course.repos', '-o', 'of_repos');
    assert.equal(all.code, 0, all.stderr);
    assert.equal(all.report.added, 4);
    assert.match(all.report.packages[0]?.source ?? '', new RegExp(`/room@${commit}`));
    assert.match(ws.read('of_repos/ros2wasm.lock').toString(), new RegExp(commit));
    const asked = server.requests();
    const again = await build('course.repos', '-o', 'of_repos', '--locked', '--offline');
    assert.deepEqual([again.code, again.report.unchanged, server.requests()], [0, 4, asked], again.stderr);
    const other = await ws.run(['channel', 'build', 'course.repos', '-o', 'not_locked', '--locked']);
    assert.equal(other.code, 1);
    assert.match(other.stderr, /R2W0311/);
    ws.write('distribution.yaml', `%YAML 1.1
---
release_platforms: {ubuntu: [noble]}
repositories:
  room:
    release: {packages: [room_msgs, room_logger], tags: {release: "1.0"}, url: "${server.address}/room", version: 1.2.3-1}
type: distribution
version: 2
`);
    const named = await build('room_logger', 'turtlesim', '--distribution', 'distribution.yaml', '-o', 'of_names');
    assert.equal(named.code, 0, named.stderr);
    assert.deepEqual(named.report.packages.map((one) => [one.name, one.state]), [['room_logger', 'added'], ['room_msgs', 'added'], ['turtlesim', 'skipped']]);
    assert.match(named.report.packages.at(-1)?.cause ?? '', /a channel of the workspace has it: `ros-jazzy-turtlesim`/);
    const unknown = await build('room_attic', '--distribution', 'distribution.yaml', '-o', 'of_names');
    assert.equal(unknown.code, 1);
    assert.match(unknown.stderr, /R2W0513.*no source and no distribution has the package `room_attic`/);
  } finally {
    server.close();
  }
});
