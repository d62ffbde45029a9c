// Two arms with gravity in one world of Gazebo Sim, each with a controller manager in its namespace: one by position commands, one
// by efforts of PIDs. A node in Python sends both to a place and measures how near they keep to the trajectory.

// Compatibility, works: several robots with a controller manager each in Gazebo Sim; joint_trajectory_controller by positions and by
// efforts with PIDs against gravity

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const link = (name: string, mass: number, length: number): string => `
  <link name="${name}"><inertial><origin xyz="0 0 ${-length / 2}"/><mass value="${mass}"/>
    <inertia ixx="${(mass * length * length) / 12}" iyy="${(mass * length * length) / 12}" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><origin xyz="0 0 ${-length / 2}"/><geometry><box size="0.05 0.05 ${length}"/></geometry></visual></link>`;
const joint = (name: string, parent: string, child: string, z: number): string => `
  <joint name="${name}" type="revolute"><parent link="${parent}"/><child link="${child}"/><origin xyz="0 0 ${z}"/><axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" effort="60" velocity="6"/><dynamics damping="0.1"/></joint>`;
const driven = (name: string, command: string): string =>
  `<joint name="${name}"><command_interface name="${command}"/>
    <state_interface name="position"/><state_interface name="velocity"/></joint>`;

/** An arm that hangs from a frame: 0.5 m with 1 kg, 0.4 m with 0.5 kg. */
const arm = (name: string, y: number, command: string): string =>
  `<robot name="${name}">
  <link name="world"/>
  <joint name="hold" type="fixed"><parent link="world"/><child link="frame"/><origin xyz="0 ${y} 1.5"/></joint>
  ${link('frame', 1, 0.1)}${link('upper', 1, 0.5)}${link('lower', 0.5, 0.4)}
  ${joint('shoulder', 'frame', 'upper', 0)}${joint('elbow', 'upper', 'lower', -0.5)}
  <ros2_control name="${name}" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
    ${driven('shoulder', command)}${driven('elbow', command)}</ros2_control>
  <gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
    <ros><namespace>/${name}</namespace></ros><parameters>package://arms/config/${name}.yaml</parameters>
    <position_proportional_gain>0.1</position_proportional_gain></plugin></gazebo>
</robot>
`;

const controllers = (name: string, command: string): string =>
  `/${name}/controller_manager:
  ros__parameters:
    update_rate: 500
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
/${name}/arm:
  ros__parameters:
    joints: [shoulder, elbow]
    command_interfaces: [${command}]
    state_interfaces: [position, velocity]
    constraints: {stopped_velocity_tolerance: 0.05, goal_time: 1.0, shoulder: {goal: 0.01}, elbow: {goal: 0.01}}
    gains:
      shoulder: {p: 400.0, i: 400.0, d: 12.0, i_clamp: 20.0}
      elbow: {p: 120.0, i: 120.0, d: 1.5, i_clamp: 10.0}
`;

const launch = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def robot(name):
    with open(os.path.join(get_package_share_directory('arms'), 'urdf', name + '.urdf')) as file:
        description = file.read()
    spawn = Node(package='ros_gz_sim', executable='create', arguments=['-topic', '/' + name + '/robot_description', '-name', name])
    spawner = Node(package='controller_manager', executable='spawner', namespace=name,
                   arguments=['joint_state_broadcaster', 'arm', '-c', '/' + name + '/controller_manager'])
    return [Node(package='robot_state_publisher', executable='robot_state_publisher', namespace=name,
                 parameters=[{'robot_description': description, 'use_sim_time': True}]),
            spawn, RegisterEventHandler(OnProcessExit(target_action=spawn, on_exit=[spawner]))]


def generate_launch_description():
    simulator = os.path.join(get_package_share_directory('ros_gz_sim'), 'launch', 'gz_sim.launch.py')
    return LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource(simulator), launch_arguments={'gz_args': '-r empty.sdf'}.items()),
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=['/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock']),
        *robot('left'), *robot('right'),
        Node(package='arms', executable='mover', parameters=[{'use_sim_time': True}])])
`;

const mover = `
import rclpy
from builtin_interfaces.msg import Duration
from control_msgs.action import FollowJointTrajectory
from control_msgs.msg import JointTrajectoryControllerState
from rclpy.action import ActionClient
from rclpy.node import Node
from sensor_msgs.msg import JointState
from trajectory_msgs.msg import JointTrajectoryPoint

GOAL = {'shoulder': -0.8, 'elbow': 1.0}


class Mover(Node):
    def __init__(self):
        super().__init__('mover')
        self.joints = {}
        self.error = {}
        for name in ('left', 'right'):
            self.create_subscription(JointState, f'/{name}/joint_states', lambda one, name=name: self.take(name, one), 10)
            self.create_subscription(JointTrajectoryControllerState, f'/{name}/arm/controller_state',
                                     lambda one, name=name: self.measure(name, one), 10)

    def take(self, name, message):
        self.joints[name] = dict(zip(message.name, message.position))

    def measure(self, name, message):
        self.error[name] = max(self.error.get(name, 0.0), *[abs(one) for one in message.error.positions])

    def move(self, name):
        client = ActionClient(self, FollowJointTrajectory, f'/{name}/arm/follow_joint_trajectory')
        client.wait_for_server()
        goal = FollowJointTrajectory.Goal()
        goal.trajectory.joint_names = list(GOAL)
        goal.trajectory.points = [JointTrajectoryPoint(positions=list(GOAL.values()), velocities=[0.0, 0.0],
                                                       time_from_start=Duration(sec=2))]
        self.error[name] = 0.0
        sent = client.send_goal_async(goal)
        rclpy.spin_until_future_complete(self, sent)
        begin = self.get_clock().now()
        done = sent.result().get_result_async()
        rclpy.spin_until_future_complete(self, done)
        seconds = (self.get_clock().now() - begin).nanoseconds * 1e-9
        result = done.result().result
        away = max(abs(self.joints[name][one] - place) for one, place in GOAL.items())
        print(f'{name}: result {result.error_code} after {seconds:.2f} s, {away:.4f} rad away, {self.error[name]:.3f} on the way', flush=True)


rclpy.init()
node = Mover()
for arm in ('left', 'right'):
    node.move(arm)
print('both arms have moved', flush=True)
`;

let workspace: PackWorkspace;

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('arms', {}, {
    cmake: `install(DIRECTORY urdf config DESTINATION share/\${PROJECT_NAME})
install(FILES arms.launch.py DESTINATION share/\${PROJECT_NAME})
install(PROGRAMS mover DESTINATION lib/\${PROJECT_NAME})\n`,
    depends: ['rclpy', 'ros_gz_sim', 'ros_gz_bridge', 'gz_ros2_control', 'robot_state_publisher', 'ros2_controllers', 'control_msgs', 'sensor_msgs',
      'trajectory_msgs'],
  });
  for (const [name, y, command] of [['left', 1, 'position'], ['right', -1, 'effort']] as const) {
    workspace.write(`src/arms/urdf/${name}.urdf`, arm(name, y, command));
    workspace.write(`src/arms/config/${name}.yaml`, controllers(name, command));
  }
  workspace.write('src/arms/mover', `#!/usr/bin/env python3${mover}`);
  workspace.write('src/arms/arms.launch.py', launch);
  workspace.write('workspace.yaml', 'schema: 1\nname: arms\npackages: [src/*]\nlaunch: src/arms/arms.launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stdout + packed.stderr);
}, watchdog);
after(() => workspace.close());

test('an arm by positions and an arm by efforts reach their goal in the time that the trajectory gives', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--for', '60s', '--until', 'both arms have moved']);
  for (const name of ['left', 'right']) {
    const [, code, seconds, away, onTheWay] = new RegExp(`${name}: result (\\S+) after (\\S+) s, (\\S+) rad away, (\\S+) on the way`)
      .exec(run.stdout)?.map(Number) ?? assert.fail(run.stdout + run.stderr);
    assert.equal(code, 0, run.stdout + run.stderr);
    assert.ok((seconds ?? 9) > 1.9 && (seconds ?? 9) < 2.4, `${name}: ${String(seconds)} s`);
    assert.ok((away ?? 9) < 0.01, `${name}: ${String(away)} rad`);
    assert.ok((onTheWay ?? 9) < 0.06, run.stdout.slice(-600));
  }
});

test('two stepped runs of a seed send the same', watchdog, async () => {
  const traces = [];
  for (const name of ['first.trace', 'second.trace']) {
    const run = await workspace.run(['run', 'site', '--stepped', '--seed', '7', '--for', '8s', '--trace', name]);
    assert.match(run.stdout, /both arms have moved/, run.stdout + run.stderr);
    traces.push(/^trace: \d+ messages, sha256 \w+$/m.exec(run.stderr)?.[0] ?? assert.fail(run.stdout + run.stderr));
  }
  assert.equal(traces[0], traces[1]);
});
