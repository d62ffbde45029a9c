// The controller server of Nav2 with a planner server: a robot follows a path around a wall with regulated pure pursuit, is stopped, held
// and blocked; codes of errors, and a controller and a goal checker of the workspace. Headless.

// Compatibility, works: Nav2's `controller_server` with regulated pure pursuit, SimpleGoalChecker, StoppedGoalChecker, PositionGoalChecker,
// SimpleProgressChecker and PoseProgressChecker, `follow_path`, `speed_limit`, and controllers and checkers of the workspace

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { base, costmap, room, roomYaml, said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('house_drive')
    params = os.path.join(share, 'params', 'nav2_params.yaml')
    lifecycle_nodes = ['map_server', 'controller_server', 'planner_server']
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_server', output='screen',
             parameters=[params, {'yaml_filename': os.path.join(share, 'maps', 'room.yaml')}]),
        Node(package='nav2_controller', executable='controller_server', output='screen', parameters=[params],
             remappings=[('cmd_vel', 'cmd_vel_nav')]),
        Node(package='nav2_planner', executable='planner_server', name='planner_server', output='screen', parameters=[params]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True, 'node_names': lifecycle_nodes}]),
        Node(package='house_drive', executable='base', output='screen', remappings=[('cmd_vel', 'cmd_vel_nav')]),
        Node(package='house_drive', executable='driver', output='screen'),
    ])
`;

const parameters = `
controller_server:
  ros__parameters:
    controller_frequency: 20.0
    min_x_velocity_threshold: 0.001
    failure_tolerance: 0.3
    odom_topic: odom
    progress_checker_plugins: ["progress_checker", "turning"]
    goal_checker_plugins: ["general_goal_checker", "standing", "place", "never"]
    controller_plugins: ["FollowPath", "Creep"]
    progress_checker:
      plugin: "nav2_controller::SimpleProgressChecker"
      required_movement_radius: 0.3
      movement_time_allowance: 5.0
    turning:
      plugin: "nav2_controller::PoseProgressChecker"
      required_movement_radius: 0.3
      movement_time_allowance: 2.0
    general_goal_checker:
      plugin: "nav2_controller::SimpleGoalChecker"
      xy_goal_tolerance: 0.1
      yaw_goal_tolerance: 0.2
    standing:
      plugin: "nav2_controller::StoppedGoalChecker"
      xy_goal_tolerance: 0.25
      yaw_goal_tolerance: 3.2
      trans_stopped_velocity: 0.05
    place:
      plugin: "nav2_controller::PositionGoalChecker"
      xy_goal_tolerance: 0.3
    never:
      plugin: "house_drive::Never"
    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
      desired_linear_vel: 0.5
      lookahead_dist: 0.4
      use_cost_regulated_linear_velocity_scaling: false
    Creep:
      plugin: "house_drive::Creep"
planner_server:
  ros__parameters:
    planner_plugins: ["GridBased"]
    GridBased:
      plugin: "nav2_navfn_planner::NavfnPlanner"
${costmap('global_costmap', 'map', '      plugins: ["static_layer", "inflation_layer"]')}
${costmap('local_costmap', 'odom', '      rolling_window: true\n      width: 3\n      height: 3\n      plugins: ["static_layer", "inflation_layer"]')}
`;

const plugins = `
#include "nav2_core/controller.hpp"
#include "nav2_core/goal_checker.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace house_drive {

// Drives ahead slowly.
class Creep : public nav2_core::Controller {
 public:
  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name, std::shared_ptr<tf2_ros::Buffer>,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override {
    RCLCPP_INFO(parent.lock()->get_logger(), "%s in %s", name.c_str(), costmap_ros->getGlobalFrameID().c_str());
  }
  void cleanup() override {}
  void activate() override {}
  void deactivate() override {}
  void setPlan(const nav_msgs::msg::Path& path) override { poses_ = path.poses.size(); }
  geometry_msgs::msg::TwistStamped computeVelocityCommands(const geometry_msgs::msg::PoseStamped& pose, const geometry_msgs::msg::Twist&,
                                                           nav2_core::GoalChecker*) override {
    if (poses_ > 100) throw nav2_core::ControllerTimedOut("too many poses");
    geometry_msgs::msg::TwistStamped command;
    command.header = pose.header;
    command.twist.linear.x = speed_;
    return command;
  }
  void setSpeedLimit(const double& speed_limit, const bool& percentage) override { speed_ = percentage ? 0.4 * speed_limit / 100 : speed_limit; }

 private:
  size_t poses_ = 0;
  double speed_ = 0.4;
};

class Never : public nav2_core::GoalChecker {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr&, const std::string&, const std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) override {}
  void reset() override {}
  bool isGoalReached(const geometry_msgs::msg::Pose&, const geometry_msgs::msg::Pose&, const geometry_msgs::msg::Twist&) override { return false; }
  bool getTolerances(geometry_msgs::msg::Pose&, geometry_msgs::msg::Twist&) override { return false; }
};

}  // namespace house_drive

PLUGINLIB_EXPORT_CLASS(house_drive::Creep, nav2_core::Controller)
PLUGINLIB_EXPORT_CLASS(house_drive::Never, nav2_core::GoalChecker)
`;

const driver = `
#include <functional>
#include <cmath>

#include "nav2_costmap_2d/costmap_subscriber.hpp"
#include "nav2_msgs/action/compute_path_to_pose.hpp"
#include "nav2_msgs/action/follow_path.hpp"
#include "nav2_msgs/msg/speed_limit.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/bool.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

using namespace std::chrono_literals;
using geometry_msgs::msg::PoseStamped;
using ToPose = nav2_msgs::action::ComputePathToPose;
using Follow = nav2_msgs::action::FollowPath;

${driverStart}

nav_msgs::msg::Odometry odometry;
double fastest = 0;
rclcpp_action::Client<ToPose>::SharedPtr planner;
rclcpp_action::Client<Follow>::SharedPtr follower;

PoseStamped pose(double x, double y, double yaw = 0) {
  PoseStamped result;
  result.header.frame_id = "map";
  result.pose.position.x = x;
  result.pose.position.y = y;
  result.pose.orientation = nav2_util::geometry_utils::orientationAroundZAxis(yaw);
  return result;
}

nav_msgs::msg::Path plan(const PoseStamped& goal) {
  ToPose::Goal request;
  request.goal = goal;
  const auto handle = wait(planner->async_send_goal(request));
  return wait(planner->async_get_result(handle)).result->path;
}

struct Feedback {
  double first = 0, last = 0;
  int count = 0;
};

auto follow(const char* what, const nav_msgs::msg::Path& path, const std::string& controller, const std::string& checker,
            std::chrono::nanoseconds cancel_after = 0s, const std::string& progress = "progress_checker") {
  Follow::Goal goal;
  goal.path = path;
  goal.controller_id = controller;
  goal.goal_checker_id = checker;
  goal.progress_checker_id = progress;
  Feedback feedback;
  rclcpp_action::Client<Follow>::SendGoalOptions options;
  options.feedback_callback = [&feedback](const auto&, const std::shared_ptr<const Follow::Feedback> one) {
    if (feedback.count++ == 0) feedback.first = one->distance_to_goal;
    feedback.last = one->distance_to_goal;
  };
  const auto handle = wait(follower->async_send_goal(goal, options));
  if (cancel_after > 0s) {
    pass(cancel_after);
    wait(follower->async_cancel_goal(handle));
  }
  const auto result = wait(follower->async_get_result(handle));
  say("%s: code %d error %d", what, static_cast<int>(result.code), result.result->error_code);
  return feedback;
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  planner = rclcpp_action::create_client<ToPose>(node, "compute_path_to_pose");
  follower = rclcpp_action::create_client<Follow>(node, "follow_path");
  const auto odometries = node->create_subscription<nav_msgs::msg::Odometry>("odom", 10, [](const nav_msgs::msg::Odometry& message) {
    odometry = message;
    fastest = std::max(fastest, message.twist.twist.linear.x);
  });
  const auto limits = node->create_publisher<nav2_msgs::msg::SpeedLimit>("speed_limit", 10);
  const auto brakes = node->create_publisher<std_msgs::msg::Bool>("brake", 1);
  nav2_costmap_2d::CostmapSubscriber costs(rclcpp::Node::WeakPtr(node), "local_costmap/costmap_raw");
  follower->wait_for_action_server();
  planner->wait_for_action_server();
  // Both servers are active once a goal is accepted.
  nav_msgs::msg::Path around;
  while (rclcpp::ok() && around.poses.empty()) {
    ToPose::Goal request;
    request.goal = pose(2.0, -2.0, 1.57);
    const auto handle = wait(planner->async_send_goal(request));
    if (handle) around = wait(planner->async_get_result(handle)).result->path;
    pass(200ms);
  }
  const double length = nav2_util::geometry_utils::calculate_path_length(around);
  say("path of %.1f m", length);
  const auto start = node->now();
  const auto feedback = follow("around the wall", around, "FollowPath", "general_goal_checker");
  const double seconds = (node->now() - start).seconds();
  pass(300ms);
  const auto& place = odometry.pose.pose.position;
  say("at the goal %d turned %d stands %d", std::hypot(place.x - 3.975, place.y + 0.025) < 0.15,
      std::abs(tf2::getYaw(odometry.pose.pose.orientation) - 1.57) < 0.25, odometry.twist.twist.linear.x == 0);
  // The border of the map, which the window of the robot reaches here only: the costmap has another frame than the map.
  const auto costmap = costs.getCostmap();
  unsigned int mx = 0, my = 0;
  say("border in the window %d: %d", costmap->worldToMap(4.45, -0.025, mx, my), costmap->getCost(mx, my) >= 253);
  say("fastest %.2f, in time %d, feedback %d from %.1f to less than a metre %d", fastest, seconds < length / 0.5 + 12, feedback.count > 50,
      feedback.first, feedback.last < 1);

  nav_msgs::msg::Path opposite = around;
  opposite.poses.back() = pose(2.0, -2.0, -1.57);
  follow("place only", opposite, "FollowPath", "place");
  say("turned as before %d", std::abs(tf2::getYaw(odometry.pose.pose.orientation) - 1.57) < 0.25);
  follow("unknown controller", around, "Nobody", "general_goal_checker");
  follow("unknown checker", around, "FollowPath", "nothing");
  follow("empty path", nav_msgs::msg::Path(), "FollowPath", "general_goal_checker");
  nav_msgs::msg::Path elsewhere = around;
  elsewhere.header.frame_id = "nowhere";
  follow("frame", elsewhere, "FollowPath", "general_goal_checker");
  follow("own error", around, "Creep", "never");

  std_msgs::msg::Bool brake;
  brake.data = true;
  brakes->publish(brake);
  const auto back = plan(pose(2.0, -1.0));
  follow("held", back, "FollowPath", "general_goal_checker", 0s, "turning");
  brake.data = false;
  brakes->publish(brake);

  nav2_msgs::msg::SpeedLimit limit;
  limit.percentage = true;
  limit.speed_limit = 50;
  limits->publish(limit);
  pass(100ms);
  fastest = 0;
  follow("slowly", plan(pose(2.0, 0.5)), "FollowPath", "standing");
  say("fastest %.2f", fastest);
  limit.speed_limit = 0;
  limits->publish(limit);
  follow("cancelled", plan(pose(2.0, -2.0)), "FollowPath", "never", 1s);
  pass(200ms);
  say("stands %d", odometry.twist.twist.linear.x == 0);

  // Through the wall: the controller sees it.
  nav_msgs::msg::Path through;
  through.header.frame_id = "map";
  const double x = odometry.pose.pose.position.x - 1.975, y = odometry.pose.pose.position.y - 1.975;
  for (int i = 0; i <= 200; ++i) through.poses.push_back(pose(x + (-2.0 - x) * i / 200, y + (-2.0 - y) * i / 200, M_PI));
  follow("through the wall", through, "FollowPath", "general_goal_checker");
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

const xml = `<library path="house_drive_plugins">
  <class type="house_drive::Creep" base_class_type="nav2_core::Controller"><description>slow</description></class>
  <class type="house_drive::Never" base_class_type="nav2_core::GoalChecker"><description>never</description></class>
</library>
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['geometry_msgs', 'nav2_core', 'nav2_costmap_2d', 'nav2_msgs', 'nav2_util', 'nav_msgs', 'pluginlib', 'rclcpp', 'rclcpp_action', 'std_msgs',
    'tf2_geometry_msgs', 'tf2_ros'];
  workspace.addPackage('house_drive', { base, driver }, {
    depends: [...libraries, 'nav2_common', 'nav2_controller', 'nav2_planner', 'nav2_map_server', 'nav2_lifecycle_manager'],
    cmake: `${[...libraries, 'nav2_common'].map((name) => `find_package(${name} REQUIRED)`).join('\n')}
nav2_package()
add_library(house_drive_plugins SHARED src/plugins.cpp)
ament_target_dependencies(house_drive_plugins nav2_core nav2_costmap_2d pluginlib)
pluginlib_export_plugin_description_file(nav2_core plugins.xml)
ament_target_dependencies(base geometry_msgs nav2_util nav_msgs rclcpp std_msgs tf2_ros)
ament_target_dependencies(driver nav2_costmap_2d nav2_msgs nav2_util nav_msgs rclcpp rclcpp_action std_msgs tf2_geometry_msgs)
install(TARGETS house_drive_plugins DESTINATION lib)
install(DIRECTORY launch maps params DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/house_drive/${path}`, content);
  file('src/plugins.cpp', plugins);
  file('plugins.xml', xml);
  file('launch/navigation_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  file('maps/room.pgm', room());
  file('maps/room.yaml', roomYaml);
  workspace.write('workspace.yaml', 'schema: 1\nname: drive\npackages: [src/*]\nlaunch: src/house_drive/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared')) {
  test(`${link}: a robot follows paths, and what stops it is answered by its code`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '240s', '--until', 'driver is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const server = said(output, 'controller_server');
    assert.deepEqual(said(output, 'driver'), [
      'path of 8.2 m',
      'around the wall: code 4 error 0',
      'at the goal 1 turned 1 stands 1',
      'border in the window 1: 1',
      'fastest 0.50, in time 1, feedback 1 from 8.2 to less than a metre 1',
      'place only: code 4 error 0',
      'turned as before 1',
      'unknown controller: code 6 error 101',
      'unknown checker: code 6 error 100',
      'empty path: code 6 error 103',
      'frame: code 6 error 102',
      'own error: code 6 error 107',
      'held: code 6 error 105',
      'slowly: code 4 error 0',
      'fastest 0.25',
      'cancelled: code 5 error 0',
      'stands 1',
      'through the wall: code 6 error 104',
      'driver is over',
    ], server.join('\n'));
    for (
      const line of ['Creep in odom', 'Received a goal, begin computing control effort.', 'Reached the goal!', 'Failed to make progress',
        'Cancellation was successful. Stopping the robot.', 'RegulatedPurePursuitController detected collision ahead!', 'Controller patience exceeded',
        'Path is empty.', 'too many poses']
    ) assert.ok(server.includes(line), `controller_server does not say: ${line}\n${output}`);
  });
}
