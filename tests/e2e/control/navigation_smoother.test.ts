// The smoother server of Nav2 beside a planner server: paths around a wall and by hand, reversals, collisions, codes of errors, and a
// smoother of the workspace. Headless.

// Compatibility, works: Nav2's `smoother_server` with SimpleSmoother and SavitzkyGolaySmoother, `smooth_path`, `plan_smoothed`, checks for
// collisions, and smoothers of the workspace

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { room, said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    share = get_package_share_directory('smooth_house')
    params = os.path.join(share, 'params', 'nav2_params.yaml')
    lifecycle_nodes = ['map_server', 'smoother_server', 'planner_server']
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_server', output='screen',
             parameters=[params, {'yaml_filename': os.path.join(share, 'maps', 'room.yaml')}]),
        Node(package='nav2_smoother', executable='smoother_server', output='screen', parameters=[params]),
        Node(package='nav2_planner', executable='planner_server', name='planner_server', output='screen', parameters=[params]),
        ComposableNodeContainer(
            name='spare_container', namespace='', package='rclcpp_components', executable='component_container', output='screen',
            composable_node_descriptions=[
                ComposableNode(package='nav2_smoother', plugin='nav2_smoother::SmootherServer', name='spare', namespace='apart',
                               parameters=[{'costmap_topic': 'nobody/costmap_raw'}]),
                ComposableNode(package='nav2_smoother', plugin='nav2_smoother::SmootherServer', name='wrong', parameters=[params]),
                ComposableNode(package='nav2_smoother', plugin='nav2_smoother::SmootherServer', name='wild', parameters=[
                    {'simple_smoother.plugin': 'nav2_smoother::SimpleSmoother', 'simple_smoother.w_smooth': 1.5}]),
            ]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True, 'node_names': lifecycle_nodes}]),
        Node(package='smooth_house', executable='driver', output='screen'),
    ])
`;

const parameters = `
smoother_server:
  ros__parameters:
    costmap_topic: global_costmap/costmap_raw
    footprint_topic: global_costmap/published_footprint
    robot_base_frame: base_link
    transform_tolerance: 0.1
    smoother_plugins: ["simple_smoother", "savitzky_golay", "own", "simple_once", "filter_once"]
    simple_once:
      plugin: "nav2_smoother::SimpleSmoother"
      refinement_num: 0
    filter_once:
      plugin: "nav2_smoother::SavitzkyGolaySmoother"
      do_refinement: False
    simple_smoother:
      plugin: "nav2_smoother::SimpleSmoother"
      tolerance: 1.0e-10
      max_its: 1000
      do_refinement: True
    savitzky_golay:
      plugin: "nav2_smoother::SavitzkyGolaySmoother"
      do_refinement: True
      refinement_num: 2
    own:
      plugin: "smooth_house::Middle"
wrong:
  ros__parameters:
    smoother_plugins: ["constrained_smoother"]
    constrained_smoother:
      plugin: "nav2_constrained_smoother/ConstrainedSmoother"
planner_server:
  ros__parameters:
    planner_plugins: ["GridBased"]
    GridBased:
      plugin: "nav2_navfn_planner::NavfnPlanner"
global_costmap:
  global_costmap:
    ros__parameters:
      update_frequency: 5.0
      publish_frequency: 5.0
      global_frame: map
      robot_base_frame: base_link
      robot_radius: 0.15
      resolution: 0.05
      plugins: ["static_layer", "inflation_layer"]
      static_layer:
        plugin: "nav2_costmap_2d::StaticLayer"
        map_subscribe_transient_local: True
      inflation_layer:
        plugin: "nav2_costmap_2d::InflationLayer"
        cost_scaling_factor: 5.0
        inflation_radius: 0.4
`;

const plugin = `
#include "nav2_core/smoother.hpp"
#include "nav2_smoother/smoother_utils.hpp"
#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace smooth_house {

// Puts each inner pose between its neighbours.
class Middle : public nav2_core::Smoother {
 public:
  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name, std::shared_ptr<tf2_ros::Buffer>,
                 std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_sub,
                 std::shared_ptr<nav2_costmap_2d::FootprintSubscriber>) override {
    costmap_ = costmap_sub;
    RCLCPP_INFO(parent.lock()->get_logger(), "%s is ready", name.c_str());
  }
  void cleanup() override {}
  void activate() override {}
  void deactivate() override {}
  bool smooth(nav_msgs::msg::Path& path, const rclcpp::Duration& max_time) override {
    if (path.poses.size() > 100) throw nav2_core::FailedToSmoothPath("too many poses");
    if (path.poses.size() < 3) throw std::runtime_error("too few poses");
    if (costmap_->getCostmap()->getSizeInCellsX() == 0) throw nav2_core::SmootherException("no cells");
    const auto before = path.poses;
    for (size_t i = 1; i + 1 < before.size(); ++i) {
      path.poses[i].pose.position.y = (before[i - 1].pose.position.y + before[i + 1].pose.position.y) / 2;
    }
    bool reversing = false;
    smoother_utils::updateApproximatePathOrientations(path, reversing);
    return max_time.seconds() >= 1;
  }

 private:
  std::shared_ptr<nav2_costmap_2d::CostmapSubscriber> costmap_;
};

}  // namespace smooth_house

PLUGINLIB_EXPORT_CLASS(smooth_house::Middle, nav2_core::Smoother)
`;

const driver = `
#include <functional>
#include <cmath>

#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "nav2_msgs/action/compute_path_to_pose.hpp"
#include "nav2_msgs/action/smooth_path.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/lifecycle_service_client.hpp"
#include "nav2_util/service_client.hpp"
#include "nav_msgs/msg/path.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/static_transform_broadcaster.h"

using namespace std::chrono_literals;
using nav2_util::geometry_utils::calculate_path_length;
using nav2_util::geometry_utils::orientationAroundZAxis;
using nav_msgs::msg::Path;
using SmoothPath = nav2_msgs::action::SmoothPath;
using ToPose = nav2_msgs::action::ComputePathToPose;

${driverStart}

geometry_msgs::msg::PoseStamped pose(double x, double y, double yaw) {
  geometry_msgs::msg::PoseStamped result;
  result.header.frame_id = "map";
  result.pose.position.x = x;
  result.pose.position.y = y;
  result.pose.orientation = orientationAroundZAxis(yaw);
  return result;
}

Path path_of(const std::vector<geometry_msgs::msg::PoseStamped>& poses) {
  Path path;
  path.header.frame_id = "map";
  path.poses = poses;
  return path;
}

/// From the left along y, by turns to both sides of it.
Path zigzag(double x, double y, int count, double side) {
  std::vector<geometry_msgs::msg::PoseStamped> poses;
  for (int i = 0; i < count; ++i) poses.push_back(pose(x + 0.05 * i, y + (i % 2 == 0 ? side : -side), 0));
  return path_of(poses);
}

/// Ahead, and back again beside it, with its nose to the front.
Path there_and_back() {
  std::vector<geometry_msgs::msg::PoseStamped> poses;
  for (int i = 0; i <= 15; ++i) poses.push_back(pose(-2 + 0.05 * i, -1.5 + (i % 2 == 0 ? 0.02 : -0.02), 0));
  for (int i = 1; i <= 15; ++i) poses.push_back(pose(-1.25 - 0.05 * i, -1.52 - 0.02 * i, 0));
  return path_of(poses);
}

/// The sum of all changes of direction.
double bend(const Path& path) {
  double sum = 0;
  for (size_t i = 1; i + 1 < path.poses.size(); ++i) {
    const auto& a = path.poses[i - 1].pose.position;
    const auto& b = path.poses[i].pose.position;
    const auto& c = path.poses[i + 1].pose.position;
    sum += std::abs(std::remainder(std::atan2(c.y - b.y, c.x - b.x) - std::atan2(b.y - a.y, b.x - a.x), 2 * M_PI));
  }
  return sum;
}

bool same_place(const geometry_msgs::msg::PoseStamped& a, const geometry_msgs::msg::PoseStamped& b) {
  return nav2_util::geometry_utils::euclidean_distance(a, b) < 1e-12;
}

template <typename ActionT>
typename rclcpp_action::ClientGoalHandle<ActionT>::WrappedResult run(const std::string& name, const typename ActionT::Goal& goal) {
  static std::map<std::string, typename rclcpp_action::Client<ActionT>::SharedPtr> clients;
  auto& client = clients[name];
  if (!client) client = rclcpp_action::create_client<ActionT>(node, name);
  client->wait_for_action_server();
  auto handle = client->async_send_goal(goal);
  rclcpp::spin_until_future_complete(node, handle);
  auto result = client->async_get_result(handle.get());
  rclcpp::spin_until_future_complete(node, result);
  return result.get();
}

Path smooth(const char* what, const std::string& smoother, const Path& path, bool checks = false, double seconds = 5.0,
            const char* name = "smooth_path") {
  SmoothPath::Goal goal;
  goal.path = path;
  goal.smoother_id = smoother;
  goal.check_for_collisions = checks;
  goal.max_smoothing_duration = rclcpp::Duration::from_seconds(seconds);
  const auto result = run<SmoothPath>(name, goal);
  say("%s: code %d error %d completed %d", what, static_cast<int>(result.code), result.result->error_code, result.result->was_completed);
  return result.result->path;
}

/// Shorter, less curved, with the same ends.
void compare(const char* what, const Path& before, const Path& after) {
  const bool ends = before.poses.size() == after.poses.size() && same_place(before.poses.front(), after.poses.front()) &&
                    same_place(before.poses.back(), after.poses.back());
  say("%s: shorter %d straighter %d ends %d", what, calculate_path_length(after) < 0.99 * calculate_path_length(before),
      bend(after) < 0.5 * bend(before), ends);
}

uint8_t change(const char* name, std::initializer_list<uint8_t> transitions) {
  nav2_util::LifecycleServiceClient client(name, node);
  for (const uint8_t transition : transitions) client.change_state(transition, 20s);
  return client.get_state(20s);
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  tf2_ros::StaticTransformBroadcaster broadcaster(node);
  geometry_msgs::msg::TransformStamped transform;
  transform.header.stamp = node->now();
  transform.header.frame_id = "map";
  transform.child_frame_id = "base_link";
  transform.transform.translation.x = -2.0;
  transform.transform.translation.y = -2.0;
  transform.transform.rotation.w = 1.0;
  broadcaster.sendTransform(transform);
  size_t published = 0;
  const auto plans = node->create_subscription<Path>("plan_smoothed", 10, [&](const Path& path) { published = path.poses.size(); });
  nav2_util::ServiceClient<std_srvs::srv::Trigger> is_active("lifecycle_manager_navigation/is_active", node);
  auto question = std::make_shared<std_srvs::srv::Trigger::Request>();
  spin_until([&] { return is_active.invoke(question, 30s)->success; });
  spin_until([] { return false; }, 1s);

  const Path crooked = zigzag(-2.0, -1.5, 30, 0.02);
  compare("zigzag", crooked, smooth("simple", "simple_smoother", crooked, true));
  compare("zigzag", crooked, smooth("filter", "savitzky_golay", crooked, true));
  compare("zigzag", crooked, smooth("own", "own", crooked));
  const double once[] = {bend(smooth("simple once", "simple_once", crooked)), bend(smooth("filter once", "filter_once", crooked))};
  const double refined[] = {bend(smooth("simple again", "simple_smoother", crooked)), bend(smooth("filter again", "savitzky_golay", crooked))};
  say("refined %d %d", refined[0] < 0.9 * once[0], refined[1] < 0.9 * once[1]);
  spin_until([&] { return published == 30; }, 5s);
  say("published %zu", published);

  ToPose::Goal goal;
  goal.goal = pose(2.0, -2.0, -1.5);
  const Path around = run<ToPose>("compute_path_to_pose", goal).result->path;
  Path smoother_path = smooth("around the wall", "simple_smoother", around, true);
  say("longer than 6 m %d, shorter than before %d", calculate_path_length(smoother_path) > 6,
      calculate_path_length(smoother_path) < calculate_path_length(around));
  const auto& last = smoother_path.poses.back().pose;
  say("ends %d %d turned %d", same_place(around.poses.front(), smoother_path.poses.front()), same_place(around.poses.back(), smoother_path.poses.back()),
      std::abs(tf2::getYaw(last.orientation) - tf2::getYaw(around.poses.back().pose.orientation)) < 1e-9);

  const Path reversing = there_and_back();
  for (const char* const smoother : {"simple_smoother", "savitzky_golay"}) {
    const Path smoothed = smooth(smoother, smoother, reversing);
    const double ahead = tf2::getYaw(smoothed.poses[8].pose.orientation), back = tf2::getYaw(smoothed.poses[22].pose.orientation);
    say("cusp stays %d, looks ahead %d %d", same_place(reversing.poses[15], smoothed.poses[15]), std::cos(ahead) > 0.9, std::cos(back) > 0.9);
  }
  Path straight = zigzag(-2.0, -1.5, 30, 0);
  const Path still_straight = smooth("straight", "savitzky_golay", straight);
  double most = 0;
  for (const auto& stamped : still_straight.poses) most = std::max(most, std::abs(stamped.pose.position.y + 1.5));
  say("off the line by %.6f", most);

  const Path through = zigzag(-1.0, -1.5, 40, 0.02);
  smooth("through the wall", "savitzky_golay", through, true);
  smooth("unchecked", "savitzky_golay", through, false);
  const Path blocked = smooth("blocked", "simple_smoother", through, false);
  say("blocked path is as before %d", std::equal(blocked.poses.begin(), blocked.poses.end(), through.poses.begin(), same_place));

  smooth("unknown smoother", "nobody", crooked);
  smooth("no smoother", "", crooked);
  smooth("empty", "simple_smoother", path_of({}));
  Path broken = crooked;
  broken.poses[7].pose.position.x = std::nan("");
  smooth("not a number", "simple_smoother", broken);
  smooth("one pose", "simple_smoother", path_of({pose(0, 0, 1)}));
  smooth("no time", "simple_smoother", crooked, false, 0.0);
  smooth("less than no time", "savitzky_golay", crooked, false, -1.0);
  smooth("own, short", "own", crooked, false, 0.5);
  smooth("own, long", "own", zigzag(-2.0, -1.5, 101, 0.02));
  smooth("own, few", "own", path_of({pose(0, 0, 1)}));

  using lifecycle_msgs::msg::State;
  using lifecycle_msgs::msg::Transition;
  say("wild: %d", change("wild", {Transition::TRANSITION_CONFIGURE}) == State::PRIMARY_STATE_UNCONFIGURED);
  say("wrong: %d", change("wrong", {Transition::TRANSITION_CONFIGURE}) == State::PRIMARY_STATE_UNCONFIGURED);
  say("spare: %d", change("apart/spare", {Transition::TRANSITION_CONFIGURE, Transition::TRANSITION_ACTIVATE}) == State::PRIMARY_STATE_ACTIVE);
  smooth("without a costmap", "", crooked, false, 5.0, "apart/smooth_path");
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

const xml = `<library path="smooth_house_plugins">
  <class type="smooth_house::Middle" base_class_type="nav2_core::Smoother"><description>between</description></class>
</library>
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['geometry_msgs', 'lifecycle_msgs', 'nav2_msgs', 'nav2_util', 'nav_msgs', 'rclcpp', 'rclcpp_action', 'std_srvs', 'tf2', 'tf2_geometry_msgs',
    'tf2_ros'];
  const more = ['nav2_core', 'nav2_smoother', 'pluginlib'];
  workspace.addPackage('smooth_house', { driver }, {
    depends: [...libraries, ...more, 'nav2_planner', 'nav2_map_server', 'nav2_lifecycle_manager', 'rclcpp_components'],
    cmake: `${[...libraries, ...more].map((name) => `find_package(${name} REQUIRED)`).join('\n')}
add_library(smooth_house_plugins SHARED src/plugin.cpp)
ament_target_dependencies(smooth_house_plugins ${more.join(' ')})
pluginlib_export_plugin_description_file(nav2_core plugins.xml)
ament_target_dependencies(driver ${libraries.join(' ')})
install(TARGETS smooth_house_plugins DESTINATION lib)
install(DIRECTORY launch maps params DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/smooth_house/${path}`, content);
  file('src/plugin.cpp', plugin);
  file('plugins.xml', xml);
  file('launch/navigation_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  file('maps/room.pgm', room());
  file('maps/room.yaml', 'image: room.pgm\nresolution: 0.05\norigin: [-2.5, -2.5, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n');
  workspace.write('workspace.yaml', 'schema: 1\nname: smooth\npackages: [src/*]\nlaunch: src/smooth_house/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

test('paths are smoothed, and what cannot be is answered by its code', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--link', 'shared', '--for', '240s', '--until', 'driver is over']);
  const output = run.stdout + run.stderr;
  assert.equal(run.code, 0, output);
  const server = said(output, 'smoother_server');
  assert.deepEqual(said(output, 'driver'), [
    'simple: code 4 error 0 completed 1',
    'zigzag: shorter 1 straighter 1 ends 1',
    'filter: code 4 error 0 completed 1',
    'zigzag: shorter 1 straighter 1 ends 1',
    'own: code 4 error 0 completed 1',
    'zigzag: shorter 1 straighter 0 ends 1',
    'simple once: code 4 error 0 completed 1',
    'filter once: code 4 error 0 completed 1',
    'simple again: code 4 error 0 completed 1',
    'filter again: code 4 error 0 completed 1',
    'refined 1 1',
    'published 30',
    'around the wall: code 4 error 0 completed 1',
    'longer than 6 m 1, shorter than before 1',
    'ends 1 1 turned 1',
    'simple_smoother: code 4 error 0 completed 1',
    'cusp stays 1, looks ahead 1 1',
    'savitzky_golay: code 4 error 0 completed 1',
    'cusp stays 1, looks ahead 1 1',
    'straight: code 4 error 0 completed 1',
    'off the line by 0.000000',
    'through the wall: code 6 error 503 completed 1',
    'unchecked: code 4 error 0 completed 1',
    'blocked: code 4 error 0 completed 1',
    'blocked path is as before 1',
    'unknown smoother: code 6 error 501 completed 0',
    'no smoother: code 6 error 501 completed 0',
    'empty: code 6 error 505 completed 0',
    'not a number: code 6 error 505 completed 0',
    'one pose: code 4 error 0 completed 1',
    'no time: code 6 error 502 completed 0',
    'less than no time: code 6 error 502 completed 0',
    'own, short: code 4 error 0 completed 0',
    'own, long: code 6 error 504 completed 0',
    'own, few: code 6 error 500 completed 0',
    'wild: 1',
    'wrong: 1',
    'spare: 1',
    'without a costmap: code 6 error 500 completed 0',
    'driver is over',
  ], output);
  for (
    const line of ['Created smoother : simple_smoother of type nav2_smoother::SimpleSmoother', 'own is ready',
      'Smoother Server has simple_smoother savitzky_golay own simple_once filter_once  smoothers available.', 'Received a path to smooth.',
      'SmoothPath called with smoother name nobody, which does not exist. Available smoothers are: simple_smoother savitzky_golay own simple_once filter_once .',
      'Invalid Smoother: nobody', 'Requested path to smooth is empty', 'Requested path to smooth is invalid', 'Requested path to smooth contains NaNs or Infs',
      'Smoothing time exceeded allowed duration of 0.00.', 'Smoothing time exceed allowed duration', 'too many poses', 'too few poses']
  ) assert.ok(server.includes(line), `smoother_server does not say: ${line}\n${output}`);
  assert.match(output, /\[smoother_server\]: Smoothed path leads to a collision at x: -0\.\d+, y: -1\.\d+, theta: /);
  assert.match(output, /\[wrong\]: Failed to create smoother\. Exception: .*nav2_constrained_smoother\/ConstrainedSmoother/);
  assert.match(output, /spare\]: Costmap is not available/);
  assert.match(output, /spare\]: No smoother was specified in action call\. Server will use only plugin loaded simple_smoother \. /);
});
