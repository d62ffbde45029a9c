// Robots under ros2_control in the simulator, by launch files as they are written for Gazebo: a controller manager in the
// simulator, spawners, a drive by velocities, a mast by positions, and a controller of the workspace's own.

// Compatibility, works: ros2_control in Gazebo Sim (`gz_ros2_control`, `ign_ros2_control`) and Gazebo Classic
// (`gazebo_ros2_control`): commands by position and velocity, initial values, IMU and force sensors, controllers of the workspace

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const inertia = (mass: number, moment: number): string =>
  `<inertial><mass value="${mass}"/><inertia ixx="${moment}" iyy="${moment}" izz="${moment}" ixy="0" ixz="0" iyz="0"/></inertial>`;
const both = (geometry: string, rpy = '0 0 0'): string =>
  `<visual><origin rpy="${rpy}"/><geometry>${geometry}</geometry></visual><collision><origin rpy="${rpy}"/><geometry>${geometry}</geometry></collision>`;
const wheel = (side: string, y: number): string => `
  <link name="${side}_wheel">${inertia(0.4, 0.001)}${both('<cylinder radius="0.08" length="0.04"/>', '1.5707963 0 0')}</link>
  <joint name="${side}_wheel_joint" type="continuous"><parent link="base_link"/><child link="${side}_wheel"/>
    <origin xyz="0 ${y} 0"/><axis xyz="0 1 0"/></joint>`;

/** With a plugin for the hardware, and the plugin of the simulator. */
const robot = (hardware: string, simulator: string): string =>
  `<?xml version="1.0"?>
<robot name="mover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base_link">${inertia(5, 0.08)}${both('<box size="0.4 0.28 0.08"/>')}</link>
  <link name="caster">${inertia(0.2, 0.0005)}${both('<sphere radius="0.05"/>')}</link>
  <joint name="caster_joint" type="fixed"><parent link="base_link"/><child link="caster"/><origin xyz="-0.16 0 -0.03"/></joint>
  <gazebo reference="caster"><mu1>0.001</mu1><mu2>0.001</mu2></gazebo>
  ${wheel('left', 0.18)}${wheel('right', -0.18)}
  <link name="mast">${inertia(0.3, 0.002)}${both('<box size="0.02 0.02 0.2"/>')}</link>
  <joint name="mast_joint" type="revolute"><parent link="base_link"/><child link="mast"/><origin xyz="0.1 0 0.2"/>
    <axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="20" velocity="3"/></joint>
  <ros2_control name="mover" type="system">
    <hardware><plugin>${hardware}</plugin></hardware>
    <xacro:macro name="driven" params="side"><joint name="\${side}_wheel_joint"><command_interface name="velocity"/>
      <state_interface name="position"/><state_interface name="velocity"/></joint></xacro:macro>
    <xacro:driven side="left"/><xacro:driven side="right"/>
    <sensor name="imu">${
    ['orientation.x', 'orientation.y', 'orientation.z', 'orientation.w', 'angular_velocity.x', 'angular_velocity.y', 'angular_velocity.z',
      'linear_acceleration.x', 'linear_acceleration.y', 'linear_acceleration.z'].map((one) => `<state_interface name="${one}"/>`).join('')
  }</sensor>
    <sensor name="load">${['force', 'torque'].flatMap((one) => ['x', 'y', 'z'].map((axis) => `<state_interface name="${one}.${axis}"/>`)).join('')}</sensor>
    <joint name="mast_joint"><command_interface name="position"/>
      <state_interface name="position"><param name="initial_value">0.3</param></state_interface><state_interface name="velocity"/></joint>
  </ros2_control>
  <gazebo reference="base_link"><sensor name="imu" type="imu"/></gazebo>
  <gazebo reference="mast_joint"><sensor name="load" type="force_torque"/></gazebo>
  <gazebo><plugin ${simulator}><parameters>$(find mover)/config/controllers.yaml</parameters></plugin></gazebo>
  <gazebo><plugin filename="gz-sim-odometry-publisher-system" name="gz::sim::systems::OdometryPublisher"><odom_topic>/truth</odom_topic>
    </plugin></gazebo>
  <gazebo><plugin filename="libgazebo_ros_p3d.so" name="truth"><ros><remapping>odom:=/truth</remapping></ros>
    <body_name>base_link</body_name><update_rate>50</update_rate></plugin></gazebo>
</robot>
`;

const controllers = `
controller_manager:
  ros__parameters:
    update_rate: 100
    use_sim_time: true
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    wheels: {type: diff_drive_controller/DiffDriveController}
    mast: {type: mover/SwingController}
    imu: {type: imu_sensor_broadcaster/IMUSensorBroadcaster}
    load: {type: force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster}
imu:
  ros__parameters: {sensor_name: imu, frame_id: base_link}
load:
  ros__parameters: {sensor_name: load, frame_id: mast}
wheels:
  ros__parameters:
    left_wheel_names: [left_wheel_joint]
    right_wheel_names: [right_wheel_joint]
    wheel_separation: 0.36
    wheel_radius: 0.08
    base_frame_id: base_link
    odom_frame_id: odom
    position_feedback: true
    cmd_vel_timeout: 0.5
    publish_rate: 50.0
mast:
  ros__parameters:
    joint: mast_joint
    amplitude: 0.8
`;

/** A controller of the workspace: it follows a sine of simulated time. */
const swing = `
#include <cmath>
#include <string>
#include "controller_interface/controller_interface.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace mover {

class SwingController : public controller_interface::ControllerInterface {
 public:
  controller_interface::CallbackReturn on_init() override {
    auto_declare<std::string>("joint", "");
    auto_declare<double>("amplitude", 1.0);
    return controller_interface::CallbackReturn::SUCCESS;
  }
  controller_interface::InterfaceConfiguration command_interface_configuration() const override {
    return {controller_interface::interface_configuration_type::INDIVIDUAL, {name("position")}};
  }
  controller_interface::InterfaceConfiguration state_interface_configuration() const override {
    return {controller_interface::interface_configuration_type::INDIVIDUAL, {name("position")}};
  }
  controller_interface::CallbackReturn on_activate(const rclcpp_lifecycle::State &) override {
    RCLCPP_INFO(get_node()->get_logger(), "begins at %.2f", state_interfaces_[0].get_optional().value());
    return controller_interface::CallbackReturn::SUCCESS;
  }
  controller_interface::return_type update(const rclcpp::Time &, const rclcpp::Duration & period) override {
    passed_ += period.seconds();
    const double amplitude = get_node()->get_parameter("amplitude").as_double();
    (void)command_interfaces_[0].set_value(amplitude * std::sin(passed_));
    return controller_interface::return_type::OK;
  }

 private:
  std::string name(const std::string & kind) const { return get_node()->get_parameter("joint").as_string() + "/" + kind; }
  double passed_ = 0;
};

}  // namespace mover

PLUGINLIB_EXPORT_CLASS(mover::SwingController, controller_interface::ControllerInterface)
`;

const launchHead = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def included(package, file, **arguments):
    path = os.path.join(get_package_share_directory(package), 'launch', file)
    return IncludeLaunchDescription(PythonLaunchDescriptionSource(path), launch_arguments=arguments.items())


def generate_launch_description():
    description = Command(['xacro ', PathJoinSubstitution([FindPackageShare('mover'), 'urdf', 'mover.urdf.xacro'])])
    state_publisher = Node(package='robot_state_publisher', executable='robot_state_publisher',
                           parameters=[{'robot_description': ParameterValue(description, value_type=str), 'use_sim_time': True}])
    states = Node(package='controller_manager', executable='spawner', arguments=['joint_state_broadcaster'])
    others = Node(package='controller_manager', executable='spawner',
                  arguments=['wheels', 'mast', 'imu', 'load', '--controller-manager', '/controller_manager'])
    driver = Node(package='mover', executable='driver', parameters=[{'use_sim_time': True}])
`;
const launchTail = `
    return LaunchDescription([
        *simulator, state_publisher, spawn,
        RegisterEventHandler(OnProcessExit(target_action=spawn, on_exit=[states])),
        RegisterEventHandler(OnProcessExit(target_action=states, on_exit=[others])),
        driver])
`;
const launches = {
  sim: `${launchHead}
    simulator = [
        included('ros_gz_sim', 'gz_sim.launch.py', gz_args='-r empty.sdf'),
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[
            '/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock', '/truth@nav_msgs/msg/Odometry[gz.msgs.Odometry'])]
    spawn = Node(package='ros_gz_sim', executable='create', arguments=['-topic', 'robot_description', '-z', '0.1'])
${launchTail}`,
  classic: `${launchHead}
    simulator = [included('gazebo_ros', 'gazebo.launch.py')]
    spawn = Node(package='gazebo_ros', executable='spawn_entity.py',
                 arguments=['-topic', 'robot_description', '-entity', 'mover', '-z', '0.1'])
${launchTail}`,
};

/** Drives a bend by stamped velocities for 3 s of simulated time, and says what it has seen. */
const driver = `
import math
import rclpy
from geometry_msgs.msg import TwistStamped, WrenchStamped
from nav_msgs.msg import Odometry
from rclpy.node import Node
from sensor_msgs.msg import Imu, JointState


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.out = self.create_publisher(TwistStamped, '/wheels/cmd_vel', 10)
        self.odometry = self.truth = self.began = None
        self.joints = {}
        self.swing = 0.0
        self.create_subscription(Odometry, '/wheels/odom', self.take_odometry, 10)
        self.create_subscription(Odometry, '/truth', self.take_truth, 10)
        self.create_subscription(JointState, '/joint_states', self.take_joints, 10)
        self.felt = self.load = 0.0
        self.create_subscription(Imu, '/imu/imu', self.take_imu, 10)
        self.create_subscription(WrenchStamped, '/load/wrench', self.take_load, 10)
        self.create_timer(0.05, self.tick)
        self.done = False

    def take_odometry(self, message):
        self.odometry = message

    def take_truth(self, message):
        self.truth = message

    def take_imu(self, message):
        self.felt = message.linear_acceleration.z

    def take_load(self, message):
        self.load = abs(message.wrench.force.z)

    def take_joints(self, message):
        self.joints = dict(zip(message.name, message.position))
        self.swing = max(self.swing, self.joints.get('mast_joint', 0.0))

    def tick(self):
        if self.done or self.odometry is None or self.truth is None or not self.joints:
            return
        now = self.get_clock().now()
        self.began = self.began or now
        passed = (now - self.began).nanoseconds * 1e-9
        message = TwistStamped()
        message.header.stamp = now.to_msg()
        message.twist.linear.x = 0.4 if passed < 3.0 else 0.0
        message.twist.angular.z = 0.3 if passed < 3.0 else 0.0
        self.out.publish(message)
        if passed > 4.0:
            self.done = True
            odometry, truth = self.odometry.pose.pose, self.truth.pose.pose
            drift = math.hypot(odometry.position.x - truth.position.x, odometry.position.y - truth.position.y)
            print(f'it feels {self.felt:.1f} m/s2, the mast weighs {self.load:.1f} N', flush=True)
            yaw = 2 * math.atan2(odometry.orientation.z, odometry.orientation.w)
            print(f'drove to {odometry.position.x:.2f}, {odometry.position.y:.2f}, yaw {yaw:.2f}, {drift:.2f} m beside the truth', flush=True)
            print(f'the mast swung to {self.swing:.1f}, joints: {sorted(self.joints)}', flush=True)


rclpy.init()
rclpy.spin(Driver())
`;

const labs = {
  sim: robot('gz_ros2_control/GazeboSimSystem', 'filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"'),
  classic: robot('gazebo_ros2_control/GazeboSystem', 'filename="libgazebo_ros2_control.so" name="gazebo_ros2_control"'),
} as const;
type Lab = keyof typeof labs;
const workspaces = new Map<Lab, PackWorkspace>();

/** The plugin of the other Gazebo is skipped with a warning, so each robot has its own only. */
const withOne = (lab: Lab): string =>
  labs[lab].replace(lab === 'sim' ? /<gazebo><plugin filename="libgazebo_ros_p3d[^]*?<\/gazebo>/ : /<gazebo><plugin filename="gz-sim-odometry[^]*?<\/gazebo>/,
    '');

before(async () => {
  for (const lab of ['sim', 'classic'] as const) {
    const workspace = new PackWorkspace('shared');
    workspaces.set(lab, workspace);
    workspace.addPackage('mover', {}, {
      cmake: `find_package(controller_interface REQUIRED)
find_package(pluginlib REQUIRED)
find_package(rclcpp_lifecycle REQUIRED)
add_library(mover_controllers SHARED src/swing_controller.cpp)
ament_target_dependencies(mover_controllers controller_interface pluginlib rclcpp_lifecycle)
pluginlib_export_plugin_description_file(controller_interface controllers.xml)
install(TARGETS mover_controllers LIBRARY DESTINATION lib ARCHIVE DESTINATION lib)
install(DIRECTORY urdf config DESTINATION share/\${PROJECT_NAME})
install(FILES lab.launch.py DESTINATION share/\${PROJECT_NAME})
install(PROGRAMS driver DESTINATION lib/\${PROJECT_NAME})\n`,
      depends: ['controller_interface', 'controller_manager', 'pluginlib', 'rclcpp_lifecycle', 'rclpy', 'nav_msgs', 'geometry_msgs', 'sensor_msgs',
        'robot_state_publisher', 'joint_state_broadcaster', 'diff_drive_controller', 'imu_sensor_broadcaster', 'force_torque_sensor_broadcaster', 'xacro',
        ...(lab === 'sim' ? ['ros_gz_sim', 'ros_gz_bridge'] : ['gazebo_ros'])],
    });
    workspace.write('src/mover/src/swing_controller.cpp', swing);
    workspace.write('src/mover/controllers.xml', `<library path="mover_controllers">
  <class name="mover/SwingController" type="mover::SwingController" base_class_type="controller_interface::ControllerInterface"/>
</library>\n`);
    workspace.write('src/mover/urdf/mover.urdf.xacro', withOne(lab));
    workspace.write('src/mover/config/controllers.yaml', controllers);
    workspace.write('src/mover/driver', `#!/usr/bin/env python3${driver}`);
    workspace.write('src/mover/lab.launch.py', launches[lab]);
    workspace.write('workspace.yaml', 'schema: 1\nname: mover\npackages: [src/*]\nlaunch: src/mover/lab.launch.py\n');
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 0, packed.stdout + packed.stderr);
  }
}, watchdog);
after(() => {
  for (const workspace of workspaces.values()) workspace.close();
});

/** 3 s at 0.4 m/s and 0.3 rad/s: a radius of 4/3 m, 0.9 rad; less the way in which the wheels speed up. */
function expectDriven(said: string): void {
  const [, x = '', y = '', yaw = '', drift = ''] = /drove to (\S+), (\S+), yaw (\S+), (\S+) m beside/.exec(said) ?? assert.fail(said);
  assert.ok(Math.abs(Number(x) - (4 / 3) * Math.sin(0.9)) < 0.08, said);
  assert.ok(Math.abs(Number(y) - (4 / 3) * (1 - Math.cos(0.9))) < 0.08, said);
  assert.ok(Math.abs(Number(yaw) - 0.9) < 0.06, said);
  assert.ok(Number(drift) < 0.06, said);
  // At rest at the end: gravity, and 0.3 kg of it.
  assert.match(said, /it feels 9\.8 m\/s2, the mast weighs 2\.9 N/);
  assert.match(said, /the mast swung to 0\.8, joints: \['left_wheel_joint', 'mast_joint', 'right_wheel_joint'\]/);
}

for (const lab of ['sim', 'classic'] as const)
  test(`${lab}, Node.js, ${lab === 'sim' ? 'shared' : 'port'}: controllers of the channel and of the workspace move the robot`, watchdog, async () => {
    const workspace = workspaces.get(lab) ?? assert.fail();
    const run = await workspace.run(['run', 'site', '--for', '15s', '--link', lab === 'sim' ? 'shared' : 'port']);
    const said = run.stdout + run.stderr;
    expectDriven(said);
    assert.match(said, /begins at 0\.30/);
    assert.match(said, /Configured and activated .*wheels/);
    assert.match(said, /Configured and activated .*mast/);
  });

test('sim, Chromium: the same', watchdog, async () => {
  const workspace = workspaces.get('sim') ?? assert.fail();
  const browser = await chromium.launch(chromiumOptions());
  const server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
  try {
    const page = await browser.newPage();
    await page.goto(server.url);
    const line = page.getByText(/the mast swung to 0\.8/).first();
    await line.waitFor({ timeout: 60_000 });
    expectDriven((await page.locator('.panel-console').allInnerTexts()).join('\n'));
  } finally {
    await browser.close();
    server.close();
  }
});
