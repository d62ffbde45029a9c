// The planner server with its global costmap as bringup packages of Nav2 start it: paths around a wall, codes of errors, obstacles that a
// lidar sees, costs, services, and a planner and a costmap layer of the workspace. Headless.

// Compatibility, works: Nav2's `planner_server` with NavfnPlanner (Dijkstra and A*; the paths of upstream), `compute_path_to_pose`,
// `compute_path_through_poses`, `is_path_valid`, and planners of the workspace, also with the `createPlan` of ROS 2 Humble

// Compatibility, works: Nav2's costmaps (nav2_costmap_2d): static, obstacle, voxel and inflation layers and those of the workspace, rolling
// and fixed, with their topics and services

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { room, said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
from nav2_common.launch import RewrittenYaml


def generate_launch_description():
    share = get_package_share_directory('house_planner')
    configured_params = RewrittenYaml(source_file=os.path.join(share, 'params', 'nav2_params.yaml'), root_key='', convert_types=True,
                                      param_rewrites={'yaml_filename': os.path.join(share, 'maps', 'room.yaml')})
    lifecycle_nodes = ['map_server', 'planner_server']
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_server', name='map_server', output='screen', parameters=[configured_params]),
        Node(package='nav2_planner', executable='planner_server', name='planner_server', output='screen', parameters=[configured_params]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True}, {'node_names': lifecycle_nodes}]),
        Node(package='house_planner', executable='driver', output='screen'),
    ])
`;

const parameters = `
map_server:
  ros__parameters:
    yaml_filename: ""
planner_server:
  ros__parameters:
    expected_planner_frequency: 0.2
    planner_plugins: ["GridBased", "Star", "Line", "Old", "Exact"]
    GridBased:
      plugin: "nav2_navfn_planner::NavfnPlanner"
      tolerance: 0.5
      use_astar: false
      allow_unknown: true
    Star:
      plugin: "nav2_navfn_planner/NavfnPlanner"
      use_astar: true
    Line:
      plugin: "house_planner::Line"
    Old:
      plugin: "house_planner::OldLine"
    Exact:
      plugin: "nav2_navfn_planner::NavfnPlanner"
      tolerance: 0.0
      use_final_approach_orientation: true
global_costmap:
  global_costmap:
    ros__parameters:
      update_frequency: 10.0
      publish_frequency: 10.0
      global_frame: map
      robot_base_frame: base_link
      robot_radius: 0.22
      footprint_padding: 0.0
      resolution: 0.05
      track_unknown_space: true
      plugins: ["static_layer", "obstacle_layer", "voxel_layer", "stripe_layer", "inflation_layer"]
      static_layer:
        plugin: "nav2_costmap_2d::StaticLayer"
        map_subscribe_transient_local: True
      obstacle_layer:
        plugin: "nav2_costmap_2d::ObstacleLayer"
        enabled: True
        observation_sources: scan
        scan:
          topic: /scan
          max_obstacle_height: 2.0
          clearing: True
          marking: True
          data_type: "LaserScan"
          raytrace_max_range: 3.0
          obstacle_max_range: 2.5
      voxel_layer:
        plugin: "nav2_costmap_2d::VoxelLayer"
        enabled: True
        z_voxels: 16
        z_resolution: 0.05
        max_obstacle_height: 2.0
        mark_threshold: 0
        publish_voxel_map: True
        observation_sources: points
        points:
          topic: /points
          max_obstacle_height: 2.0
          clearing: True
          marking: True
          data_type: "PointCloud2"
      stripe_layer:
        plugin: "house_planner::StripeLayer"
      inflation_layer:
        plugin: "nav2_costmap_2d::InflationLayer"
        enabled: False
        cost_scaling_factor: 3.0
        inflation_radius: 0.75
`;

const plugins = `
#include "nav2_core/global_planner.hpp"
#include "nav2_costmap_2d/costmap_layer.hpp"
#include "nav2_costmap_2d/costmap_math.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace house_planner {

using geometry_msgs::msg::PoseStamped;
using nav_msgs::msg::Path;

class LinePlanner : public nav2_core::GlobalPlanner {
 public:
  void configure(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, std::string name, std::shared_ptr<tf2_ros::Buffer>,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override {
    frame_ = costmap_ros->getGlobalFrameID();
    RCLCPP_INFO(parent.lock()->get_logger(), "line %s over %u cells", name.c_str(), costmap_ros->getCostmap()->getSizeInCellsX());
  }
  void cleanup() override {}
  void activate() override {}
  void deactivate() override {}

 protected:
  Path line(const PoseStamped& start, const PoseStamped& goal) {
    if (start.header.frame_id != goal.header.frame_id) throw nav2_core::PlannerException("two frames");
    Path path;
    path.header.frame_id = frame_;
    path.poses = {start, goal};
    return path;
  }
  std::string frame_;
};

class Line : public LinePlanner {
 public:
  Path createPlan(const PoseStamped& start, const PoseStamped& goal, std::function<bool()>) override {
    if (goal.pose.position.x < 0) throw std::runtime_error("a goal behind the zero");
    return line(start, goal);
  }
};

// As a planner of ROS 2 Humble.
class OldLine : public LinePlanner {
 public:
  Path createPlan(const PoseStamped& start, const PoseStamped& goal) override { return line(start, goal); }
};

// A column of cells that cost 100.
class StripeLayer : public nav2_costmap_2d::Layer {
 public:
  void onInitialize() override {
    declareParameter("enabled", rclcpp::ParameterValue(true));
    node_.lock()->get_parameter(name_ + "." + "enabled", enabled_);
    current_ = true;
  }
  void updateBounds(double, double, double, double* min_x, double* min_y, double* max_x, double* max_y) override {
    *min_x = std::min(*min_x, -2.4);
    *min_y = std::min(*min_y, -2.4);
    *max_x = std::max(*max_x, 2.4);
    *max_y = std::max(*max_y, 2.4);
  }
  void updateCosts(nav2_costmap_2d::Costmap2D& master_grid, int, int min_j, int, int max_j) override {
    if (!enabled_) return;
    for (int j = min_j; j < max_j; j++) {
      if (master_grid.getCost(95, j) < 100) master_grid.setCost(95, j, 100);
    }
  }
  void reset() override {}
  bool isClearable() override { return false; }
};

}  // namespace house_planner

PLUGINLIB_EXPORT_CLASS(house_planner::Line, nav2_core::GlobalPlanner)
PLUGINLIB_EXPORT_CLASS(house_planner::OldLine, nav2_core::GlobalPlanner)
PLUGINLIB_EXPORT_CLASS(house_planner::StripeLayer, nav2_costmap_2d::Layer)
`;

const driver = `
#include <functional>
#include <cmath>
#include <limits>

#include "nav2_costmap_2d/costmap_subscriber.hpp"
#include "nav2_msgs/action/compute_path_through_poses.hpp"
#include "nav2_msgs/action/compute_path_to_pose.hpp"
#include "nav2_msgs/msg/voxel_grid.hpp"
#include "nav2_msgs/srv/clear_costmap_around_robot.hpp"
#include "nav2_msgs/srv/clear_entire_costmap.hpp"
#include "nav2_msgs/srv/get_cost.hpp"
#include "nav2_msgs/srv/is_path_valid.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/service_client.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2_ros/transform_broadcaster.h"

using namespace std::chrono_literals;
using geometry_msgs::msg::PoseStamped;
using ToPose = nav2_msgs::action::ComputePathToPose;
using ThroughPoses = nav2_msgs::action::ComputePathThroughPoses;

${driverStart}

std::shared_ptr<tf2_ros::TransformBroadcaster> broadcaster;
rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scans;
rclcpp::Publisher<sensor_msgs::msg::PointCloud2>::SharedPtr clouds;
double block = 0;  // m in front of the robot; 0: nothing; less: the lidar is covered
bool sees_box = false;
int looks = 0;

double world(int cell) { return -2.5 + (cell + 0.5) * 0.05; }

PoseStamped pose(int x, int y, double yaw = 0) {
  PoseStamped result;
  result.header.frame_id = "map";
  result.pose.position.x = world(x);
  result.pose.position.y = world(y);
  result.pose.orientation = nav2_util::geometry_utils::orientationAroundZAxis(yaw);
  return result;
}

void look() {
  geometry_msgs::msg::TransformStamped transform;
  transform.header.stamp = node->now();
  transform.header.frame_id = "map";
  transform.child_frame_id = "base_link";
  transform.transform.translation.x = world(10);
  transform.transform.translation.y = world(10);
  transform.transform.rotation.w = 1.0;
  broadcaster->sendTransform(transform);
  sensor_msgs::msg::LaserScan scan;
  scan.header.stamp = transform.header.stamp;
  scan.header.frame_id = "base_link";
  scan.angle_min = -0.1F;
  scan.angle_max = 0.1F;
  scan.angle_increment = 0.02F;
  scan.range_min = 0.1F;
  scan.range_max = 5.0F;
  scan.ranges.assign(11, block > 0 ? static_cast<float>(block) : block < 0 ? 0.05F : 2.9F);
  scans->publish(scan);
  sensor_msgs::msg::PointCloud2 cloud;
  cloud.header = scan.header;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(2);
  // Without the box, what is behind it in the same direction.
  const float points[2][3] = {{0.0F, sees_box ? 1.0F : 2.8F, sees_box ? 0.225F : 0.63F}, {std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F}};
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x"), y(cloud, "y"), z(cloud, "z");
  for (const auto& point : points) {
    *x = point[0]; *y = point[1]; *z = point[2];
    ++x; ++y; ++z;
  }
  clouds->publish(cloud);
  // Clouds that nobody can read.
  cloud.width = 1000;
  clouds->publish(cloud);
  cloud.width = 2;
  cloud.fields.pop_back();
  clouds->publish(cloud);
  ++looks;
}

template <typename ActionT>
typename rclcpp_action::ClientGoalHandle<ActionT>::WrappedResult run(const std::string& name, const typename ActionT::Goal& goal) {
  static auto client = rclcpp_action::create_client<ActionT>(node, name);
  client->wait_for_action_server();
  auto handle = client->async_send_goal(goal);
  rclcpp::spin_until_future_complete(node, handle);
  auto result = client->async_get_result(handle.get());
  rclcpp::spin_until_future_complete(node, result);
  return result.get();
}

template <typename ResultT>
void tell(const char* what, const ResultT& result) {
  const auto& path = result.result->path;
  say("%s: code %d error %d poses %zu length %.3f", what, static_cast<int>(result.code), result.result->error_code, path.poses.size(),
      nav2_util::geometry_utils::calculate_path_length(path));
}

nav_msgs::msg::Path plan(const char* what, const std::string& planner, const PoseStamped& goal) {
  ToPose::Goal request;
  request.goal = goal;
  request.planner_id = planner;
  const auto result = run<ToPose>("compute_path_to_pose", request);
  tell(what, result);
  return result.result->path;
}

template <typename ServiceT>
typename ServiceT::Response call(const std::string& name, std::shared_ptr<typename ServiceT::Request> request = std::make_shared<typename ServiceT::Request>()) {
  nav2_util::ServiceClient<ServiceT> client(name, node);
  return *client.invoke(request, 30s);
}

double cost(double x, double y) {
  auto request = std::make_shared<nav2_msgs::srv::GetCost::Request>();
  request->x = static_cast<float>(x);
  request->y = static_cast<float>(y);
  return call<nav2_msgs::srv::GetCost>("global_costmap/get_cost_global_costmap", request).cost;
}

bool valid(const nav_msgs::msg::Path& path) {
  auto request = std::make_shared<nav2_msgs::srv::IsPathValid::Request>();
  request->path = path;
  return call<nav2_msgs::srv::IsPathValid>("is_path_valid", request).is_valid;
}

bool set(const std::string& name, const rclcpp::ParameterValue& value) {
  rclcpp::AsyncParametersClient client(node, "/global_costmap/global_costmap");
  client.wait_for_service();
  auto future = client.set_parameters({rclcpp::Parameter(name, value)});
  rclcpp::spin_until_future_complete(node, future);
  return future.get().at(0).successful;
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  broadcaster = std::make_shared<tf2_ros::TransformBroadcaster>(node);
  scans = node->create_publisher<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS());
  clouds = node->create_publisher<sensor_msgs::msg::PointCloud2>("points", rclcpp::SensorDataQoS());
  const auto timer = node->create_wall_timer(50ms, look);
  nav_msgs::msg::OccupancyGrid grid;
  const auto grids = node->create_subscription<nav_msgs::msg::OccupancyGrid>(
      "global_costmap/costmap", rclcpp::QoS(1).transient_local(), [&](const nav_msgs::msg::OccupancyGrid& message) { grid = message; });
  size_t voxels = 0;
  const auto voxel_grids = node->create_subscription<nav2_msgs::msg::VoxelGrid>(
      "global_costmap/voxel_grid", rclcpp::QoS(1).transient_local(), [&](const nav2_msgs::msg::VoxelGrid& message) {
        voxels = 0;
        for (const uint32_t column : message.data) voxels += (column >> 16) != 0;
      });
  nav2_costmap_2d::CostmapSubscriber costs(rclcpp::Node::WeakPtr(node), "global_costmap/costmap_raw");
  // Before the map has come the costmap has a size of its own.
  spin_until([&] { return grid.info.origin.position.x < 0; });
  say("costmap %ux%u at %.2f", grid.info.width, grid.info.height, grid.info.origin.position.x);

  const auto around = plan("dijkstra", "GridBased", pose(90, 10, 1.0));
  const auto& last = around.poses.back().pose;
  say("to %.3f %.3f turned %d", last.position.x, last.position.y, last.orientation.z > 0.4);
  plan("astar", "Star", pose(90, 10));
  plan("line", "Line", pose(90, 10));
  plan("old line", "Old", pose(90, 10));
  plan("behind", "Line", pose(10, 90));
  plan("unknown planner", "Nobody", pose(90, 10));
  plan("no planner", "", pose(90, 10));
  plan("outside", "GridBased", pose(300, 10));
  plan("occupied", "Exact", pose(50, 20));
  plan("nearby", "GridBased", pose(50, 20));
  PoseStamped elsewhere = pose(90, 10);
  elsewhere.header.frame_id = "nowhere";
  plan("other frame", "GridBased", elsewhere);

  ThroughPoses::Goal through;
  through.planner_id = "GridBased";
  tell("through none", run<ThroughPoses>("compute_path_through_poses", through));
  through.goals = {pose(20, 60), pose(40, 60)};
  tell("through two", run<ThroughPoses>("compute_path_through_poses", through));

  const auto straight = plan("straight", "GridBased", pose(40, 10));
  say("valid %d, empty %d", valid(straight), valid(nav_msgs::msg::Path()));
  say("costs free %.0f, wall %.0f, stripe %.0f, outside %.0f", cost(world(30), world(30)), cost(world(50), world(30)), cost(world(95), world(95)), cost(9, 9));

  block = 1.0;
  say("block %d", spin_until([] { return cost(world(10) + 1.0, world(10)) == 254; }));
  say("valid with it %d", valid(straight));
  block = 0;
  say("cleared %d", spin_until([] { return cost(world(10) + 1.0, world(10)) == 0; }));
  sees_box = true;
  say("box %d", spin_until([] { return cost(world(10), world(10) + 1.0) == 254; }));
  say("voxels %d", spin_until([&] { return voxels > 0; }));
  sees_box = false;
  say("box gone %d", spin_until([] { return cost(world(10), world(10) + 1.0) == 0; }));

  say("inflate %d", set("inflation_layer.enabled", rclcpp::ParameterValue(true)));
  spin_until([] { return cost(world(50) - 0.5, world(30)) > 0; });
  say("inflated %.0f %.0f %.0f %.0f %.0f", cost(world(50) - 0.2, world(30)), cost(world(50) - 0.25, world(30)), cost(world(50) - 0.3, world(30)),
      cost(world(50) - 0.5, world(30)), cost(world(50) - 0.7, world(30)));
  const auto wide = plan("inflated path", "GridBased", pose(90, 10));
  double nearest = 10;
  for (const auto& one : wide.poses) nearest = std::min(nearest, std::hypot(one.pose.position.x - world(50), one.pose.position.y - world(69)));
  say("keeps away %d", nearest > 0.3);
  say("same costs %d", spin_until([&] { return costs.getCostmap()->getCost(45, 30) == cost(world(45), world(30)); }, 10s));
  say("refused width %d", set("width", rclcpp::ParameterValue(-1)));

  block = 1.0;
  spin_until([] { return cost(world(10) + 1.0, world(10)) == 254; });
  block = -1;
  const int seen = looks;
  spin_until([&] { return looks > seen + 10; });
  say("stays %d", cost(world(10) + 1.0, world(10)) == 254);
  auto distance = std::make_shared<nav2_msgs::srv::ClearCostmapAroundRobot::Request>();
  distance->reset_distance = 4.0F;
  call<nav2_msgs::srv::ClearCostmapAroundRobot>("global_costmap/clear_around_global_costmap", distance);
  say("around cleared %d", spin_until([] { return cost(world(10) + 1.0, world(10)) != 254; }, 10s));
  call<nav2_msgs::srv::ClearEntireCostmap>("global_costmap/clear_entirely_global_costmap");
  say("wall again %d", spin_until([] { return cost(world(50), world(30)) == 254; }, 10s));
  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

const xml = `<class_libraries>
  <library path="house_plugins">
    <class type="house_planner::Line" base_class_type="nav2_core::GlobalPlanner"><description>straight</description></class>
    <class type="house_planner::OldLine" base_class_type="nav2_core::GlobalPlanner"><description>straight</description></class>
  </library>
</class_libraries>
`;
const layerXml = `<library path="house_plugins">
  <class type="house_planner::StripeLayer" base_class_type="nav2_costmap_2d::Layer"><description>a stripe</description></class>
</library>
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['nav2_core', 'nav2_costmap_2d', 'nav2_msgs', 'nav2_util', 'nav_msgs', 'pluginlib', 'rclcpp', 'rclcpp_action', 'sensor_msgs', 'tf2_ros'];
  workspace.addPackage('house_planner', { driver }, {
    depends: [...libraries, 'nav2_common', 'nav2_planner', 'nav2_map_server', 'nav2_lifecycle_manager'],
    cmake: `${[...libraries, 'nav2_common'].map((name) => `find_package(${name} REQUIRED)`).join('\n')}
nav2_package()
add_library(house_plugins SHARED src/plugins.cpp)
ament_target_dependencies(house_plugins nav2_core nav2_costmap_2d pluginlib)
pluginlib_export_plugin_description_file(nav2_core planners.xml)
pluginlib_export_plugin_description_file(nav2_costmap_2d layers.xml)
ament_target_dependencies(driver ${libraries.join(' ')})
install(TARGETS house_plugins DESTINATION lib)
install(DIRECTORY launch maps params DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/house_planner/${path}`, content);
  file('src/plugins.cpp', plugins);
  file('planners.xml', xml);
  file('layers.xml', layerXml);
  file('launch/navigation_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  file('maps/room.pgm', room());
  file('maps/room.yaml', 'image: room.pgm\nresolution: 0.05\norigin: [-2.5, -2.5, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n');
  workspace.write('workspace.yaml', 'schema: 1\nname: planner\npackages: [src/*]\nlaunch: src/house_planner/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared')) {
  test(`${link}: the planner server plans, and its costmap has what is seen`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '120s', '--until', 'driver is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const inflated = /inflated path: code 4 error 0 poses \d+ length ([\d.]+)/;
    const lines = said(output, 'driver');
    assert.deepEqual(lines.filter((line) => !inflated.test(line)), [
      'costmap 100x100 at -2.50',
      // The paths of upstream's NavFn, 225 and 283 poses, and the way from the last cell's corner to the goal.
      'dijkstra: code 4 error 0 poses 284 length 7.262',
      'to 2.025 -1.975 turned 1',
      'astar: code 4 error 0 poses 289 length 7.403',
      'line: code 4 error 0 poses 2 length 4.000',
      'old line: code 4 error 0 poses 2 length 4.000',
      'behind: code 6 error 200 poses 0 length 0.000',
      'unknown planner: code 6 error 201 poses 0 length 0.000',
      'no planner: code 6 error 201 poses 0 length 0.000',
      'outside: code 6 error 204 poses 0 length 0.000',
      'occupied: code 6 error 206 poses 0 length 0.000',
      'nearby: code 4 error 0 poses 82 length 2.087',
      'other frame: code 6 error 202 poses 0 length 0.000',
      'through none: code 6 error 309 poses 0 length 0.000',
      'through two: code 4 error 0 poses 140 length 3.625',
      'straight: code 4 error 0 poses 59 length 1.535',
      'valid 1, empty 0',
      'costs free 0, wall 254, stripe 100, outside -1',
      'block 1',
      'valid with it 0',
      'cleared 1',
      'box 1',
      'voxels 1',
      'box gone 1',
      'inflate 1',
      // 253 within 0.22 m; beyond it 252 exp(-3 (d - 0.2158)), for the inscribed radius of 16 corners.
      'inflated 253 227 195 107 58',
      'keeps away 1',
      'same costs 1',
      'refused width 0',
      'stays 1',
      'around cleared 1',
      'wall again 1',
      'driver is over',
    ]);
    const length = Number(inflated.exec(lines.join('\n'))?.[1]);
    assert.ok(length > 7.5 && length < 10, `the path around the costs has ${String(length)} m`);
    assert.ok(said(output, 'global_costmap.global_costmap').some((line) => line.startsWith('A cloud on /points is ignored')), output);
    assert.ok(said(output, 'planner_server').includes('Line plugin failed to plan from (-1.97, -1.97) to (-1.97, 2.03): "a goal behind the zero"'), output);
  });
}
