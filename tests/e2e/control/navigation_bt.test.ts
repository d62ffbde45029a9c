// Nav2 as a whole: bt_navigator leads planner, controller and behaviours by its default trees and by trees of the workspace. Goals by
// action and by topic, through poses, changed, cancelled, and out of reach; nodes of all kinds, and nodes and navigators of the workspace.

// Compatibility, works: Nav2's `bt_navigator` with `navigate_to_pose`, `navigate_through_poses` and `goal_pose`, its default trees, the nodes of
// `nav2_behavior_tree`, and trees, nodes (`plugin_lib_names`) and navigators of the workspace

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { base, costmap, room, roomYaml, said } from '../support/room_robot.ts';
import { trees } from '../support/tour_trees.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('house_tour')
    params = os.path.join(share, 'params', 'nav2_params.yaml')
    lifecycle_nodes = ['map_server', 'controller_server', 'planner_server', 'smoother_server', 'behavior_server', 'bt_navigator']
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_server', output='screen',
             parameters=[params, {'yaml_filename': os.path.join(share, 'maps', 'room.yaml')}]),
        Node(package='nav2_controller', executable='controller_server', output='screen', parameters=[params]),
        Node(package='nav2_planner', executable='planner_server', name='planner_server', output='screen', parameters=[params]),
        Node(package='nav2_smoother', executable='smoother_server', name='smoother_server', output='screen', parameters=[params]),
        Node(package='nav2_behaviors', executable='behavior_server', name='behavior_server', output='screen', parameters=[params]),
        Node(package='nav2_bt_navigator', executable='bt_navigator', name='bt_navigator', output='screen', parameters=[params]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True, 'node_names': lifecycle_nodes}]),
        Node(package='house_tour', executable='base', output='screen'),
        Node(package='house_tour', executable='driver', output='screen', parameters=[{'trees': os.path.join(share, 'trees')}]),
    ])
`;

const parameters = `
bt_navigator:
  ros__parameters:
    global_frame: map
    robot_base_frame: base_link
    odom_topic: odom
    default_server_timeout: 20
    navigators: ["navigate_to_pose", "navigate_through_poses", "tour"]
    navigate_to_pose:
      plugin: "nav2_bt_navigator::NavigateToPoseNavigator"
    navigate_through_poses:
      plugin: "nav2_bt_navigator::NavigateThroughPosesNavigator"
    tour:
      plugin: "house_tour::TourNavigator"
    plugin_lib_names: ["house_tour_nodes", "nav2_spin_action_bt_node"]
    error_code_names: ["compute_path_error_code", "follow_path_error_code"]
controller_server:
  ros__parameters:
    controller_frequency: 20.0
    failure_tolerance: 0.3
    progress_checker_plugins: ["progress_checker"]
    goal_checker_plugins: ["goal_checker"]
    controller_plugins: ["FollowPath"]
    progress_checker:
      plugin: "nav2_controller::SimpleProgressChecker"
      required_movement_radius: 0.2
      movement_time_allowance: 3.0
    goal_checker:
      plugin: "nav2_controller::SimpleGoalChecker"
    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
      desired_linear_vel: 0.5
      lookahead_dist: 0.4
      use_cost_regulated_linear_velocity_scaling: false
planner_server:
  ros__parameters:
    planner_plugins: ["GridBased"]
    GridBased:
      plugin: "nav2_navfn_planner::NavfnPlanner"
      tolerance: 0.0
smoother_server:
  ros__parameters:
    smoother_plugins: ["simple"]
    simple:
      plugin: "nav2_smoother::SimpleSmoother"
behavior_server:
  ros__parameters:
    local_costmap_topic: local_costmap/costmap_raw
    global_costmap_topic: global_costmap/costmap_raw
    local_footprint_topic: local_costmap/published_footprint
    global_footprint_topic: global_costmap/published_footprint
    behavior_plugins: ["spin", "backup", "drive_on_heading", "wait", "assisted_teleop"]
    spin:
      plugin: "nav2_behaviors::Spin"
    backup:
      plugin: "nav2_behaviors::BackUp"
    drive_on_heading:
      plugin: "nav2_behaviors::DriveOnHeading"
    wait:
      plugin: "nav2_behaviors::Wait"
    assisted_teleop:
      plugin: "nav2_behaviors::AssistedTeleop"
${costmap('global_costmap', 'map', '      plugins: ["static_layer", "inflation_layer"]')}
${costmap('local_costmap', 'odom', '      rolling_window: true\n      width: 3\n      height: 3\n      plugins: ["static_layer", "inflation_layer"]')}
`;

/** A library of nodes, as packages write them. */
const nodes = `
#include <string>

#include "behaviortree_cpp/bt_factory.h"
#include "nav2_behavior_tree/bt_service_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace house_tour {

class Ring : public nav2_behavior_tree::BtServiceNode<std_srvs::srv::Trigger> {
 public:
  Ring(const std::string& name, const BT::NodeConfiguration& conf) : BtServiceNode(name, conf) {}
  static BT::PortsList providedPorts() { return providedBasicPorts({BT::OutputPort<std::string>("said", "what it said")}); }
  BT::NodeStatus on_completion(std::shared_ptr<std_srvs::srv::Trigger::Response> response) override {
    setOutput("said", response->message);
    return response->success ? BT::NodeStatus::SUCCESS : BT::NodeStatus::FAILURE;
  }
};

class Say : public BT::SyncActionNode {
 public:
  Say(const std::string& name, const BT::NodeConfiguration& conf) : BT::SyncActionNode(name, conf) {}
  static BT::PortsList providedPorts() { return {BT::InputPort<std::string>("text", "what to say")}; }
  BT::NodeStatus tick() override {
    std::string text;
    getInput("text", text);
    RCLCPP_INFO(config().blackboard->get<rclcpp::Node::SharedPtr>("node")->get_logger(), "tree says %s", text.c_str());
    return BT::NodeStatus::SUCCESS;
  }
};

}  // namespace house_tour

BT_REGISTER_NODES(factory) {
  factory.registerNodeType<house_tour::Ring>("Ring");
  factory.registerNodeType<house_tour::Say>("Say");
}
`;

/** A navigator with an action of Nav2 that no other one has. */
const navigator = `
#include "ament_index_cpp/get_package_share_directory.hpp"
#include "nav2_core/behavior_tree_navigator.hpp"
#include "nav2_msgs/action/dummy_behavior.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace house_tour {

class TourNavigator : public nav2_core::BehaviorTreeNavigator<nav2_msgs::action::DummyBehavior> {
 public:
  using ActionT = nav2_msgs::action::DummyBehavior;
  std::string getName() override { return "tour"; }
  std::string getDefaultBTFilepath(rclcpp_lifecycle::LifecycleNode::WeakPtr) override {
    return ament_index_cpp::get_package_share_directory("house_tour") + "/trees/tour.xml";
  }

 protected:
  bool goalReceived(ActionT::Goal::ConstSharedPtr goal) override {
    bt_action_server_->getBlackboard()->set("text", goal->command.data);
    return goal->command.data != "nothing";
  }
  void onLoop() override {}
  void onPreempt(ActionT::Goal::ConstSharedPtr) override {}
  void goalCompleted(ActionT::Result::SharedPtr, const nav2_behavior_tree::BtStatus) override {}
};

}  // namespace house_tour

PLUGINLIB_EXPORT_CLASS(house_tour::TourNavigator, nav2_core::NavigatorBase)
`;

const navigatorXml = `<library path="house_tour_navigator">
  <class type="house_tour::TourNavigator" base_class_type="nav2_core::NavigatorBase"><description>A tour.</description></class>
</library>
`;

const driver = `
#include <functional>
#include <cmath>

#include <filesystem>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav2_behavior_tree/behavior_tree_engine.hpp"
#include "nav2_behavior_tree/plugins_list.hpp"
#include "nav2_msgs/action/dummy_behavior.hpp"
#include "nav2_msgs/action/navigate_through_poses.hpp"
#include "nav2_msgs/action/navigate_to_pose.hpp"
#include "nav2_msgs/msg/behavior_tree_log.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/string_utils.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "sensor_msgs/msg/battery_state.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_srvs/srv/empty.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

using namespace std::chrono_literals;
using geometry_msgs::msg::PoseStamped;
using ToPose = nav2_msgs::action::NavigateToPose;
using Through = nav2_msgs::action::NavigateThroughPoses;
using Tour = nav2_msgs::action::DummyBehavior;

${driverStart}

nav_msgs::msg::Odometry odometry;
geometry_msgs::msg::Twist command;
std::string trees;

PoseStamped pose(double x, double y, double yaw = 0) {
  PoseStamped result;
  result.header.frame_id = "map";
  result.pose.position.x = x;
  result.pose.position.y = y;
  result.pose.orientation = nav2_util::geometry_utils::orientationAroundZAxis(yaw);
  return result;
}

double distance(double x, double y) {
  const auto& place = odometry.pose.pose.position;
  return std::hypot(place.x - 1.975 - x, place.y - 1.975 - y);
}

ToPose::Goal to(double x, double y, double yaw = 0, const std::string& tree = "") {
  ToPose::Goal goal;
  goal.pose = pose(x, y, yaw);
  if (!tree.empty()) goal.behavior_tree = trees + "/" + tree;
  return goal;
}

template <typename ActionT>
struct Work {
  typename rclcpp_action::Client<ActionT>::SharedPtr client;
  std::vector<double> distances;
  int left = 0, recoveries = 0;

  explicit Work(const std::string& name) : client(rclcpp_action::create_client<ActionT>(node, name)) {}

  auto send(const typename ActionT::Goal& goal) {
    distances.clear();
    typename rclcpp_action::Client<ActionT>::SendGoalOptions options;
    options.feedback_callback = [this](const auto&, const std::shared_ptr<const typename ActionT::Feedback> one) {
      if constexpr (!std::is_same_v<ActionT, Tour>) {
        distances.push_back(one->distance_remaining);
        recoveries = one->number_of_recoveries;
      }
      if constexpr (std::is_same_v<ActionT, Through>) left = one->number_of_poses_remaining;
    };
    return wait(client->async_send_goal(goal, options));
  }

  template <typename HandleT>
  void end(const char* what, HandleT handle) {
    const auto result = wait(client->async_get_result(handle));
    say("%s: code %d error %d", what, static_cast<int>(result.code), result.result->error_code);
  }

  void work(const char* what, const typename ActionT::Goal& goal) { end(what, send(goal)); }
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  trees = node->declare_parameter("trees", std::string());
  Work<ToPose> navigator("navigate_to_pose");
  Work<Through> through("navigate_through_poses");
  Work<Tour> tour("tour");
  const auto odometries = node->create_subscription<nav_msgs::msg::Odometry>("odom", 10, [](const nav_msgs::msg::Odometry& message) { odometry = message; });
  const auto commands = node->create_subscription<geometry_msgs::msg::Twist>("cmd_vel", 10, [](const geometry_msgs::msg::Twist& twist) { command = twist; });
  int changes = 0;
  std::string follower = "not seen";
  const auto log = node->create_subscription<nav2_msgs::msg::BehaviorTreeLog>("behavior_tree_log", 10, [&](const nav2_msgs::msg::BehaviorTreeLog& message) {
    changes += static_cast<int>(message.event_log.size());
    for (const auto& event : message.event_log) {
      if (event.node_name == "FollowPath" && event.current_status == "RUNNING") follower = event.previous_status;
    }
  });
  const auto bell = node->create_service<std_srvs::srv::Trigger>("ring", [](const std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr answer) {
    answer->success = true;
    answer->message = "dong";
  });
  int reinitialized = 0;
  const auto reinitialize = node->create_service<std_srvs::srv::Empty>("reinitialize_global_localization",
    [&](const std_srvs::srv::Empty::Request::SharedPtr, std_srvs::srv::Empty::Response::SharedPtr) { ++reinitialized; });
  const auto brakes = node->create_publisher<std_msgs::msg::Bool>("brake", 1);
  const auto batteries = node->create_publisher<sensor_msgs::msg::BatteryState>("/battery_status", rclcpp::QoS(10));
  const auto goals = node->create_publisher<PoseStamped>("goal_pose", 10);
  sensor_msgs::msg::BatteryState battery;
  battery.percentage = 0.1F;
  battery.power_supply_status = battery.POWER_SUPPLY_STATUS_CHARGING;
  const auto charger = node->create_wall_timer(100ms, [&] { batteries->publish(battery); });
  navigator.client->wait_for_action_server();
  decltype(navigator.send(to(0, 0))) handle;
  while (rclcpp::ok() && !handle) {
    handle = navigator.send(to(2.0, -2.0, 1.57));
    if (!handle) pass(200ms);
  }
  const auto start = node->now();
  navigator.end("around the wall", handle);
  say("in time %d, at the goal %d, turned %d", (node->now() - start).seconds() < 30, distance(2.0, -2.0) < 0.25,
      std::abs(tf2::getYaw(odometry.pose.pose.orientation) - 1.57) < 0.25);
  const auto& d = navigator.distances;
  double before = 0;
  for (const double one : d) if (one > 0 && before == 0) before = one;
  say("remaining at first %.1f, at last %d, recoveries %d", before, !d.empty() && d.back() < 0.5, navigator.recoveries);
  say("log %d, FollowPath began %s", changes > 20, follower.c_str());

  goals->publish(pose(2.0, -1.0, 1.57));
  for (int i = 0; i < 200 && distance(2.0, -1.0) > 0.25; ++i) pass(100ms);
  pass(1s);
  say("by topic at the goal %d", distance(2.0, -1.0) < 0.25);

  Through::Goal both;
  both.poses = {pose(2.0, 1.0), pose(-1.0, 1.8, 3.14)};
  through.work("through poses", both);
  say("at the last %d, left %d", distance(-1.0, 1.8) < 0.25, through.left);

  handle = navigator.send(to(-2.0, -2.0));
  pass(1s);
  const auto second = navigator.send(to(-2.0, 1.0));
  navigator.end("the first of two", handle);
  navigator.end("the second", second);
  say("at the second %d", distance(-2.0, 1.0) < 0.25);

  handle = navigator.send(to(-2.0, -2.0));
  pass(1500ms);
  const auto while_busy = tour.send(Tour::Goal());
  tour.end("another navigator meanwhile", while_busy);
  wait(navigator.client->async_cancel_goal(handle));
  navigator.end("cancelled", handle);
  pass(300ms);
  say("stands %d", command.linear.x == 0 && command.angular.z == 0);

  navigator.work("in the wall", to(0.025, -1.0));
  ToPose::Goal lost = to(1.0, 1.0);
  lost.pose.header.frame_id = "nowhere";
  navigator.work("in no frame", lost);
  navigator.work("no such tree", to(1.0, 1.0, 0, "none.xml"));
  navigator.work("tree with an unknown node", to(1.0, 1.0, 0, "unknown.xml"));
  navigator.work("tree without a server", to(1.0, 1.0, 0, "absent.xml"));
  navigator.work("every condition", to(-2.0, 1.0, 0, "conditions.xml"));
  navigator.work("paths", to(-2.0, -1.0, 0, "paths.xml"));
  pass(200ms);
  const double yaw = tf2::getYaw(odometry.pose.pose.orientation);
  navigator.work("behaviours", to(-2.0, 1.0, 0, "behaviours.xml"));
  pass(200ms);
  const double turned = std::remainder(tf2::getYaw(odometry.pose.pose.orientation) - yaw, 2 * M_PI);
  say("turned by half a radian %d, reinitialized %d", std::abs(turned - 0.5) < 0.15, reinitialized);
  Through::Goal nested;
  nested.poses = {pose(1.0, 1.0)};
  nested.behavior_tree = trees + "/nested.xml";
  through.work("a navigation within another one", nested);

  // Held, the robot makes no progress: the tree recovers until it is free again.
  std_msgs::msg::Bool brake;
  brake.data = true;
  brakes->publish(brake);
  handle = navigator.send(to(-2.0, 1.0));
  pass(5s);
  brake.data = false;
  brakes->publish(brake);
  navigator.end("held for a while", handle);
  say("recovered %d", navigator.recoveries > 0);

  int loaded = 0;
  for (const auto& file : std::filesystem::directory_iterator(ament_index_cpp::get_package_share_directory("nav2_bt_navigator") + "/behavior_trees")) {
    const bool takes_poses = file.path().string().find("through_poses") != std::string::npos;
    ToPose::Goal one = to(-1.0, 1.0);
    one.behavior_tree = file.path();
    if (takes_poses) continue;
    handle = navigator.send(one);
    pass(200ms);
    wait(navigator.client->async_cancel_goal(handle));
    loaded += wait(navigator.client->async_get_result(handle)).code == rclcpp_action::ResultCode::CANCELED;
  }
  say("trees %d", loaded);

  // An own program has the nodes of Nav2, too.
  nav2_behavior_tree::BehaviorTreeEngine engine(nav2_util::split(nav2::details::BT_BUILTIN_PLUGINS, ';'), node);
  BT::Tree own = engine.createTreeFromText(
    "<root BTCPP_format='4'><BehaviorTree ID='T'><RateController hz='10'><AlwaysSuccess/></RateController></BehaviorTree></root>", BT::Blackboard::create());
  say("own tree %d", engine.run(&own, [] {}, [] { return false; }) == nav2_behavior_tree::BtStatus::SUCCEEDED);
  Tour::Goal words;
  words.command.data = "hello";
  tour.work("a tour", words);
  words.command.data = "nothing";
  tour.work("a tour of nothing", words);
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['ament_index_cpp', 'behaviortree_cpp', 'geometry_msgs', 'nav2_behavior_tree', 'nav2_core', 'nav2_msgs', 'nav2_util', 'nav_msgs',
    'pluginlib', 'rclcpp', 'rclcpp_action', 'sensor_msgs', 'std_msgs', 'std_srvs', 'tf2_geometry_msgs', 'tf2_ros'];
  workspace.addPackage('house_tour', { base, driver }, {
    depends: [...libraries, 'nav2_behaviors', 'nav2_bt_navigator', 'nav2_controller', 'nav2_lifecycle_manager', 'nav2_map_server', 'nav2_planner',
      'nav2_smoother'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
add_library(house_tour_nodes SHARED src/nodes.cpp)
ament_target_dependencies(house_tour_nodes behaviortree_cpp nav2_behavior_tree rclcpp std_srvs)
target_compile_definitions(house_tour_nodes PRIVATE BT_PLUGIN_EXPORT)
add_library(house_tour_navigator SHARED src/navigator.cpp)
ament_target_dependencies(house_tour_navigator ament_index_cpp nav2_behavior_tree nav2_core nav2_msgs pluginlib)
pluginlib_export_plugin_description_file(nav2_core navigators.xml)
ament_target_dependencies(base geometry_msgs nav2_util nav_msgs rclcpp std_msgs tf2_ros)
ament_target_dependencies(driver ament_index_cpp geometry_msgs nav2_behavior_tree nav2_msgs nav2_util nav_msgs rclcpp rclcpp_action sensor_msgs std_msgs
  std_srvs tf2_geometry_msgs)
install(TARGETS house_tour_nodes house_tour_navigator DESTINATION lib)
install(DIRECTORY launch maps params trees DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/house_tour/${path}`, content);
  file('src/nodes.cpp', nodes);
  file('src/navigator.cpp', navigator);
  file('navigators.xml', navigatorXml);
  file('launch/navigation_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  file('maps/room.pgm', room());
  file('maps/room.yaml', roomYaml);
  for (const [name, text] of Object.entries(trees)) file(`trees/${name}.xml`, text);
  workspace.write('workspace.yaml', 'schema: 1\nname: tour\npackages: [src/*]\nlaunch: src/house_tour/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared')) {
  test(`${link}: trees lead a robot to goals, and their nodes run`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '180s', '--until', 'driver is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const server = said(output, 'bt_navigator');
    assert.deepEqual(said(output, 'driver'), [
      'around the wall: code 4 error 0',
      'in time 1, at the goal 1, turned 1',
      'remaining at first 8.2, at last 1, recoveries 0',
      'log 1, FollowPath began IDLE',
      'by topic at the goal 1',
      'through poses: code 4 error 0',
      'at the last 1, left 1',
      'the first of two: code 6 error 0',
      'the second: code 4 error 0',
      'at the second 1',
      'another navigator meanwhile: code 6 error 0',
      'cancelled: code 5 error 0',
      'stands 1',
      'in the wall: code 6 error 206',
      'in no frame: code 6 error 0',
      'no such tree: code 6 error 0',
      'tree with an unknown node: code 6 error 0',
      'tree without a server: code 6 error 0',
      'every condition: code 4 error 0',
      'paths: code 4 error 0',
      'behaviours: code 4 error 0',
      'turned by half a radian 1, reinitialized 1',
      'a navigation within another one: code 4 error 0',
      'held for a while: code 4 error 0',
      'recovered 1',
      'trees 11',
      'own tree 1',
      'a tour: code 4 error 0',
      'a tour of nothing: code 6 error 0',
      'driver is over',
    ], output);
    for (
      const line of [
        'Creating navigator id navigate_to_pose of type nav2_bt_navigator::NavigateToPoseNavigator',
        'Goal succeeded',
        'Goal canceled',
        'Goal failed',
        'Received goal preemption request',
        'Requested navigation from tour while another navigator is processing, rejecting request.',
        'Requested navigation from navigate_to_pose while another navigator is processing, rejecting request.',
        "Failed to transform a goal pose provided with frame_id 'nowhere' to the global frame 'map'.",
      ]
    ) assert.ok(server.includes(line), `bt_navigator does not say: ${line}\n${output}`);
    assert.match(output, /Begin navigating from current location \(-1\.9\d, -1\.9\d\) to \(2\.00, -2\.00\)/);
    assert.match(output, /BT file not found: .*none\.xml\. Navigation canceled\./);
    assert.match(output, /Exception when loading BT: .*Fly/);
    assert.match(output, /"nobody\/spin" action server not available after waiting for 1\.00s/);
    for (const text of ['all conditions', 'all paths', 'all behaviours', 'dong', 'hello']) assert.match(output, new RegExp(`tree says ${text}`));
  });
}
