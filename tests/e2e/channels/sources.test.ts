// `sources:` of a manifest: packages of git repositories are fetched, locked, built and run, as the lock has them.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { commitAll, git, type GitServer, serveGit } from '../../support/git_server.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 120_000 };

const packageXml = (name: string, type: string, depends: string): string =>
  `<package format="3">
  <name>${name}</name><version>0.3.0</version><description>Part of a lab</description>
  <maintainer email="someone@example.org">Someone</maintainer><license>BSD-3-Clause</license>
  ${depends}<export><build_type>${type}</build_type></export>
</package>
`;

/** Upstream: a message, a program in C++ that needs it, and a package that cannot be built here. */
const arms: Readonly<Record<string, string>> = {
  'LICENSE': 'Redistribution and use in source and binary forms are permitted.\n',
  'arm_msgs/package.xml': packageXml('arm_msgs', 'ament_cmake', `<buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend><member_of_group>rosidl_interface_packages</member_of_group>`),
  'arm_msgs/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(arm_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(\${PROJECT_NAME} "msg/Reach.msg")
ament_package()
`,
  'arm_msgs/msg/Reach.msg': 'float64 meters\n',
  'arm_driver/package.xml': packageXml('arm_driver', 'ament_cmake', '<depend>rclcpp</depend><depend>arm_msgs</depend>'),
  'arm_driver/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(arm_driver)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(arm_msgs REQUIRED)
add_executable(driver src/driver.cpp)
ament_target_dependencies(driver rclcpp arm_msgs)
install(TARGETS driver DESTINATION lib/\${PROJECT_NAME})
ament_package()
`,
  'arm_driver/src/driver.cpp': `#include <arm_msgs/msg/reach.hpp>
#include <rclcpp/rclcpp.hpp>
#include "reach.hpp"
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("driver");
  auto publisher = node->create_publisher<arm_msgs::msg::Reach>("reach", rclcpp::QoS(1).transient_local());
  arm_msgs::msg::Reach message;
  message.meters = kReach;
  publisher->publish(message);
  rclcpp::spin(node);
}
`,
  'arm_driver/src/reach.hpp': 'constexpr double kReach = 0.75;\n',
  'arm_camera/package.xml': packageXml('arm_camera', 'ament_cmake', '<depend>librealsense2</depend>'),
  'arm_camera/CMakeLists.txt': 'cmake_minimum_required(VERSION 3.8)\nproject(arm_camera)\nfind_package(realsense2 REQUIRED)\n',
};

const LISTENER = `import rclpy
from arm_msgs.msg import Reach
from rclpy.qos import DurabilityPolicy, QoSProfile


def main():
    rclpy.init()
    node = rclpy.create_node('listener')
    quality = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(Reach, 'reach', lambda heard: print(f'reach {heard.meters} m', flush=True), quality)
    rclpy.spin(node)
`;

let ws: PackWorkspace;
let server: GitServer;
let first = '';
const upstream = (): string => join(ws.root, 'git/arms');

function writeManifest(more = ''): void {
  ws.write('workspace.yaml', `schema: 1
name: lab
packages: [src/*]
sources:
  - git: ${server.address}/arms
    revision: "1.0"
    packages: [arm_driver, arm_msgs]
launch:
  - {package: arm_driver, executable: driver}
  - {package: lab, executable: listener}
${more}`);
}

async function succeeds(...words: readonly string[]): Promise<string> {
  const { code, stdout, stderr } = await ws.run(words);
  assert.equal(code, 0, stderr);
  return stdout + stderr;
}

const heard = (): Promise<string> => succeeds('run', 'site', '--for', '20s', '--until', 'reach 0');

before(async () => {
  ws = new PackWorkspace();
  for (const [path, text] of Object.entries(arms)) ws.write(`git/arms/${path}`, text);
  first = commitAll(upstream(), '1.0');
  server = await serveGit(join(ws.root, 'git'));
  ws.addPythonPackage('lab', { listener: LISTENER }, ['rclpy', 'arm_msgs']);
  writeManifest();
});
after(() => {
  server.close();
  ws.close();
});

test('check reports that a source is not here, and fetches nothing', watchdog, async () => {
  const { code, stderr } = await ws.run(['check']);
  assert.equal(code, 0, stderr);
  assert.match(stderr, /warning\[R2W0253\]: `http:\/\/127\.0\.0\.1:\d+\/arms` is not on this machine/);
  assert.equal(server.requests(), 0);
});

test('build --plan says what would be built, and from where, and builds nothing', watchdog, async () => {
  const said = await succeeds('build', '--plan');
  assert.match(said, new RegExp(`^arm_driver 0\\.3\\.0 {2}about \\d+ s {2}git\\+http://127\\.0\\.0\\.1:\\d+/arms@${first}$`, 'm'));
  assert.match(said, /^lab 1\.2\.3 {2}about \d+ s$/m);
  assert.match(said, /to build: 3 of 3 packages, about \d+ s one after the other/);
  assert.equal(existsSync(join(ws.root, 'site')), false);
  const json = JSON.parse((await ws.run(['--json', 'build', '--plan'])).stdout) as readonly { readonly package: string; readonly cached: boolean; }[];
  assert.deepEqual(json.map((one) => [one.package, one.cached]).sort(), [['arm_driver', false], ['arm_msgs', false], ['lab', false]]);
});

test('a package of a git repository is fetched with what it needs, locked by its commit, built and run', watchdog, async () => {
  const said = await succeeds('pack', '-o', 'site');
  assert.match(said, new RegExp(`from arms 1\\.0, commit ${first.slice(0, 10)}: arm_driver, arm_msgs`));
  assert.doesNotMatch(said, /arm_camera/);
  const lock = ws.read('ros2wasm.lock').toString();
  assert.match(lock, new RegExp(
    `sources:\n  - git: .*/arms"?\n    revision: "1\\.0"\n    commit: "?${first}"?\n    tree: "?${git(upstream(), 'rev-parse', 'HEAD^{tree}')}"?\n`,
  ));
  assert.match(await heard(), /reach 0\.75 m/);
  const place = `http://127\\.0\\.0\\.1:\\d+/arms 1\\.0, commit ${first.slice(0, 10)}`;
  assert.match(await succeeds('tree'), new RegExp(`^built from ${place}\n\\|-- arm_driver 0\\.3\\.0\n\`-- arm_msgs 0\\.3\\.0$`, 'm'));
  assert.match(await succeeds('why', 'arm_msgs'), new RegExp(`^arm_msgs is built from ${place}$`, 'm'));
  assert.match(await succeeds('build', '--plan'), /nothing to build: 3 packages are cached/);
  const licenses = ws.read('site/sbom.spdx.json').toString();
  assert.match(licenses, new RegExp(`git\\+http://127\\.0\\.0\\.1:\\d+/arms@${first}`));
  assert.match(ws.read('site/LICENSES.txt').toString(), /Redistribution and use in source and binary forms are permitted/);
});

// Guarantee, same bytes: a site of fetched sources, while the lock has their commits: a tag that moves changes nothing
test('with the lock, a tag that moves changes nothing, and nobody is asked', watchdog, async () => {
  ws.write('git/arms/arm_driver/src/reach.hpp', 'constexpr double kReach = 0.25;\n');
  commitAll(upstream(), '1.0');
  const asked = server.requests();
  const before = ws.files('site');
  await succeeds('pack', '-o', 'site', '--locked', '--offline');
  assert.deepEqual(ws.files('site'), before);
  await succeeds('pack', '-o', 'site', '--frozen');
  assert.equal(server.requests(), asked);
  assert.equal((await ws.run(['lock', '--check'])).code, 0);
  // The cache is lost: the old commit comes again, although no tag leads to it.
  rmSync(join(ws.cache, 'ros2wasm/sources'), { recursive: true });
  const offline = await ws.run(['pack', '-o', 'site', '--offline']);
  assert.match(offline.stderr, /error\[R2W0253\][^]*ros2wasm cache fetch ros2wasm\.lock/);
  await succeeds('cache', 'fetch', 'ros2wasm.lock');
  await succeeds('pack', '-o', 'site', '--offline');
  assert.deepEqual(ws.files('site'), before);
});

test('lock --update takes what the tag names now', watchdog, async () => {
  const manifest = ws.read('workspace.yaml').toString();
  const { code, stderr } = await ws.run(['lock', '--update', 'arms']);
  assert.equal(code, 0, stderr);
  const now = git(upstream(), 'rev-parse', 'HEAD');
  assert.match(ws.read('ros2wasm.lock').toString(), new RegExp(now));
  await succeeds('pack', '-o', 'site');
  assert.match(await heard(), /reach 0\.25 m/);
  // Another revision than the lock has is not packed with --locked.
  ws.write('workspace.yaml', manifest.replace('"1.0"', 'main'));
  const locked = await ws.run(['pack', '-o', 'site', '--locked']);
  assert.match(locked.stderr, /error\[R2W0311\]: the source `arms` is not in the lock/);
  ws.write('workspace.yaml', manifest);
});

test("a package of the workspace takes the place of the source's", watchdog, async () => {
  ws.addPackage('arm_driver', { driver: '#include <cstdio>\nint main() { std::puts("my own driver"); }\n' });
  const said = await succeeds('pack', '-o', 'site');
  assert.match(said, /arm_driver is taken from the workspace, not from a source/);
  assert.match(await succeeds('run', 'site', '--for', '20s', '--until', 'my own driver'), /my own driver/);
  rmSync(join(ws.root, 'src/arm_driver'), { recursive: true });
});

// Guarantee, verified: `ros2wasm rebuild` makes a site with fetched sources once more from what it carries, without a network
test('a site carries its sources, and is made once more from them without a network', watchdog, async () => {
  writeManifest('site: {sources: true}\n');
  await succeeds('pack', '-o', 'site');
  const asked = server.requests();
  rmSync(join(ws.cache, 'ros2wasm/sources'), { recursive: true });
  assert.match(await succeeds('rebuild', 'site'), /its sources make the same site/);
  assert.equal(server.requests(), asked);
});

test('a folder beside the workspace and a .repos file name packages too', watchdog, async () => {
  ws.write('lab.repos', `repositories:\n  group/arms:\n    type: git\n    url: ${server.address}/arms\n    version: main\n`);
  ws.write('deep/workspace.yaml', `schema: 1
name: deep
packages: [../src/*]
sources:
  - repos: ../lab.repos
    packages: [arm_msgs]
  - folder: ../git/arms
    packages: [arm_driver]
launch:
  - {package: arm_driver, executable: driver}
  - {package: lab, executable: listener}
`);
  const said = await succeeds('pack', 'deep', '-o', 'deep_site');
  assert.match(said, /from arms main, commit \w{10}: arm_msgs\n[^]*from arms: arm_driver\n/);
  assert.doesNotMatch(ws.read('deep/ros2wasm.lock').toString(), /folder/);
  assert.match(await succeeds('run', 'deep_site', '--for', '20s', '--until', 'reach 0'), /reach 0\.25 m/);
});

// Guarantee, hostile input: a repository on the web whose submodule is a path on this machine, or needs the user's ssh keys
test('a submodule of a repository on the web does not lead to this machine', watchdog, async () => {
  ws.write('git/secret/arm/package.xml', packageXml('arm_secret', 'ament_cmake', ''));
  const secret = commitAll(join(ws.root, 'git/secret'), '1.0');
  for (const url of [`file://${join(ws.root, 'git/secret')}`, join(ws.root, 'git/secret'), 'git@127.0.0.1:secret.git']) {
    const trap = join(ws.root, 'git/trap');
    ws.write('git/trap/arm/package.xml', packageXml('arm', 'ament_cmake', ''));
    ws.write('git/trap/.gitmodules', `[submodule "s"]\n\tpath = s\n\turl = ${url}\n`);
    commitAll(trap, '1.0');
    git(trap, 'update-index', '--add', '--cacheinfo', `160000,${secret},s`);
    git(trap, 'commit', '--quiet', '--amend', '--message', 'trap');
    ws.write('trapped/workspace.yaml',
      `schema: 1\nname: trapped\nsources: [{git: "${server.address}/trap", revision: main}]\nlaunch:\n  - {package: arm, executable: arm}\n`);
    const { code, stderr } = await ws.run(['pack', 'trapped', '-o', 'trapped_site']);
    assert.equal(code, 1, stderr);
    assert.match(stderr, /error\[R2W0254\]: the source `trap` is not taken\n[^]*its submodule `s` comes from/);
    rmSync(trap, { recursive: true });
  }
});

test('leftovers of fetches are removed by cache prune, and the rest stays', watchdog, async () => {
  const sources = join(ws.cache, 'ros2wasm/sources');
  assert.deepEqual(existsSync(join(sources, 'unfinished')) ? readdirSync(join(sources, 'unfinished')) : [], []);
  assert.match(await succeeds('cache', 'verify'), / 0 damaged/);
  await succeeds('cache', 'prune');
  const asked = server.requests();
  await succeeds('pack', 'deep', '-o', 'deep_site', '--offline');
  assert.equal(server.requests(), asked);
});
