// Drives, controllers of joints and forces of the simulator, of both Gazebos, in worlds of few parts: what a command does is
// measured against the formula that it follows. Headless in Node.js.

// Compatibility, works: controllers of joints (position, velocity, trajectory, effort), cars (Ackermann), mecanum and skid steering
// wheels, VelocityControl, DetachableJoint, wrenches on links, and the services of `libgazebo_ros_state.so`,
// `libgazebo_ros_force_system.so` and `libgazebo_ros_properties.so`

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

interface LinkOptions {
  readonly mass?: number;
  readonly moment?: number;
  readonly pose?: string;
  readonly shape?: string;
}

const link = (name: string, options: LinkOptions = {}): string => {
  const { mass = 1, moment = 0.1, pose = '0 0 0 0 0 0', shape = '' } = options;
  const moments = ['ixx', 'iyy', 'izz'].map((one) => `<${one}>${moment}</${one}>`).join('');
  return `<link name="${name}"><pose>${pose}</pose><inertial><mass>${mass}</mass><inertia>${moments}</inertia></inertial>${shape}</link>`;
};
const collision = (geometry: string, friction = '', pose = '0 0 0 0 0 0'): string =>
  `<collision name="c"><pose>${pose}</pose><geometry>${geometry}</geometry><surface><friction><ode>${friction}</ode></friction></surface></collision>`;
const slippery = '<mu>0</mu><mu2>0</mu2>';
const joint = (name: string, parent: string, child: string, axis: string, type = 'revolute', limit = ''): string =>
  `<joint name="${name}" type="${type}"><parent>${parent}</parent><child>${child}</child><axis><xyz>${axis}</xyz>${limit}</axis></joint>`;
const model = (name: string, pose: string, ...parts: readonly string[]): string => `<model name="${name}"><pose>${pose}</pose>${parts.join('\n')}</model>`;
const elements = (values: Readonly<Record<string, string | number>>): string =>
  Object.entries(values).map(([name, value]) => `<${name}>${value}</${name}>`).join('');

/** A body of 5 kg on four wheels of 10 cm, 0.8 m long and 0.6 m wide, with the rear axle through its origin. */
const car = (friction: (front: number, left: number) => string, steers: boolean): string =>
  link('body', { mass: 5, moment: 0.5, pose: '0.4 0 0.1 0 0 0' })
  + [['front', 0.8], ['rear', 0]].flatMap(([end, x]) =>
    [['left', 0.3], ['right', -0.3]].map(([side, y]) => {
      const name = `${end}_${side}`;
      const wheel = link(name, {
        mass: 0.3,
        moment: 0.002,
        pose: `${x} ${y} 0.1 0 0 0`,
        shape: collision('<cylinder><radius>0.1</radius><length>0.04</length></cylinder>', friction(end === 'front' ? 1 : -1, side === 'left' ? 1 : -1),
          '0 0 0 1.5707963 0 0'),
      });
      if (!steers || end !== 'front') return wheel + joint(`${name}_joint`, 'body', name, '0 1 0');
      const limit = '<limit><lower>-0.8</lower><upper>0.8</upper></limit>';
      return wheel + link(`${name}_knuckle`, { mass: 0.3, moment: 0.01, pose: `${x} ${y} 0.1 0 0 0` })
        + joint(`${side}_steering_joint`, 'body', `${name}_knuckle`, '0 0 1', 'revolute', limit)
        + joint(`${name}_joint`, `${name}_knuckle`, name, '0 1 0');
    })
  ).join('\n');
const rolling = (): string => '<mu>1</mu><mu2>1</mu2>';
const rollers = (front: number, left: number): string => `<mu>1</mu><mu2>0</mu2><fdir1 gz:expressed_in="body">1 ${-front * left} 0</fdir1>`;

/** One link on a joint to the world, away from the ground. */
const rotor = (name: string, y: number, type: string, axis: string, ...more: readonly string[]): string =>
  model(name, `0 ${y} 1 0 0 0`, link('part'), joint('joint', 'world', 'part', axis, type), ...more);
const puck = (name: string, x: number, y: number, ...more: readonly string[]): string =>
  model(name, `${x} ${y} 0.1 0 0 1.5707963`, link('body', { mass: 2, shape: collision('<box><size>0.4 0.4 0.2</size></box>', slippery) }), ...more);
const world = (version: string, ...parts: readonly string[]): string =>
  `<sdf version="${version}" xmlns:gz="http://gazebosim.org/schema">
<world name="yard">
  <model name="floor"><static>true</static><link name="l">${collision('<plane><normal>0 0 1</normal><size>20 20</size></plane>')}</link></model>
  ${parts.join('\n')}
</world></sdf>
`;

const gz = (name: string, values: Readonly<Record<string, string | number>> = {}, more = ''): string =>
  `<plugin filename="gz-sim-${name}" name="gz::sim::systems::${name}">${elements(values)}${more}</plugin>`;
const truth = (name: string): string => gz('OdometryPublisher', { odom_topic: `/${name}/truth`, tf_topic: `/${name}/tf`, dimensions: 3 });
const states = gz('JointStatePublisher', { topic: '/joints' });
const sides = '<left_joint>front_left_joint</left_joint><left_joint>rear_left_joint</left_joint>'
  + '<right_joint>front_right_joint</right_joint><right_joint>rear_right_joint</right_joint>';

const simWorld = world('1.9', gz('Physics'), gz('UserCommands'), gz('ApplyLinkWrench'),
  rotor('arm', -8, 'revolute', '0 0 1', states.replace('/joints', '/arm/joints'),
    gz('JointPositionController', { joint_name: 'joint', topic: '/arm/to', p_gain: 20, i_gain: 0, d_gain: 3 })),
  rotor('lift', -7, 'prismatic', '0 0 1', states.replace('/joints', '/lift/joints'),
    gz('JointPositionController', { joint_name: 'joint', sub_topic: 'to', use_velocity_commands: 'true', cmd_max: 0.5 })),
  rotor('spinner', -6, 'revolute', '0 0 1', states.replace('/joints', '/spinner/joints'), gz('JointController', { joint_name: 'joint' })),
  rotor('follower', -5, 'revolute', '0 0 1', states.replace('/joints', '/follower/joints'),
    gz('JointTrajectoryController', { topic: '/follower/path', position_p_gain: 20, position_d_gain: 3 })),
  rotor('wheel', -4, 'revolute', '0 0 1', states.replace('/joints', '/wheel/joints'), gz('ApplyJointForce', { joint_name: 'joint' })),
  model('racer', '0 4 0 0 0 0', car(rolling, true), truth('racer'), gz('AckermannSteering', {
    left_joint: 'rear_left_joint',
    right_joint: 'rear_right_joint',
    left_steering_joint: 'left_steering_joint',
    right_steering_joint: 'right_steering_joint',
    wheel_separation: 0.6,
    kingpin_width: 0.6,
    wheel_base: 0.8,
    wheel_radius: 0.1,
    steering_limit: 0.7,
    steer_p_gain: 10,
    topic: '/racer/cmd_vel',
    odom_topic: '/racer/odom',
  })), model('sidler', '8 0 0 0 0 0', car(rollers, false), truth('sidler'), gz('MecanumDrive', {
    front_left_joint: 'front_left_joint',
    front_right_joint: 'front_right_joint',
    back_left_joint: 'rear_left_joint',
    back_right_joint: 'rear_right_joint',
    wheel_separation: 0.6,
    wheelbase: 0.8,
    wheel_radius: 0.1,
    topic: '/sidler/cmd_vel',
  })),
  model('skidder', '8 -6 0 0 0 0', car(rolling, false), truth('skidder'),
    gz('DiffDrive', { wheel_separation: 0.6, wheel_radius: 0.1, topic: '/skidder/cmd_vel' }, sides)),
  puck('glider', -6, 0, truth('glider'), gz('VelocityControl', { topic: '/glider/cmd_vel' })), puck('puck', -8, 0, truth('puck')),
  model('ball', '-4 0 3 0 0 0', link('body', { shape: collision('<sphere><radius>0.1</radius></sphere>') }), truth('ball')),
  rotor('misspelt', 1, 'revolute', '0 0 1', gz('ApplyJointForce', { joint_name: 'joynt' })), rotor('crane', 0, 'fixed', '0 0 1', gz('DetachableJoint', {
    parent_link: 'part',
    child_model: 'ball',
    child_link: 'body',
    detach_topic: '/crane/drop',
    attach_topic: '/crane/hold',
    output_topic: '/crane/state',
  })));

const bridged = [
  ...['/arm/to', '/model/lift/to', '/model/spinner/joint/joint/cmd_vel', '/model/wheel/joint/joint/cmd_force']
    .map((topic) => `${topic}@std_msgs/msg/Float64]gz.msgs.Double`),
  ...['arm', 'lift', 'spinner', 'follower', 'wheel'].map((name) => `/${name}/joints@sensor_msgs/msg/JointState[gz.msgs.Model`),
  ...['racer', 'sidler', 'skidder', 'glider'].map((name) => `/${name}/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist`),
  ...['racer', 'sidler', 'skidder', 'glider', 'puck', 'ball'].map((name) => `/${name}/truth@nav_msgs/msg/Odometry[gz.msgs.Odometry`),
  '/racer/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry',
  '/crane/drop@std_msgs/msg/Empty]gz.msgs.Empty',
  '/follower/path@trajectory_msgs/msg/JointTrajectory]gz.msgs.JointTrajectory',
  '/follower/path_progress@std_msgs/msg/Float32[gz.msgs.Float',
  '/world/yard/wrench/persistent@ros_gz_interfaces/msg/EntityWrench]gz.msgs.EntityWrench',
  '/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock',
];

const classic = (name: string, file: string, values: Readonly<Record<string, string | number>> = {}, more = ''): string =>
  `<plugin name="${name}" filename="libgazebo_ros_${file}.so"><ros><namespace>/${name}</namespace></ros>${elements(values)}${more}</plugin>`;
const classicWorld = world('1.6', classic('demo', 'state'), classic('facts', 'properties'), puck('puck', -8, 0),
  puck('pushed', -6, 0, classic('push', 'force', { link_name: 'body', force_frame: 'link' })),
  rotor('wheel', -4, 'revolute', '0 0 1', classic('wheel', 'joint_state_publisher', { joint_name: 'joint' })),
  rotor('figure', -5, 'revolute', '0 0 1', classic('figure', 'joint_pose_trajectory'),
    classic('figure_joints', 'joint_state_publisher', { joint_name: 'joint' })),
  model('racer', '0 4 0 0 0 0', car(rolling, true), classic('racer', 'ackermann_drive', {
    front_left_joint: 'front_left_joint',
    front_right_joint: 'front_right_joint',
    rear_left_joint: 'rear_left_joint',
    rear_right_joint: 'rear_right_joint',
    left_steering_joint: 'left_steering_joint',
    right_steering_joint: 'right_steering_joint',
    left_steering_pid_gain: '200 0 20',
    left_steering_i_range: '0 0',
    right_steering_pid_gain: '200 0 20',
    right_steering_i_range: '0 0',
    linear_velocity_pid_gain: '2 0 0',
    linear_velocity_i_range: '0 0',
    max_speed: 2,
    publish_odom: 'true',
    publish_distance: 'true',
    publish_steerangle: 'true',
  })));

/** The parts that both programs share: the measurements of a topic, and waiting for the clock. */
const common = `
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>
#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "trajectory_msgs/msg/joint_trajectory.hpp"

rclcpp::Node::SharedPtr node;

double now() { return node->get_clock()->now().seconds(); }

bool spin_until(const std::function<bool()>& done) {
  while (rclcpp::ok() && !done()) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(std::chrono::milliseconds(2));
  }
  return rclcpp::ok();
}
void wait(double seconds) {
  const double end = now() + seconds;
  spin_until([&] { return now() >= end; });
}

/// The last message of a topic, by topic.
template <typename Message>
const Message& last(const std::string& topic) {
  static std::map<std::string, Message> messages;
  static std::vector<std::shared_ptr<void>> subscriptions;
  if (messages.count(topic) == 0) {
    bool heard = false;
    subscriptions.push_back(node->create_subscription<Message>(topic, 10, [topic, &heard, first = true](const Message& m) mutable {
      messages[topic] = m;
      if (first) heard = true;
      first = false;
    }));
    spin_until([&] { return heard; });
  }
  return messages[topic];
}
using Odometry = nav_msgs::msg::Odometry;
using JointState = sensor_msgs::msg::JointState;
using Trajectory = trajectory_msgs::msg::JointTrajectory;

double seconds(const builtin_interfaces::msg::Time& time) { return time.sec + 1e-9 * time.nanosec; }

template <typename Message>
void send(const std::string& topic, const Message& message) {
  static std::map<std::string, std::shared_ptr<rclcpp::Publisher<Message>>> publishers;
  auto& publisher = publishers[topic];
  if (!publisher) {
    publisher = node->create_publisher<Message>(topic, 10);
    spin_until([&] { return publisher->get_subscription_count() > 0; });
  }
  publisher->publish(message);
}
geometry_msgs::msg::Twist twist(double x, double y, double turn) {
  geometry_msgs::msg::Twist message;
  message.linear.x = x;
  message.linear.y = y;
  message.angular.z = turn;
  return message;
}
Trajectory trajectory(const std::vector<std::pair<double, int>>& points) {
  Trajectory message;
  message.joint_names = {"joint"};
  for (const auto& [position, milliseconds] : points) {
    trajectory_msgs::msg::JointTrajectoryPoint point;
    point.positions = {position};
    point.time_from_start.sec = milliseconds / 1000;
    point.time_from_start.nanosec = milliseconds % 1000 * 1000000;
    message.points.push_back(point);
  }
  return message;
}

/// The radius of the circle through three places.
double radius_of(const std::vector<std::pair<double, double>>& p) {
  const auto side = [&](int i, int j) { return std::hypot(p[i].first - p[j].first, p[i].second - p[j].second); };
  const double twice_area = std::abs((p[1].first - p[0].first) * (p[2].second - p[0].second) - (p[2].first - p[0].first) * (p[1].second - p[0].second));
  return side(0, 1) * side(1, 2) * side(2, 0) / (2 * twice_area);
}
/// The radius that a body goes round, which is 0.4 m before the rear axle.
double rear_radius(const std::string& odometry) {
  std::vector<std::pair<double, double>> places;
  for (int i = 0; i < 3; ++i) {
    const auto& pose = last<Odometry>(odometry).pose.pose;
    places.emplace_back(pose.position.x, pose.position.y);
    wait(1.5);
  }
  return radius_of(places);
}
void report(const char* what, double measured, double expected, double tolerance) {
  const bool is_right = std::abs(measured - expected) <= tolerance;
  RCLCPP_INFO(node->get_logger(), "%s: %s (%.4f, expected %.4f)", what, is_right ? "as computed" : "WRONG", measured, expected);
}
`;

const simPilot = `${common}
#include "ros_gz_interfaces/msg/entity_wrench.hpp"
#include "std_msgs/msg/empty.hpp"
#include "std_msgs/msg/float32.hpp"
#include "std_msgs/msg/float64.hpp"

std_msgs::msg::Float64 number(double value) {
  std_msgs::msg::Float64 message;
  message.data = value;
  return message;
}
double position(const std::string& name) { return last<JointState>("/" + name + "/joints").position.at(0); }

/// The change of a velocity in a second, by the stamps.
template <typename Message, typename Read>
double slope(const std::string& topic, Read read) {
  const Message first = last<Message>(topic);
  wait(1);
  const Message& second = last<Message>(topic);
  return (read(second) - read(first)) / (seconds(second.header.stamp) - seconds(first.header.stamp));
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("pilot");
  spin_until([] { return now() > 0; });
  for (const char* name : {"racer", "sidler", "skidder", "glider", "puck", "ball"}) last<Odometry>(std::string("/") + name + "/truth");
  for (const char* name : {"arm", "lift", "spinner", "follower", "wheel"}) position(name);
  send("/arm/to", number(0.8));
  send("/model/lift/to", number(0.4));
  send("/model/spinner/joint/joint/cmd_vel", number(3));
  send("/racer/cmd_vel", twist(0.5, 0, 0.25));
  send("/glider/cmd_vel", twist(0.5, 0, 0));
  send("/sidler/cmd_vel", twist(0, 0.2, 0));
  send("/skidder/cmd_vel", twist(0.2, 0, 0));
  send("/follower/path", trajectory({{0.5, 2000}, {-0.5, 3500}}));
  // In the middle of its time, so that a message which is late on a busy machine changes nothing.
  wait(1.4);
  report("the first point of the trajectory", position("follower"), 0.5, 0.01);
  wait(2.5);
  report("the arm", position("arm"), 0.8, 0.001);
  report("the lift", position("lift"), 0.4, 0.001);
  report("the spinner", last<JointState>("/spinner/joints").velocity.at(0), 3, 0.001);
  report("the end of the trajectory", position("follower"), -0.5, 0.01);
  const auto& glide = last<Odometry>("/glider/truth").twist.twist.linear;
  report("the glider, along its own axis", glide.x, 0.5, 0.01);
  const auto slide = [] { return last<Odometry>("/sidler/truth"); };
  const Odometry before = slide(), straight = last<Odometry>("/skidder/truth");
  wait(1);
  const Odometry behind = slide(), further = last<Odometry>("/skidder/truth");
  const auto passed = [](const Odometry& a, const Odometry& b) { return seconds(b.header.stamp) - seconds(a.header.stamp); };
  report("the mecanum wheels to the left", (behind.pose.pose.position.y - before.pose.pose.position.y) / passed(before, behind), 0.2, 0.004);
  report("the mecanum wheels forward", behind.pose.pose.position.x - before.pose.pose.position.x, 0, 0.01);
  report("four driven wheels", (further.pose.pose.position.x - straight.pose.pose.position.x) / passed(straight, further), 0.2, 0.004);
  send("/skidder/cmd_vel", twist(0, 0, 0.5));
  report("the car's radius", rear_radius("/racer/truth"), std::hypot(2, 0.4), 0.05);
  report("the car's own odometry", last<Odometry>("/racer/odom").twist.twist.linear.x / last<Odometry>("/racer/odom").twist.twist.angular.z, 2, 0.05);
  RCLCPP_INFO(node->get_logger(), "four driven wheels turn to the left: %d", last<Odometry>("/skidder/truth").twist.twist.angular.z > 0.05);
  send("/model/wheel/joint/joint/cmd_force", number(0.05));
  wait(0.1);
  report("a force on a joint", slope<JointState>("/wheel/joints", [](const JointState& m) { return m.velocity.at(0); }), 0.05 / 0.1001, 0.002);
  ros_gz_interfaces::msg::EntityWrench wrench;
  wrench.entity.name = "puck";
  wrench.entity.type = ros_gz_interfaces::msg::Entity::MODEL;
  wrench.wrench.force.y = 1;  // the puck looks that way
  send("/world/yard/wrench/persistent", wrench);
  wait(0.1);
  report("a force on a link", slope<Odometry>("/puck/truth", [](const Odometry& m) { return m.twist.twist.linear.x; }), 0.5, 0.01);
  report("what the crane holds", last<Odometry>("/ball/truth").pose.pose.position.z, 3, 0.01);
  send("/crane/drop", std_msgs::msg::Empty());
  wait(1.5);
  report("what the crane has dropped", last<Odometry>("/ball/truth").pose.pose.position.z, 0.1, 0.01);
  RCLCPP_INFO(node->get_logger(), "measured");
  rclcpp::spin(node);
  rclcpp::shutdown();
}
`;

const classicPilot = `${common}
#include "gazebo_msgs/msg/model_states.hpp"
#include "gazebo_msgs/msg/performance_metrics.hpp"
#include "gazebo_msgs/srv/apply_joint_effort.hpp"
#include "gazebo_msgs/srv/apply_link_wrench.hpp"
#include "gazebo_msgs/srv/get_entity_state.hpp"
#include "gazebo_msgs/srv/get_model_properties.hpp"
#include "gazebo_msgs/srv/joint_request.hpp"
#include "gazebo_msgs/srv/link_request.hpp"
#include "gazebo_msgs/srv/set_link_properties.hpp"
#include "std_msgs/msg/float32.hpp"

using namespace gazebo_msgs::srv;

template <typename Service>
typename Service::Response call(const std::string& name, const typename Service::Request& request) {
  auto client = node->create_client<Service>(name);
  spin_until([&] { return client->service_is_ready(); });
  auto future = client->async_send_request(std::make_shared<typename Service::Request>(request));
  rclcpp::spin_until_future_complete(node, future);
  return *future.get();
}
GetEntityState::Response state(const std::string& name) {
  GetEntityState::Request request;
  request.name = name;
  return call<GetEntityState>("/demo/get_entity_state", request);
}
double acceleration(const std::string& name) {
  const auto first = state(name);
  wait(1);
  const auto second = state(name);
  return (second.state.twist.linear.y - first.state.twist.linear.y) / (seconds(second.header.stamp) - seconds(first.header.stamp));
}
double joint_velocity() { return last<JointState>("/wheel/joint_states").velocity.at(0); }
double joint_acceleration() {
  const JointState first = last<JointState>("/wheel/joint_states");
  wait(1);
  const JointState& second = last<JointState>("/wheel/joint_states");
  return (second.velocity.at(0) - first.velocity.at(0)) / (seconds(second.header.stamp) - seconds(first.header.stamp));
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("pilot");
  spin_until([] { return now() > 0; });
  send("/racer/cmd_vel", twist(1, 0, 0.3));
  ApplyLinkWrench::Request wrench;
  wrench.link_name = "puck::body";
  wrench.wrench.force.y = 1;
  wrench.duration.sec = -1;
  const auto pushed = call<ApplyLinkWrench>("/apply_link_wrench", wrench);
  report("a wrench on 2 kg", acceleration("puck"), 0.5, 0.005);
  SetLinkProperties::Request heavy;
  heavy.link_name = "puck::body";
  heavy.mass = 4;
  heavy.ixx = heavy.iyy = heavy.izz = 0.1;
  heavy.gravity_mode = true;
  call<SetLinkProperties>("/facts/set_link_properties", heavy);
  report("the same wrench on 4 kg", acceleration("puck"), 0.25, 0.005);
  LinkRequest::Request no_wrench;
  no_wrench.link_name = wrench.link_name;
  call<LinkRequest>("/clear_link_wrenches", no_wrench);
  wait(0.2);  // a clock step may still be under way when the service answers
  report("no wrench", acceleration("puck"), 0, 0.002);
  wrench.link_name = "nobody::body";
  const auto missed = call<ApplyLinkWrench>("/apply_link_wrench", wrench);
  RCLCPP_INFO(node->get_logger(), "pushed: %d, and nobody: %d", pushed.success, missed.success);
  joint_velocity();
  ApplyJointEffort::Request effort;
  effort.joint_name = "wheel::joint";
  effort.effort = 0.05;
  effort.duration.sec = -1;
  call<ApplyJointEffort>("/apply_joint_effort", effort);
  wait(0.2);
  report("an effort", joint_acceleration(), 0.05 / 0.1001, 0.005);
  JointRequest::Request no_effort;
  no_effort.joint_name = effort.joint_name;
  call<JointRequest>("/clear_joint_efforts", no_effort);
  wait(0.2);
  report("no effort", joint_acceleration(), 0, 0.002);
  geometry_msgs::msg::Wrench along;
  along.force.x = 1;  // of the link, which looks along y
  send("/push/gazebo_ros_force", along);
  wait(0.2);
  report("a force along the link", acceleration("pushed"), 0.5, 0.005);
  last<JointState>("/figure_joints/joint_states");
  send("/figure/set_joint_trajectory", trajectory({{0.7, 500}, {-0.3, 500}}));
  wait(0.3);
  report("the first pose", last<JointState>("/figure_joints/joint_states").position.at(0), 0.7, 1e-6);
  wait(0.7);
  report("the second pose", last<JointState>("/figure_joints/joint_states").position.at(0), -0.3, 1e-6);
  report("the car's radius", rear_radius("/racer/odom"), std::hypot(0.8 / std::tan(0.3), 0.4), 0.1);
  report("the car's steering", last<std_msgs::msg::Float32>("/racer/steerangle").data, 0.3, 0.02);
  GetModelProperties::Request which;
  which.model_name = "racer";
  const auto facts = call<GetModelProperties>("/facts/get_model_properties", which);
  RCLCPP_INFO(node->get_logger(), "the car has %zu links and %zu joints, first %s", facts.body_names.size(), facts.joint_names.size(), facts.canonical_body_name.c_str());
  const auto& models = last<gazebo_msgs::msg::ModelStates>("/demo/model_states");
  const auto& metrics = last<gazebo_msgs::msg::PerformanceMetrics>("/performance_metrics");
  RCLCPP_INFO(node->get_logger(), "%zu models, the second is %s, the factor is positive: %d", models.name.size(), models.name.at(1).c_str(), metrics.real_time_factor > 0);
  RCLCPP_INFO(node->get_logger(), "measured");
  rclcpp::spin(node);
  rclcpp::shutdown();
}
`;

const launch = (simulator: string): string => `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    world = os.path.join(get_package_share_directory('yard'), 'yard.world')
    return LaunchDescription([
        ${simulator}
        Node(package='yard', executable='pilot', parameters=[{'use_sim_time': True}], output='screen'),
    ])
`;
const include = (name: string, file: string, launched: string): string =>
  `IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('${name}'), 'launch', '${file}')),
            launch_arguments=${launched}.items()),`;

interface Lab {
  readonly name: string;
  readonly depends: readonly string[];
  readonly messages: readonly string[];
  readonly world: string;
  readonly pilot: string;
  readonly launch: string;
  readonly said: readonly RegExp[];
}
const labs: readonly Lab[] = [
  {
    name: 'Gazebo Sim',
    depends: ['ros_gz_sim', 'ros_gz_bridge'],
    messages: ['ros_gz_interfaces'],
    world: simWorld,
    pilot: simPilot,
    launch: launch(`${include('ros_gz_sim', 'gz_sim.launch.py', "{'gz_args': '-r -s ' + world}")}
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[${bridged.map((one) => `'${one}'`).join(', ')}]),`),
    said: [/ERROR.*Failed to find joint \[joynt\] for model \[misspelt\]; the nearest joint is \[joint\]$/m, /four driven wheels turn to the left: 1$/m,
      /\[JointController\] subscribed to Double messages on \[\/model\/spinner\/joint\/joint\/cmd_vel\]$/m],
  },
  {
    name: 'Gazebo Classic',
    depends: ['gazebo_ros'],
    messages: ['gazebo_msgs'],
    world: classicWorld,
    pilot: classicPilot,
    launch: launch(include('gazebo_ros', 'gzserver.launch.py', "{'world': world}")),
    said: [
      /pushed: 1, and nobody: 0$/m,
      /the car has 7 links and 6 joints, first body$/m,
      /6 models, the second is puck, the factor is positive: 1$/m,
      /\[gazebo\]: ApplyLinkWrench: Link \[nobody::body\] does not exist$/m,
    ],
  },
];

const messages = ['geometry_msgs', 'nav_msgs', 'sensor_msgs', 'std_msgs', 'trajectory_msgs'];
const workspaces = new Map<string, PackWorkspace>();
before(async () => {
  for (const lab of labs) {
    const workspace = new PackWorkspace('shared');
    workspaces.set(lab.name, workspace);
    const all = [...messages, ...lab.messages];
    const cmake = `find_package(rclcpp REQUIRED)
${all.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(pilot rclcpp ${all.join(' ')})
install(FILES yard.world sim.launch.py DESTINATION share/\${PROJECT_NAME})
`;
    workspace.addPackage('yard', { pilot: lab.pilot }, { cmake, depends: ['rclcpp', ...all, ...lab.depends] });
    workspace.write('src/yard/yard.world', lab.world);
    workspace.write('src/yard/sim.launch.py', lab.launch);
    workspace.write('workspace.yaml', 'schema: 1\nname: yard\npackages: [src/*]\nlaunch: src/yard/sim.launch.py\n');
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 0, packed.stderr);
  }
}, watchdog);
after(() => {
  for (const workspace of workspaces.values()) workspace.close();
});

for (const lab of labs)
  test(`${lab.name}: joints, drives and forces follow their formulas`, watchdog, async () => {
    const workspace = workspaces.get(lab.name) ?? assert.fail();
    const run = await workspace.run(['run', 'site', '--for', '120s', '--until', 'measured']);
    assert.equal(run.code, 0, run.stdout + run.stderr);
    assert.doesNotMatch(run.stdout, /WRONG|is skipped/, run.stdout + run.stderr);
    assert.ok(run.stdout.split('as computed').length > 10, run.stdout);
    for (const line of lab.said) assert.match(run.stdout, line, run.stdout + run.stderr);
    // A machine that is busy may be slower than time.
    const warnings = run.stdout.match(/^.*\[WARN\].*$/gm)?.filter((line) => !line.includes('slower than time')) ?? [];
    assert.deepEqual(warnings.filter((line) => !lab.said.some((said) => said.test(line))), []);
  });

test('two stepped runs of a seed are the same', watchdog, async () => {
  const workspace = workspaces.get('Gazebo Sim') ?? assert.fail();
  const traces = [];
  for (const name of ['first.trace', 'second.trace']) {
    const run = await workspace.run(['run', 'site', '--stepped', '--seed', '7', '--for', '4s', '--trace', name]);
    traces.push(/^trace: \d+ messages, sha256 \w+$/m.exec(run.stderr)?.[0] ?? assert.fail(run.stdout + run.stderr));
  }
  assert.equal(traces[0], traces[1]);
});
