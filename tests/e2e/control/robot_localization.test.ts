// robot_localization as a robot's bringup package starts it: an EKF for odom, an EKF and a UKF for map, navsat_transform_node, and an EKF
// with lagged data on simulated time. A scripted robot drives a straight line with biased odometry. Headless.

// Compatibility, works: robot_localization: `ekf_node`, `ukf_node` and `navsat_transform_node` with their parameters, topics, services,
// frames and diagnostics: `odomN`, `poseN`, `twistN`, `imuN` (differential, relative, rejection thresholds), two_d_mode, control,
// smooth_lagged_data; `set_pose`, `toggle`, `enable`, `reset`, `datum`, `toLL`, `fromLL`, `setUTMZone`

// Compatibility, differs: robot_localization -> a UKF corrects by the covariance after the process noise (upstream by points from before it),
// and follows the control; gravity is removed in the frame of the IMU; `reset_on_time_jump` resets; `debug` writes no file; there is no
// `robot_localization_listener_node`, and no library to link

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory('rover'), 'config', 'localization.yaml')

    def node(executable, name, output):
        return Node(package='robot_localization', executable=executable, name=name, output='screen', parameters=[config],
                    remappings=[('odometry/filtered', output), ('imu', 'imu/data')])

    lab = Node(package='robot_localization', executable='ekf_node', name='lab', namespace='lab', output='screen', parameters=[config])
    return LaunchDescription([
        Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--yaw', '1.5707963267949', '--frame-id', 'base_link',
                                                                                    '--child-frame-id', 'imu_link']),
        Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--x', '0.3', '--z', '0.5', '--frame-id', 'base_link',
                                                                                    '--child-frame-id', 'gps']),
        node('ekf_node', 'ekf_filter_node_odom', 'odometry/local'),
        node('ekf_node', 'ekf_filter_node_map', 'odometry/global'),
        node('ukf_node', 'ukf_filter_node', 'odometry/ukf'),
        node('navsat_transform_node', 'navsat_transform', 'odometry/global'),
        lab,
        Node(package='rover', executable='driver', output='screen'),
    ])
`;

const flags = (...members: readonly string[]): string => {
  const names = ['x', 'y', 'z', 'roll', 'pitch', 'yaw', 'vx', 'vy', 'vz', 'vroll', 'vpitch', 'vyaw', 'ax', 'ay', 'az'];
  return `[${names.map((name) => String(members.includes(name))).join(', ')}]`;
};

/** Wheels that slip in turns, and a good IMU. */
const wheelsAndImu = `
    frequency: 30.0
    two_d_mode: true
    odom0: wheel/odometry
    odom0_config: ${flags('vx', 'vy')}
    imu0: imu/data
    imu0_config: ${flags('yaw', 'vyaw')}`;
const withGps = `${wheelsAndImu}
    world_frame: map
    odom1: odometry/gps
    odom1_config: ${flags('x', 'y')}`;

const config = `
ekf_filter_node_odom:
  ros__parameters:${wheelsAndImu}
    print_diagnostics: true
    publish_acceleration: true
    transform_time_offset: 0.05
ekf_filter_node_map:
  ros__parameters:${withGps}
ukf_filter_node:
  ros__parameters:${withGps}
    publish_tf: false
navsat_transform:
  ros__parameters:
    frequency: 30.0
    broadcast_cartesian_transform: true
/lab/lab:
  ros__parameters:
    use_sim_time: true
    frequency: 20.0
    disabled_at_startup: true
    print_diagnostics: true
    publish_tf: false
    smooth_lagged_data: true
    history_length: 2.0
    permit_corrected_publication: true
    reset_on_time_jump: true
    pose0: pose
    pose0_config: ${flags('x', 'y', 'yaw')}
    pose0_relative: true
    pose0_rejection_threshold: 4.0
    pose1: pose
    pose1_rejection_threshold: 5.0
    pose1_config: ${flags('x', 'y')}
    pose1_differential: true
    twist0: twist
    twist0_config: ${flags('vx')}
    use_control: true
    control_timeout: 0.5
    control_config: [false, false, false, false, false, true]
    acceleration_limits: [1.0, 0.0, 0.0, 0.0, 0.0, 2.0]
    acceleration_gains: [1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    process_noise_covariance: [0.05, 0.05, 0.06, 0.03, 0.03, 0.06, 0.025, 0.025, 0.04, 0.01, 0.01, 0.02, 0.01, 0.01, 0.015]
`;

const robot = `
// A robot that drives 15 m to the east; its odometry turns by 0.05 rad/s more than it does.
#pragma once

#include <cmath>
#include <random>

#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/nav_sat_fix.hpp"

constexpr double kLatitude = 55.9;
constexpr double kLongitude = -0.5;
constexpr double kSpeed = 0.5;
constexpr double kPeriod = 0.02;

struct Robot {
  rclcpp::Node::SharedPtr node;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry = node->create_publisher<nav_msgs::msg::Odometry>("wheel/odometry", 10);
  rclcpp::Publisher<sensor_msgs::msg::Imu>::SharedPtr imu = node->create_publisher<sensor_msgs::msg::Imu>("imu/data", 10);
  rclcpp::Publisher<sensor_msgs::msg::NavSatFix>::SharedPtr fix = node->create_publisher<sensor_msgs::msg::NavSatFix>("gps/fix", 10);
  std::mt19937 random{5};
  std::normal_distribution<double> noise{};
  int step = 0;
  double east = 0, raw_x = 0, raw_y = 0, raw_yaw = 0;

  bool has_listeners() const {
    return odometry->get_subscription_count() >= 3 && imu->get_subscription_count() >= 4 && fix->get_subscription_count() >= 1;
  }

  void drive() {
    const rclcpp::Time now = node->now();
    if (step > 0) east += kSpeed * kPeriod;
    publish_odometry(now);
    publish_imu(now);
    if (step % 10 == 0) publish_fix(now);
    ++step;
  }

  void publish_odometry(const rclcpp::Time& now) {
    nav_msgs::msg::Odometry message;
    message.header.stamp = now;
    message.header.frame_id = "odom";
    message.child_frame_id = "base_link";
    auto& twist = message.twist.twist;
    twist.linear.x = kSpeed + 0.05 * noise(random);
    twist.angular.z = 0.05 + 0.1 * noise(random);
    message.twist.covariance[0] = message.twist.covariance[7] = 0.0025;
    message.twist.covariance[35] = 0.01;
    odometry->publish(message);
    raw_x += twist.linear.x * kPeriod * std::cos(raw_yaw);
    raw_y += twist.linear.x * kPeriod * std::sin(raw_yaw);
    raw_yaw += twist.angular.z * kPeriod;
  }

  /// It is mounted a quarter turn to the left.
  void publish_imu(const rclcpp::Time& now) {
    sensor_msgs::msg::Imu message;
    message.header.stamp = now;
    message.header.frame_id = "imu_link";
    const double yaw = M_PI / 2 + 0.02 * noise(random);
    message.orientation.z = std::sin(yaw / 2);
    message.orientation.w = std::cos(yaw / 2);
    message.angular_velocity.z = 0.02 * noise(random);
    for (const int i : {0, 4, 8}) message.orientation_covariance[i] = message.angular_velocity_covariance[i] = 0.0004;
    message.linear_acceleration_covariance[0] = -1.0;
    imu->publish(message);
  }

  /// By the radii of the globe at that latitude.
  void publish_fix(const rclcpp::Time& now) {
    sensor_msgs::msg::NavSatFix message;
    message.header.stamp = now;
    message.header.frame_id = "gps";
    const double sine = std::sin(kLatitude * M_PI / 180);
    const double radius = 6378137.0 / std::sqrt(1 - 0.00669437999014 * sine * sine) * std::cos(kLatitude * M_PI / 180);
    message.latitude = kLatitude;
    message.longitude = kLongitude + (east + 0.3) / radius * 180 / M_PI;
    message.altitude = 40.0;
    for (const int i : {0, 4, 8}) message.position_covariance[i] = 0.01;
    message.position_covariance_type = message.COVARIANCE_TYPE_KNOWN;
    fix->publish(message);
  }
};
`;

const driver = `
#include <functional>
#include <map>
#include <string>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "geometry_msgs/msg/accel_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/twist_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "robot.hpp"
#include "robot_localization/srv/from_ll_array.hpp"
#include "robot_localization/srv/from_ll.hpp"
#include "robot_localization/srv/set_datum.hpp"
#include "robot_localization/srv/set_pose.hpp"
#include "robot_localization/srv/set_utm_zone.hpp"
#include "robot_localization/srv/to_ll.hpp"
#include "robot_localization/srv/toggle_filter_processing.hpp"
#include "rosgraph_msgs/msg/clock.hpp"
#include "std_srvs/srv/empty.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"

using namespace std::chrono_literals;
using namespace robot_localization::srv;
using nav_msgs::msg::Odometry;

rclcpp::Node::SharedPtr node;
std::map<std::string, Odometry> newest;
std::map<std::string, int> counts;
std::map<std::string, std::string> diagnostics;

template <typename... T>
void say(const char* format, T... values) { RCLCPP_INFO(node->get_logger(), format, values...); }

void spin_until(const char* what, const std::function<bool()>& is_done) {
  const auto end = node->now() + rclcpp::Duration(20s);
  while (!is_done()) {
    if (node->now() > end) { say("no end of: %s", what); std::exit(1); }
    rclcpp::spin_some(node);
    rclcpp::sleep_for(5ms);
  }
}

void spin_for(std::chrono::nanoseconds time) {
  const auto end = node->now() + rclcpp::Duration(time);
  while (node->now() < end) { rclcpp::spin_some(node); rclcpp::sleep_for(5ms); }
}

template <typename Service>
typename Service::Response call(const std::string& name, const std::function<void(typename Service::Request&)>& fill = {}) {
  auto client = node->create_client<Service>(name);
  client->wait_for_service();
  auto request = std::make_shared<typename Service::Request>();
  if (fill) fill(*request);
  auto future = client->async_send_request(request);
  rclcpp::spin_until_future_complete(node, future);
  return *future.get();
}

rclcpp::Subscription<Odometry>::SharedPtr listen(const std::string& topic) {
  return node->create_subscription<Odometry>(topic, 10, [topic](const Odometry& message) { newest[topic] = message; ++counts[topic]; });
}

void say_place(const char* what, const std::string& topic) {
  const auto& pose = newest[topic].pose.pose;
  say("%s %.4f %.4f %.4f", what, pose.position.x, pose.position.y, tf2::getYaw(pose.orientation));
}

void say_transform(tf2_ros::Buffer& buffer, const char* parent, const char* child) {
  const auto found = buffer.lookupTransform(parent, child, tf2::TimePointZero);
  say("%s to %s %.3f %.3f %.4f", parent, child, found.transform.translation.x, found.transform.translation.y, tf2::getYaw(found.transform.rotation));
}

void drive(Robot& robot, int steps) {
  for (int i = 0; i < steps; ++i) { robot.drive(); spin_for(20ms); }
}

void services(Robot& robot) {
  call<SetPose>("/set_pose", [](SetPose::Request& request) {
    request.pose.header.frame_id = "odom";
    request.pose.header.stamp = node->now();
    request.pose.pose.pose.position.x = 5.0;
    request.pose.pose.pose.position.y = 7.0;
    request.pose.pose.pose.orientation.w = 1.0;
  });
  drive(robot, 20);
  say_place("set_pose", "odometry/local");
  const auto toggle = [](bool on) { return int(call<ToggleFilterProcessing>("/toggle", [on](auto& request) { request.on = on; }).status); };
  const int first = toggle(false), second = toggle(false);
  spin_for(100ms);
  const double before = newest["odometry/local"].pose.pose.position.x;
  drive(robot, 25);
  const double after = newest["odometry/local"].pose.pose.position.x;
  const int third = toggle(true);
  say("toggled %d %d %d moved %.4f", first, second, third, after - before);
  call<std_srvs::srv::Empty>("/reset");
  drive(robot, 25);
  say_place("reset", "odometry/local");
}

void places() {
  const auto ahead = call<FromLL>("fromLL", [](auto& request) { request.ll_point.latitude = kLatitude; request.ll_point.longitude = kLongitude; request.ll_point.altitude = 40.0; });
  const auto& origin = ahead.map_point;
  say("fromLL %.3f %.3f %.3f", origin.x, origin.y, origin.z);
  const auto both = call<FromLLArray>("fromLLArray", [](auto& request) { request.ll_points.resize(2); for (auto& one : request.ll_points) { one.latitude = kLatitude; one.longitude = kLongitude; } request.ll_points[1].latitude += 0.0001; });
  say("fromLLArray %zu %.2f", both.map_points.size(), both.map_points[1].y - both.map_points[0].y);
  const auto back = call<ToLL>("toLL", [&origin](auto& request) { request.map_point = origin; });
  say("toLL %.7f %.7f %.3f", back.ll_point.latitude, back.ll_point.longitude, back.ll_point.altitude);
  const auto off = call<ToLL>("toLL", [](auto& request) { request.map_point.x = 10.0; request.map_point.y = 5.0; });
  say("off toLL %.7f %.7f", off.ll_point.latitude, off.ll_point.longitude);
}

/// A datum of the user, south of where the robot began, and a zone next to its own.
void datum(Robot& robot) {
  call<SetDatum>("datum", [](auto& request) { request.geo_pose.position.latitude = kLatitude - 0.0001; request.geo_pose.position.longitude = kLongitude; request.geo_pose.orientation.w = 1.0; });
  drive(robot, 30);
  const auto moved = call<FromLL>("fromLL", [](auto& request) { request.ll_point.latitude = kLatitude; request.ll_point.longitude = kLongitude; });
  say("datum %.2f %.2f", moved.map_point.x, moved.map_point.y);
  call<SetUTMZone>("setUTMZone", [](auto& request) { request.utm_zone = "nonsense"; });
  call<SetUTMZone>("setUTMZone", [](auto& request) { request.utm_zone = "31U"; });
  drive(robot, 30);
  const auto again = call<FromLL>("fromLL", [](auto& request) { request.ll_point.latitude = kLatitude; request.ll_point.longitude = kLongitude; });
  say("zone %.1f", again.map_point.y);
}

/// Time that goes back, late poses, outliers, and a control.
struct Lab {
  rclcpp::Publisher<rosgraph_msgs::msg::Clock>::SharedPtr clock = node->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 10);
  rclcpp::Publisher<geometry_msgs::msg::PoseWithCovarianceStamped>::SharedPtr pose = node->create_publisher<geometry_msgs::msg::PoseWithCovarianceStamped>("/lab/pose", 10);
  rclcpp::Publisher<geometry_msgs::msg::TwistWithCovarianceStamped>::SharedPtr twist = node->create_publisher<geometry_msgs::msg::TwistWithCovarianceStamped>("/lab/twist", 10);
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr command = node->create_publisher<geometry_msgs::msg::Twist>("/lab/cmd_vel", 10);
  double time = 100.0;

  void tick() {
    time += 0.025;
    rosgraph_msgs::msg::Clock message;
    message.clock = rclcpp::Time(int64_t(time * 1e9));
    clock->publish(message);
    spin_for(10ms);
  }
  void send_pose(double stamp, double x, const char* frame = "odom") {
    geometry_msgs::msg::PoseWithCovarianceStamped message;
    message.header.stamp = rclcpp::Time(int64_t(stamp * 1e9));
    message.header.frame_id = frame;
    message.pose.pose.position.x = 50.0 + x;
    message.pose.pose.orientation.w = 1.0;
    for (const int i : {0, 7, 35}) message.pose.covariance[i] = 0.01;
    pose->publish(message);
  }
  void send_speed(double stamp, double speed) {
    geometry_msgs::msg::TwistWithCovarianceStamped message;
    message.header.stamp = rclcpp::Time(int64_t(stamp * 1e9));
    message.header.frame_id = "base_link";
    message.twist.twist.linear.x = speed;
    message.twist.covariance[0] = 0.01;
    twist->publish(message);
  }
  void run() {
    spin_until("a filter in the lab", [this] { return pose->get_subscription_count() == 2 && twist->get_subscription_count() == 1 && command->get_subscription_count() == 1; });
    for (int i = 0; i < 10; ++i) tick();
    say("disabled %d", counts["/lab/odometry/filtered"]);
    call<std_srvs::srv::Empty>("/lab/enable");
    const double begin = time;
    for (int i = 0; i < 80; ++i) {
      send_speed(time, 1.0);
      // The camera needs half a second; one picture shows another robot.
      if (i >= 20) send_pose(time - 0.5, i == 60 ? 1000.0 : time - 0.5 - begin);
      tick();
    }
    // The first pose is zero: it was seen when the robot was already there.
    say("lagged %.3f", newest["/lab/odometry/filtered"].pose.pose.position.x - (time - begin));
    geometry_msgs::msg::Twist turn;
    turn.angular.z = 0.5;
    for (int i = 0; i < 80; ++i) { send_speed(time, 0.0); command->publish(turn); tick(); }
    say("controlled %.2f", newest["/lab/odometry/filtered"].twist.twist.angular.z);
    time = 50.0;
    for (int i = 0; i < 10; ++i) tick();
    counts.erase("/lab/odometry/filtered");
    for (int i = 0; i < 20; ++i) { send_speed(time, 0.0); tick(); }
    say("after a jump %.3f %d", newest["/lab/odometry/filtered"].pose.pose.position.x, int(counts["/lab/odometry/filtered"] > 5));
  }
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = rclcpp::Node::make_shared("driver");
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions;
  for (const char* topic : {"odometry/local", "odometry/global", "odometry/ukf", "odometry/gps", "/lab/odometry/filtered"}) subscriptions.push_back(listen(topic));
  subscriptions.push_back(node->create_subscription<geometry_msgs::msg::AccelWithCovarianceStamped>("accel/filtered", 10, [](const geometry_msgs::msg::AccelWithCovarianceStamped&) { ++counts["accel"]; }));
  sensor_msgs::msg::NavSatFix place;
  subscriptions.push_back(node->create_subscription<sensor_msgs::msg::NavSatFix>("gps/filtered", 10, [&place](const sensor_msgs::msg::NavSatFix& message) { place = message; }));
  subscriptions.push_back(node->create_subscription<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics", 10, [](const diagnostic_msgs::msg::DiagnosticArray& message) {
    for (const auto& status : message.status) {
      diagnostics[status.name] = status.message;
      for (const auto& value : status.values) diagnostics[status.name + " " + value.key] = value.value;
    }
  }));
  tf2_ros::Buffer buffer(node->get_clock());
  tf2_ros::TransformListener listener(buffer, node);
  Robot robot{node};
  spin_until("all filters", [&robot] { return robot.has_listeners(); });
  spin_until("the frames of sensors", [&buffer] { return buffer.canTransform("base_link", "imu_link", tf2::TimePointZero) && buffer.canTransform("base_link", "gps", tf2::TimePointZero); });
  spin_for(100ms);
  drive(robot, 1500);

  say("truth %.4f raw %.4f %.4f", robot.east, robot.raw_x, robot.raw_y);
  say_place("local", "odometry/local");
  say_place("global", "odometry/global");
  say_place("ukf", "odometry/ukf");
  say_place("gps", "odometry/gps");
  say("back to the globe %.7f %.7f", place.latitude, place.longitude);
  say("rates %d %d", counts["odometry/local"], counts["accel"]);
  say("frames %s %s %s", newest["odometry/local"].header.frame_id.c_str(), newest["odometry/local"].child_frame_id.c_str(), newest["odometry/global"].header.frame_id.c_str());
  say_transform(buffer, "odom", "base_link");
  say_transform(buffer, "map", "odom");
  say_transform(buffer, "map", "utm");
  places();
  services(robot);
  datum(robot);
  Lab().run();
  spin_for(1500ms);
  for (const auto& [key, text] : diagnostics) say("diagnostics %s = %s", key.c_str(), text.c_str());
  say("driver is over");
  rclcpp::shutdown();
}
`;

const workspace = new PackWorkspace('shared');
before(async () => {
  const depends = ['diagnostic_msgs', 'geometry_msgs', 'nav_msgs', 'rclcpp', 'robot_localization', 'rosgraph_msgs', 'sensor_msgs', 'std_srvs', 'tf2',
    'tf2_geometry_msgs', 'tf2_ros'];
  workspace.addPackage('rover', { driver }, {
    depends,
    cmake: `${depends.map((one) => `find_package(${one} REQUIRED)`).join('\n')}
target_compile_features(driver PUBLIC cxx_std_17)
ament_target_dependencies(driver ${depends.join(' ')})
install(DIRECTORY launch config DESTINATION share/\${PROJECT_NAME})`,
  });
  workspace.write('src/rover/src/robot.hpp', robot);
  workspace.write('src/rover/config/localization.yaml', config);
  workspace.write('src/rover/launch/localization.launch.py', launchFile);
  workspace.write('workspace.yaml', 'schema: 1\nname: rover\npackages: [src/*]\nlaunch: src/rover/launch/localization.launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
});
after(() => workspace.close());

/** The numbers that the driver prints after a text. */
function numbers(output: string, what: string): number[] {
  const text = `[driver]: ${what} `;
  const line = output.split('\n').find((one) => one.includes(text));
  assert.ok(line, `no line has: ${text}\n${output}`);
  return (line.slice(line.indexOf(text) + text.length).match(/-?\d+(\.\d+)?/g) ?? []).map(Number);
}

function near(actual: readonly number[], expected: readonly number[], tolerance: number, what: string): void {
  assert.equal(actual.length, expected.length, `${what}: ${actual.join(' ')}`);
  for (const [i, value] of expected.entries()) {
    assert.ok(Math.abs((actual[i] ?? NaN) - value) <= tolerance, `${what}: ${actual.join(' ')} is not near ${expected.join(' ')}`);
  }
}

/** Metres of a degree at latitude 55.9 (WGS 84). */
const northDegree = 111_340;
const eastDegree = 62_553;

for (const link of played('shared')) {
  let output = '';
  test(`${link}: filters know where a robot is, whose odometry does not`, { timeout: 400_000 }, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--stepped', '--seed', '7', '--for', '120s', '--until', 'driver is over']);
    output = run.stdout;
    assert.equal(run.code, 0, output + run.stderr);

    const [east = NaN, rawX = NaN, rawY = NaN] = numbers(output, 'truth');
    const rawError = Math.hypot(rawX - east, rawY);
    assert.ok(rawError > 8, `odometry by itself is wrong by ${String(rawError)}`);
    for (const what of ['local', 'global', 'ukf']) {
      const [x = NaN, y = NaN, yaw = NaN] = numbers(output, what);
      const error = Math.hypot(x - east, y);
      assert.ok(error < 0.3 && error < 0.05 * rawError, `${what}: ${String(error)}\n${output}`);
      near([yaw], [0], 0.03, `${what}, yaw`);
    }
    // The last position is up to 0.2 s old; the first orientation has noise, by which the frames are turned.
    near(numbers(output, 'gps').slice(0, 2), [east, 0], 0.3, 'gps');
    near(numbers(output, 'back to the globe'), [55.9, -0.5 + east / eastDegree], 5e-6, 'gps/filtered');
    near(numbers(output, 'rates'), [900, 900], 20, 'rates');
    assert.match(output, /frames odom base_link map/);
    const [x = NaN, y = NaN] = numbers(output, 'local');
    near(numbers(output, 'odom to base_link').slice(0, 2), [x, y], 0.02, 'odom to base_link');
    const [globalX = NaN, globalY = NaN] = numbers(output, 'global');
    near(numbers(output, 'map to odom').slice(0, 2), [globalX - x, globalY - y], 0.05, 'map to odom');
    // Grid north is 0.036 rad from true north there.
    near(numbers(output, 'map to utm').slice(2), [-0.0361], 0.05, 'map to utm');
    near(numbers(output, 'fromLL'), [0, 0, 0.5], 0.03, 'fromLL');
    near(numbers(output, 'fromLLArray'), [2, 11.13], 0.05, 'fromLLArray');
    near(numbers(output, 'toLL'), [55.9, -0.5, 40], 1e-6, 'toLL');
    near(numbers(output, 'off toLL'), [55.9 + 5 / northDegree, -0.5 + 10 / eastDegree], 6e-6, 'toLL off the origin');
  });
  test(`${link}: services move, stop and reset a filter`, () => {
    // 0.4 s and 0.5 s at 0.5 m/s.
    near(numbers(output, 'set_pose'), [5.2, 7, 0], 0.06, 'set_pose');
    near(numbers(output, 'toggled'), [1, 0, 1, 0], 1e-3, 'toggle');
    near(numbers(output, 'reset'), [0.25, 0, 0], 0.06, 'reset');
    assert.match(output, /ekf_filter_node_odom\]: Toggling filter measurement filtering to Off\./);
    assert.match(output, /ekf_filter_node_odom\]: Received a request to reset filter\./);
    near(numbers(output, 'datum'), [0, 11.13], 0.05, 'datum');
    assert.match(output, /navsat_transform\]: UTM zone set to 31 north/);
    // The robot is where the filter says, whose pose is new since the reset.
    assert.ok(numbers(output, 'zone').every(Number.isFinite));
  });
  test(`${link}: late data, outliers, control and time that goes back`, () => {
    near(numbers(output, 'disabled'), [0], 0, 'disabled');
    assert.match(output, /To enable it call the \/lab\/enable service/);
    assert.match(output, /lab\.lab\]: \[lab:\] Enabling filter\.\.\./);
    near(numbers(output, 'lagged'), [0], 0.1, 'lagged');
    near(numbers(output, 'controlled'), [0.5 * (1 - Math.exp(-2))], 0.05, 'controlled');
    near(numbers(output, 'after a jump'), [0, 1], 0.05, 'after a jump');
    assert.match(output,
      /diagnostics ekf_filter_node_odom: Filter diagnostic updater = The robot_localization state estimation node appears to be functioning properly\./);
    assert.match(output, /diagnostics ekf_filter_node_odom: odometry\/filtered topic status = Desired frequency met/);
    assert.match(output, /diagnostics lab: Filter diagnostic updater PITCH_configuration = Neither PITCH nor its velocity is being measured\./);
  });
}
