// Rules of ROS 2 that decide what a program says: which of several parameter files counts, what broadcasters of static frames
// keep, how refused changes of a goal's state are worded, and handlers of launch files that are followed once.

// Compatibility, works: parameter files and dictionaries by rcl's rule: node names in the order in which they appear first, and in
// Python the node's own name before wildcards; launch dictionaries go to the node alone when its whole name is known

// Compatibility, works: `StaticTransformBroadcaster` of Python keeps a frame where it was said first, that of C++ moves it

// Compatibility, works: `handle_once` of event handlers that look at several processes or at any

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const SHOW_CPP = `#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("show");
  RCLCPP_INFO(node->get_logger(), "blue is %ld", node->declare_parameter<int64_t>("blue", 0));
  rclcpp::shutdown();
}
`;
const SHOW_PY = `import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('show')
    print('blue is', node.declare_parameter('blue', 0).value, flush=True)
    rclpy.shutdown()
`;
const EXACT = [['show_a', 5], ['/robot/show_b', 6], ['show_c', 7]].map(([name, value]) => `${name}:\n  ros__parameters:\n    blue: ${value}\n`).join('');
const PRECEDENCE = (package_: string): string =>
  `from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def show(name, *parameters, **more):
    return Node(package='${package_}', executable='show', name=name, output='screen', parameters=list(parameters), **more)


def generate_launch_description():
    exact = PathJoinSubstitution([FindPackageShare('rules_cpp'), 'config', 'exact.yaml'])
    return LaunchDescription([
        show('show_a', {'blue': 100}, exact, {'blue': 200}),
        show('show_b', {'blue': 100}, exact, {'blue': 200}, namespace='/robot'),
        show('show_c', exact, {'blue': 200}),
    ])
`;

const GIVER_PY = `import rclpy
from geometry_msgs.msg import TransformStamped
from tf2_ros import StaticTransformBroadcaster


def main():
    rclpy.init()
    node = rclpy.create_node('giver')
    broadcaster = StaticTransformBroadcaster(node)
    for child, x in (('left', 1.0), ('right', 2.0), ('left', 9.0), ('last', 0.0)):
        transform = TransformStamped()
        transform.header.frame_id = 'base'
        transform.child_frame_id = child
        transform.transform.translation.x = x
        transform.transform.rotation.w = 1.0
        broadcaster.sendTransform(transform)
    rclpy.spin(node)
`;
const GIVER_CPP = `#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("giver");
  tf2_ros::StaticTransformBroadcaster broadcaster(node);
  for (const auto& [child, x] : {std::pair{"left", 1.0}, std::pair{"right", 2.0}, std::pair{"left", 9.0}, std::pair{"last", 0.0}}) {
    geometry_msgs::msg::TransformStamped transform;
    transform.header.frame_id = "base";
    transform.child_frame_id = child;
    transform.transform.translation.x = x;
    transform.transform.rotation.w = 1.0;
    broadcaster.sendTransform(transform);
  }
  rclcpp::spin(node);
}
`;
const LATE_PY = `import rclpy
from rclpy.time import Time
from tf2_ros import Buffer, TransformListener


def main():
    rclpy.init()
    node = rclpy.create_node('late')
    buffer = Buffer()
    TransformListener(buffer, node, spin_thread=False)
    while not buffer.can_transform('base', 'last', Time()):
        rclpy.spin_once(node, timeout_sec=0.1)
    for child in ('left', 'right'):
        print(child, buffer.lookup_transform('base', child, Time()).transform.translation.x, flush=True)
`;

const EARLY_CPP = `#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
using Fibonacci = example_interfaces::action::Fibonacci;
using Handle = rclcpp_action::ServerGoalHandle<Fibonacci>;
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("early");
  auto server = rclcpp_action::create_server<Fibonacci>(
      node, "early",
      [](const rclcpp_action::GoalUUID&, std::shared_ptr<const Fibonacci::Goal>) { return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE; },
      [](std::shared_ptr<Handle>) { return rclcpp_action::CancelResponse::ACCEPT; },
      [&](std::shared_ptr<Handle> handle) {
        try {
          handle->canceled(std::make_shared<Fibonacci::Result>());
          RCLCPP_INFO(node->get_logger(), "accepted");
        } catch (const rclcpp::exceptions::RCLError& error) {
          RCLCPP_INFO(node->get_logger(), "refused: %s", error.what());
          handle->abort(std::make_shared<Fibonacci::Result>());
        }
      });
  auto client = rclcpp_action::create_client<Fibonacci>(node, "early");
  client->wait_for_action_server();
  auto options = rclcpp_action::Client<Fibonacci>::SendGoalOptions();
  options.result_callback = [&](const auto& result) {
    RCLCPP_INFO(node->get_logger(), "result code %d", static_cast<int>(result.code));
    rclcpp::shutdown();
  };
  client->async_send_goal(Fibonacci::Goal(), options);
  rclcpp::spin(node);
}
`;

/** \`exits\`: of two processes that end, the first one is followed. */
const ONCE = `from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler, Shutdown, TimerAction
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    listener = Node(package='demo_nodes_cpp', executable='listener', output='screen')
    client = Node(package='demo_nodes_cpp', executable='add_two_ints_client', output='screen')
    return LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=None, on_start=[listener], handle_once=True)),
        RegisterEventHandler(OnProcessExit(target_action=lambda action: action is not listener, handle_once=True,
                                           on_exit=lambda event, context: LogInfo(msg=f'one has ended: {event.process_name}'))),
        RegisterEventHandler(OnProcessExit(
            target_action=client,
            # On a busy machine the client is done before the listener has begun.
            on_exit=[LogInfo(msg='client is done, all ends'), TimerAction(period=5.0, actions=[Shutdown(reason='client done')])])),
        Node(package='demo_nodes_cpp', executable='talker', output='screen'),
        Node(package='demo_nodes_cpp', executable='add_two_ints_server', output='screen'),
        client,
    ])
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('rules_cpp', { show: SHOW_CPP, giver: GIVER_CPP, early: EARLY_CPP }, {
    depends: ['rclcpp', 'rclcpp_action', 'example_interfaces', 'geometry_msgs', 'tf2_ros', 'demo_nodes_cpp'],
    cmake: `foreach(name IN ITEMS rclcpp rclcpp_action example_interfaces geometry_msgs tf2_ros)
  find_package(\${name} REQUIRED)
endforeach()
ament_target_dependencies(show rclcpp)
ament_target_dependencies(giver rclcpp geometry_msgs tf2_ros)
ament_target_dependencies(early rclcpp rclcpp_action example_interfaces)
install(DIRECTORY config launch DESTINATION share/\${PROJECT_NAME})`,
  });
  workspace.write('src/rules_cpp/config/exact.yaml', EXACT);
  workspace.write('src/rules_cpp/launch/precedence.launch.py', PRECEDENCE('rules_cpp'));
  workspace.write('src/rules_cpp/launch/precedence_py.launch.py', PRECEDENCE('rules_py'));
  workspace.write('src/rules_cpp/launch/once.launch.py', ONCE);
  workspace.addPythonPackage('rules_py', { show: SHOW_PY, giver: GIVER_PY, late: LATE_PY }, ['rclpy', 'geometry_msgs', 'tf2_ros_py']);
});
after(() => workspace.close());

async function said(name: string, launch: string, until: readonly string[]): Promise<string> {
  workspace.write(`${name}.yaml`, `schema: 1\nname: ${name}\npackages: [src/*]\n${launch}`);
  const packed = await workspace.run(['pack', `${name}.yaml`, '--output', `site_${name}`]);
  assert.equal(packed.code, 0, packed.stderr);
  const ran = await workspace.run(['run', `site_${name}`, ...until, '--for', '90s']);
  return `${ran.stdout}${ran.stderr}`;
}

test('a parameter that is said several times', { timeout: 500_000 }, async () => {
  const cpp = await said('precedence', 'launch: src/rules_cpp/launch/precedence.launch.py\n', []);
  for (const line of ['[show_a]: blue is 5', '[robot.show_b]: blue is 200', '[show_c]: blue is 200']) assert.ok(cpp.includes(line), cpp);
  const python = await said('precedence_py', 'launch: src/rules_cpp/launch/precedence_py.launch.py\n', []);
  for (const line of [/^\[show-1\] blue is 5$/m, /^\[show-2\] blue is 200$/m, /^\[show-3\] blue is 7$/m]) assert.match(python, line);
});

for (const [name, left] of [['rules_py', '1.0'], ['rules_cpp', '9.0']] as const) {
  test(`a static frame that the broadcaster of ${name} is given again`, { timeout: 500_000 }, async () => {
    const all = await said(`frames_${name}`, `launch:\n  - {package: ${name}, executable: giver}\n  - {package: rules_py, executable: late}\n`, ['--until',
      'right 2.0']);
    assert.match(all, new RegExp(`left ${left}\n(?:.*\n)*.*right 2\\.0`), all);
  });
}

test('a goal that is canceled without a request', { timeout: 500_000 }, async () => {
  const all = await said('early', 'launch:\n  - {package: rules_cpp, executable: early}\n', ['--until', 'result code']);
  assert.match(all, /refused: goal_handle attempted invalid transition from state EXECUTING with event CANCELED, at [^\n]+:\d+\n/);
  assert.match(all, /result code 6\n/);
  assert.doesNotMatch(all, /accepted/);
});

test('a handler that is followed once', { timeout: 500_000 }, async () => {
  const all = await said('once', 'launch: src/rules_cpp/launch/once.launch.py\n', []);
  assert.match(all, /client is done, all ends/);
  assert.equal(all.match(/one has ended: /g)?.length, 1, all);
  assert.equal(new Set(all.match(/^\[listener-\d+\]/gm)).size, 1, all);
});
