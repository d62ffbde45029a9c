// The local planner DWB in the controller server of Nav2, with parameters of the shape of TurtleBot 3's: a robot follows a path around a
// wall and turns at the goal; scores, costs and markers are published; walls forbid trajectories; speed limits; critics and a generator of the
// workspace, unknown ones, and no valid trajectory. Headless.

// Compatibility, works: Nav2's DWB (`dwb_core::DWBLocalPlanner`, the default controller) with the critics and generators of upstream,
// parameter files of TurtleBot 3, `evaluation`, `marker` and `local_plan`, and critics of the workspace

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
    share = get_package_share_directory('house_dwb')
    params = os.path.join(share, 'params', 'burger.yaml')
    lifecycle_nodes = ['map_server', 'controller_server']
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_server', output='screen',
             parameters=[params, {'yaml_filename': os.path.join(share, 'maps', 'room.yaml')}]),
        Node(package='nav2_controller', executable='controller_server', output='screen', parameters=[params]),
        Node(package='nav2_controller', executable='controller_server', namespace='broken', output='screen', parameters=[params]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True, 'node_names': lifecycle_nodes}]),
        Node(package='house_dwb', executable='base', output='screen'),
        Node(package='house_dwb', executable='driver', output='screen'),
    ])
`;

/** A controller with these critics, for a robot that drives as fast as `speed`. */
const dwb = (name: string, speed: number, critics: string, more = ''): string => `
    ${name}:
      plugin: "dwb_core::DWBLocalPlanner"
      debug_trajectory_details: True
      publish_cost_grid_pc: True
      min_vel_x: 0.0
      min_vel_y: 0.0
      max_vel_x: ${speed}
      max_vel_y: 0.0
      max_vel_theta: 1.5
      min_speed_xy: 0.0
      max_speed_xy: ${speed}
      min_speed_theta: 0.0
      acc_lim_x: 2.5
      acc_lim_y: 0.0
      acc_lim_theta: 3.2
      decel_lim_x: -2.5
      decel_lim_y: 0.0
      decel_lim_theta: -3.2
      vx_samples: 20
      vy_samples: 5
      vtheta_samples: 40
      sim_time: 1.5
      linear_granularity: 0.05
      angular_granularity: 0.025
      transform_tolerance: 0.2
      xy_goal_tolerance: 0.1
      trans_stopped_velocity: 0.25
      short_circuit_trajectory_evaluation: True
      stateful: True
      critics: ${critics}
      BaseObstacle.scale: 0.02
      PathAlign.scale: 32.0
      PathAlign.forward_point_distance: 0.1
      GoalAlign.scale: 24.0
      GoalAlign.forward_point_distance: 0.1
      PathDist.scale: 32.0
      GoalDist.scale: 24.0
      RotateToGoal.scale: 32.0
      RotateToGoal.slowing_factor: 5.0
      RotateToGoal.lookahead_time: -1.0
${more}`;

const usual = '["RotateToGoal", "Oscillation", "BaseObstacle", "GoalAlign", "PathAlign", "PathDist", "GoalDist"]';

const parameters = `
controller_server:
  ros__parameters:
    controller_frequency: 10.0
    odom_topic: odom
    progress_checker:
      plugin: "nav2_controller::SimpleProgressChecker"
      required_movement_radius: 0.2
      movement_time_allowance: 10.0
    goal_checker:
      plugin: "nav2_controller::SimpleGoalChecker"
      xy_goal_tolerance: 0.15
      yaw_goal_tolerance: 0.2
    controller_plugins: ["FollowPath", "Own", "Boxed"]
${dwb('FollowPath', 0.5, usual)}
${
  dwb(
    'Own',
    0.5,
    '["Calm", "ObstacleFootprint", "PathDist", "GoalDist", "PreferForward", "Twirling"]',
    '      default_critic_namespaces: ["dwb_critics", "house_dwb"]\n      trajectory_generator_name: "dwb_plugins::LimitedAccelGenerator"\n      Calm.scale: 1000.0\n      Twirling.scale: 0.1\n      PreferForward.scale: 0.01\n',
  )
}
${dwb('Boxed', 0.5, '["never", "PathDist"]', '      never.class: "house_dwb::Never"\n      trajectory_generator_name: "house_dwb::NamedGenerator"\n')}
/broken/controller_server:
  ros__parameters:
    FollowPath.critics: ["PathDist", "Nothing"]
${
  costmap(
    'local_costmap',
    'odom',
    '      rolling_window: true\n      width: 3\n      height: 3\n      plugins: ["static_layer", "inflation_layer"]',
  )
}
`;

const plugins = `
#include <cmath>

#include "dwb_core/exceptions.hpp"
#include "dwb_core/trajectory_critic.hpp"
#include "dwb_plugins/standard_traj_generator.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace house_dwb {

// Likes 0.2 m/s.
class CalmCritic : public dwb_core::TrajectoryCritic {
 public:
  void onInit() override { RCLCPP_INFO(node_.lock()->get_logger(), "calm in %s", costmap_ros_->getGlobalFrameID().c_str()); }
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) override { return std::abs(traj.velocity.x - 0.2); }
};

class NeverCritic : public dwb_core::TrajectoryCritic {
 public:
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D&) override { throw dwb_core::IllegalTrajectoryException(name_, "Never."); }
};

class NamedGenerator : public dwb_plugins::StandardTrajectoryGenerator {
 public:
  void initialize(const nav2_util::LifecycleNode::SharedPtr& node, const std::string& name) override {
    dwb_plugins::StandardTrajectoryGenerator::initialize(node, name);
    RCLCPP_INFO(node->get_logger(), "generator of %s for %.1f s", name.c_str(), sim_time_);
  }
};

}  // namespace house_dwb

PLUGINLIB_EXPORT_CLASS(house_dwb::CalmCritic, dwb_core::TrajectoryCritic)
PLUGINLIB_EXPORT_CLASS(house_dwb::NeverCritic, dwb_core::TrajectoryCritic)
PLUGINLIB_EXPORT_CLASS(house_dwb::NamedGenerator, dwb_core::TrajectoryGenerator)
`;

const driver = `
#include <functional>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "costmap_queue/costmap_queue.hpp"
#include "costmap_queue/limited_costmap_queue.hpp"
#include "dwb_core/dwb_local_planner.hpp"
#include "dwb_msgs/msg/local_plan_evaluation.hpp"
#include "lifecycle_msgs/srv/change_state.hpp"
#include "nav2_core/controller_exceptions.hpp"
#include "nav2_msgs/action/follow_path.hpp"
#include "nav2_msgs/msg/speed_limit.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav_2d_utils/path_ops.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "visualization_msgs/msg/marker_array.hpp"

using namespace std::chrono_literals;
using Follow = nav2_msgs::action::FollowPath;
using lifecycle_msgs::srv::ChangeState;

${driverStart}

nav_msgs::msg::Odometry odometry;
double fastest = 0;
rclcpp_action::Client<Follow>::SharedPtr follower;

nav_msgs::msg::Path path(const std::vector<std::pair<double, double>>& corners, double yaw) {
  nav_msgs::msg::Path result;
  result.header.frame_id = "map";
  for (size_t i = 0; i + 1 < corners.size(); ++i) {
    const auto [x, y] = corners[i];
    const auto [to_x, to_y] = corners[i + 1];
    const int steps = std::ceil(std::hypot(to_x - x, to_y - y) / 0.05);
    for (int j = 0; j <= steps; ++j) {
      geometry_msgs::msg::PoseStamped pose;
      pose.header.frame_id = "map";
      pose.pose.position.x = x + (to_x - x) * j / steps;
      pose.pose.position.y = y + (to_y - y) * j / steps;
      result.poses.push_back(pose);
    }
  }
  result.poses.back().pose.orientation = nav2_util::geometry_utils::orientationAroundZAxis(yaw);
  return result;
}

bool follow(const char* what, const nav_msgs::msg::Path& path, const std::string& controller) {
  Follow::Goal goal;
  goal.path = path;
  goal.controller_id = controller;
  const auto handle = wait(follower->async_send_goal(goal));
  if (!handle) return false;
  const auto result = wait(follower->async_get_result(handle));
  say("%s: code %d error %d", what, static_cast<int>(result.code), result.result->error_code);
  return true;
}

void queues() {
  nav2_costmap_2d::Costmap2D costmap(7, 5, 0.1, 0, 0);
  costmap_queue::CostmapQueue queue(costmap, true);
  queue.enqueueCell(0, 0);
  queue.enqueueCell(6, 4);
  double last = 0, sum = 0;
  bool in_order = true;
  int cells = 0;
  for (; !queue.isEmpty(); ++cells) {
    const auto cell = queue.getNextCell();
    in_order = in_order && cell.distance_ >= last;
    last = cell.distance_;
    sum += cell.distance_;
  }
  // Sum of min(x + y, 6 - x + 4 - y) over all cells.
  say("queue of %d cells in order %d, farthest %.0f, sum %.0f", cells, in_order, last, sum);
  costmap_queue::LimitedCostmapQueue limited(costmap, 2);
  limited.enqueueCell(3, 2);
  for (cells = 0; !limited.isEmpty(); ++cells) limited.getNextCell();
  say("within 2 cells: %d", cells);
  nav_2d_msgs::msg::Path2D line;
  line.poses.resize(2);
  line.poses[1].x = 1;
  say("line of %zu poses", nav_2d_utils::adjustPlanResolution(line, 0.1).poses.size());
}

// DWB by itself, with limits of 0 and with a frame that nobody knows.
void alone() {
  const auto costmap = std::make_shared<nav2_costmap_2d::Costmap2DROS>("plain_costmap");
  costmap->configure();
  costmap->getCostmap()->updateOrigin(-1.5, -1.5);
  const auto parent = std::make_shared<rclcpp_lifecycle::LifecycleNode>("plain");
  parent->declare_parameter("Plain.critics", std::vector<std::string>{"PathDist"});
  dwb_core::DWBLocalPlanner planner;
  planner.configure(parent, "Plain", std::make_shared<tf2_ros::Buffer>(parent->get_clock()), costmap);
  planner.activate();
  geometry_msgs::msg::PoseStamped pose;
  pose.header.frame_id = "map";
  pose.pose.orientation.w = 1;
  const auto ask = [&](const nav_msgs::msg::Path& plan) {
    planner.setPlan(plan);
    try {
      planner.computeVelocityCommands(pose, geometry_msgs::msg::Twist(), nullptr);
    } catch (const nav2_core::ControllerTFError& error) {
      say("TF: %s", error.what());
    } catch (const nav2_core::ControllerException& error) {
      say("error: %s", error.what());
    }
  };
  auto line = path({{0, 0}, {1, 0}}, 0);
  ask(line);
  line.header.frame_id = "nowhere";
  ask(line);
  planner.deactivate();
  planner.cleanup();
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  queues();
  alone();
  const auto broken = node->create_client<ChangeState>("broken/controller_server/change_state");
  broken->wait_for_service();
  auto request = std::make_shared<ChangeState::Request>();
  request->transition.id = 1;
  say("broken configured %d", wait(broken->async_send_request(request).future.share())->success);

  follower = rclcpp_action::create_client<Follow>(node, "follow_path");
  const auto odometries = node->create_subscription<nav_msgs::msg::Odometry>("odom", 10, [](const nav_msgs::msg::Odometry& message) {
    odometry = message;
    fastest = std::max(fastest, message.twist.twist.linear.x);
  });
  int evaluations = 0, sound = 0, plans = 0, clouds = 0, sums = 0, cells = 0, nearer = 0;
  size_t twists = 0, markers = 0, received_poses = 0;
  std::string fields;
  std::set<std::string> refusing, scoring;
  // Grids count in half cells of 0.05 m.
  std::map<std::string, float> scales{{"BaseObstacle", 0.02F}, {"PathAlign", 0.8F}, {"GoalAlign", 0.6F}, {"PathDist", 0.8F}, {"GoalDist", 0.6F}};
  auto scores = node->create_subscription<dwb_msgs::msg::LocalPlanEvaluation>("evaluation", 1, [&](const dwb_msgs::msg::LocalPlanEvaluation& it) {
    ++evaluations;
    twists = it.twists.size();
    const auto& best = it.twists.at(it.best_index);
    bool is_best = best.total >= 0 && it.header.frame_id == "odom" && best.traj.poses.size() > 1;
    for (const auto& one : it.twists) is_best = is_best && (one.total < 0 || one.total >= best.total);
    sound += is_best;
    for (const auto& one : it.twists) {
      for (const auto& score : one.scores) {
        if (score.raw_score < 0) refusing.insert(score.name);
        if (score.raw_score > 0) scoring.insert(score.name);
      }
    }
  });
  auto costs = node->create_subscription<sensor_msgs::msg::PointCloud2>("cost_cloud", 1, [&](const sensor_msgs::msg::PointCloud2& it) {
    fields.clear();
    for (const auto& field : it.fields) fields += field.name + " ";
    cells = it.width;
    // x, y, z, the channels of critics, and the sum of those times their scales.
    std::vector<float> values(it.fields.size());
    bool is_sum = true;
    for (size_t i = 0; i < it.width; ++i) {
      std::memcpy(values.data(), &it.data[i * it.point_step], it.point_step);
      float sum = 0;
      for (size_t j = 3; j + 1 < values.size(); ++j) sum += values[j] * scales[it.fields[j].name];
      // PathAlign does not count near the goal.
      const float rest = std::abs(sum - values.back());
      is_sum = is_sum && std::min(rest, std::abs(rest - values[5] * scales["PathAlign"])) <= 1e-4F * std::abs(sum);
    }
    sums += is_sum;
    ++clouds;
  });
  auto received = node->create_subscription<nav_msgs::msg::Path>("received_global_plan", 1, [&](const nav_msgs::msg::Path& it) {
    if (it.header.frame_id == "map") received_poses = it.poses.size();
  });
  auto transformed = node->create_subscription<nav_msgs::msg::Path>("transformed_global_plan", 1, [&](const nav_msgs::msg::Path& it) {
    nearer += it.header.frame_id == "odom" && !it.poses.empty() && it.poses.size() <= received_poses;
  });
  auto drawn = node->create_subscription<visualization_msgs::msg::MarkerArray>("marker", 1, [&](const visualization_msgs::msg::MarkerArray& it) {
    markers = it.markers.size();
  });
  auto local = node->create_subscription<nav_msgs::msg::Path>("local_plan", 1, [&](const nav_msgs::msg::Path& it) { plans += it.poses.size() > 1; });
  follower->wait_for_action_server();
  const auto around = path({{-1.975, -1.975}, {-1.0, 1.4}, {0.0, 1.7}, {1.0, 1.4}, {1.3, 0.5}}, M_PI);
  // The server is active once a goal is accepted.
  while (rclcpp::ok() && !follow("around the wall", around, "FollowPath")) rclcpp::sleep_for(200ms);
  const auto& place = odometry.pose.pose.position;
  say("at the goal %d turned %d faster than 0.3 %d", std::hypot(place.x - 3.275, place.y - 2.475) < 0.2,
      std::abs(tf2::getYaw(odometry.pose.pose.orientation)) > M_PI - 0.25, fastest > 0.3 && fastest < 0.501);
  say("scores %d sound %d of at least 800 %d, markers %d, local plans %d", evaluations > 20, sound == evaluations, twists >= 800, markers >= 800, plans > 20);
  say("costs of %d cells: %s, sums %d", cells, fields.c_str(), clouds > 20 && sums == clouds);
  say("plan of %zu poses, pruned %d", received_poses, nearer > 20);
  costs.reset();
  drawn.reset();
  local.reset();

  fastest = 0;
  follow("own critic", path({{1.3, 0.5}, {0.7, 0.5}}, M_PI), "Own");
  say("fastest %d", fastest > 0.15 && fastest < 0.26);

  rclcpp::AsyncParametersClient server(node, "controller_server");
  const auto set = [&](double speed) { return wait(server.set_parameters({rclcpp::Parameter("FollowPath.max_vel_x", speed)}))[0]; };
  say("not finite: %s", set(NAN).reason.c_str());
  say("slower %d", set(0.15).successful);
  fastest = 0;
  follow("slowly", path({{0.7, 0.5}, {0.45, 0.5}}, M_PI), "FollowPath");
  say("fastest %d", fastest > 0.1 && fastest < 0.151);

  const auto limits = node->create_publisher<nav2_msgs::msg::SpeedLimit>("speed_limit", 10);
  while (limits->get_subscription_count() == 0) rclcpp::sleep_for(20ms);
  nav2_msgs::msg::SpeedLimit limit;
  limit.speed_limit = 0.4;  // m/s, of 0.5: 0.12 of 0.15
  limits->publish(limit);
  limit.speed_limit = NAN;
  limits->publish(limit);
  rclcpp::sleep_for(300ms);
  fastest = 0;
  follow("limited", path({{0.45, 0.5}, {0.2, 0.5}}, M_PI), "FollowPath");
  say("fastest %d", fastest > 0.08 && fastest < 0.121);
  scoring.clear();
  for (const char* controller : {"FollowPath", "Own"}) {
    refusing.clear();
    follow("through the wall", path({{0.35, 0.5}, {-1.0, 0.5}}, M_PI), controller);
    std::string names;
    for (const auto& name : refusing) names += " " + name;
    say("in the room %d, refused by%s", odometry.pose.pose.position.x - 1.975 > 0.15, names.c_str());
  }
  std::string names;
  for (const auto& name : scoring) names += " " + name;
  say("scored by%s", names.c_str());
  scores.reset();

  follow("never", path({{0.7, 0.5}, {1.3, 0.5}}, M_PI), "Boxed");
  follow("far away", path({{-2.0, -2.0}, {-2.0, -1.5}}, 0), "FollowPath");
  auto nowhere = path({{0.7, 0.5}, {1.3, 0.5}}, M_PI);
  nowhere.poses[3].pose.position.x = NAN;
  follow("not finite", nowhere, "FollowPath");
  nowhere.poses[3].pose.position.x = 0;
  nowhere.header.frame_id = "nowhere";
  follow("frame", nowhere, "FollowPath");
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

const xml = `<library path="house_dwb_critics">
  <class type="house_dwb::CalmCritic" base_class_type="dwb_core::TrajectoryCritic"><description>calm</description></class>
  <class type="house_dwb::NeverCritic" base_class_type="dwb_core::TrajectoryCritic"><description>never</description></class>
  <class type="house_dwb::NamedGenerator" base_class_type="dwb_core::TrajectoryGenerator"><description>named</description></class>
</library>
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['costmap_queue', 'dwb_core', 'dwb_msgs', 'dwb_plugins', 'geometry_msgs', 'lifecycle_msgs', 'nav2_core', 'nav2_costmap_2d', 'nav2_msgs',
    'nav2_util', 'nav_2d_utils', 'nav_msgs', 'pluginlib', 'rclcpp', 'rclcpp_action', 'sensor_msgs', 'std_msgs', 'tf2_geometry_msgs', 'tf2_ros',
    'visualization_msgs'];
  workspace.addPackage('house_dwb', { base, driver }, {
    depends: [...libraries, 'nav2_controller', 'nav2_map_server', 'nav2_lifecycle_manager'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
add_library(house_dwb_critics SHARED src/critics.cpp)
ament_target_dependencies(house_dwb_critics dwb_core dwb_plugins pluginlib)
pluginlib_export_plugin_description_file(dwb_core critics.xml)
ament_target_dependencies(base geometry_msgs nav2_util nav_msgs rclcpp std_msgs tf2_ros)
ament_target_dependencies(driver costmap_queue dwb_core dwb_msgs lifecycle_msgs nav2_core nav2_costmap_2d nav2_msgs nav2_util nav_2d_utils nav_msgs rclcpp
  rclcpp_action sensor_msgs tf2_geometry_msgs
  visualization_msgs)
install(TARGETS house_dwb_critics DESTINATION lib)
install(DIRECTORY launch maps params DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/house_dwb/${path}`, content);
  file('src/critics.cpp', plugins);
  file('critics.xml', xml);
  file('launch/dwb_launch.py', launchFile);
  file('params/burger.yaml', parameters);
  file('maps/room.pgm', room());
  file('maps/room.yaml', roomYaml);
  workspace.write('workspace.yaml', 'schema: 1\nname: dwb\npackages: [src/*]\nlaunch: src/house_dwb/launch/dwb_launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared')) {
  test(`${link}: DWB drives a robot, and what stops it is answered by its code`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '120s', '--until', 'driver is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    assert.deepEqual(said(output, 'driver'), [
      'queue of 35 cells in order 1, farthest 5, sum 105',
      'within 2 cells: 13',
      'line of 8 poses',
      'error: Could not find a legal trajectory: No valid trajectories out of 0! ',
      "TF: Unable to transform robot pose into global plan's frame",
      'broken configured 0',
      'around the wall: code 4 error 0',
      'at the goal 1 turned 1 faster than 0.3 1',
      'scores 1 sound 1 of at least 800 1, markers 1, local plans 1',
      'costs of 3600 cells: x y z BaseObstacle GoalAlign PathAlign PathDist GoalDist total_cost , sums 1',
      'plan of 37 poses, pruned 1',
      'own critic: code 4 error 0',
      'fastest 1',
      'not finite: FollowPath.max_vel_x must be a finite number',
      'slower 1',
      'slowly: code 4 error 0',
      'fastest 1',
      'limited: code 4 error 0',
      'fastest 1',
      'through the wall: code 6 error 105',
      'in the room 1, refused by BaseObstacle Oscillation',
      'through the wall: code 6 error 105',
      'in the room 1, refused by ObstacleFootprint',
      'scored by BaseObstacle Calm GoalAlign GoalDist ObstacleFootprint PathAlign PathDist PreferForward Twirling',
      'never: code 6 error 106',
      'far away: code 6 error 103',
      'not finite: code 6 error 103',
      'frame: code 6 error 102',
      'driver is over',
    ], output);
    for (
      const line of ['Using critic "Calm" (house_dwb::CalmCritic)', 'calm in odom', "'sim_period' parameter is not set for Own", 'generator of Boxed for 1.5 s',
        'A speed limit of nan is ignored: it must be finite and at least 0', 'No velocity is within the limits: x from 0 to 0 m/s',
        'Could not find a legal trajectory: No valid trajectories out of', '1.00:      never/Never.', 'Resulting plan has 0 poses in it.',
        'Created controller : FollowPath of type dwb_core::DWBLocalPlanner',
        "Couldn't load critics! Caught exception: According to the loaded plugin descriptions the class NothingCritic with base class type dwb_core::TrajectoryCritic does not exist"]
    ) assert.ok(output.includes(line), `nobody says: ${line}\n${output}`);
  });
}
