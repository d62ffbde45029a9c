// The behaviour server of Nav2 beside a controller server, whose local costmap it reads: a robot turns, drives, backs up, waits and is
// steered in front of a wall; what ends a goal early, and a behaviour of the workspace. Headless.

// Compatibility, works: Nav2's `behavior_server`, a program and a component, with Spin, BackUp, DriveOnHeading, Wait and AssistedTeleop
// (their actions and codes of errors, checks for collisions, timeouts), and behaviours of the workspace that derive from `TimedBehavior`

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { said } from '../support/room_robot.ts';
import { wheeledBase } from '../support/wheeled_base.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    params = os.path.join(get_package_share_directory('house_moves'), 'params', 'nav2_params.yaml')
    return LaunchDescription([
        Node(package='nav2_controller', executable='controller_server', output='screen', parameters=[params]),
        Node(package='nav2_behaviors', executable='behavior_server', name='behavior_server', output='screen', parameters=[params]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True, 'node_names': ['controller_server', 'behavior_server']}]),
        Node(package='house_moves', executable='base', output='screen'),
        Node(package='house_moves', executable='driver', output='screen'),
        ComposableNodeContainer(
            name='spare_container', namespace='', package='rclcpp_components', executable='component_container_isolated', output='screen',
            composable_node_descriptions=[ComposableNode(
                package='nav2_behaviors', plugin='behavior_server::BehaviorServer', name='lost', namespace='spare',
                parameters=[{'local_frame': 'nowhere', 'enable_stamped_cmd_vel': True}])]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lost_manager', namespace='spare', output='screen',
             parameters=[{'autostart': True, 'node_names': ['lost']}]),
        Node(package='nav2_behaviors', executable='behavior_server', name='broken', namespace='spare', output='screen',
             parameters=[{'behavior_plugins': ['spin', 'fly'], 'spin.plugin': 'nav2_behaviors::Spin', 'fly.plugin': 'nobody::Fly'}]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='broken_manager', namespace='spare', output='screen',
             parameters=[{'autostart': True, 'node_names': ['broken']}]),
    ])
`;

const parameters = `
controller_server:
  ros__parameters:
    controller_plugins: ["FollowPath"]
    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
behavior_server:
  ros__parameters:
    local_costmap_topic: local_costmap/costmap_raw
    global_costmap_topic: global_costmap/costmap_raw
    local_footprint_topic: local_costmap/published_footprint
    global_footprint_topic: global_costmap/published_footprint
    cycle_frequency: 10.0
    behavior_plugins: ["spin", "backup", "drive_on_heading", "assisted_teleop", "wait", "wiggle"]
    spin:
      plugin: "nav2_behaviors::Spin"
    backup:
      plugin: "nav2_behaviors::BackUp"
    drive_on_heading:
      plugin: "nav2_behaviors::DriveOnHeading"
    wait:
      plugin: "nav2_behaviors/Wait"
    assisted_teleop:
      plugin: "nav2_behaviors::AssistedTeleop"
    wiggle:
      plugin: "house_moves::Wiggle"
    wiggle_speed: 0.7
    local_frame: odom
    global_frame: map
    robot_base_frame: base_link
    transform_tolerance: 0.1
    simulate_ahead_time: 2.0
    max_rotational_vel: 1.0
    min_rotational_vel: 0.4
    rotational_acc_lim: 3.2
local_costmap:
  local_costmap:
    ros__parameters:
      update_frequency: 10.0
      publish_frequency: 10.0
      global_frame: odom
      robot_base_frame: base_link
      rolling_window: true
      width: 4
      height: 4
      resolution: 0.05
      footprint: "[[0.4, 0.1], [0.4, -0.1], [-0.1, -0.1], [-0.1, 0.1]]"
      footprint_padding: 0.0
      plugins: ["static_layer"]
      static_layer:
        plugin: "nav2_costmap_2d::StaticLayer"
        map_topic: /map
`;

const plugin = `
#include "nav2_behaviors/timed_behavior.hpp"
#include "nav2_msgs/action/wait.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace house_moves {

using nav2_behaviors::ResultStatus;
using nav2_behaviors::Status;
using Action = nav2_msgs::action::Wait;

// Turns left for a time. 98 seconds are refused, 97 fail, 99 stand for a mistake in the code.
class Wiggle : public nav2_behaviors::TimedBehavior<Action> {
 public:
  void onConfigure() override {
    const auto node = node_.lock();
    nav2_util::declare_parameter_if_not_declared(node, "wiggle_speed", rclcpp::ParameterValue(0.1));
    node->get_parameter("wiggle_speed", speed_);
    RCLCPP_INFO(logger_, "%s at %.1f in %s, checker %d", behavior_name_.c_str(), speed_, local_frame_.c_str(), global_collision_checker_ != nullptr);
  }
  ResultStatus onRun(const std::shared_ptr<const Action::Goal> command) override {
    seconds_ = command->time.sec;
    return ResultStatus{seconds_ == 98 ? Status::FAILED : Status::SUCCEEDED, 98};
  }
  ResultStatus onCycleUpdate() override {
    if (elasped_time_.seconds() > 0.45 && seconds_ == 99) throw std::runtime_error("out of order");
    if (elasped_time_.seconds() > 0.45 && seconds_ == 97) {
      stopRobot();
      return ResultStatus{Status::FAILED, 97};
    }
    if (elasped_time_ >= rclcpp::Duration(std::chrono::seconds(seconds_))) {
      stopRobot();
      return ResultStatus{Status::SUCCEEDED};
    }
    auto cmd_vel = std::make_unique<geometry_msgs::msg::TwistStamped>();
    cmd_vel->twist.angular.z = speed_;
    vel_pub_->publish(std::move(cmd_vel));
    return ResultStatus{Status::RUNNING};
  }
  void onActionCompletion(std::shared_ptr<Action::Result> result) override {
    RCLCPP_INFO(logger_, "wiggled for %d s, code %d", result->total_elapsed_time.sec, result->error_code);
  }
  void onCleanup() override { RCLCPP_INFO(logger_, "%s", "wiggle is cleaned up"); }
  nav2_core::CostmapInfoType getResourceInfo() override { return nav2_core::CostmapInfoType::NONE; }

 private:
  double speed_ = 0;
  int seconds_ = 0;
};

}  // namespace house_moves

PLUGINLIB_EXPORT_CLASS(house_moves::Wiggle, nav2_core::Behavior)
`;

const driver = `
#include <cmath>
#include <functional>
#include <limits>

#include "composition_interfaces/srv/list_nodes.hpp"
#include "composition_interfaces/srv/unload_node.hpp"
#include "geometry_msgs/msg/pose2_d.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "nav2_lifecycle_manager/lifecycle_manager_client.hpp"
#include "nav2_msgs/action/assisted_teleop.hpp"
#include "nav2_msgs/action/back_up.hpp"
#include "nav2_msgs/action/drive_on_heading.hpp"
#include "nav2_msgs/action/spin.hpp"
#include "nav2_msgs/action/wait.hpp"
#include "nav2_util/lifecycle_service_client.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/empty.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

using namespace std::chrono_literals;
using nav2_msgs::action::AssistedTeleop;
using nav2_msgs::action::BackUp;
using nav2_msgs::action::DriveOnHeading;
using nav2_msgs::action::Spin;
using nav2_msgs::action::Wait;

${driverStart}

nav_msgs::msg::Odometry odometry;
rclcpp::Publisher<geometry_msgs::msg::Pose2D>::SharedPtr places;

double x() { return odometry.pose.pose.position.x; }
double yaw() { return tf2::getYaw(odometry.pose.pose.orientation); }
bool stands() { return odometry.twist.twist.linear.x == 0 && odometry.twist.twist.angular.z == 0; }
bool is_near(double value, double aim, double tolerance) { return std::abs(value - aim) <= tolerance; }

/// Waits until the costmap and the transforms of the server know the place.
void place(double px, double theta) {
  geometry_msgs::msg::Pose2D pose;
  pose.x = px;
  pose.theta = theta;
  places->publish(pose);
  pass(1s);
}

template <typename ActionT>
class Behavior {
 public:
  using Handle = typename rclcpp_action::ClientGoalHandle<ActionT>::SharedPtr;
  explicit Behavior(const char* name) : name_(name), client_(rclcpp_action::create_client<ActionT>(node, name)) { client_->wait_for_action_server(); }

  Handle send(const typename ActionT::Goal& goal) {
    feedbacks = 0;
    typename rclcpp_action::Client<ActionT>::SendGoalOptions options;
    options.feedback_callback = [this](Handle, const std::shared_ptr<const typename ActionT::Feedback> one) {
      feedback = *one;
      ++feedbacks;
    };
    return wait(client_->async_send_goal(goal, options));
  }
  void end(const char* what, const Handle& handle) {
    const auto wrapped = wait(client_->async_get_result(handle));
    elapsed = rclcpp::Duration(wrapped.result->total_elapsed_time).seconds();
    say("%s %s: code %d error %d", name_, what, static_cast<int>(wrapped.code), wrapped.result->error_code);
  }
  /// The same, and the robot stands.
  void stop(const char* what, const Handle& handle) {
    end(what, handle);
    if (!spin_until(stands, 500ms)) say("moves by %.2f and %.2f", odometry.twist.twist.linear.x, odometry.twist.twist.angular.z);
    pass(100ms);
  }
  void run(const char* what, const typename ActionT::Goal& goal) {
    if (const Handle handle = send(goal)) stop(what, handle);
    else say("%s %s: refused", name_, what);
  }
  void cancel(const Handle& handle) { wait(client_->async_cancel_goal(handle)); }

  int feedbacks = 0;
  typename ActionT::Feedback feedback;
  double elapsed = 0;

 private:
  const char* name_;
  typename rclcpp_action::Client<ActionT>::SharedPtr client_;
};

Spin::Goal turn(float angle, double allowance = 0) {
  Spin::Goal goal;
  goal.target_yaw = angle;
  goal.time_allowance = rclcpp::Duration::from_seconds(allowance);
  return goal;
}

template <typename ActionT>
typename ActionT::Goal way(double distance, float speed, double allowance = 0, double aside = 0) {
  typename ActionT::Goal goal;
  goal.target.x = distance;
  goal.target.y = aside;
  goal.speed = speed;
  goal.time_allowance = rclcpp::Duration::from_seconds(allowance);
  return goal;
}

Wait::Goal seconds(int time) {
  Wait::Goal goal;
  goal.time.sec = time;
  return goal;
}

void spins(Behavior<Spin>& spin) {
  place(0, 0);
  spin.run("left", turn(1.57f));
  say("turned %d in time %d, feedback %d to the end %d", is_near(yaw(), 1.57, 0.15), spin.elapsed > 1.5 && spin.elapsed < 3, spin.feedbacks > 10,
      is_near(spin.feedback.angular_distance_traveled, 1.57, 0.15));
  // Over the angle where yaw wraps.
  place(0, 2.8);
  spin.run("over the back", turn(1.2f));
  say("turned %d", is_near(yaw(), 4.0 - 2 * M_PI, 0.15));
  spin.run("right", turn(-0.8f));
  say("turned %d", is_near(yaw(), 3.2 - 2 * M_PI, 0.3));
  spin.run("too slow", turn(3.0f, 0.5));
  spin.run("without a number", turn(std::numeric_limits<float>::quiet_NaN()));
  place(0.75, M_PI / 2);
  spin.run("into the wall", turn(-1.57f));
  say("stopped in time %d", yaw() > 0.9 && yaw() < 1.45);
}

void drives(Behavior<DriveOnHeading>& drive, Behavior<BackUp>& backup) {
  place(0, 0);
  drive.run("ahead", way<DriveOnHeading>(0.3, 0.2f));
  say("moved %d, feedback %d", is_near(x(), 0.3, 0.06), is_near(drive.feedback.distance_traveled, x(), 0.06));
  drive.run("into the wall", way<DriveOnHeading>(1.0, 0.1f));
  say("stopped in time %d", x() > 0.36 && x() < 0.5);
  const double start = x();
  backup.run("back", way<BackUp>(0.3, 0.15f));
  say("moved %d in time %d", is_near(x() - start, -0.3, 0.05), is_near(backup.elapsed, 2.0, 0.5));
  backup.run("aside", way<BackUp>(0.3, 0.15f, 0, 0.1));
  backup.run("too slow", way<BackUp>(0.3, 0.05f, 0.5));
  drive.run("aside", way<DriveOnHeading>(0.3, 0.2f, 0, 0.1));
  drive.run("two signs", way<DriveOnHeading>(0.3, -0.2f));
  drive.run("without a number", way<DriveOnHeading>(std::numeric_limits<double>::quiet_NaN(), -0.2f));
  drive.run("too slow", way<DriveOnHeading>(0.3, 0.05f, 0.5));
}

void early_ends(Behavior<DriveOnHeading>& drive, Behavior<Wait>& pause) {
  pause.run("a second", seconds(1));
  say("waited %d, feedback %d", is_near(pause.elapsed, 1.0, 0.4), pause.feedbacks > 5);
  place(0, M_PI);
  auto first = drive.send(way<DriveOnHeading>(2.0, 0.2f));
  pass(1s);
  say("drives %d", !stands());
  drive.cancel(first);
  drive.stop("cancelled", first);
  place(0, M_PI);
  first = drive.send(way<DriveOnHeading>(2.0, 0.2f));
  pass(1s);
  const auto second = drive.send(way<DriveOnHeading>(0.2, 0.4f));
  drive.end("older", first);
  drive.stop("newer", second);
}

void steers(Behavior<AssistedTeleop>& teleop) {
  const auto commands = node->create_publisher<geometry_msgs::msg::Twist>("cmd_vel_teleop", 1);
  const auto ends = node->create_publisher<std_msgs::msg::Empty>("preempt_teleop", 1);
  geometry_msgs::msg::Twist velocity;
  const auto velocities = node->create_subscription<geometry_msgs::msg::Twist>("cmd_vel", 1, [&](const geometry_msgs::msg::Twist& one) { velocity = one; });
  pass(300ms);
  // The nose to the left, and the wall at the right.
  place(0.75, M_PI / 2);
  geometry_msgs::msg::Twist command;
  command.linear.y = 0.4;
  commands->publish(command);
  pass(300ms);
  auto handle = teleop.send(AssistedTeleop::Goal());
  pass(500ms);
  say("nobody steers %d", velocity.linear.y == 0 && stands());
  commands->publish(command);
  say("away from the wall %d", spin_until([&] { return velocity.linear.y == 0.4; }, 2s));
  place(0.75, M_PI / 2);
  command.linear.y = -0.4;
  commands->publish(command);
  pass(300ms);
  say("to the wall %d", velocity.linear.y > -0.3 && velocity.linear.y <= 0);
  ends->publish(std_msgs::msg::Empty());
  teleop.stop("aside", handle);
  place(0, 0);
  handle = teleop.send(AssistedTeleop::Goal());
  command.linear.y = 0;
  command.linear.x = 0.4;
  commands->publish(command);
  // 0.2 s before the outline meets the wall, at first.
  say("unchanged %d", spin_until([] { return odometry.twist.twist.linear.x == 0.4; }, 2s));
  say("slower %d", spin_until([] { return odometry.twist.twist.linear.x > 0 && odometry.twist.twist.linear.x < 0.3; }, 4s));
  say("stands %d before the wall %d", spin_until(stands, 8s), x() > 0.4 && x() < 0.6);
  command.linear.x = std::numeric_limits<double>::quiet_NaN();
  commands->publish(command);
  pass(300ms);
  say("still stands %d", stands());
  command.linear.x = -0.2;
  commands->publish(command);
  say("back %d", spin_until([] { return odometry.twist.twist.linear.x == -0.2; }, 2s));
  ends->publish(std_msgs::msg::Empty());
  teleop.stop("done", handle);
  AssistedTeleop::Goal goal;
  goal.time_allowance.nanosec = 500000000;
  teleop.run("for half a second", goal);
}

void own(Behavior<Wait>& wiggle) {
  place(0, 0);
  wiggle.run("a second", seconds(1));
  say("turned %d", is_near(yaw(), 0.7, 0.2));
  wiggle.run("refused by itself", seconds(98));
  wiggle.run("failing", seconds(97));
  wiggle.run("throwing", seconds(99));
}

void pauses(Behavior<DriveOnHeading>& drive) {
  nav2_lifecycle_manager::LifecycleManagerClient manager("lifecycle_manager_navigation", node);
  place(0, M_PI);
  const auto handle = drive.send(way<DriveOnHeading>(2.0, 0.2f));
  pass(1s);
  say("pause %d", manager.pause());
  drive.stop("paused", handle);
  drive.run("while paused", way<DriveOnHeading>(0.1, 0.2f));
  say("resume %d", manager.resume());
  drive.run("again", way<DriveOnHeading>(0.1, 0.2f));
  say("reset %d", manager.reset());
}

/// Settings that cannot work are refused when the server is configured, and it can be configured once more.
void configures() {
  nav2_util::LifecycleServiceClient server("behavior_server", node);
  const auto parameters = std::make_shared<rclcpp::AsyncParametersClient>(node, "behavior_server");
  const auto configure = [&](const char* name, double value) {
    wait(parameters->set_parameters({rclcpp::Parameter(name, value)}));
    server.change_state(lifecycle_msgs::msg::Transition::TRANSITION_CONFIGURE, 10s);
    say("%s %.1f: state %d", name, value, server.get_state());
  };
  configure("cycle_frequency", 0);
  wait(parameters->set_parameters({rclcpp::Parameter("cycle_frequency", 20.0)}));
  configure("simulation_time_step", 0);
  configure("simulation_time_step", 1e-9);
  configure("simulation_time_step", 0.2);
}

/// A server as a component, with the parameters that are the default, without costmaps, in a frame that nobody knows.
void lost_server() {
  geometry_msgs::msg::TwistStamped last;
  int count = 0;
  const auto commands = node->create_subscription<geometry_msgs::msg::TwistStamped>("spare/cmd_vel", 1, [&](const geometry_msgs::msg::TwistStamped& one) {
    last = one;
    ++count;
  });
  Behavior<Wait> pause("spare/wait");
  while (rclcpp::ok() && !pause.send(seconds(0))) pass(200ms);
  Behavior<Spin>("spare/spin").run("lost", turn(1));
  Behavior<BackUp>("spare/backup").run("lost", way<BackUp>(0.1, 0.1f));
  Behavior<DriveOnHeading>("spare/drive_on_heading").run("lost", way<DriveOnHeading>(0.1, 0.1f));
  const auto handle = pause.send(seconds(50));
  pass(300ms);
  pause.cancel(handle);
  pause.end("cancelled", handle);
  spin_until([&count] { return count > 0; }, 1s);
  say("%d stamped: %s %.1f %.1f", count, last.header.frame_id.c_str(), last.twist.linear.x, last.twist.angular.z);
  // Its goal still runs when the component is unloaded.
  const auto last_goal = pause.send(seconds(50));
  pass(300ms);
  using composition_interfaces::srv::UnloadNode;
  const auto unloader = node->create_client<UnloadNode>("spare_container/_container/unload_node");
  unloader->wait_for_service();
  auto request = std::make_shared<UnloadNode::Request>();
  request->unique_id = 1;
  say("unloaded %d", wait(unloader->async_send_request(request).future.share())->success);
  const auto lister = node->create_client<composition_interfaces::srv::ListNodes>("spare_container/_container/list_nodes");
  say("nodes %zu", wait(lister->async_send_request(std::make_shared<composition_interfaces::srv::ListNodes::Request>()).future.share())->unique_ids.size());
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  const auto odometries = node->create_subscription<nav_msgs::msg::Odometry>("odom", 10, [](const nav_msgs::msg::Odometry& message) { odometry = message; });
  places = node->create_publisher<geometry_msgs::msg::Pose2D>("place", 1);
  Behavior<Wait> pause("wait");
  Behavior<Spin> spin("spin");
  Behavior<BackUp> backup("backup");
  Behavior<DriveOnHeading> drive("drive_on_heading");
  Behavior<AssistedTeleop> teleop("assisted_teleop");
  Behavior<Wait> wiggle("wiggle");
  while (rclcpp::ok() && !pause.send(seconds(0))) pass(200ms);
  say("costmaps: local %d, global %d", static_cast<int>(node->count_subscribers("local_costmap/costmap_raw")),
      static_cast<int>(node->count_subscribers("global_costmap/costmap_raw")));
  spins(spin);
  drives(drive, backup);
  early_ends(drive, pause);
  steers(teleop);
  own(wiggle);
  lost_server();
  pauses(drive);
  configures();
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

const xml = `<library path="house_moves_plugins">
  <class type="house_moves::Wiggle" base_class_type="nav2_core::Behavior"><description>turns left</description></class>
</library>
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['composition_interfaces', 'geometry_msgs', 'lifecycle_msgs', 'nav2_behaviors', 'nav2_core', 'nav2_lifecycle_manager', 'nav2_msgs',
    'nav2_util', 'nav_msgs', 'pluginlib', 'rclcpp', 'rclcpp_action', 'std_msgs', 'tf2_geometry_msgs', 'tf2_ros'];
  workspace.addPackage('house_moves', { base: wheeledBase, driver }, {
    depends: [...libraries, 'nav2_common', 'nav2_controller', 'rclcpp_components'],
    cmake: `${[...libraries, 'nav2_common'].map((name) => `find_package(${name} REQUIRED)`).join('\n')}
nav2_package()
add_library(house_moves_plugins SHARED src/plugin.cpp)
ament_target_dependencies(house_moves_plugins nav2_behaviors nav2_core nav2_msgs nav2_util pluginlib rclcpp)
pluginlib_export_plugin_description_file(nav2_core plugins.xml)
ament_target_dependencies(base geometry_msgs nav2_util nav_msgs rclcpp tf2_ros)
ament_target_dependencies(driver composition_interfaces geometry_msgs lifecycle_msgs nav2_lifecycle_manager nav2_msgs nav2_util nav_msgs rclcpp rclcpp_action
  std_msgs tf2_geometry_msgs)
install(TARGETS house_moves_plugins DESTINATION lib)
install(DIRECTORY launch params DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string): string => workspace.write(`src/house_moves/${path}`, content);
  file('src/plugin.cpp', plugin);
  file('plugins.xml', xml);
  file('launch/navigation_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  workspace.write('workspace.yaml', 'schema: 1\nname: moves\npackages: [src/*]\nlaunch: src/house_moves/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared')) {
  test(`${link}: a robot turns, drives and is steered, and what stops it is answered by its code`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '240s', '--until', 'driver is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const server = said(output, 'behavior_server');
    assert.deepEqual(said(output, 'driver'), [
      'costmaps: local 1, global 0',
      'spin left: code 4 error 0',
      'turned 1 in time 1, feedback 1 to the end 1',
      'spin over the back: code 4 error 0',
      'turned 1',
      'spin right: code 4 error 0',
      'turned 1',
      'spin too slow: code 6 error 701',
      'spin without a number: code 6 error 700',
      'spin into the wall: code 6 error 703',
      'stopped in time 1',
      'drive_on_heading ahead: code 4 error 0',
      'moved 1, feedback 1',
      'drive_on_heading into the wall: code 6 error 723',
      'stopped in time 1',
      'backup back: code 4 error 0',
      'moved 1 in time 1',
      'backup aside: code 6 error 713',
      'backup too slow: code 6 error 711',
      'drive_on_heading aside: code 6 error 724',
      'drive_on_heading two signs: code 6 error 724',
      'drive_on_heading without a number: code 6 error 724',
      'drive_on_heading too slow: code 6 error 721',
      'wait a second: code 4 error 0',
      'waited 1, feedback 1',
      'drives 1',
      'drive_on_heading cancelled: code 5 error 0',
      'drive_on_heading older: code 6 error 0',
      'drive_on_heading newer: code 4 error 0',
      'nobody steers 1',
      'away from the wall 1',
      'to the wall 1',
      'assisted_teleop aside: code 4 error 0',
      'unchanged 1',
      'slower 1',
      'stands 1 before the wall 1',
      'still stands 1',
      'back 1',
      'assisted_teleop done: code 4 error 0',
      'assisted_teleop for half a second: code 6 error 731',
      'wiggle a second: code 4 error 0',
      'turned 1',
      'wiggle refused by itself: code 6 error 98',
      'wiggle failing: code 6 error 97',
      'wiggle throwing: code 6 error 0',
      'spare/spin lost: code 6 error 702',
      'spare/backup lost: code 6 error 712',
      'spare/drive_on_heading lost: code 6 error 722',
      'spare/wait cancelled: code 5 error 0',
      '1 stamped: base_link 0.0 0.0',
      'unloaded 1',
      'nodes 0',
      'pause 1',
      'drive_on_heading paused: code 6 error 0',
      'drive_on_heading while paused: refused',
      'resume 1',
      'drive_on_heading again: code 4 error 0',
      'reset 1',
      'cycle_frequency 0.0: state 1',
      'simulation_time_step 0.0: state 1',
      'simulation_time_step 0.0: state 1',
      'simulation_time_step 0.2: state 2',
      'driver is over',
    ], server.join('\n'));
    for (
      const line of ['Creating behavior plugin wait of type nav2_behaviors/Wait', 'wiggle at 0.7 in odom, checker 0', 'Turning 1.57 for spin behavior.',
        'spin completed successfully', 'Exceeded time allowance before reaching the Spin goal - Exiting Spin', 'spin failed', 'Collision Ahead - Exiting Spin',
        'Initial checks failed for backup', 'Backing up in Y and Z not supported, will only move in X.', 'Collision Ahead - Exiting DriveOnHeading',
        'DrivingOnHeading in Y and Z not supported, will only move in X.', 'Speed and command sign did not match', 'Canceling drive_on_heading',
        'Received a preemption request for drive_on_heading, however feature is currently not implemented. Aborting and stopping.',
        'Exceeded time allowance before reaching the assisted_teleopgoal - Exiting assisted_teleop', 'A velocity that is not finite is ignored.',
        'wiggled for 1 s, code 0', 'wiggled for 0 s, code 97', 'wiggle is cleaned up', 'cycle_frequency must be greater than 0',
        'Failed to configure behaviors. Exception: simulation_time_step must be greater than 0',
        'Failed to configure behaviors. Exception: projection_time must be at most 10,000 times simulation_time_step']
    ) assert.ok(server.includes(line), `behavior_server does not say: ${line}\n${output}`);
    const broken = said(output, 'spare.broken').find((line) => line.startsWith('Failed to create'));
    assert.match(broken ?? '', /^Failed to create behavior fly of type nobody::Fly\. Exception: .* does not exist\. Declared types are .*nav2_behaviors::Spin/);
    assert.ok(said(output, 'spare.broken_manager').includes('Failed to change state for node: broken'), output);
    const lost = said(output, 'spare.lost');
    for (const line of ['Initial robot pose is not available.', 'Deactivating', 'Cleaning up']) assert.ok(lost.includes(line), output);
  });
}
