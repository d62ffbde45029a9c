// Packages as their users write them: ament_cmake_auto, messages of another package used in both languages, groups
// and package.xml of format 2, built for real and run together.
//
// Compatibility, works: `ament_cmake_auto`: `ament_auto_find_build_dependencies`, `ament_auto_add_library`,
// `ament_auto_add_executable`, `ament_auto_package` with `INSTALL_TO_SHARE`
//
// Compatibility, works: interfaces of one package used by C++ and Python nodes of two others, on one topic; `group_depend`
// and `member_of_group`; package.xml of format 2
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { PackWorkspace, finished } from '../support/pack_workspace.ts';

const HEAD = (name: string, format: number): string =>
  `<?xml version="1.0"?>
<package format="${String(format)}">
  <name>${name}</name>
  <version>0.1.0</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
`;
const FILES: Readonly<Record<string, string>> = {
  // Nobody names it as a dependency but through its group.
  'src/zz_interfaces/package.xml': `${HEAD('zz_interfaces', 3)}  <buildtool_depend>ament_cmake</buildtool_depend>
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <member_of_group>lab_interfaces</member_of_group>
  <export><build_type>ament_cmake</build_type></export>
</package>
`,
  'src/zz_interfaces/msg/Level.msg': 'string tank\nfloat32[] samples\n',
  'src/zz_interfaces/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(zz_interfaces)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(\${PROJECT_NAME} "msg/Level.msg")
ament_package()
`,
  'src/a_tank/package.xml': `${HEAD('a_tank', 2)}  <buildtool_depend>ament_cmake_auto</buildtool_depend>
  <depend>rclcpp</depend>
  <depend>zz_interfaces</depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
`,
  'src/a_tank/include/a_tank/filling.hpp': '#pragma once\n#include "zz_interfaces/msg/level.hpp"\nzz_interfaces::msg::Level filling(int step);\n',
  'src/a_tank/src/filling.cpp': `#include "a_tank/filling.hpp"
zz_interfaces::msg::Level filling(int step) {
  zz_interfaces::msg::Level level;
  level.tank = "north";
  level.samples = {0.5F * static_cast<float>(step), 2.0F};
  return level;
}
`,
  'src/a_tank/src/tank.cpp': `#include <chrono>
#include "a_tank/filling.hpp"
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("tank");
  const auto levels = node->create_publisher<zz_interfaces::msg::Level>("levels", 10);
  int step = 0;
  const auto timer = node->create_wall_timer(std::chrono::milliseconds(100), [&] { levels->publish(filling(++step)); });
  const auto answers = node->create_subscription<zz_interfaces::msg::Level>("answers", 10,
    [&](zz_interfaces::msg::Level::ConstSharedPtr level) {
      RCLCPP_INFO(node->get_logger(), "%s answers %.1f", level->tank.c_str(), level->samples.at(0));
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
}
`,
  'src/a_tank/config/tank.yaml': 'tank: {}\n',
  'src/a_tank/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(a_tank)
find_package(ament_cmake_auto REQUIRED)
ament_auto_find_build_dependencies()
ament_auto_add_library(filling src/filling.cpp)
ament_auto_add_executable(tank src/tank.cpp)
ament_auto_package(INSTALL_TO_SHARE config)
`,
  'src/b_gauge/package.xml': `${HEAD('b_gauge', 3)}  <group_depend>lab_interfaces</group_depend>
  <exec_depend>rclpy</exec_depend>
  <exec_depend>zz_interfaces</exec_depend>
  <export><build_type>ament_python</build_type></export>
</package>
`,
  'src/b_gauge/resource/b_gauge': '',
  'src/b_gauge/b_gauge/__init__.py': '',
  'src/b_gauge/b_gauge/gauge.py': `import rclpy
from rclpy.node import Node
from zz_interfaces.msg import Level


class Gauge(Node):
    def __init__(self):
        super().__init__('gauge')
        self.answers = self.create_publisher(Level, 'answers', 10)
        self.create_subscription(Level, 'levels', self.heard, 10)

    def heard(self, level):
        self.get_logger().info(f'{level.tank} has {sum(level.samples):.1f}')
        self.answers.publish(Level(tank='gauge', samples=[sum(level.samples)]))


def main():
    rclpy.init()
    rclpy.spin(Gauge())
`,
  'src/b_gauge/setup.cfg': '[develop]\nscript_dir=$base/lib/b_gauge\n[install]\ninstall_scripts=$base/lib/b_gauge\n',
  'src/b_gauge/setup.py': `from setuptools import find_packages, setup
setup(
    name='b_gauge', version='0.1.0', packages=find_packages(),
    data_files=[('share/ament_index/resource_index/packages', ['resource/b_gauge']), ('share/b_gauge', ['package.xml'])],
    install_requires=['setuptools'], entry_points={'console_scripts': ['gauge = b_gauge.gauge:main']},
)
`,
  'workspace.yaml': `schema: 1
name: tanks
packages: [src/*]
launch:
  - {package: a_tank, executable: tank}
  - {package: b_gauge, executable: gauge}
`,
};

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  for (const [path, text] of Object.entries(FILES)) workspace.write(path, text);
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
});
after(() => workspace.close());

test('a C++ node built by ament_cmake_auto and a Python node talk in messages of a third package', async () => {
  const wanted = [/^\[gauge-2\] .*\[gauge\]: north has \d+\.\d$/m, /^\[tank-1\] .*\[tank\]: gauge answers \d+\.\d$/m];
  const child = workspace.start(['run', 'site', '--for', '120s']);
  let said = '';
  child.stdout?.on('data', (bytes: Buffer) => {
    said += bytes.toString();
    if (!child.killed && wanted.every((line) => line.test(said))) child.kill('SIGINT');
  });
  const ran = await finished(child);
  assert.equal(ran.code, 130, `${ran.stderr}\n${ran.stdout.slice(-4000)}`);
});

test('what ament_auto_package installs is there', async () => {
  const built = await workspace.run(['build', '--json']);
  assert.equal(built.code, 0, built.stderr);
  const packages = JSON.parse(built.stdout) as readonly { package: string; prefix: string; }[];
  const prefix = packages.find((one) => one.package === 'a_tank')?.prefix ?? '';
  for (const path of ['share/a_tank/config/tank.yaml', 'lib/libfilling.a', 'lib/a_tank/tank.wasm'])
    assert.ok(existsSync(`${prefix}/${path}`), path);
  // Its group puts the interfaces first, whatever the names are.
  assert.deepEqual(packages.map((one) => one.package), ['zz_interfaces', 'a_tank', 'b_gauge']);
});
