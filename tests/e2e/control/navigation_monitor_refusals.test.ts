// Parameters that Nav2's collision monitor refuses, one mistake after the other until all is well; as a component, and with velocities
// that have a header. Headless.

// Compatibility, works: Nav2's `collision_monitor` as a component, with `enable_stamped_cmd_vel`, and with upstream's texts about what is
// wrong in its parameters

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    params = os.path.join(get_package_share_directory('refused'), 'params', 'nav2_params.yaml')
    return LaunchDescription([
        ComposableNodeContainer(
            name='container', namespace='', package='rclcpp_components', executable='component_container', output='screen',
            composable_node_descriptions=[ComposableNode(package='nav2_collision_monitor', plugin='nav2_collision_monitor::CollisionMonitor',
                                                         name='spare', parameters=[params]),
                                          ComposableNode(package='nav2_collision_monitor', plugin='nav2_collision_monitor::CollisionDetector',
                                                         name='detector', parameters=[params])]),
        Node(package='refused', executable='driver', output='screen'),
    ])
`;

const parameters = `
spare:
  ros__parameters:
    cmd_vel_in_topic: "spare_in"
    cmd_vel_out_topic: "spare_out"
    enable_stamped_cmd_vel: True
    base_shift_correction: False
    eye:
      type: "sonar"
      topic: "scan"
    Zone:
      slowdown_ratio: -0.5
      radius: 0.0
      simulation_time_step: 0.0
      sources_names: ["nose"]
detector:
  ros__parameters:
    observation_sources: ["eye"]
    eye:
      topic: "scan"
    polygons: ["Zone"]
    Zone:
      type: "velocity_polygon"
      action_type: "none"
      velocity_polygons: ["forward"]
      forward:
        points: "[[1, 1], [1, -1], [-1, -1], [-1, 1]]"
        linear_min: -1.0
        linear_max: 1.0
        theta_min: -1.0
        theta_max: 1.0
`;

const driver = `
#include <functional>

#include "geometry_msgs/msg/twist_stamped.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "nav2_util/lifecycle_service_client.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"

using namespace std::chrono_literals;
using geometry_msgs::msg::TwistStamped;

${driverStart}

/// A wall 1.55 m ahead of the robot.
sensor_msgs::msg::LaserScan wall() {
  sensor_msgs::msg::LaserScan scan;
  scan.header.stamp = node->now();
  scan.header.frame_id = "base_footprint";
  scan.angle_min = -0.1F;
  scan.angle_increment = 0.02F;
  scan.range_min = 0.1F;
  scan.range_max = 5.0F;
  scan.ranges.assign(11, 1.55F);
  return scan;
}

void set(const std::string& name, const rclcpp::ParameterValue& value) {
  static rclcpp::AsyncParametersClient client(node, "spare");
  client.wait_for_service();
  auto future = client.set_parameters({rclcpp::Parameter(name, value)});
  rclcpp::spin_until_future_complete(node, future);
  if (!future.get().at(0).successful) say("%s is refused", name.c_str());
}

void try_spare() {
  nav2_util::LifecycleServiceClient client("spare", node);
  const auto configure = [&](const char* what) {
    client.change_state(lifecycle_msgs::msg::Transition::TRANSITION_CONFIGURE, 20s);
    say("%s: %s", what, client.get_state(20s) == lifecycle_msgs::msg::State::PRIMARY_STATE_INACTIVE ? "configured" : "refused");
  };
  using Value = rclcpp::ParameterValue;
  using Names = std::vector<std::string>;
  configure("nothing");
  set("observation_sources", Value(Names{"eye"}));
  configure("a sonar");
  set("eye.type", Value("scan"));
  configure("no polygons");
  set("polygons", Value(Names{"Zone"}));
  configure("no type");
  set("Zone.type", Value("blob"));
  configure("a blob");
  set("Zone.type", Value("polygon"));
  configure("no action");
  set("Zone.action_type", Value("fly"));
  configure("flying");
  set("Zone.action_type", Value("stop"));
  set("Zone.points", Value("[[0.5, 0.5], [0.5"));
  configure("half a list");
  set("Zone.points", Value("[[1, 0], [0, 1], [0, -1]]"));
  configure("a triangle");
  set("Zone.points", Value("[[1, 1], [1, -1], [-1, -1], [-1, 1, 1]]"));
  configure("three numbers");
  set("Zone.points", Value("[[1, 1], [1, -1], [-1, -1], [-1, 1]]"));
  configure("an unknown source");
  set("Zone.sources_names", Value(Names{"eye"}));
  set("Zone.action_type", Value("slowdown"));
  configure("backwards");
  set("Zone.slowdown_ratio", Value(30.0));
  configure("percents");
  set("Zone.action_type", Value("approach"));
  configure("no step");
  set("Zone.simulation_time_step", Value(0.1));
  set("Zone.points", Value("[[1, 1], [1, -1]"));
  configure("half a list, with a footprint to fall back on");
  set("Zone.type", Value("circle"));
  configure("no radius");
  set("Zone.type", Value("polygon"));
  set("Zone.points", Value("[[1, 1], [1, -1], [-1, -1], [-1, 1]]"));
  configure("all is well");
  client.change_state(lifecycle_msgs::msg::Transition::TRANSITION_ACTIVATE, 20s);
  nav2_util::LifecycleServiceClient detector("detector", node);
  detector.change_state(lifecycle_msgs::msg::Transition::TRANSITION_CONFIGURE, 20s);
  say("detector: %s", detector.get_state(20s) == lifecycle_msgs::msg::State::PRIMARY_STATE_UNCONFIGURED ? "refused" : "configured");
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  const auto scans = node->create_publisher<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS());
  const auto timer = node->create_wall_timer(50ms, [&] { scans->publish(wall()); });
  try_spare();
  TwistStamped stamped;
  const auto spare_outs = node->create_subscription<TwistStamped>("spare_out", 1, [&](const TwistStamped& message) { stamped = message; });
  const auto spare_ins = node->create_publisher<TwistStamped>("spare_in", 1);
  spin_until([&] { return spare_ins->get_subscription_count() == 1 && spare_outs->get_publisher_count() == 1; });
  spin_until([] { return false; }, 200ms);
  TwistStamped command;
  command.header.frame_id = "wheels";
  command.twist.linear.x = 1.0;
  spare_ins->publish(command);
  spin_until([&] { return !stamped.header.frame_id.empty(); }, 2s);
  say("stamped: %.2f in %s", stamped.twist.linear.x, stamped.header.frame_id.c_str());
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['geometry_msgs', 'lifecycle_msgs', 'nav2_util', 'rclcpp', 'sensor_msgs'];
  workspace.addPackage('refused', { driver }, {
    depends: [...libraries, 'nav2_collision_monitor', 'rclcpp_components'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(driver ${libraries.join(' ')})
install(DIRECTORY launch params DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/refused/launch/monitor_launch.py', launchFile);
  workspace.write('src/refused/params/nav2_params.yaml', parameters);
  workspace.write('workspace.yaml', 'schema: 1\nname: refused\npackages: [src/*]\nlaunch: src/refused/launch/monitor_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

test('mistakes in parameters are named, and what is right works', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--stepped', '--for', '120s', '--until', 'driver is over']);
  const output = run.stdout + run.stderr;
  assert.equal(run.code, 0, output);
  assert.deepEqual(said(output, 'driver'), [
    ...['nothing', 'a sonar', 'no polygons', 'no type', 'a blob', 'no action', 'flying', 'half a list', 'a triangle', 'three numbers', 'an unknown source',
      'backwards', 'percents', 'no step', 'half a list, with a footprint to fall back on', 'no radius'].map((what) => `${what}: refused`),
    'all is well: configured',
    'detector: refused',
    'stamped: 0.25 in wheels',
    'driver is over',
  ], output);
  const zones = said(output, 'collision_monitor');
  for (
    const line of ['[Zone]: Unknown action type: fly', "Error parsing polygon parameter [[0.5, 0.5], [0.5: 'Unterminated vector string.'",
      'Polygon must have at least three points.', 'Points in the polygon specification must be pairs of numbersFound a point with 3 numbers.',
      '[Zone]: Error while getting polygon parameters: static points and sub topic both not defined',
      "Observation source [nose] configured for polygon [Zone] is not defined as one of the node's observation_source!",
      "[Zone]: Error while getting common polygon parameters: parameter 'Zone.slowdown_ratio' has to be a number from 0 to 1, and is -0.5",
      "[Zone]: Error while getting common polygon parameters: parameter 'Zone.slowdown_ratio' has to be a number from 0 to 1, and is 30"]
  ) assert.ok(zones.includes(line), `nobody says: ${line}\n${output}`);
  const spare = said(output, 'spare');
  for (
    const line of ["Error while getting parameters: parameter 'observation_sources' is not initialized", '[eye]: Unknown source type: sonar',
      "Error while getting parameters: parameter 'polygons' is not initialized", '[Zone]: Unknown polygon type: blob',
      "Error while getting parameters: parameter 'Zone.radius' has to be a number above 0, and is 0.000000"]
  ) assert.ok(spare.includes(line), `spare does not say: ${line}\n${output}`);
  assert.match(output, /\[detector\]: \[Zone\]: The collision detector knows no velocity/);
});
