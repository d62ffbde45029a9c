// Controllers of ros2_controllers on mock hardware, started by spawners of a launch file: a base that drives an arc, an arm that
// follows a trajectory, arms that are stuck, a car, a gripper, a motor with a PID, and sensors; headless.

// Compatibility, works: ros2_controllers: joint_state_broadcaster, forward_command_controller and the groups of position_, velocity_ and
// effort_controllers, diff_drive_controller, joint_trajectory_controller, pid_controller, the broadcasters of IMU, range and force torque
// sensors, the steering controllers (bicycle, tricycle, Ackermann) and the gripper controllers, with their parameters, topics, actions and texts

// Compatibility, differs: filters of broadcasters (`sensor_filter_chain`) -> are refused when such a controller is configured

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const JOINTS = ['left_wheel', 'right_wheel', 'j1', 'j2', 'stuck_on_the_way', 'stuck_at_the_end', 'lamp', 'drive', 'steer', 'finger', 'motor'];

const joint = (name: string): string => `
  <link name="${name}_link"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="${name}" type="revolute">
    <parent link="base_link"/><child link="${name}_link"/><axis xyz="0 0 1"/>
    <limit lower="-100" upper="100" velocity="100" effort="100"/>
  </joint>`;

const control = (name: string, command: string, state: string, joints: readonly string[], parameter = ''): string => `
  <ros2_control name="${name}" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin>${parameter}</hardware>
${
  joints.map((one) =>
    `    <joint name="${one}">
      <command_interface name="${command}"/>
      <state_interface name="position"><param name="initial_value">0.0</param></state_interface>
${state}    </joint>`
  ).join('\n')
}
  </ros2_control>`;

const velocityState = '      <state_interface name="velocity"/>\n';
/** Sensors with values that do not change. */
const sensor = (name: string, values: Readonly<Record<string, number>>): string =>
  `    <sensor name="${name}">
${
    Object.entries(values).map(([one, value]) => `      <state_interface name="${one}"><param name="initial_value">${String(value)}</param></state_interface>`)
      .join('\n')
  }
    </sensor>`;
const imu = {
  'orientation.x': 0,
  'orientation.y': 0,
  'orientation.z': 0.6,
  'orientation.w': 0.8,
  'angular_velocity.x': 0,
  'angular_velocity.y': 0,
  'angular_velocity.z': 0.5,
  'linear_acceleration.x': 0,
  'linear_acceleration.y': 0,
  'linear_acceleration.z': 9.81,
};
const wrench = { 'force.x': 2, 'force.y': 0, 'force.z': 0, 'torque.x': 0, 'torque.y': 0, 'torque.z': -1 };

const description = `<?xml version="1.0"?>
<robot name="bench">
  <link name="base_link"/>${JOINTS.map(joint).join('')}
${control('Base', 'velocity', velocityState, ['left_wheel', 'right_wheel'], '<param name="calculate_dynamics">true</param>')}
${control('Arm', 'position', '', ['j1', 'j2', 'lamp'])}
${control('Stuck', 'position', '', ['stuck_on_the_way', 'stuck_at_the_end'], '<param name="disable_commands">true</param>')}
${control('Drive', 'velocity', velocityState, ['drive'])}
${control('Steer', 'position', '', ['steer'])}
${control('Finger', 'position', velocityState, ['finger'])}
${control('Motor', 'velocity', velocityState, ['motor'], '<param name="calculate_dynamics">true</param>')}
  <ros2_control name="Sensors" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
${sensor('imu', imu)}
${sensor('range', { range: 1.5 })}
${sensor('wrist', wrench)}
  </ros2_control>
</robot>
`;

const CONTROLLERS = [
  'joint_state_broadcaster',
  'base_controller',
  'arm_controller',
  'way_controller',
  'end_controller',
  'lamp_controller',
  'car_controller',
  'finger_controller',
  'motor_controller',
  'imu_broadcaster',
  'range_broadcaster',
  'wrist_broadcaster',
];

const config = `
controller_manager:
  ros__parameters:
    update_rate: 100
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    base_controller: {type: diff_drive_controller/DiffDriveController}
    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}
    way_controller: {type: joint_trajectory_controller/JointTrajectoryController}
    end_controller: {type: joint_trajectory_controller/JointTrajectoryController}
    lamp_controller: {type: position_controllers/JointGroupPositionController}
    car_controller: {type: bicycle_steering_controller/BicycleSteeringController}
    finger_controller: {type: parallel_gripper_action_controller/GripperActionController}
    motor_controller: {type: pid_controller/PidController}
    imu_broadcaster: {type: imu_sensor_broadcaster/IMUSensorBroadcaster}
    range_broadcaster: {type: range_sensor_broadcaster/RangeSensorBroadcaster}
    wrist_broadcaster: {type: force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster}

base_controller:
  ros__parameters:
    left_wheel_names: [left_wheel]
    right_wheel_names: [right_wheel]
    wheel_separation: 0.4
    wheel_radius: 0.05
    base_frame_id: base_link

arm_controller:
  ros__parameters:
    joints: [j1, j2]
    command_interfaces: [position]
    state_interfaces: [position]

way_controller:
  ros__parameters:
    joints: [stuck_on_the_way]
    command_interfaces: [position]
    state_interfaces: [position]
    constraints: {stuck_on_the_way: {trajectory: 0.05}}

end_controller:
  ros__parameters:
    joints: [stuck_at_the_end]
    command_interfaces: [position]
    state_interfaces: [position]
    constraints: {goal_time: 0.5, stuck_at_the_end: {goal: 0.01}}

lamp_controller:
  ros__parameters:
    joints: [lamp]

car_controller:
  ros__parameters:
    traction_joints_names: [drive]
    steering_joints_names: [steer]
    wheelbase: 2.0
    traction_wheel_radius: 0.5

finger_controller:
  ros__parameters:
    joint: finger

motor_controller:
  ros__parameters:
    dof_names: [motor]
    command_interface: velocity
    reference_and_state_interfaces: [position]
    gains: {motor: {p: 8.0}}

imu_broadcaster:
  ros__parameters: {sensor_name: imu, frame_id: imu_link}

range_broadcaster:
  ros__parameters: {sensor_name: range, frame_id: range_link}

wrist_broadcaster:
  ros__parameters: {sensor_name: wrist, frame_id: wrist_link, offset: {force: {x: 1.0}}, multiplier: {force: {x: 2.0}}}
`;

const launchFile = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('bench')
    with open(os.path.join(share, 'config', 'bench.urdf')) as file:
        description = file.read()
    controllers = os.path.join(share, 'config', 'controllers.yaml')
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': description}]),
        Node(package='controller_manager', executable='ros2_control_node', parameters=[controllers],
             remappings=[('~/robot_description', '/robot_description')]),
        Node(package='controller_manager', executable='spawner', arguments=[${CONTROLLERS.map((c) => `'${c}'`).join(', ')}]),
        Node(package='bench', executable='driver', output='screen'),
    ])
`;

const driver = `
#include <cmath>
#include <deque>
#include <map>
#include <optional>

#include "control_msgs/action/follow_joint_trajectory.hpp"
#include "control_msgs/action/parallel_gripper_command.hpp"
#include "control_msgs/msg/joint_trajectory_controller_state.hpp"
#include "control_msgs/msg/multi_dof_command.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "geometry_msgs/msg/wrench_stamped.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "sensor_msgs/msg/range.hpp"
#include "std_msgs/msg/float64_multi_array.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

using namespace std::chrono_literals;
using Action = control_msgs::action::FollowJointTrajectory;
using Handle = rclcpp_action::ClientGoalHandle<Action>;

class Driver : public rclcpp::Node {
 public:
  Driver() : Node("driver") {
    twist_ = create_publisher<geometry_msgs::msg::TwistStamped>("base_controller/cmd_vel", 10);
    lamp_ = create_publisher<std_msgs::msg::Float64MultiArray>("lamp_controller/commands", 10);
    odometry_ = create_subscription<nav_msgs::msg::Odometry>(
        "base_controller/odom", 10, [this](const nav_msgs::msg::Odometry& message) { odom = message; ++odoms; });
    tf_ = create_subscription<tf2_msgs::msg::TFMessage>("/tf", 10, [this](const tf2_msgs::msg::TFMessage& message) {
      for (const auto& one : message.transforms) transforms += one.header.frame_id == "odom" && one.child_frame_id == "base_link";
    });
    states_ = create_subscription<sensor_msgs::msg::JointState>("joint_states", 10, [this](const sensor_msgs::msg::JointState& message) {
      for (size_t i = 0; i < message.name.size(); ++i) joints[message.name[i]].push_back({rclcpp::Time(message.header.stamp).seconds(), message.position[i]});
    });
    path_ = create_subscription<control_msgs::msg::JointTrajectoryControllerState>(
        "arm_controller/controller_state", 10, [this](const control_msgs::msg::JointTrajectoryControllerState& message) {
          const double since = rclcpp::Duration(message.reference.time_from_start).seconds();
          if (is_moving && arm_start == 0.0 && since < 0.1) arm_start = rclcpp::Time(message.header.stamp).seconds() - since;
        });
  }

  // Between two messages on the line that they are on.
  double at(const std::string& joint, double time) {
    const auto& states = joints[joint];
    for (size_t i = 1; i < states.size(); ++i) {
      const auto& [before, from] = states[i - 1];
      const auto& [after, to] = states[i];
      if (before <= time && time <= after) return from + (to - from) * (time - before) / (after - before);
    }
    return states.back().second;
  }

  nav_msgs::msg::Odometry odom;
  int odoms = 0;
  int transforms = 0;
  bool is_moving = false;
  double arm_start = 0.0;
  std::map<std::string, std::deque<std::pair<double, double>>> joints;
  rclcpp::Publisher<geometry_msgs::msg::TwistStamped>::SharedPtr twist_;
  rclcpp::Publisher<std_msgs::msg::Float64MultiArray>::SharedPtr lamp_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr tf_;
  rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr states_;
  rclcpp::Subscription<control_msgs::msg::JointTrajectoryControllerState>::SharedPtr path_;
};

std::shared_ptr<Driver> node;
std::map<std::string, rclcpp_action::Client<Action>::SharedPtr> clients;
int results = 0;

void spin_until(const std::function<bool()>& is_done, std::chrono::nanoseconds most = 120s) {
  const auto end = node->now() + rclcpp::Duration(most);
  while (!is_done() && node->now() < end) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(2ms);
  }
}

Action::Goal goal_of(const std::vector<std::string>& joints, const std::vector<std::vector<double>>& points) {
  Action::Goal goal;
  goal.trajectory.joint_names = joints;
  for (size_t i = 0; i < points.size(); ++i) {
    trajectory_msgs::msg::JointTrajectoryPoint point;
    point.positions = points[i];
    point.time_from_start.sec = static_cast<int32_t>(i) + 1;
    goal.trajectory.points.push_back(point);
  }
  return goal;
}

void send(const std::string& controller, const Action::Goal& goal) {
  rclcpp_action::Client<Action>::SendGoalOptions options;
  const rclcpp::Time start = node->now();
  options.goal_response_callback = [controller](Handle::SharedPtr handle) {
    if (!handle) { RCLCPP_INFO(node->get_logger(), "%s rejected", controller.c_str()); ++results; }
  };
  options.result_callback = [controller, start](const Handle::WrappedResult& result) {
    RCLCPP_INFO(node->get_logger(), "%s ended with code %d error %d after %.2f s: %s", controller.c_str(), static_cast<int>(result.code),
                result.result->error_code, (node->now() - start).seconds(), result.result->error_string.c_str());
    ++results;
  };
  clients[controller]->async_send_goal(goal, options);
}

void drive() {
  geometry_msgs::msg::TwistStamped twist;
  twist.twist.linear.x = twist.twist.angular.z = 0.5;
  const double start = node->now().seconds();
  int count = 0;
  int transforms = 0;
  const auto publish = [&] {
    const double since = node->now().seconds() - start;
    if (since >= 0.05 * count && since < 2.0) {
      ++count;
      twist.header.stamp = node->now();
      node->twist_->publish(twist);
    }
    if (transforms == 0 && since >= 1.0) transforms = node->transforms;
    return since >= 2.0;
  };
  spin_until(publish);
  RCLCPP_INFO(node->get_logger(), "transforms per second %d", node->transforms - transforms);
  RCLCPP_INFO(node->get_logger(), "speed %.3f %.3f", node->odom.twist.twist.linear.x, node->odom.twist.twist.angular.z);
  spin_until([] { return std::abs(node->odom.twist.twist.linear.x) < 1e-6; });
  const auto& pose = node->odom.pose.pose;
  const double yaw = 2 * std::atan2(pose.orientation.z, pose.orientation.w);
  RCLCPP_INFO(node->get_logger(), "stopped at %.4f %.4f %.4f", pose.position.x, pose.position.y, yaw);
}

template <class MessageT>
MessageT message_of(const std::string& topic) {
  std::optional<MessageT> received;
  const auto subscription = node->create_subscription<MessageT>(topic, 10, [&](const MessageT& message) { received = message; });
  spin_until([&] { return received.has_value(); });
  return received.value();
}

void read_sensors() {
  const auto imu = message_of<sensor_msgs::msg::Imu>("imu_broadcaster/imu");
  RCLCPP_INFO(node->get_logger(), "imu %.2f %.2f %.2f", imu.orientation.w, imu.angular_velocity.z, imu.linear_acceleration.z);
  RCLCPP_INFO(node->get_logger(), "range %.2f", message_of<sensor_msgs::msg::Range>("range_broadcaster/range").range);
  const auto wrench = message_of<geometry_msgs::msg::WrenchStamped>("wrist_broadcaster/wrench");
  RCLCPP_INFO(node->get_logger(), "wrench %.2f %.2f", wrench.wrench.force.x, wrench.wrench.torque.z);
}

void steer() {
  const auto reference = node->create_publisher<geometry_msgs::msg::TwistStamped>("car_controller/reference", 10);
  nav_msgs::msg::Odometry odom;
  const auto subscription = node->create_subscription<nav_msgs::msg::Odometry>(
      "car_controller/odometry", 10, [&](const nav_msgs::msg::Odometry& message) { odom = message; });
  geometry_msgs::msg::TwistStamped twist;
  twist.twist.linear.x = 1.0;
  twist.twist.angular.z = 0.25;
  const double start = node->now().seconds();
  spin_until([&] {
    twist.header.stamp = node->now();
    reference->publish(twist);
    return node->now().seconds() > start + 1.5;
  });
  const auto& pose = odom.pose.pose;
  RCLCPP_INFO(node->get_logger(), "car at %.4f %.4f %.4f", pose.position.x, pose.position.y, 2 * std::atan2(pose.orientation.z, pose.orientation.w));
  RCLCPP_INFO(node->get_logger(), "car drives %.3f %.3f", odom.twist.twist.linear.x, odom.twist.twist.angular.z);
}

void grip() {
  using Grip = control_msgs::action::ParallelGripperCommand;
  const auto client = rclcpp_action::create_client<Grip>(node, "finger_controller/gripper_cmd");
  spin_until([&] { return client->action_server_is_ready(); });
  Grip::Goal goal;
  goal.command.position = {0.04};
  bool is_over = false;
  rclcpp_action::Client<Grip>::SendGoalOptions options;
  options.result_callback = [&](const rclcpp_action::ClientGoalHandle<Grip>::WrappedResult& result) {
    RCLCPP_INFO(node->get_logger(), "grip %d %d %.2f", static_cast<int>(result.code), result.result->reached_goal, result.result->state.position[0]);
    is_over = true;
  };
  client->async_send_goal(goal, options);
  spin_until([&] { return is_over; });
}

void turn_motor() {
  const auto reference = node->create_publisher<control_msgs::msg::MultiDOFCommand>("motor_controller/reference", rclcpp::QoS(1).best_effort());
  control_msgs::msg::MultiDOFCommand command;
  command.dof_names = {"motor"};
  command.values = {1.0};
  spin_until([&] { return reference->get_subscription_count() > 0; });
  reference->publish(command);
  spin_until([] { return node->joints["motor"].back().second > 0.99; }, 10s);
  RCLCPP_INFO(node->get_logger(), "motor at %.2f", node->joints["motor"].back().second);
}

void set_parameter() {
  rclcpp::SyncParametersClient parameters(node, "motor_controller");
  const auto results = parameters.set_parameters({rclcpp::Parameter("gains.motor.antiwindup_strategy", "never")});
  RCLCPP_INFO(node->get_logger(), "parameter: %s", results.at(0).reason.c_str());
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<Driver>();
  for (const char* name : {"arm_controller", "way_controller", "end_controller"}) {
    clients[name] = rclcpp_action::create_client<Action>(node, std::string(name) + "/follow_joint_trajectory");
  }
  spin_until([] {
    bool is_ready = node->joints.size() >= ${String(JOINTS.length)} && node->lamp_->get_subscription_count() > 0 && node->odoms > 0;
    for (const auto& [name, client] : clients) is_ready = is_ready && client->action_server_is_ready();
    return is_ready;
  });
  std::string names;
  for (const auto& [name, states] : node->joints) names += name + " ";
  RCLCPP_INFO(node->get_logger(), "ready with %s", names.c_str());

  std_msgs::msg::Float64MultiArray command;
  command.data = {0.75};
  node->lamp_->publish(command);
  drive();
  RCLCPP_INFO(node->get_logger(), "lamp at %.2f", node->at("lamp", node->now().seconds()));

  send("arm_controller", goal_of({"j1", "unknown"}, {{1.0, 1.0}}));
  spin_until([] { return results == 1; });
  node->is_moving = true;
  send("arm_controller", goal_of({"j1", "j2"}, {{1.0, -1.0}, {0.5, 0.5}}));
  send("way_controller", goal_of({"stuck_on_the_way"}, {{1.0}, {0.5}}));
  send("end_controller", goal_of({"stuck_at_the_end"}, {{1.0}, {0.5}}));
  spin_until([] { return results == 4; });
  for (const double time : {0.5, 1.0, 2.0}) {
    RCLCPP_INFO(node->get_logger(), "arm after %.1f s at %.3f %.3f", time, node->at("j1", node->arm_start + time),
                node->at("j2", node->arm_start + time));
  }
  read_sensors();
  steer();
  grip();
  turn_motor();
  set_parameter();
  command.data = {1.0, 2.0};
  node->lamp_->publish(command);
  spin_until([] { return false; }, 500ms);
  RCLCPP_INFO(node->get_logger(), "driver is over");
  rclcpp::shutdown();
}
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const depends = ['rclcpp', 'rclcpp_action', 'control_msgs', 'geometry_msgs', 'nav_msgs', 'sensor_msgs', 'std_msgs', 'tf2_msgs'];
  workspace.addPackage('bench', { driver }, {
    depends: [...depends, 'controller_manager', 'robot_state_publisher'],
    cmake: `${depends.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(driver ${depends.join(' ')})
install(DIRECTORY config launch DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/bench/config/bench.urdf', description);
  workspace.write('src/bench/config/controllers.yaml', config);
  workspace.write('src/bench/launch/bench.launch.py', launchFile);
  workspace.write('workspace.yaml', 'schema: 1\nname: bench\npackages: [src/*]\nlaunch: src/bench/launch/bench.launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
});
after(() => workspace.close());

/** The numbers that the driver prints after a text. */
function numbers(output: string, what: string): number[] {
  const text = `[driver]: ${what}`;
  const line = output.split('\n').find((one) => one.includes(text));
  assert.ok(line, `no line has: ${text}\n${output}`);
  return line.slice(line.indexOf(text) + text.length).trim().split(/ +/).map(Number);
}

function near(actual: readonly number[], expected: readonly number[], tolerance: number, what: string): void {
  assert.equal(actual.length, expected.length, what);
  expected.forEach((value, i) => {
    assert.ok(Math.abs((actual[i] ?? NaN) - value) <= tolerance, `${what}: ${actual.join(' ')} is not ${expected.join(' ')}`);
  });
}

for (const link of played('port', 'shared')) {
  test(`${link}: controllers drive a base and move arms`, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '120s', '--until', 'driver is over']);
    const output = run.stdout;
    assert.equal(run.code, 0, output + run.stderr);
    for (const name of CONTROLLERS) assert.match(output, new RegExp(`Configured and activated ${name}`));
    assert.match(output, new RegExp(`ready with ${[...JOINTS].sort().join(' ')}`));

    near(numbers(output, 'transforms per second'), [50], 5, 'transforms');
    near(numbers(output, 'speed'), [0.5, 0.5], 0.01, 'speed');
    // An arc of radius 1 m: two seconds, and half a second until the command is too old.
    const [x = NaN, y = NaN, yaw = NaN] = numbers(output, 'stopped at');
    near([x, y], [Math.sin(yaw), 1 - Math.cos(yaw)], 0.02, 'arc');
    // On a busy machine the first command and the last one come a little late.
    near([yaw], [1.25], 0.15, 'yaw');
    assert.match(output, /WARN\] .*\[base_controller\]: Velocity command timed out\. Braking\./);
    near(numbers(output, 'lamp at'), [0.75], 0.001, 'lamp');

    assert.match(output, /\[arm_controller\]: Incoming joint unknown doesn't match the controller's joints\.[^]*arm_controller rejected/);
    assert.match(output, /arm_controller ended with code 4 error 0 after 2\.\d+ s: Goal successfully reached!/);
    near(numbers(output, 'arm after 0.5 s at'), [0.5, -0.5], 0.02, 'at 0.5 s');
    near(numbers(output, 'arm after 1.0 s at'), [1, -1], 0.02, 'at 1 s');
    near(numbers(output, 'arm after 2.0 s at'), [0.5, 0.5], 0.01, 'at 2 s');
    assert.match(output, /way_controller ended with code 6 error -4 after 0\.\d+ s: Aborted due to path tolerance violation/);
    assert.match(output, /end_controller ended with code 6 error -5 after 2\.[5-7]\d+ s: Aborted due to goal_time_tolerance exceeding by 0\.5\d+ seconds/);

    near(numbers(output, 'imu'), [0.8, 0.5, 9.81], 0, 'imu');
    near(numbers(output, 'range'), [1.5], 0, 'range');
    near(numbers(output, 'wrench'), [6, -1], 0, 'wrench: (2 + 1) * 2');
    // On a circle of radius 4 m.
    const [carX = NaN, carY = NaN, carYaw = NaN] = numbers(output, 'car at');
    near([carX, carY], [4 * Math.sin(carYaw), 4 * (1 - Math.cos(carYaw))], 0.02, 'car');
    near(numbers(output, 'car drives'), [1, 0.25], 0.001, 'car');
    near(numbers(output, 'grip'), [4, 1, 0.04], 0, 'grip');
    near(numbers(output, 'motor at'), [1], 0.02, 'motor');
    assert.ok(output.includes("parameter: Parameter 'gains.motor.antiwindup_strategy' with the value 'never' is not in the set "
      + "'{back_calculation, conditional_integration, legacy, none}'"), output);
    assert.match(output, /command size \(2\) does not match number of interfaces \(1\)/);
  });
}
