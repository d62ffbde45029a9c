// slam_toolbox: a robot whose odometry drifts drives around a block, with a laser that is mounted upside down. The loop is closed, the map has
// its walls, and is saved; sessions are saved and read; a node that nobody manages starts by itself. Headless.

// Compatibility, works: slam_toolbox's `async_slam_toolbox_node` and `sync_slam_toolbox_node` with its launch files: scan matching, loop
// closure, `map`, `pose`, the frame `map`, and the services save_map, dynamic_map, serialize_map, deserialize_map, reset and pause

import assert from 'node:assert/strict';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { driverStart } from '../support/driver.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    params = os.path.join(get_package_share_directory('block'), 'params', 'mapper.yaml')
    slam = os.path.join(get_package_share_directory('slam_toolbox'), 'launch', 'online_async_launch.py')
    return LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource(slam),
                                 launch_arguments={'use_sim_time': 'false', 'slam_params_file': params}.items()),
        Node(package='slam_toolbox', executable='sync_slam_toolbox_node', name='slam', namespace='old', output='screen', parameters=[
            {'map_name': 'old_map', 'transform_publish_period': 0.0, 'use_sim_time': False, 'resolution': -1.0,
             'map_update_interval': 1.0}]),
        # Managed from outside, with a bond.
        Node(package='slam_toolbox', executable='async_slam_toolbox_node', name='slam', namespace='managed', output='screen',
             parameters=[{'use_lifecycle_manager': True, 'map_name': 'map', 'transform_publish_period': 0.0}]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager', namespace='managed', output='screen',
             parameters=[{'autostart': True, 'node_names': ['slam']}]),
        Node(package='block', executable='robot', output='screen'),
    ])
`;

/** A saved session that a parameter names, at a pose that is a little off. */
const sessionFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    session = os.path.join(get_package_share_directory('block'), 'sessions', 'session')
    return LaunchDescription([
        Node(package='slam_toolbox', executable='async_slam_toolbox_node', name='slam_toolbox', output='screen',
             parameters=[{'map_file_name': session, 'map_start_pose': [0.15, -0.1, 0.1]}]),
        Node(package='block', executable='robot', output='screen'),
    ])
`;

/** Nav2 as a whole, which makes its map itself. */
const bringupFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    bringup = os.path.join(get_package_share_directory('nav2_bringup'), 'launch', 'bringup_launch.py')
    return LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource(bringup), launch_arguments={'slam': 'True', 'use_sim_time': 'False'}.items()),
        Node(package='tf2_ros', executable='static_transform_publisher',
             arguments=['--z', '0.01', '--frame-id', 'base_footprint', '--child-frame-id', 'base_link']),
        Node(package='block', executable='robot', output='screen'),
    ])
`;

const parameters = `
slam_toolbox:
  ros__parameters:
    solver_plugin: solver_plugins::CeresSolver
    odom_frame: odom
    map_frame: map
    base_frame: base_footprint
    scan_topic: /scan
    mode: mapping
    map_update_interval: 5.0
    transform_publish_period: 0.02
    resolution: 0.05
    max_laser_range: 3.5
    minimum_time_interval: 0.5
    transform_timeout: 0.2
    minimum_travel_distance: 0.5
    minimum_travel_heading: 0.5
    minimum_distance_penalty: 0.5
`;

const robot = `
#include <cmath>
#include <functional>
#include <random>

#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/lifecycle_service_client.hpp"
#include "nav_msgs/msg/map_meta_data.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/srv/get_map.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "slam_toolbox/srv/clear_queue.hpp"
#include "slam_toolbox/srv/deserialize_pose_graph.hpp"
#include "slam_toolbox/srv/pause.hpp"
#include "slam_toolbox/srv/reset.hpp"
#include "slam_toolbox/srv/save_map.hpp"
#include "slam_toolbox/srv/serialize_pose_graph.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"
#include "visualization_msgs/msg/marker_array.hpp"

using namespace std::chrono_literals;
using nav_msgs::msg::OccupancyGrid;
namespace srv = slam_toolbox::srv;

${driverStart}

struct Point { double x, y; };
struct Pose {
  double x, y, yaw;
  void move(double length, double angle) {
    x += length * std::cos(yaw);
    y += length * std::sin(yaw);
    yaw = std::remainder(yaw + angle, 2 * M_PI);
  }
};

// A corridor of 2 m around a block of 8 m by 4 m, with niches. The robot starts at 1, 1.
const std::vector<std::vector<Point>> outlines = {
    {{0, 0}, {5, 0}, {5, -0.6}, {6, -0.6}, {6, 0}, {12, 0}, {12, 3}, {12.5, 3}, {12.5, 4}, {12, 4}, {12, 8}, {8, 8}, {8, 8.7}, {7, 8.7}, {7, 8},
     {0, 8}, {0, 5}, {-0.5, 5}, {-0.5, 4}, {0, 4}},
    {{2, 2}, {4, 2}, {4, 2.4}, {4.8, 2.4}, {4.8, 2}, {10, 2}, {10, 6}, {6, 6}, {6, 5.5}, {5, 5.5}, {5, 6}, {2, 6}}};

double range_at(const Point& from, double angle) {
  const double dx = std::cos(angle), dy = std::sin(angle);
  double least = INFINITY;
  for (const auto& corners : outlines) {
    for (size_t i = 0; i < corners.size(); ++i) {
      const Point& a = corners[i];
      const Point& b = corners[(i + 1) % corners.size()];
      const double ex = b.x - a.x, ey = b.y - a.y, det = ex * dy - ey * dx;
      if (std::abs(det) < 1e-12) continue;
      const double t = (ex * (a.y - from.y) - ey * (a.x - from.x)) / det;
      const double u = (dx * (a.y - from.y) - dy * (a.x - from.x)) / det;
      if (t > 0 && u >= 0 && u <= 1) least = std::min(least, t);
    }
  }
  return least;
}

double distance_to_wall(double x, double y) {
  double least = INFINITY;
  for (const auto& corners : outlines) {
    for (size_t i = 0; i < corners.size(); ++i) {
      const Point& a = corners[i];
      const Point& b = corners[(i + 1) % corners.size()];
      const double ex = b.x - a.x, ey = b.y - a.y;
      const double t = std::clamp(((x - a.x) * ex + (y - a.y) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
      least = std::min(least, std::hypot(x - a.x - t * ex, y - a.y - t * ey));
    }
  }
  return least;
}

class Robot {
 public:
  Robot() : moves_(node), fixed_(node), buffer_(node->get_clock()), listener_(buffer_, node, false) {
    geometry_msgs::msg::TransformStamped laser;
    laser.header.frame_id = "base_footprint";
    laser.child_frame_id = "base_scan";
    laser.transform.translation.x = -0.03;
    laser.transform.translation.z = 0.2;
    laser.transform.rotation.x = 1;  // upside down
    laser.transform.rotation.w = 0;
    fixed_.sendTransform(laser);
    scans_ = node->create_publisher<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS());
    timer_ = node->create_wall_timer(100ms, [this] { publish(); });
  }

  /// At 1 m/s, with odometry that is 2 % too long and turns by 0.02 rad too much each meter.
  void drive(const Point& goal) {
    const double turn = std::remainder(std::atan2(goal.y - pose.y, goal.x - pose.x) - pose.yaw, 2 * M_PI);
    for (int i = 0; i < 10; ++i) step(0, turn / 10);
    for (double left = std::hypot(goal.x - pose.x, goal.y - pose.y); left > 1e-9; left -= 0.1) step(std::min(left, 0.1), 0);
  }
  void step(double length, double angle) {
    pose.move(length, angle);
    odometry_.move(1.02 * length, 1.02 * angle + 0.02 * length);
    pass(100ms);
  }
  /// How far the pose in the frame of the map is from the true one.
  double error() {
    const auto found = buffer_.lookupTransform("map", "base_footprint", tf2::TimePointZero).transform.translation;
    return std::hypot(found.x + 1 - pose.x, found.y + 1 - pose.y);
  }
  double drift() const { return std::hypot(odometry_.x + 1 - pose.x, odometry_.y + 1 - pose.y); }

  Pose pose{1, 1, 0};

 private:
  void publish() {
    geometry_msgs::msg::TransformStamped transform;
    transform.header.stamp = node->now();
    transform.header.frame_id = "odom";
    transform.child_frame_id = "base_footprint";
    transform.transform.translation.x = odometry_.x;
    transform.transform.translation.y = odometry_.y;
    transform.transform.rotation = nav2_util::geometry_utils::orientationAroundZAxis(odometry_.yaw);
    moves_.sendTransform(transform);
    sensor_msgs::msg::LaserScan scan;
    scan.header.stamp = transform.header.stamp;
    scan.header.frame_id = "base_scan";
    scan.angle_max = 359 * M_PI / 180;
    scan.angle_increment = M_PI / 180;
    scan.range_min = 0.12F;
    scan.range_max = 4.0F;
    const Point from{pose.x - 0.03 * std::cos(pose.yaw), pose.y - 0.03 * std::sin(pose.yaw)};
    for (int i = 0; i < 360; ++i) {
      const double range = range_at(from, pose.yaw - i * M_PI / 180) + noise_(random_);
      scan.ranges.push_back(range < 4.0 ? range : INFINITY);
    }
    scans_->publish(scan);
  }

  Pose odometry_{0, 0, 0};
  std::mt19937 random_{1};
  std::normal_distribution<double> noise_{0.0, 0.01};
  tf2_ros::TransformBroadcaster moves_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scans_;
  rclcpp::TimerBase::SharedPtr timer_;
};

template <typename ServiceT>
typename ServiceT::Response::SharedPtr call(const std::string& name, const std::function<void(typename ServiceT::Request&)>& fill = [](auto&) {}) {
  auto client = node->create_client<ServiceT>(name);
  client->wait_for_service();
  auto request = std::make_shared<typename ServiceT::Request>();
  fill(*request);
  return wait(client->async_send_request(request).future.share());
}

/// Occupied cells, how many of them are within the tolerance of a wall, and how much of the corridor is free.
void tell(const char* what, const OccupancyGrid& map, double tolerance = 0.12) {
  int occupied = 0, right = 0, free = 0, free_in_block = 0;
  for (size_t i = 0; i < map.data.size(); ++i) {
    const double x = map.info.origin.position.x + (i % map.info.width + 0.5) * map.info.resolution + 1;
    const double y = map.info.origin.position.y + (i / map.info.width + 0.5) * map.info.resolution + 1;
    occupied += map.data[i] == 100;
    right += map.data[i] == 100 && distance_to_wall(x, y) < tolerance;
    free += map.data[i] == 0;
    free_in_block += map.data[i] == 0 && x > 2.6 && x < 9.4 && y > 2.6 && y < 5.3;
  }
  // The walls are 1,340 cells long, and the corridor has 26,000.
  say("%s: walls %d right %d free %d in the block %d", what, occupied > 900, right >= 0.9 * occupied, free > 20000 && free < 30000, free_in_block);
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("robot");
  Robot robot;
  OccupancyGrid map;
  nav_msgs::msg::MapMetaData metadata;
  OccupancyGrid old_map;
  int maps = 0, old_poses = 0;
  size_t nodes = 0;
  geometry_msgs::msg::PoseWithCovarianceStamped last;
  const auto latched = rclcpp::QoS(1).transient_local().reliable();
  const auto heard = node->create_subscription<OccupancyGrid>("map", latched, [&](const OccupancyGrid& one) {
    map = one;
    ++maps;
  });
  const auto heard_metadata =
      node->create_subscription<nav_msgs::msg::MapMetaData>("map_metadata", latched, [&](const nav_msgs::msg::MapMetaData& one) { metadata = one; });
  const auto poses = node->create_subscription<geometry_msgs::msg::PoseWithCovarianceStamped>(
      "pose", 10, [&](const geometry_msgs::msg::PoseWithCovarianceStamped& one) { last = one; });
  const auto others = node->create_subscription<geometry_msgs::msg::PoseWithCovarianceStamped>(
      "old/pose", 10, [&](const geometry_msgs::msg::PoseWithCovarianceStamped&) { ++old_poses; });
  const auto old_maps = node->create_subscription<OccupancyGrid>("old/old_map", latched, [&](const OccupancyGrid& one) { old_map = one; });
  const auto graphs = node->create_subscription<visualization_msgs::msg::MarkerArray>(
      "slam_toolbox/graph_visualization", 10, [&](const visualization_msgs::msg::MarkerArray& one) { nodes = one.markers.at(0).points.size(); });
  say("first map %d", spin_until([&] { return maps > 0; }));
  say("of the whole block %d", map.info.width > 200);
  pass(2s);
  say("where the robot is %d", robot.error() < 0.05);
  for (const Point& corner : {Point{11, 1}, Point{11, 7}, Point{1, 7}, Point{1, 1}, Point{6, 1}}) robot.drive(corner);
  pass(6s);
  say("odometry off by more than 1 m %d, the pose by less than 0.15 m %d", robot.drift() > 1, robot.error() < 0.15);
  say("pose in %s, sure %d", last.header.frame_id.c_str(), last.pose.covariance[0] > 0 && last.pose.covariance[0] < 0.1);
  tell("map", map);
  say("%s %.2f m, metadata %d, maps %d, graph %d", map.header.frame_id.c_str(), map.info.resolution, metadata.width == map.info.width,
      maps > 5 && maps < 25, nodes > 60 && nodes < 130);
  tell("dynamic", call<nav_msgs::srv::GetMap>("slam_toolbox/dynamic_map")->map);
  say("old poses %d", old_poses > 40);
  // It began after 3 s, when the frame of odometry had turned a little.
  tell("old map", old_map, 0.6);

  const auto save = [](const char* name) {
    return call<srv::SaveMap>("slam_toolbox/save_map", [name](auto& request) { request.name.data = name; })->result;
  };
  say("saved %d, nowhere %d", save("block"), save("/tmp/no/such/folder/block"));
  const auto serialize = [](const char* name) {
    return call<srv::SerializePoseGraph>("slam_toolbox/serialize_map", [name](auto& request) { request.filename = name; })->result;
  };
  say("session %d, nowhere %d", serialize("session"), serialize("/tmp/no/such/folder/session"));

  say("paused %d", call<srv::Pause>("slam_toolbox/pause_new_measurements")->status);
  const auto before = last.header.stamp;
  robot.drive({7, 1});
  say("nothing is added %d", last.header.stamp == before);
  call<srv::Pause>("slam_toolbox/pause_new_measurements");
  robot.drive({8, 1});
  say("goes on %d, off by less than 0.15 m %d", last.header.stamp != before, robot.error() < 0.15);

  const auto read = [](const char* name, int type, double x) {
    call<srv::DeserializePoseGraph>("slam_toolbox/deserialize_map", [&](auto& request) {
      request.filename = name;
      request.match_type = type;
      request.initial_pose.x = x;
    });
  };
  read("/tmp/nothing", 1, 0);
  read("", 1, 0);
  read("session", 0, 0);
  read("session", 3, 0);
  say("reset %d", call<srv::Reset>("slam_toolbox/reset", [](auto& request) { request.pause_new_measurements = true; })->result);
  pass(500ms);
  say("lost %d", robot.error() > 1);
  call<srv::Pause>("slam_toolbox/pause_new_measurements");
  // The robot is at 8, 1, which is 7, 0 in the map: 0.15 m and some more off.
  read("session", 2, 7.15);
  pass(1s);
  say("found again %d", robot.error() < 0.1);
  robot.drive({11, 1});
  robot.drive({11, 4});
  pass(6s);
  say("and on its way %d", robot.error() < 0.15);
  tell("read and continued", map);
  // A node that is managed from outside: it forgets its map, and begins another.
  nav2_util::LifecycleServiceClient old("old/slam", node);
  using lifecycle_msgs::msg::Transition;
  for (const auto transition :
       {Transition::TRANSITION_DEACTIVATE, Transition::TRANSITION_CLEANUP, Transition::TRANSITION_CONFIGURE, Transition::TRANSITION_ACTIVATE}) {
    old.change_state(transition, 20s);
  }
  old_poses = 0;
  old_map.data.clear();
  say("begins again %d", spin_until([&] { return old_poses > 0 && !old_map.data.empty(); }));
  say("its map is smaller %d", old_map.data.size() < map.data.size() / 2);
  robot.drive({11, 7});
  robot.drive({1, 7});
  robot.drive({1, 1});
  // Where the session began, and in its direction.
  for (int i = 0; i < 10; ++i) robot.step(0, -robot.pose.yaw / (10 - i));
  read("session", 1, 0);
  pass(1s);
  say("at the first scan %d", robot.error() < 0.1);
  say("cleared %d", call<srv::ClearQueue>("old/slam_toolbox/clear_queue")->status);
  say("robot is over");
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
/** The session that the first test saved. */
let session: Buffer;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['geometry_msgs', 'lifecycle_msgs', 'nav2_util', 'nav_msgs', 'rclcpp', 'sensor_msgs', 'slam_toolbox', 'tf2_geometry_msgs', 'tf2_ros',
    'visualization_msgs'];
  workspace.addPackage('block', { robot }, {
    depends: [...libraries, 'nav2_bringup', 'nav2_lifecycle_manager'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(robot ${libraries.join(' ')})
install(DIRECTORY launch params sessions DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/block/launch/slam_launch.py', launchFile);
  workspace.write('src/block/params/mapper.yaml', parameters);
  workspace.write('workspace.yaml', 'schema: 1\nname: slam\npackages: [src/*]\nlaunch: src/block/launch/slam_launch.py\n');
  workspace.write('src/block/launch/bringup_launch.py', bringupFile);
  workspace.write('src/block/launch/session_launch.py', sessionFile);
  workspace.write('src/block/sessions/README', 'Sessions of slam_toolbox.\n');
  workspace.write('bringup.yaml', 'schema: 1\nname: bringup\npackages: [src/*]\nlaunch: src/block/launch/bringup_launch.py\n');
  for (const [manifest, site] of [['workspace.yaml', 'site'], ['bringup.yaml', 'bringup']] as const) {
    const packed = await workspace.run(['pack', manifest, '--output', site]);
    assert.equal(packed.code, 0, packed.stderr);
  }
}, watchdog);
after(() => workspace.close());

test('a robot maps the corridor around a block, and finds itself in a saved session', watchdog, async () => {
  const kept = mkdtempSync(join(tmpdir(), 'ros2wasm-slam-'));
  try {
    const run = await workspace.run(['run', 'site', '--stepped', '--bags', kept, '--for', '300s', '--until', 'robot is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    assert.deepEqual(said(output, 'robot'), [
      'first map 1',
      'of the whole block 0',
      'where the robot is 1',
      'odometry off by more than 1 m 1, the pose by less than 0.15 m 1',
      'pose in map, sure 1',
      'map: walls 1 right 1 free 1 in the block 0',
      'map 0.05 m, metadata 1, maps 1, graph 1',
      'dynamic: walls 1 right 1 free 1 in the block 0',
      'old poses 1',
      'old map: walls 1 right 1 free 1 in the block 0',
      'saved 0, nowhere 255',
      'session 0, nowhere 255',
      'paused 1',
      'nothing is added 1',
      'goes on 1, off by less than 0.15 m 1',
      'reset 0',
      'lost 1',
      'found again 1',
      'and on its way 1',
      'read and continued: walls 1 right 1 free 1 in the block 0',
      'begins again 1',
      'its map is smaller 1',
      'at the first scan 1',
      'cleared 1',
      'robot is over',
    ], output);
    const slam = said(output, 'slam_toolbox');
    for (
      const line of ['Configuring', 'Activating', 'SlamToolbox: Saving map as block.', 'SlamToolbox: Toggled to pause taking new measurements.',
        'SlamToolbox: Toggled to actively taking new measurements.', 'DeserializePoseGraph: Failed to read file: /tmp/nothing (the file cannot be opened).',
        'No map file given!', 'Deserialization called without valid processor type set. Undefined behavior!',
        'Requested a localization deserialization in non-localization mode.', 'SlamToolbox: Toggled to pause taking new measurements after reset.']
    ) assert.ok(slam.includes(line), `slam_toolbox does not say: ${line}\n${output}`);
    assert.ok(said(output, 'managed.manager').includes('Server slam connected with bond.'), output);
    const old = said(output, 'old.slam');
    assert.ok(old.some((line) => line.startsWith('This node was not configured within 3 s, so it configures and activates itself')), output);
    assert.ok(old.includes('maximum laser range setting (25.0 m) exceeds the capabilities of the used Lidar (4.0 m)'), output);
    assert.ok(old.some((line) => line.startsWith("You've set resolution to -1, this isn't allowed so it will be set to 0.05.")), output);
    const files = readdirSync(kept, { recursive: true, encoding: 'utf8' });
    const yaml = files.find((name) => name.endsWith('block.yaml')) ?? '';
    assert.match(readFileSync(join(kept, yaml), 'utf8'), /image: block\.pgm\nmode: trinary\nresolution: 0\.05/);
    assert.ok(files.some((name) => name.endsWith('block.pgm')) && files.some((name) => name.endsWith('session.posegraph')), files.join('\n'));
    session = readFileSync(join(kept, files.find((name) => name.endsWith('session.posegraph')) ?? ''));
  } finally {
    rmSync(kept, { recursive: true });
  }
});

test('bringup_launch.py with slam:=True makes the map that its servers use', watchdog, async () => {
  const run = await workspace.run(['run', 'bringup', '--for', '120s', '--until', 'planner_server.*Activating']);
  const output = run.stdout + run.stderr;
  assert.equal(run.code, 0, output);
  assert.ok(said(output, 'slam_toolbox').includes('Activating'), output);
  assert.ok(said(output, 'lifecycle_manager_slam').includes('Managed nodes are active'), output);
  assert.ok(said(output, 'robot').includes('first map 1'), output);
  assert.ok(said(output, 'global_costmap.global_costmap').some((line) => line.startsWith('StaticLayer: Resizing costmap to')), output);
});

test('a session that a parameter names goes on where the robot is', watchdog, async () => {
  workspace.write('src/block/sessions/session.posegraph', session);
  workspace.write('session.yaml', 'schema: 1\nname: session\npackages: [src/*]\nlaunch: src/block/launch/session_launch.py\n');
  const packed = await workspace.run(['pack', 'session.yaml', '--output', 'session']);
  assert.equal(packed.code, 0, packed.stderr);
  const run = await workspace.run(['run', 'session', '--stepped', '--for', '60s', '--until', 'where the robot is']);
  const output = run.stdout + run.stderr;
  assert.equal(run.code, 0, output);
  assert.deepEqual(said(output, 'robot'), ['first map 1', 'of the whole block 1', 'where the robot is 1'], output);
});
