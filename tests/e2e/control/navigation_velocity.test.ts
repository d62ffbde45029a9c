// The velocity smoother of Nav2: steps of a command, the end of one that nobody repeats, proportions of axes, odometry, and what its
// parameters refuse. Headless, stepped.

// Compatibility, works: Nav2's `velocity_smoother`, as a program and a component, with all parameters of upstream, in an open and a
// closed loop, with and without headers; it does not wake up while nobody commands

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
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
    params = os.path.join(get_package_share_directory('gentle'), 'params', 'nav2_params.yaml')
    return LaunchDescription([
        Node(package='nav2_velocity_smoother', executable='velocity_smoother', name='velocity_smoother', output='screen',
             parameters=[params], remappings=[('cmd_vel', 'cmd_vel_nav')]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True, 'node_names': ['velocity_smoother', 'boxed']}]),
        ComposableNodeContainer(name='box', namespace='', package='rclcpp_components', executable='component_container',
                                composable_node_descriptions=[ComposableNode(
                                    package='nav2_velocity_smoother', plugin='nav2_velocity_smoother::VelocitySmoother', name='boxed',
                                    parameters=[{'max_accel': [1.0, 0.0, 0.0]}], remappings=[('cmd_vel_smoothed', 'boxed_velocity')])]),
        Node(package='gentle', executable='driver', output='screen'),
        Node(package='gentle', executable='own', output='screen', parameters=[params]),
    ])
`;

const parameters = `
velocity_smoother:
  ros__parameters:
    smoothing_frequency: 20.0
    scale_velocities: False
    feedback: "OPEN_LOOP"
    max_velocity: [0.5, 0.0, 2.5]
    min_velocity: [-0.5, 0.0, -2.5]
    max_accel: [2.5, 0.0, 3.2]
    max_decel: [-2.5, 0.0, -3.2]
    odom_topic: "odom"
    odom_duration: 0.1
    deadband_velocity: [0.0, 0.0, 0.0]
    velocity_timeout: 1.0
`;

const driver = `
#include <functional>
#include <geometry_msgs/msg/twist.hpp>
#include <rclcpp/rclcpp.hpp>

using namespace std::chrono_literals;
using geometry_msgs::msg::Twist;

${driverStart}

std::vector<double> speeds;
std::vector<double> times;

std::string listed(size_t first, size_t count) {
  std::string text;
  for (size_t i = first; i < std::min(first + count, speeds.size()); ++i) {
    char one[16];
    std::snprintf(one, sizeof one, " %.3f", speeds[i]);
    text += one;
  }
  return text;
}

void set(const rclcpp::AsyncParametersClient::SharedPtr& client, const std::vector<rclcpp::Parameter>& values) {
  auto future = client->set_parameters(values);
  rclcpp::spin_until_future_complete(node, future);
  for (const auto& result : future.get()) say("set: %d %s", result.successful, result.reason.c_str());
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  const auto commands = node->create_publisher<Twist>("cmd_vel_nav", 1);
  const auto smoothed = node->create_subscription<Twist>("cmd_vel_smoothed", 10, [](const Twist& twist) {
    speeds.push_back(twist.linear.x);
    times.push_back(node->now().seconds());
  });
  const auto client = std::make_shared<rclcpp::AsyncParametersClient>(node, "velocity_smoother");
  std::vector<double> boxed;
  const auto component = node->create_subscription<Twist>("boxed_velocity", 10, [&boxed](const Twist& twist) { boxed.push_back(twist.linear.x); });
  // A smoother passes commands on once it is active.
  Twist command;
  const auto box = node->create_publisher<Twist>("cmd_vel", 1);
  while (rclcpp::ok() && (speeds.empty() || boxed.empty())) {
    commands->publish(command);
    box->publish(command);
    pass(100ms);
  }
  pass(2s);
  const size_t quiet = speeds.size();
  pass(2s);
  say("nothing comes from nothing: %d", speeds.size() == quiet);

  speeds.clear();
  times.clear();
  command.linear.x = 9.0;
  const double sent = node->now().seconds();
  commands->publish(command);
  pass(3s);
  say("steps:%s", listed(0, 6).c_str());
  const double last = times.back() - sent;
  const auto first_fall = std::find_if(speeds.begin() + 4, speeds.end(), [](double speed) { return speed < 0.4999; });
  const size_t fall = first_fall - speeds.begin();
  say("falls at %d:%s", std::abs(times[fall] - sent - 1.05) < 0.06, listed(fall, 9).c_str());
  say("last after 1.2 s: %d, period %.3f", std::abs(last - 1.2) < 0.06, (times[3] - times[0]) / 3);

  command.linear.x = std::nan("");
  commands->publish(command);
  pass(1s);
  say("after NaN %d", times.back() - sent == last);

  using rclcpp::Parameter;
  set(client, {Parameter("max_accel", std::vector<double>{-1.0, 0.0, 0.0})});
  set(client, {Parameter("max_decel", std::vector<double>{1.0, 0.0, 0.0})});
  set(client, {Parameter("max_velocity", std::vector<double>{1.0, -1.0, 0.0})});
  set(client, {Parameter("min_velocity", std::vector<double>{1.0, 0.0, 0.0})});
  set(client, {Parameter("deadband_velocity", std::vector<double>{1.0})});
  set(client, {Parameter("smoothing_frequency", 0.0)});
  set(client, {Parameter("feedback", "LOOP")});
  set(client, {Parameter("velocity_timeout", std::nan(""))});
  set(client, {Parameter("smoothing_frequency", 10.0), Parameter("velocity_timeout", 0.25),
               Parameter("max_velocity", std::vector<double>{1.0, 0.0, 0.0}),
               Parameter("max_decel", std::vector<double>{-5.0, 0.0, -1.0}),
               Parameter("deadband_velocity", std::vector<double>{0.3, 0.0, 0.0})});
  speeds.clear();
  command.linear.x = 2.0;
  commands->publish(command);
  pass(2s);
  say("at 10 Hz:%s", listed(0, 20).c_str());
  boxed.clear();
  command.linear.x = 0.2;
  box->publish(command);
  pass(500ms);
  say("a component: %.3f %.3f %.3f %.3f", boxed.at(0), boxed.at(1), boxed.at(2), boxed.at(3));
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

const own = `
#include <cstdio>

#include <nav2_velocity_smoother/velocity_smoother.hpp>
#include <nav_msgs/msg/odometry.hpp>

using namespace std::chrono_literals;
using geometry_msgs::msg::TwistStamped;
using rclcpp::Parameter;

rclcpp::Node::SharedPtr node;
rclcpp::executors::SingleThreadedExecutor executor;

template <typename... T>
void say(const char* format, T... values) { RCLCPP_INFO(node->get_logger(), format, values...); }

void pass(std::chrono::nanoseconds time) {
  const auto end = node->now() + rclcpp::Duration(time);
  while (rclcpp::ok() && node->now() < end) {
    executor.spin_some();
    rclcpp::sleep_for(5ms);
  }
}

/// A smoother shows whether it has a reason to wake up.
class Probe : public nav2_velocity_smoother::VelocitySmoother {
 public:
  using VelocitySmoother::VelocitySmoother;
  bool sleeps() const { return timer_ && timer_->is_canceled(); }
};

std::shared_ptr<Probe> probe(const char* name, const std::vector<Parameter>& parameters) {
  std::vector<Parameter> all = {Parameter("enable_stamped_cmd_vel", true), Parameter("bond_heartbeat_period", 0.0)};
  all.insert(all.end(), parameters.begin(), parameters.end());
  const std::string rename = std::string("__node:=") + name;
  const std::string topics = std::string("__ns:=/") + name;
  return std::make_shared<Probe>(rclcpp::NodeOptions().use_global_arguments(false).arguments({"--ros-args", "-r", rename, "-r", topics})
      .parameter_overrides(all));
}

void show_steps(const char* name, const std::vector<Parameter>& parameters, bool is_stamped) {
  auto smoother = probe(name, parameters);
  executor.add_node(smoother->get_node_base_interface());
  const std::string prefix = std::string("/") + name + "/";
  std::string text;
  TwistStamped command;
  const auto smoothed = node->create_subscription<TwistStamped>(prefix + "cmd_vel_smoothed", 10, [&](const TwistStamped& twist) {
    const auto after = rclcpp::Time(twist.header.stamp) - rclcpp::Time(command.header.stamp);
    char one[96];
    std::snprintf(one, sizeof one, " (%.3f %.3f at %.0f %s)", twist.twist.linear.x, twist.twist.angular.z, after.seconds() * 1000,
        twist.header.frame_id.c_str());
    text += one;
  });
  const auto commands = node->create_publisher<TwistStamped>(prefix + "cmd_vel", 1);
  const auto odometries = node->create_publisher<nav_msgs::msg::Odometry>(prefix + "odom", 10);
  say("%s configured %d", name, smoother->configure().id() == 2);
  smoother->activate();
  pass(300ms);
  say("%s sleeps %d", name, smoother->sleeps());
  nav_msgs::msg::Odometry odometry;
  odometry.header.stamp = node->now();
  odometry.twist.twist.linear.x = 0.2;
  odometry.twist.twist.angular.z = -0.1;
  odometries->publish(odometry);
  pass(50ms);
  command.header.frame_id = "base_link";
  if (is_stamped) command.header.stamp = node->now();
  command.twist.linear.x = 0.5;
  command.twist.angular.z = 2.5;
  commands->publish(command);
  pass(120ms);
  say("%s awake %d, steps:%s", name, !smoother->sleeps(), text.c_str());
  odometry.header.stamp = node->now();
  odometry.twist.twist = geometry_msgs::msg::Twist();
  odometries->publish(odometry);
  pass(3s);
  say("%s sleeps %d", name, smoother->sleeps());
  smoother->deactivate();
  smoother->cleanup();
  executor.remove_node(smoother->get_node_base_interface());
}

void refuse(const char* name, const Parameter& parameter) {
  auto smoother = probe(name, {parameter});
  say("%s state %d", name, smoother->configure().id());
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("own");
  executor.add_node(node);
  show_steps("scaled", {Parameter("scale_velocities", true)}, false);
  show_steps("closed", {Parameter("feedback", "CLOSED_LOOP"), Parameter("velocity_timeout", 0.2)}, false);
  show_steps("stamped", {Parameter("stamp_smoothed_velocity_with_smoothing_time", true)}, true);
  show_steps("dead", {Parameter("deadband_velocity", std::vector<double>{0.2, 0.0, 0.2})}, false);
  refuse("long_array", Parameter("max_velocity", std::vector<double>{1.0, 0.0, 0.0, 0.0}));
  refuse("speeds_up", Parameter("max_decel", std::vector<double>{1.0, 0.0, 0.0}));
  refuse("backwards", Parameter("max_velocity", std::vector<double>{-1.0, 0.0, 0.0}));
  refuse("not_a_number", Parameter("max_accel", std::vector<double>{std::nan(""), 0.0, 0.0}));
  refuse("never", Parameter("smoothing_frequency", 0.0));
  refuse("no_loop", Parameter("feedback", "HALF_OPEN"));
  auto smoother = probe("formulas", {});
  smoother->configure();
  say("eta %.3f %.3f, constrained %.3f %.3f", smoother->findEtaConstraint(0.0, 0.5, 2.5, -2.5),
      smoother->findEtaConstraint(0.4, 0.5, 2.5, -2.5), smoother->applyConstraints(0.0, 0.5, 2.5, -2.5, 1.0),
      smoother->applyConstraints(0.5, -0.5, 2.5, -1.0, 1.0));
  say("%s", "own is over");
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['geometry_msgs', 'nav2_velocity_smoother', 'nav_msgs', 'rclcpp'];
  workspace.addPackage('gentle', { driver, own }, {
    depends: [...libraries, 'nav2_lifecycle_manager'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(driver geometry_msgs rclcpp)
ament_target_dependencies(own ${libraries.join(' ')})
install(DIRECTORY launch params DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/gentle/launch/navigation_launch.py', launchFile);
  workspace.write('src/gentle/params/nav2_params.yaml', parameters);
  workspace.write('workspace.yaml', 'schema: 1\nname: gentle\npackages: [src/*]\nlaunch: src/gentle/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

/** Without the parts that depend on the speed of the machine: only runs on shared memory can be stepped. */
function timeless(lines: readonly string[]): string[] {
  return lines.map((line) => line.replace(/(falls at|last after|awake|at 10 Hz).*/, '$1'));
}

for (const link of played('shared', 'port')) {
  const isStepped = link === 'shared';
  const play = (end: string) =>
    workspace.run(['run', 'site', '--link', link, ...isStepped ? ['--stepped', '--seed', '3'] : [], '--for', '60s', '--until', end]);
  const isSaid = (output: string, node: string, expected: readonly string[]): void => {
    const lines = said(output, node);
    assert.deepEqual(isStepped ? lines : timeless(lines), isStepped ? expected : timeless(expected), output);
  };

  test(`${link}: commands become steps, and a robot that nobody commands stops`, watchdog, async () => {
    const run = await play('driver is over');
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const smoother = said(output, 'velocity_smoother');
    isSaid(output, 'driver', [
      'nothing comes from nothing: 1',
      'steps: 0.125 0.250 0.375 0.500 0.500 0.500',
      'falls at 1: 0.375 0.250 0.125 0.000',
      'last after 1.2 s: 1, period 0.050',
      'after NaN 1',
      'set: 0 Negative values set of acceleration! These should be positive to speed up!',
      'set: 0 Positive values set of deceleration! These should be negative to slow down!',
      'set: 0 Negative values set of max_velocity! These should be positive!',
      'set: 0 Positive values set of min_velocity! These should be negative!',
      'set: 0 Invalid size of parameter deadband_velocity. Must be size 3',
      'set: 0 smoothing_frequency must be greater than 0 and at most 1000 Hz',
      'set: 0 Invalid feedback_type, options are OPEN_LOOP and CLOSED_LOOP.',
      'set: 0 velocity_timeout must be from -9e9 to 9e9 seconds',
      ...Array.from({ length: 5 }, () => 'set: 1 '),
      'at 10 Hz: 0.000 0.500 0.000',
      'a component: 0.050 0.100 0.150 0.200',
      'driver is over',
    ]);
    for (
      const line of ['Configuring velocity smoother', 'Activating', 'Velocity message contains NaNs or Infs! Ignoring as invalid!',
        'Invalid size of parameter deadband_velocity. Must be size 3']
    ) assert.ok(smoother.includes(line), `velocity_smoother does not say: ${line}\n${output}`);
    assert.ok(said(output, 'lifecycle_manager_navigation').includes('Managed nodes are active'), output);
  });

  test(`${link}: a smoother scales, closes the loop, sleeps, and refuses what it cannot use`, watchdog, async () => {
    const run = await play('own is over');
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    isSaid(output, 'own', [
      'scaled configured 1',
      'scaled sleeps 1',
      'scaled awake 1, steps: (0.032 0.160 at 0 base_link) (0.064 0.320 at 0 base_link)',
      'scaled sleeps 1',
      'closed configured 1',
      'closed sleeps 1',
      'closed awake 1, steps: (0.325 0.060 at 0 base_link) (0.325 0.060 at 0 base_link)',
      'closed sleeps 1',
      'stamped configured 1',
      'stamped sleeps 1',
      'stamped awake 1, steps: (0.125 0.160 at 50 base_link) (0.250 0.320 at 100 base_link)',
      'stamped sleeps 1',
      'dead configured 1',
      'dead sleeps 1',
      'dead awake 1, steps: (0.000 0.000 at 0 base_link) (0.250 0.320 at 0 base_link)',
      'dead sleeps 1',
      ...['long_array', 'speeds_up', 'backwards', 'not_a_number', 'never', 'no_loop'].map((name) => `${name} state 1`),
      'eta 0.250 -1.000, constrained 0.125 0.450',
      'own is over',
    ]);
  });
}
