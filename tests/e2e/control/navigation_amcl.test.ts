// Localization as bringup packages of Nav2 start it: map_server, amcl and a lifecycle manager, with a node that plays a robot in a room:
// it sends odometry and scans, gives initial poses, good and bad, and calls the services. Headless.

// Compatibility, works: Nav2's `amcl`: KLD sampling, the models likelihood_field, likelihood_field_prob and beam, DifferentialMotionModel and
// OmniMotionModel (also as `differential` and `omnidirectional`) and motion models of the workspace, initial poses, global localization,
// no-motion updates, parameters that change; as a program and as a component

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
from launch.actions import DeclareLaunchArgument, SetEnvironmentVariable
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode, ParameterFile
from nav2_common.launch import RewrittenYaml


def generate_launch_description():
    share = get_package_share_directory('room')
    remappings = [('/tf', 'tf'), ('/tf_static', 'tf_static')]
    configured_params = ParameterFile(
        RewrittenYaml(source_file=LaunchConfiguration('params_file'), root_key='', convert_types=True,
                      param_rewrites={'use_sim_time': LaunchConfiguration('use_sim_time')}),
        allow_substs=True)
    return LaunchDescription([
        SetEnvironmentVariable('RCUTILS_LOGGING_BUFFERED_STREAM', '1'),
        DeclareLaunchArgument('map', default_value=os.path.join(share, 'maps', 'room.yaml')),
        DeclareLaunchArgument('params_file', default_value=os.path.join(share, 'params', 'nav2_params.yaml')),
        DeclareLaunchArgument('use_sim_time', default_value='false'),
        Node(package='nav2_map_server', executable='map_server', name='map_server', output='screen', respawn_delay=2.0,
             parameters=[configured_params, {'yaml_filename': LaunchConfiguration('map')}],
             arguments=['--ros-args', '--log-level', 'info'], remappings=remappings),
        Node(package='nav2_amcl', executable='amcl', name='amcl', output='screen', respawn_delay=2.0,
             parameters=[configured_params], arguments=['--ros-args', '--log-level', 'info'], remappings=remappings),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_localization', output='screen',
             arguments=['--ros-args', '--log-level', 'info'],
             parameters=[{'autostart': True}, {'node_names': ['map_server', 'amcl']}]),
        ComposableNodeContainer(
            name='spare_container', namespace='', package='rclcpp_components', executable='component_container', output='screen',
            composable_node_descriptions=[ComposableNode(package='nav2_amcl', plugin='nav2_amcl::AmclNode', name='spare')]),
        Node(package='room', executable='robot', output='screen'),
    ])
`;

/** Those of Nav2's own file, with a robot model of the courses. */
const parameters = `
amcl:
  ros__parameters:
    alpha1: 0.2
    alpha2: 0.2
    alpha3: 0.2
    alpha4: 0.2
    alpha5: 0.2
    base_frame_id: "base_footprint"
    beam_skip_distance: 0.5
    beam_skip_error_threshold: 0.9
    beam_skip_threshold: 0.3
    do_beamskip: false
    global_frame_id: "map"
    lambda_short: 0.1
    laser_likelihood_max_dist: 2.0
    laser_max_range: 100.0
    laser_min_range: -1.0
    laser_model_type: "likelihood_field"
    max_beams: 60
    max_particles: 2000
    min_particles: 500
    odom_frame_id: "odom"
    pf_err: 0.05
    pf_z: 0.99
    recovery_alpha_fast: 0.0
    recovery_alpha_slow: 0.0
    resample_interval: 1
    robot_model_type: "differential"
    save_pose_rate: 0.5
    sigma_hit: 0.2
    tf_broadcast: true
    transform_tolerance: 1.0
    update_min_a: 0.2
    update_min_d: 0.25
    z_hit: 0.5
    z_max: 0.05
    z_rand: 0.5
    z_short: 0.05
    scan_topic: scan
`;

/** A motion model of the workspace, as one that is written for upstream: it trusts odometry, and shakes each particle a little. */
const model = `
#include <cmath>
#include <cstdio>

#include "nav2_amcl/angleutils.hpp"
#include "nav2_amcl/motion_model/motion_model.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace room {

class CarefulModel : public nav2_amcl::MotionModel {
 public:
  void initialize(double alpha1, double, double, double, double alpha5) override {
    alpha1_ = alpha1;
    std::printf("careful model with %.2f and %.2f\\n", alpha1, alpha5);
  }

  void odometryUpdate(pf_t* pf, const pf_vector_t& pose, const pf_vector_t& delta) override {
    pf_sample_set_t* set = pf->sets + pf->current_set;
    const pf_vector_t old_pose = pf_vector_sub(pose, delta);
    const double length = std::sqrt(delta.v[0] * delta.v[0] + delta.v[1] * delta.v[1]);
    const double bearing = nav2_amcl::angleutils::angle_diff(std::atan2(delta.v[1], delta.v[0]), old_pose.v[2]);
    for (int i = 0; i < set->sample_count; i++) {
      pf_sample_t* sample = set->samples + i;
      sample->pose.v[0] += length * std::cos(sample->pose.v[2] + bearing) + pf_ran_gaussian(0.1 * alpha1_);
      sample->pose.v[1] += length * std::sin(sample->pose.v[2] + bearing) + pf_ran_gaussian(0.1 * alpha1_);
      sample->pose.v[2] += delta.v[2];
    }
  }

 private:
  double alpha1_ = 0.0;
};

}  // namespace room

PLUGINLIB_EXPORT_CLASS(room::CarefulModel, nav2_amcl::MotionModel)
`;

const modelDescription = `
<library path="room_models">
  <class type="room::CarefulModel" base_class_type="nav2_amcl::MotionModel">
    <description>Trusts odometry.</description>
  </class>
</library>
`;

const robot = `
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "nav2_msgs/msg/particle_cloud.hpp"
#include "nav2_msgs/srv/load_map.hpp"
#include "nav2_msgs/srv/set_initial_pose.hpp"
#include "nav2_util/lifecycle_service_client.hpp"
#include "nav2_util/service_client.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_srvs/srv/empty.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

using namespace std::chrono_literals;
using geometry_msgs::msg::PoseWithCovarianceStamped;
using sensor_msgs::msg::LaserScan;

${driverStart}

template <typename ServiceT>
typename ServiceT::Response call(const std::string& name, std::shared_ptr<typename ServiceT::Request> request = std::make_shared<typename ServiceT::Request>()) {
  nav2_util::ServiceClient<ServiceT> client(name, node);
  return *client.invoke(request, 20s);
}

struct Pose { double x, y, yaw; };

// The laser is mounted upside down, 0.1 m ahead.
constexpr double kAhead = 0.1;
// More than update_min_d along x or y, whatever the direction.
constexpr double kStep = 0.36;

bool is_free(double x, double y) {
  const bool is_inside = x > 0.05 && y > 0.05 && x < 7.95 && y < 5.95;
  return is_inside && !(x > 2 && x < 3 && y > 4 && y < 5) && !(x > 5.5 && x < 6 && y > 1 && y < 2.5);
}

class Robot {
 public:
  Pose truth{2.0, 2.0, 0.3};
  Pose odometry{0.0, 0.0, 0.0};
  rclcpp::Time stamp;
  PoseWithCovarianceStamped estimate;
  nav2_msgs::msg::ParticleCloud cloud;
  int clouds = 0;

  Robot() : broadcaster_(node), mount_(node), buffer_(node->get_clock()), listener_(buffer_, node, true) {
    scans_ = node->create_publisher<LaserScan>("scan", rclcpp::SensorDataQoS());
    poses_ = node->create_publisher<PoseWithCovarianceStamped>("initialpose", 10);
    estimates_ = node->create_subscription<PoseWithCovarianceStamped>("amcl_pose", rclcpp::QoS(1).transient_local(),
        [this](const PoseWithCovarianceStamped& message) { estimate = message; });
    clouds_ = node->create_subscription<nav2_msgs::msg::ParticleCloud>("particle_cloud", rclcpp::SensorDataQoS(),
        [this](const nav2_msgs::msg::ParticleCloud& message) { cloud = message; ++clouds; });
    geometry_msgs::msg::TransformStamped mount;
    mount.header.frame_id = "base_footprint";
    mount.child_frame_id = "base_scan";
    mount.transform.translation.x = kAhead;
    mount.transform.rotation.x = 1.0;
    mount.transform.rotation.w = 0.0;
    mount_.sendTransform(mount);
  }

  bool is_connected() const { return scans_->get_subscription_count() == 1 && poses_->get_subscription_count() == 1; }

  void drive(double length, double turn) {
    truth.yaw += turn;
    odometry.yaw += 1.02 * turn;
    truth.x += length * std::cos(truth.yaw);
    truth.y += length * std::sin(truth.yaw);
    odometry.x += 1.03 * length * std::cos(odometry.yaw);
    odometry.y += 1.03 * length * std::sin(odometry.yaw);
  }

  void send_odometry() {
    stamp = node->now();
    geometry_msgs::msg::TransformStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = "odom";
    message.child_frame_id = "base_footprint";
    message.transform.translation.x = odometry.x;
    message.transform.translation.y = odometry.y;
    tf2::Quaternion rotation;
    rotation.setRPY(0, 0, odometry.yaw);
    message.transform.rotation = tf2::toMsg(rotation);
    broadcaster_.sendTransform(message);
  }

  LaserScan scan() const {
    LaserScan message;
    message.header.stamp = stamp;
    message.header.frame_id = "base_scan";
    message.angle_min = 0.0F;
    message.angle_increment = static_cast<float>(2 * M_PI / 180);
    message.angle_max = static_cast<float>(2 * M_PI - message.angle_increment);
    message.range_min = 0.12F;
    message.range_max = 5.0F;
    for (int i = 0; i < 180; ++i) message.ranges.push_back(range(-i * 2 * M_PI / 180));
    return message;
  }

  void send(const LaserScan& message) { scans_->publish(message); }

  /// Sends odometry and a scan, and waits for what amcl makes of it.
  bool look() {
    send_odometry();
    send(scan());
    return spin_until([this] { return rclcpp::Time(estimate.header.stamp) == stamp; });
  }

  void give(const PoseWithCovarianceStamped& message) { poses_->publish(message); }

  PoseWithCovarianceStamped pose(double x, double y, double yaw, const std::string& frame = "map", double variance = 0.25) const {
    PoseWithCovarianceStamped message;
    message.header.frame_id = frame;
    message.header.stamp = stamp;
    message.pose.pose.position.x = x;
    message.pose.pose.position.y = y;
    message.pose.pose.orientation.z = std::sin(yaw / 2);
    message.pose.pose.orientation.w = std::cos(yaw / 2);
    message.pose.covariance[0] = message.pose.covariance[7] = variance;
    message.pose.covariance[35] = 0.0685;
    return message;
  }

  void say_errors(const char* name) {
    const auto& found = estimate.pose.pose;
    const double yaw = tf2::getYaw(found.orientation);
    say("%s off by %.3f m, %.3f rad, with %zu particles", name, std::hypot(found.position.x - truth.x, found.position.y - truth.y),
        std::abs(std::remainder(yaw - truth.yaw, 2 * M_PI)), cloud.particles.size());
  }

  void say_transform() {
    spin_until([this] { return buffer_.canTransform("map", "odom", tf2::TimePointZero); });
    const auto ahead = buffer_.lookupTransform("map", "odom", tf2::TimePointZero);
    const double yaw = tf2::getYaw(ahead.transform.rotation);
    const double x = ahead.transform.translation.x + odometry.x * std::cos(yaw) - odometry.y * std::sin(yaw);
    const double y = ahead.transform.translation.y + odometry.x * std::sin(yaw) + odometry.y * std::cos(yaw);
    const auto& found = estimate.pose.pose.position;
    say("transform %.2f s ahead, %.4f m from the pose", (rclcpp::Time(ahead.header.stamp) - stamp).seconds(), std::hypot(x - found.x, y - found.y));
  }

  /// Least and greatest x and y of the particles.
  void say_spread(const char* name) {
    double low[2] = {1e9, 1e9};
    double high[2] = {-1e9, -1e9};
    int outside = 0;
    for (const auto& particle : cloud.particles) {
      const double at[2] = {particle.pose.position.x, particle.pose.position.y};
      for (int i = 0; i < 2; ++i) {
        low[i] = std::min(low[i], at[i]);
        high[i] = std::max(high[i], at[i]);
      }
      if (!is_free(at[0] + 0.025, at[1] + 0.025)) ++outside;
    }
    say("%s spread %.1f x %.1f m, %d not in free cells", name, high[0] - low[0], high[1] - low[1], outside);
  }

 private:
  float range(double bearing) const {
    const double x = truth.x + kAhead * std::cos(truth.yaw);
    const double y = truth.y + kAhead * std::sin(truth.yaw);
    double length = 0.0;
    while (length < 6.0 && is_free(x + length * std::cos(truth.yaw + bearing), y + length * std::sin(truth.yaw + bearing))) length += 0.01;
    return static_cast<float>(length);
  }

  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster mount_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  rclcpp::Publisher<LaserScan>::SharedPtr scans_;
  rclcpp::Publisher<PoseWithCovarianceStamped>::SharedPtr poses_;
  rclcpp::Subscription<PoseWithCovarianceStamped>::SharedPtr estimates_;
  rclcpp::Subscription<nav2_msgs::msg::ParticleCloud>::SharedPtr clouds_;
};

/// Answers come in the order of requests: what was sent before has arrived then.
void wait_for_amcl(rclcpp::SyncParametersClient& amcl) { amcl.get_parameters({"alpha1"}); }

void send_bad_scans(Robot& robot, rclcpp::SyncParametersClient& amcl) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<LaserScan> scans(7, robot.scan());
  scans[0].range_max = 0.0F;
  scans[1].ranges.assign(180, nan);
  scans[2].ranges.assign(180, std::numeric_limits<float>::infinity());
  scans[3].ranges.assign(180, -1.0F);
  scans[4].ranges.assign(180, 1e30F);
  scans[5].ranges.clear();
  scans[6].angle_min = nan;
  for (LaserScan& scan : scans) {
    call<std_srvs::srv::Empty>("request_nomotion_update");
    robot.send_odometry();
    scan.header.stamp = robot.stamp;
    robot.send(scan);
    wait_for_amcl(amcl);
  }
}

void set(rclcpp::SyncParametersClient& amcl, const rclcpp::Parameter& parameter) {
  const auto result = amcl.set_parameters({parameter}).front();
  say("set %s: %d %s", parameter.get_name().c_str(), result.successful, result.reason.c_str());
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("robot");
  Robot robot;
  rclcpp::SyncParametersClient amcl(node, "amcl");
  spin_until([&] { return robot.is_connected(); });
  spin_until([] { return call<std_srvs::srv::Trigger>("lifecycle_manager_localization/is_active").success; });

  robot.send_odometry();
  robot.send(robot.scan());
  rclcpp::sleep_for(2500ms);
  robot.send_odometry();
  robot.send(robot.scan());
  wait_for_amcl(amcl);
  say("before an initial pose: %d clouds, stamp %d", robot.clouds, static_cast<int>(robot.estimate.header.stamp.sec));
  // One by one: the subscription has the depth of SystemDefaultsQoS.
  for (const PoseWithCovarianceStamped& pose : {robot.pose(2.0, 2.0, 0.3, "odom"), robot.pose(2.0, 2.0, 0.3, "map", std::numeric_limits<double>::quiet_NaN()),
           robot.pose(std::numeric_limits<double>::infinity(), 2.0, 0.3), robot.pose(500.0, 2.0, 0.3), robot.pose(2.4, 1.7, 0.38)}) {
    robot.give(pose);
    wait_for_amcl(amcl);
  }
  if (!robot.look()) say("%s", "no pose after the initial one");
  for (int step = 1; step <= 9; ++step) {
    robot.drive(kStep, step == 4 || step == 7 ? 0.35 : 0.0);
    if (!robot.look()) say("no pose after step %d", step);
  }
  robot.say_errors("driven");
  robot.say_transform();

  send_bad_scans(robot, amcl);
  call<std_srvs::srv::Empty>("request_nomotion_update");
  say("standing still: %d", robot.look());
  robot.say_errors("after bad scans");

  for (const char* const model : {"likelihood_field_prob", "beam"}) {
    set(amcl, {"laser_model_type", std::string(model)});
    robot.drive(kStep, 0.0);
    say("%s: %d", model, robot.look());
    robot.say_errors(model);
  }
  for (const char* const model : {"nav2_amcl::OmniMotionModel", "room::CarefulModel"}) {
    set(amcl, {"robot_model_type", std::string(model)});
    robot.drive(kStep, 0.0);
    say("%s: %d", model, robot.look());
    robot.say_errors(model);
  }
  set(amcl, {"robot_model_type", std::string("flying")});
  set(amcl, {"max_particles", 400});
  set(amcl, {"resample_interval", 0});
  set(amcl, {"max_particles", int64_t{1} << 33});
  set(amcl, {"max_particles", 1'000'001});
  set(amcl, {"alpha1", -1.0});
  set(amcl, {"max_particles", 600});
  robot.look();
  say("at most 600 particles: %d", robot.cloud.particles.size() <= 600);

  robot.clouds = 0;
  call<std_srvs::srv::Empty>("reinitialize_global_localization");
  robot.look();
  robot.say_spread("global");
  auto request = std::make_shared<nav2_msgs::srv::SetInitialPose::Request>();
  request->pose = robot.pose(robot.truth.x, robot.truth.y, robot.truth.yaw, "map", 0.01);
  call<nav2_msgs::srv::SetInitialPose>("set_initial_pose", request);
  robot.look();
  robot.say_errors("given by a service");

  auto other = std::make_shared<nav2_msgs::srv::LoadMap::Request>();
  other->map_url = ament_index_cpp::get_package_share_directory("room") + "/maps/corner.yaml";
  say("load %d", call<nav2_msgs::srv::LoadMap>("map_server/load_map", other).result);
  wait_for_amcl(amcl);
  robot.drive(kStep, 0.0);
  say("on another map: %d", robot.look());
  say("the component: %d", nav2_util::LifecycleServiceClient("spare", node).change_state(lifecycle_msgs::msg::Transition::TRANSITION_CONFIGURE, 20s));
  say("%s", "robot is over");
  rclcpp::shutdown();
}
`;

const WIDTH = 160;
const HEIGHT = 120;

/** The room that the robot is in, as pixels: the first row is the upper wall. */
function roomPixels(): Uint8Array {
  const pixels = new Uint8Array(WIDTH * HEIGHT).fill(254);
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      const wall = x === 0 || y === 0 || x === WIDTH - 1 || y === HEIGHT - 1;
      const block = (x >= 40 && x < 60 && y >= 80 && y < 100) || (x >= 110 && x < 120 && y >= 20 && y < 50);
      if (wall || block) pixels[(HEIGHT - 1 - y) * WIDTH + x] = 0;
    }
  }
  return pixels;
}

const mapFile = (image: string): string =>
  `image: ${image}\nmode: trinary\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['ament_index_cpp', 'geometry_msgs', 'lifecycle_msgs', 'nav2_msgs', 'nav2_util', 'rclcpp', 'sensor_msgs', 'std_srvs', 'tf2',
    'tf2_geometry_msgs', 'tf2_ros'];
  workspace.addPackage('room', { robot }, {
    depends: [...libraries, 'nav2_amcl', 'nav2_common', 'nav2_lifecycle_manager', 'nav2_map_server', 'pluginlib', 'rclcpp_components'],
    cmake: `${[...libraries, 'nav2_amcl', 'pluginlib'].map((name) => `find_package(${name} REQUIRED)`).join('\n')}
add_library(room_models SHARED src/models.cpp)
ament_target_dependencies(room_models nav2_amcl pluginlib)
pluginlib_export_plugin_description_file(nav2_amcl models.xml)
install(TARGETS room_models ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
ament_target_dependencies(robot ${libraries.join(' ')})
install(DIRECTORY launch maps params DESTINATION share/\${PROJECT_NAME})
`,
  });
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/room/${path}`, content);
  file('src/models.cpp', model);
  file('models.xml', modelDescription);
  file('launch/localization_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  file('maps/room.pgm', Buffer.concat([Buffer.from(`P5\n${String(WIDTH)} ${String(HEIGHT)}\n255\n`), roomPixels()]));
  file('maps/room.yaml', mapFile('room.pgm'));
  file('maps/corner.pgm', 'P2 3 2 255\n0 254 254\n0 0 254\n');
  file('maps/corner.yaml', mapFile('corner.pgm'));
  workspace.write('workspace.yaml', 'schema: 1\nname: room\npackages: [src/*]\nlaunch: src/room/launch/localization_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

/** How far an estimate is off [m, rad], and how many particles it is of. */
function errors(lines: readonly string[], name: string): { distance: number; angle: number; particles: number; } {
  const found = lines.map((line) => new RegExp(`^${name} off by ([\\d.]+) m, ([\\d.]+) rad, with (\\d+) particles$`).exec(line)).find((each) => each !== null);
  assert.ok(found, `nothing about ${name}\n${lines.join('\n')}`);
  return { distance: Number(found[1]), angle: Number(found[2]), particles: Number(found[3]) };
}

/** An estimate of the default model is within 0.1 rad for nearly all random numbers, and within 0.2 rad for all. */
function isNear(lines: readonly string[], name: string, mostDistance = 0.3, mostAngle = 0.2): void {
  const found = errors(lines, name);
  assert.ok(found.distance < mostDistance && found.angle < mostAngle, `${name}: ${JSON.stringify(found)}`);
  assert.ok(found.particles >= 500 && found.particles <= 2000, `${name}: ${JSON.stringify(found)}`);
}

function count(lines: readonly string[], line: string): number {
  return lines.filter((each) => each === line).length;
}

for (const link of played('port', 'shared')) {
  test(`${link}: a robot is found on a map`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '240s', '--until', 'robot is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const lines = said(output, 'robot');
    assert.deepEqual(lines.filter((line) => !line.includes(' off by ') && !line.includes(' spread ')), [
      'before an initial pose: 0 clouds, stamp 0',
      'transform 1.00 s ahead, 0.0000 m from the pose',
      'standing still: 1',
      'set laser_model_type: 1 ',
      'likelihood_field_prob: 1',
      'set laser_model_type: 1 ',
      'beam: 1',
      'set robot_model_type: 1 ',
      'nav2_amcl::OmniMotionModel: 1',
      'set robot_model_type: 1 ',
      'room::CarefulModel: 1',
      'set robot_model_type: 0 robot_model_type is not a declared motion model: flying',
      "set max_particles: 0 You've set min_particles to be greater than max particles, this isn't allowed.",
      'set resample_interval: 0 resample_interval is not positive',
      'set max_particles: 0 max_particles is greater than 1000000',
      'set max_particles: 0 max_particles is greater than 1000000',
      'set alpha1: 1 ',
      'set max_particles: 1 ',
      'at most 600 particles: 1',
      'load 0',
      'on another map: 1',
      'the component: 1',
      'robot is over',
    ]);
    for (
      const name of ['driven', 'after bad scans', 'likelihood_field_prob', 'beam', 'nav2_amcl::OmniMotionModel', 'room::CarefulModel', 'given by a service']
    ) isNear(lines, name);
    const spread = /^global spread ([\d.]+) x ([\d.]+) m, 0 not in free cells$/m.exec(lines.join('\n'));
    assert.ok(spread !== null && Number(spread[1]) > 6 && Number(spread[2]) > 4, lines.join('\n'));

    const amcl = said(output, 'amcl');
    assert.equal(count(amcl, 'AMCL cannot publish a pose or update the transform. Please set the initial pose...'), 1);
    assert.equal(count(amcl, 'initialPoseReceived'), 6);
    assert.equal(count(amcl, 'Ignoring initial pose in frame "odom"; initial poses must be in the global frame, "map"'), 1);
    assert.equal(count(amcl, 'Received initialpose message is malformed. Rejecting.'), 2);
    assert.equal(count(amcl, 'Received initialpose from message is out of the size of map. Rejecting.'), 1);
    assert.equal(amcl.filter((line) => /^Setting pose \(\d+\.\d{6}\): 2\.400 1\.700 0\.380$/.test(line)).length, 1);
    assert.equal(
      count(amcl, 'wrong range_max of laser_scan data: 0.000000. The message could be malformed. Ignore this message and stop updating.'),
      1,
    );
    for (
      const line of ['Received a 160 X 120 map @ 0.050 m/pix', 'Received a 3 X 2 map @ 0.050 m/pix', 'Initializing with uniform distribution',
        'Global initialisation done!', "You've set alpha1 to be negative, this isn't allowed, so the alpha1 will be set to be zero."]
    ) assert.equal(count(amcl, line), 1, line);
    assert.equal(count(amcl, 'Requesting no-motion update'), 8);
    assert.match(output, /careful model with 0\.20 and 0\.20/);
    const manager = said(output, 'lifecycle_manager_localization');
    for (const line of ['Server amcl connected with bond.', 'Managed nodes are active']) assert.equal(count(manager, line), 1, line);
  });
}

test('stepped runs with one seed draw the same particles', watchdog, async () => {
  const estimates = async (seed: number): Promise<string[]> => {
    const run = await workspace.run(['run', 'site', '--stepped', '--seed', String(seed), '--for', '240s', '--until', 'likelihood_field_prob off by']);
    assert.equal(run.code, 0, run.stdout + run.stderr);
    return said(run.stdout + run.stderr, 'robot').filter((line) => line.includes(' off by '));
  };
  const first = await estimates(3);
  for (const name of ['driven', 'after bad scans', 'likelihood_field_prob']) isNear(first, name, 0.2, 0.1);
  assert.deepEqual(await estimates(3), first);
  assert.notDeepEqual(await estimates(4), first);
});
