// Nav2's collision monitor and collision detector as bringup packages start them: zones that slow, limit and stop a robot, a footprint that
// approaches, sources that are silent, and data that cannot be used. Headless.

// Compatibility, works: Nav2's `collision_monitor` and `collision_detector`: polygons, circles and velocity polygons with all actions, the
// sources scan, pointcloud, range and polygon, footprints, `~/toggle`, their states

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
from launch_ros.actions import Node


def generate_launch_description():
    params = os.path.join(get_package_share_directory('guarded'), 'params', 'nav2_params.yaml')
    lifecycle_nodes = ['collision_monitor', 'collision_detector']
    return LaunchDescription([
        Node(package='nav2_collision_monitor', executable='collision_monitor', output='screen', parameters=[params]),
        Node(package='nav2_collision_monitor', executable='collision_detector', output='screen', parameters=[params]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', output='screen',
             parameters=[{'autostart': True, 'node_names': lifecycle_nodes}]),
        Node(package='guarded', executable='driver', output='screen'),
    ])
`;

const parameters = `
collision_monitor:
  ros__parameters:
    base_frame_id: "base_footprint"
    odom_frame_id: "odom"
    cmd_vel_in_topic: "cmd_vel_smoothed"
    cmd_vel_out_topic: "cmd_vel"
    state_topic: "collision_monitor_state"
    transform_tolerance: 0.3
    source_timeout: 1.0
    base_shift_correction: True
    stop_pub_timeout: 0.5
    polygons: ["Stop", "Slow", "Limit", "Rear", "Approach"]
    Stop:
      type: "polygon"
      points: "[[0.4, 0.3], [0.4, -0.3], [0.0, -0.3], [0.0, 0.3]]"
      action_type: "stop"
      sources_names: ["scan"]
    Slow:
      type: "circle"
      polygon_sub_topic: "slow_radius"
      polygon_subscribe_transient_local: True
      action_type: "slowdown"
      min_points: 4
      slowdown_ratio: 0.3
      sources_names: ["scan"]
    Limit:
      type: "polygon"
      points: "[[1.2, 1.0], [1.2, -1.0], [-1.2, -1.0], [-1.2, 1.0]]"
      action_type: "limit"
      min_points: 4
      linear_limit: 0.4
      angular_limit: 0.5
      visualize: True
      polygon_pub_topic: "polygon_limit"
      sources_names: ["scan"]
    Rear:
      type: "velocity_polygon"
      action_type: "stop"
      min_points: 2
      holonomic: False
      velocity_polygons: ["forward", "backward"]
      forward:
        points: "[[0.1, 0.3], [0.1, -0.3], [-0.1, -0.3], [-0.1, 0.3]]"
        linear_min: 0.0
        linear_max: 2.0
        theta_min: -2.0
        theta_max: 2.0
      backward:
        points: "[[0.1, 0.3], [0.1, -0.3], [-0.7, -0.3], [-0.7, 0.3]]"
        linear_min: -2.0
        linear_max: 0.0
        theta_min: -2.0
        theta_max: 2.0
    Approach:
      type: "polygon"
      action_type: "approach"
      footprint_topic: "footprint"
      time_before_collision: 2.0
      simulation_time_step: 0.1
      min_points: 1
      sources_names: ["cloud", "peers"]
    observation_sources: ["scan", "cloud", "sonar", "peers"]
    scan:
      topic: "scan"
    cloud:
      type: "pointcloud"
      topic: "points"
      min_height: 0.1
      max_height: 0.5
    sonar:
      type: "range"
      topic: "sonar"
      obstacles_angle: 0.05
    peers:
      type: "polygon"
      topic: "peers"
      enabled: False
      sampling_distance: 0.2
collision_detector:
  ros__parameters:
    frequency: 10.0
    odom_frame_id: "odom"
    transform_tolerance: 0.3
    source_timeout: 1.0
    base_shift_correction: False
    polygons: ["Front", "Place"]
    Front:
      type: "polygon"
      points: "[[0.8, 0.3], [0.8, -0.3], [0.0, -0.3], [0.0, 0.3]]"
      action_type: "none"
    Place:
      type: "polygon"
      polygon_sub_topic: "place"
      action_type: "none"
    observation_sources: ["scan"]
    scan:
      type: "scan"
      topic: "scan"
`;

const driver = `
#include <cmath>
#include <functional>

#include "geometry_msgs/msg/polygon_instance_stamped.hpp"
#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav2_msgs/msg/collision_detector_state.hpp"
#include "nav2_msgs/msg/collision_monitor_state.hpp"
#include "nav2_msgs/srv/toggle.hpp"
#include "nav2_util/service_client.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/msg/range.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "std_msgs/msg/float32.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "visualization_msgs/msg/marker_array.hpp"

using namespace std::chrono_literals;
using geometry_msgs::msg::PolygonStamped;
using geometry_msgs::msg::Twist;

${driverStart}

/// Runs in a room: what its sensors see is set from outside.
struct Robot {
  double x = 0, wall = 3, cloud = 4, sonar = 3;  // m
  bool scans_run = true, cloud_is_broken = false, times_are_negative = false;
  float view = 0.22F;
  tf2_ros::TransformBroadcaster broadcaster{node};
  tf2_ros::StaticTransformBroadcaster mounts{node};
  template <typename T>
  static typename rclcpp::Publisher<T>::SharedPtr sensor(const char* topic) { return node->create_publisher<T>(topic, rclcpp::SensorDataQoS()); }
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scans = sensor<sensor_msgs::msg::LaserScan>("scan");
  rclcpp::Publisher<sensor_msgs::msg::PointCloud2>::SharedPtr clouds = sensor<sensor_msgs::msg::PointCloud2>("points");
  rclcpp::Publisher<sensor_msgs::msg::Range>::SharedPtr ranges = sensor<sensor_msgs::msg::Range>("sonar");
  rclcpp::Publisher<PolygonStamped>::SharedPtr footprints = node->create_publisher<PolygonStamped>("footprint", 1);

  geometry_msgs::msg::TransformStamped transform(const char* parent, const char* child, double at, double z, double w) {
    geometry_msgs::msg::TransformStamped result;
    result.header.stamp = node->now();
    result.header.frame_id = parent;
    result.child_frame_id = child;
    result.transform.translation.x = at;
    result.transform.rotation.z = z;
    result.transform.rotation.w = w;
    return result;
  }
  void mount() { mounts.sendTransform({transform("base_footprint", "laser", 0, 0, 1), transform("base_footprint", "sonar", -0.2, 1, 0)}); }

  void look() {
    broadcaster.sendTransform(transform("odom", "base_footprint", x, 0, 1));
    if (scans_run) scan();
    see_points();
    sensor_msgs::msg::Range range;
    range.header.stamp = node->now();
    range.header.frame_id = "sonar";
    range.field_of_view = view;
    range.min_range = 0.05F;
    range.max_range = 5.0F;
    range.range = static_cast<float>(sonar);
    ranges->publish(range);
    footprints->publish(box("base_footprint", -0.2F, 0.2F));
  }
  PolygonStamped box(const char* frame, float from, float to) const {
    PolygonStamped result;
    result.header.stamp = node->now();
    if (times_are_negative) result.header.stamp.sec = -5;
    result.header.frame_id = frame;
    for (const auto& [px, py] : {std::pair{to, 0.2F}, {to, -0.2F}, {from, -0.2F}, {from, 0.2F}}) {
      geometry_msgs::msg::Point32 point;
      point.x = px;
      point.y = py;
      result.polygon.points.push_back(point);
    }
    return result;
  }

 private:
  void scan() {
    sensor_msgs::msg::LaserScan result;
    result.header.stamp = node->now();
    result.header.frame_id = "laser";
    if (times_are_negative) result.header.stamp.sec = -5;
    result.angle_min = -0.1F;
    result.angle_increment = 0.02F;
    result.range_min = 0.1F;
    result.range_max = 5.0F;
    result.ranges.assign(11, static_cast<float>(wall));
    result.ranges[0] = NAN;
    scans->publish(result);
  }
  void see_points() {
    sensor_msgs::msg::PointCloud2 result;
    result.header.stamp = node->now();
    result.header.frame_id = "base_footprint";
    sensor_msgs::PointCloud2Modifier modifier(result);
    modifier.setPointCloud2FieldsByString(1, "xyz");
    modifier.resize(3);
    // One that counts, one on the floor, and none.
    const float points[3][3] = {{static_cast<float>(cloud), 0, 0.2F}, {0.1F, 0, 0.01F}, {NAN, 0, 0}};
    sensor_msgs::PointCloud2Iterator<float> px(result, "x"), py(result, "y"), pz(result, "z");
    for (const auto& point : points) {
      *px = point[0]; *py = point[1]; *pz = point[2];
      ++px; ++py; ++pz;
    }
    if (cloud_is_broken) result.width = 1000;
    clouds->publish(result);
  }
};

template <typename ServiceT>
typename ServiceT::Response call(const std::string& name, typename ServiceT::Request::SharedPtr request = std::make_shared<typename ServiceT::Request>()) {
  nav2_util::ServiceClient<ServiceT> client(name, node);
  return *client.invoke(request, 30s);
}

void set(const std::string& target, const rclcpp::Parameter& parameter) {
  static std::map<std::string, std::shared_ptr<rclcpp::AsyncParametersClient>> clients;
  auto& client = clients[target];
  if (!client) client = std::make_shared<rclcpp::AsyncParametersClient>(node, target);
  client->wait_for_service();
  auto future = client->set_parameters({parameter});
  rclcpp::spin_until_future_complete(node, future);
  if (!future.get().at(0).successful) say("%s of %s is refused", parameter.get_name().c_str(), target.c_str());
}

Twist twist(double x, double turn) {
  Twist result;
  result.linear.x = x;
  result.angular.z = turn;
  return result;
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("driver");
  Robot robot;
  robot.mount();
  const auto timer = node->create_wall_timer(50ms, [&] { robot.look(); });
  const auto radius = node->create_publisher<std_msgs::msg::Float32>("slow_radius", rclcpp::QoS(1).transient_local());
  std_msgs::msg::Float32 length;
  length.data = 0.8F;
  radius->publish(length);

  int outputs = 0;
  Twist out;
  const auto outs = node->create_subscription<Twist>("cmd_vel", 10, [&](const Twist& message) {
    out = message;
    ++outputs;
  });
  std::string actions;
  const auto states = node->create_subscription<nav2_msgs::msg::CollisionMonitorState>("collision_monitor_state", 10, [&](const nav2_msgs::msg::CollisionMonitorState& state) {
    actions += " " + std::to_string(state.action_type) + state.polygon_name;
  });
  size_t vertices = 0;
  const auto shown = node->create_subscription<PolygonStamped>("polygon_limit", 10, [&](const PolygonStamped& message) {
    vertices = message.polygon.points.size();
  });
  std::string points;
  const auto markers = node->create_subscription<visualization_msgs::msg::MarkerArray>(
      "collision_monitor/collision_points_marker", 1, [&](const visualization_msgs::msg::MarkerArray& message) {
        points.clear();
        for (const auto& marker : message.markers) points += " " + marker.ns + " " + std::to_string(marker.points.size());
      });
  std::string detections;
  const auto found = node->create_subscription<nav2_msgs::msg::CollisionDetectorState>("collision_detector_state", 10, [&](const nav2_msgs::msg::CollisionDetectorState& state) {
    detections.clear();
    for (size_t i = 0; i < state.polygons.size(); ++i) detections += state.polygons[i] + (state.detections[i] ? "! " : ". ");
  });
  const auto commands = node->create_publisher<Twist>("cmd_vel_smoothed", 1);
  const auto send = [&](const char* what, double x, double turn) {
    pass(120ms);
    outputs = 0;
    commands->publish(twist(x, turn));
    if (spin_until([&] { return outputs > 0; }, 2s)) say("%s: %.2f %.2f", what, out.linear.x, out.angular.z);
    else say("%s: nothing", what);
  };
  spin_until([] { return call<std_srvs::srv::Trigger>("lifecycle_manager_navigation/is_active").success; });
  pass(300ms);

  send("free", 1.0, 0.2);
  robot.wall = 1.0;
  send("a wall at 1 m", 1.0, 0.2);
  send("slow enough", 0.3, 0.2);
  robot.wall = 0.6;
  send("a wall at 0.6 m", 1.0, 0.2);
  say("detector: %s", detections.c_str());
  robot.wall = 0.3;
  send("a wall at 0.3 m", 1.0, 0.2);
  send("and stays", 1.0, 0.2);
  auto request = std::make_shared<nav2_msgs::srv::Toggle::Request>();
  request->enable = false;
  say("%s", call<nav2_msgs::srv::Toggle>("collision_monitor/toggle", request).message.c_str());
  send("toggled off", 1.0, 0.2);
  request->enable = true;
  say("%s", call<nav2_msgs::srv::Toggle>("collision_monitor/toggle", request).message.c_str());
  set("collision_monitor", rclcpp::Parameter("Stop.enabled", false));
  send("without the zone", 1.0, 0.2);
  set("collision_monitor", rclcpp::Parameter("Stop.enabled", true));
  robot.wall = 3.0;
  send("free again", 1.0, 0.2);
  say("states:%s", actions.c_str());
  say("vertices %zu", vertices);
  say("points:%s", points.c_str());

  robot.sonar = 0.3;
  send("ahead", 0.5, 0.0);
  send("back", -0.5, 0.0);
  send("too fast", -3.0, 0.0);
  robot.sonar = 3.0;
  robot.cloud = 1.45;
  send("approach", 1.0, 0.0);
  send("approach in a curve", 1.0, 0.5);
  send("away", -1.0, 0.0);
  robot.cloud = 0.1;
  send("touched", 1.0, 0.0);
  robot.cloud = 4.0;
  set("collision_monitor", rclcpp::Parameter("peers.enabled", true));
  send("no peers", 1.0, 0.0);
  geometry_msgs::msg::PolygonInstanceStamped peer;
  const auto peers = Robot::sensor<geometry_msgs::msg::PolygonInstanceStamped>("peers");
  const auto meet = [&](float at) {
    const PolygonStamped box = robot.box("odom", at, at + 1);
    peer.header = box.header;
    peer.polygon.polygon = box.polygon;
    peer.polygon.id = 7;
    peers->publish(peer);
  };
  spin_until([&] { return peers->get_subscription_count() == 1; });
  meet(9.0F);
  send("a peer far away", 1.0, 0.0);
  meet(0.75F);
  send("a peer", 1.0, 0.0);
  set("collision_monitor", rclcpp::Parameter("peers.enabled", false));

  // The scan is of the place where the robot was.
  robot.wall = 1.3;
  send("a wall at 1.3 m", 1.0, 0.0);
  robot.scans_run = false;
  robot.x = 0.6;
  send("drove 0.6 m", 1.0, 0.0);
  pass(1200ms);
  send("silent", 1.0, 0.0);
  send("still silent", 1.0, 0.0);
  pass(600ms);
  send("long silent", 1.0, 0.0);
  robot.scans_run = true;
  robot.wall = 3.0;
  send("seen again", 1.0, 0.0);
  robot.cloud_is_broken = true;
  send("a broken cloud", 1.0, 0.0);
  robot.cloud_is_broken = false;
  send("mended", 1.0, 0.0);
  robot.view = 1e9F;
  send("a wide view", 1.0, 0.0);
  robot.view = 0.22F;
  send("a narrow view", 1.0, 0.0);
  set("collision_monitor", rclcpp::Parameter("peers.enabled", true));
  robot.times_are_negative = true;
  meet(9.0F);
  send("negative times", 1.0, 0.0);
  robot.times_are_negative = false;
  meet(9.0F);
  send("times", 1.0, 0.0);
  set("collision_monitor", rclcpp::Parameter("peers.enabled", false));
  send("not a number", std::nan(""), 0.0);
  length.data = -1.0F;
  radius->publish(length);
  send("all well", 1.0, 0.0);

  const auto places = node->create_publisher<PolygonStamped>("place", 1);
  spin_until([&] { return places->get_subscription_count() == 1; });
  robot.wall = 2.5;
  places->publish(robot.box("odom", 3.0F, 3.2F));
  spin_until([&] { return detections == "Front. Place! "; }, 3s);
  say("detector: %s", detections.c_str());
  // The place stays in the world when the robot moves.
  robot.x = 0;
  spin_until([&] { return detections == "Front. Place. "; }, 3s);
  say("detector of a robot that moved: %s", detections.c_str());

  say("%s", "driver is over");
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['geometry_msgs', 'nav2_msgs', 'nav2_util', 'rclcpp', 'sensor_msgs', 'std_msgs', 'std_srvs', 'tf2_ros', 'visualization_msgs'];
  workspace.addPackage('guarded', { driver }, {
    depends: [...libraries, 'nav2_collision_monitor', 'nav2_lifecycle_manager'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(driver ${libraries.join(' ')})
install(DIRECTORY launch params DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/guarded/launch/monitor_launch.py', launchFile);
  workspace.write('src/guarded/params/nav2_params.yaml', parameters);
  workspace.write('workspace.yaml', 'schema: 1\nname: guarded\npackages: [src/*]\nlaunch: src/guarded/launch/monitor_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared', 'port')) {
  test(`${link}: a robot is slowed and stopped by what its sensors see`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, ...(link === 'shared' ? ['--stepped'] : []), '--for', '240s', '--until', 'driver is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    assert.deepEqual(said(output, 'driver'), [
      'free: 1.00 0.20',
      'a wall at 1 m: 0.40 0.08',
      'slow enough: 0.30 0.20',
      'a wall at 0.6 m: 0.30 0.06',
      'detector: Front! Place. ',
      'a wall at 0.3 m: 0.00 0.00',
      'and stays: 0.00 0.00',
      'Collision monitor toggled off successfully',
      'toggled off: 1.00 0.20',
      'Collision monitor toggled on successfully',
      'without the zone: 0.30 0.06',
      'free again: 1.00 0.20',
      'states: 4Limit 0 2Slow 1Stop 2Slow 0',
      'vertices 4',
      'points: collision_points_scan 10 collision_points_cloud 1 collision_points_sonar 6 collision_points_peers 0',
      'ahead: 0.50 0.00',
      'back: 0.00 0.00',
      'too fast: 0.00 0.00',
      'approach: 0.60 0.00',
      'approach in a curve: 1.00 0.50',
      'away: -1.00 0.00',
      'touched: 0.00 0.00',
      'no peers: 0.00 0.00',
      'a peer far away: 1.00 0.00',
      'a peer: 0.25 0.00',
      'a wall at 1.3 m: 1.00 0.00',
      'drove 0.6 m: 0.30 0.00',
      'silent: 0.00 0.00',
      'still silent: 0.00 0.00',
      'long silent: nothing',
      'seen again: 1.00 0.00',
      'a broken cloud: 0.00 0.00',
      'mended: 1.00 0.00',
      'a wide view: 0.00 0.00',
      'a narrow view: 1.00 0.00',
      'negative times: 0.00 0.00',
      'times: 1.00 0.00',
      'not a number: nothing',
      'all well: 1.00 0.00',
      'detector: Front. Place! ',
      'detector of a robot that moved: Front. Place. ',
      'driver is over',
    ], output);
    const monitor = said(output, 'collision_monitor');
    for (
      const line of ['Robot to limit speed due to Limit polygon', 'Robot to slowdown for 30.000000 percents due to Slow polygon',
        'Robot to stop due to Stop polygon', 'Robot to stop due to Rear polygon', 'Robot to approach for 2.000000 seconds away from collision',
        'Robot to continue normal operation', 'Robot to stop due to invalid source. Either due to data not published yet, or to lack of new data'
        + ' received within the sensor timeout, or if impossible to transform data to base frame',
        'Velocity is not covered by any of the velocity polygons. x: -3.000 y: 0.000 tw: 0.000 ', 'Source peers is invalid', 'Source scan is invalid',
        'Source cloud is invalid', '[cloud]: A cloud cannot be used: it has 48 bytes, and width * height * point_step is 16000',
        '[scan]: The data of this source cannot be used: cannot store a negative time point in rclcpp::Time',
        '[peers]: A polygon of a negative time is ignored', '[sonar]: A field of view has to be from 0 to 2 pi, and is 1000000000.000000 rad',
        'Velocity message contains NaNs or Infs! Ignoring as invalid!', '[Slow]: A radius has to be a number above 0, and is -1.000000']
    ) assert.ok(monitor.includes(line), `collision_monitor does not say: ${line}\n${output}`);
    assert.match(output, /\[collision_detector\]: Invalid source scan detected\. Either due to data not published yet/);
  });
}
