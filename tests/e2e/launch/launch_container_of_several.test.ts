// A container of a launch file with components of several packages is one program, as natively one process loads their
// libraries.
//
// Compatibility, works: containers of launch files with components of several packages of the workspace: one program and
// one worker, with intra-process communication between them
//
// Compatibility, differs: a container of a launch file with components of the channels' packages -> is refused (R2W0402):
// these have no containers; the programs that they have for their components run as nodes

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
});
after(() => workspace.close());

/** A package with one component of this name, whose class is `code`, on top of rclcpp::Node. */
function addComponent(name: string, code: string): void {
  workspace.addPackage(name, {}, {
    depends: ['rclcpp', 'rclcpp_components', 'std_msgs'],
    cmake: `find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
find_package(std_msgs REQUIRED)
add_link_options(-O1)
add_library(part SHARED src/part.cpp)
ament_target_dependencies(part rclcpp rclcpp_components std_msgs)
rclcpp_components_register_nodes(part "${name}::Part")
install(TARGETS part ARCHIVE DESTINATION lib LIBRARY DESTINATION lib)
`,
  });
  workspace.write(`src/${name}/src/part.cpp`, `#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/string.hpp>
using Text = std_msgs::msg::String;
namespace ${name} {
struct Part : rclcpp::Node {
  explicit Part(const rclcpp::NodeOptions& options) : Node("${name}", options) {
${code}
  }
  std::shared_ptr<void> first, second;
};
}  // namespace ${name}
RCLCPP_COMPONENTS_REGISTER_NODE(${name}::Part)
`);
}

test('a message goes from a component of one package to one of another as it lies in memory', async () => {
  addComponent('giver', `    auto gifts = create_publisher<Text>("gifts", 10);
    first = gifts;
    second = create_wall_timer(std::chrono::milliseconds(100), [this, gifts] {
      auto gift = std::make_unique<Text>();
      RCLCPP_INFO(get_logger(), "gave %p", static_cast<void*>(gift.get()));
      gifts->publish(std::move(gift));
    });`);
  addComponent('taker', `    first = create_subscription<Text>("gifts", 10, [this](Text::UniquePtr gift) {
      RCLCPP_INFO(get_logger(), "took %p", static_cast<void*>(gift.get()));
    });`);
  workspace.write('gifts.launch.py', `
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes
from launch_ros.descriptions import ComposableNode


def part(package):
    return ComposableNode(package=package, plugin=package + '::Part', extra_arguments=[{'use_intra_process_comms': True}])


def generate_launch_description():
    box = ComposableNodeContainer(package='rclcpp_components', executable=LaunchConfiguration('kind'), name='box', namespace='',
                                  composable_node_descriptions=[part('giver')])
    return LaunchDescription([
        DeclareLaunchArgument('kind', default_value='component_container', choices=['component_container', 'component_container_mt']),
        box, LoadComposableNodes(target_container='/box', composable_node_descriptions=[part('taker')])])
`);
  workspace.write('gifts.yaml', 'schema: 1\nname: gifts\npackages: [src/giver, src/taker]\nlaunch: gifts.launch.py\n');
  const packed = await workspace.run(['pack', 'gifts.yaml', '--output', 'gifts']);
  assert.equal(packed.code, 0, packed.stderr);
  for (const kind of ['component_container', 'component_container_mt']) {
    const run = await workspace.run(['run', 'gifts', '--link', 'shared', '--until', 'took', '--for', '60s', `kind:=${kind}`]);
    assert.equal(run.code, 0, `${run.stdout}${run.stderr}`);
    const took = new RegExp(`^\\[${kind}-1\\].* \\[taker\\]: took (\\S+)$`, 'm').exec(run.stdout)?.[1];
    assert.ok(took, run.stdout);
    assert.match(run.stdout, new RegExp(`^\\[${kind}-1\\].* \\[giver\\]: gave ${took}$`, 'm'));
  }
  const listed = await workspace.run(['ros2', 'gifts', 'component', 'list']);
  assert.equal(listed.code, 0, listed.stderr);
  assert.match(listed.stdout, /^\/box\n +1 +\/giver\n +2 +\/taker$/m);
});

test('a component of a channel is refused, with the line of the launch file', async () => {
  workspace.write('frames.launch.py', `
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return LaunchDescription([ComposableNodeContainer(
        package='rclcpp_components', executable='component_container', name='box', namespace='',
        composable_node_descriptions=[ComposableNode(package='giver', plugin='giver::Part'),
                                      ComposableNode(package='tf2_ros', plugin='tf2_ros::StaticTransformBroadcasterNode')])])
`);
  workspace.write('frames.yaml', 'schema: 1\nname: frames\npackages: [src/giver]\ndependencies: [tf2_ros]\nlaunch: frames.launch.py\n');
  const packed = await workspace.run(['pack', 'frames.yaml', '--output', 'frames']);
  assert.equal(packed.code, 1, packed.stderr);
  assert.match(packed.stderr, /error\[R2W0402\]: package `tf2_ros` has no executable `component_container`\n --> frames\.launch\.py:\d+/);
});
