// Groups of joints, several interfaces of one joint, cars with two driven wheels and the older gripper, on mock hardware: a node in
// Python commands them, reads what the hardware has got, and deactivates the groups.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const JOINTS = {
  spin: ['velocity'],
  pull: ['effort'],
  plain: ['position'],
  several: ['position', 'velocity'],
  finger: ['position'],
  trike_right: ['velocity'],
  trike_left: ['velocity'],
  trike_steer: ['position'],
  car_right: ['velocity'],
  car_left: ['velocity'],
  car_steer_right: ['position'],
  car_steer_left: ['position'],
} as const;

const description = `<robot name="bench"><link name="base_link"/>
${
  Object.keys(JOINTS).map((name) =>
    `<link name="${name}_link"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="${name}" type="revolute"><parent link="base_link"/><child link="${name}_link"/><axis xyz="0 0 1"/><limit lower="-9" upper="9" velocity="99" effort="99"/></joint>`
  ).join('\n')
}
<ros2_control name="bench" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
${
  Object.entries(JOINTS).map(([name, kinds]) =>
    `<joint name="${name}">${kinds.map((kind) => `<command_interface name="${kind}"/>`).join('')}
${['position', 'velocity', 'effort'].map((kind) => `<state_interface name="${kind}"/>`).join('')}</joint>`
  ).join('\n')
}
</ros2_control></robot>
`;

const controllers = `controller_manager:
  ros__parameters:
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    spin: {type: velocity_controllers/JointGroupVelocityController}
    pull: {type: effort_controllers/JointGroupEffortController}
    plain: {type: forward_command_controller/ForwardCommandController}
    several: {type: forward_command_controller/MultiInterfaceForwardCommandController}
    finger: {type: position_controllers/GripperActionController}
    trike: {type: tricycle_steering_controller/TricycleSteeringController}
    car: {type: ackermann_steering_controller/AckermannSteeringController}
spin: {ros__parameters: {joints: [spin]}}
pull: {ros__parameters: {joints: [pull]}}
plain: {ros__parameters: {joints: [plain], interface_name: position}}
several: {ros__parameters: {joint: several, interface_names: [position, velocity]}}
finger: {ros__parameters: {joint: finger}}
trike:
  ros__parameters:
    traction_joints_names: [trike_right, trike_left]
    steering_joints_names: [trike_steer]
    open_loop: true
    wheelbase: 1.0
    traction_track_width: 0.4
    traction_wheels_radius: 0.1
car:
  ros__parameters:
    traction_joints_names: [car_right, car_left]
    steering_joints_names: [car_steer_right, car_steer_left]
    open_loop: true
    wheelbase: 1.0
    traction_track_width: 0.4
    steering_track_width: 0.4
    traction_wheels_radius: 0.1
`;
const NAMES = ['joint_state_broadcaster', 'spin', 'pull', 'plain', 'several', 'finger', 'trike', 'car'];

const launch = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('bench')
    with open(os.path.join(share, 'bench.urdf')) as file:
        description = file.read()
    spawner = Node(package='controller_manager', executable='spawner', arguments=[${NAMES.map((one) => `'${one}'`).join(', ')}])
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': description}]),
        Node(package='controller_manager', executable='ros2_control_node', parameters=[os.path.join(share, 'controllers.yaml')]),
        spawner,
        RegisterEventHandler(OnProcessExit(target_action=spawner, on_exit=[Node(package='bench', executable='checker')]))])
`;

const checker = `
import rclpy
from control_msgs.action import GripperCommand
from controller_manager_msgs.srv import SwitchController
from geometry_msgs.msg import TwistStamped
from rclpy.action import ActionClient
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray


class Checker(Node):
    def __init__(self):
        super().__init__('checker')
        self.joints = {}
        self.create_subscription(JointState, '/joint_states', self.take, 10)
        self.wheels = [self.create_publisher(TwistStamped, f'/{one}/reference', 10) for one in ('trike', 'car')]
        self.create_timer(0.05, self.drive)

    def take(self, message):
        self.joints = {name: (message.position[i], message.velocity[i], message.effort[i]) for i, name in enumerate(message.name)}

    def drive(self):
        message = TwistStamped()
        message.header.stamp = self.get_clock().now().to_msg()
        message.twist.linear.x = message.twist.angular.z = 0.5
        for one in self.wheels:
            one.publish(message)

    def until(self, joint, index, value):
        """Waits until a joint has that position, velocity or effort; prints what it has."""
        for _ in range(100):
            rclpy.spin_once(self, timeout_sec=0.1)
            found = self.joints.get(joint, (99, 99, 99))[index]
            if abs(found - value) < 1e-3:
                break
        print(f'{joint} {("position", "velocity", "effort")[index]} {found:.3f}', flush=True)

    def command(self, name, *values):
        out = self.create_publisher(Float64MultiArray, f'/{name}/commands', 1)
        while out.get_subscription_count() == 0:
            rclpy.spin_once(self, timeout_sec=0.1)
        out.publish(Float64MultiArray(data=list(values)))

    def deactivate(self, *names):
        client = self.create_client(SwitchController, '/controller_manager/switch_controller')
        client.wait_for_service()
        done = client.call_async(SwitchController.Request(deactivate_controllers=list(names), strictness=2))
        rclpy.spin_until_future_complete(self, done)
        print('deactivated', done.result().ok, flush=True)

    def grip(self, position):
        client = ActionClient(self, GripperCommand, '/finger/gripper_cmd')
        client.wait_for_server()
        goal = GripperCommand.Goal()
        goal.command.position, goal.command.max_effort = position, 5.0
        sent = client.send_goal_async(goal)
        rclpy.spin_until_future_complete(self, sent)
        done = sent.result().get_result_async()
        rclpy.spin_until_future_complete(self, done)
        result = done.result().result
        print(f'finger reached {result.reached_goal}, stalled {result.stalled}, {result.position:.3f}', flush=True)


rclpy.init()
node = Checker()
for group, values, places in (('spin', [2.5], [('spin', 1)]), ('pull', [-4.0], [('pull', 2)]), ('plain', [0.7], [('plain', 0)]),
                              ('several', [0.2, 1.5], [('several', 0), ('several', 1)])):
    node.command(group, *values)
    for (joint, index), value in zip(places, values):
        node.until(joint, index, value)
node.deactivate('spin', 'pull')
node.until('spin', 1, 0.0)
node.until('pull', 2, 0.0)
node.until('plain', 0, 0.7)
node.grip(0.03)
for joint, index, value in (('trike_right', 1, 6.0), ('trike_left', 1, 4.0), ('trike_steer', 0, 0.785),
                            ('car_right', 1, 6.0), ('car_left', 1, 4.0), ('car_steer_right', 0, 0.695), ('car_steer_left', 0, 0.896)):
    node.until(joint, index, value)
print('all is checked', flush=True)
`;

let workspace: PackWorkspace;

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('bench', {}, {
    cmake: `install(FILES bench.urdf controllers.yaml bench.launch.py DESTINATION share/\${PROJECT_NAME})
install(PROGRAMS checker DESTINATION lib/\${PROJECT_NAME})\n`,
    depends: ['rclpy', 'control_msgs', 'controller_manager', 'controller_manager_msgs', 'geometry_msgs', 'robot_state_publisher', 'ros2_controllers',
      'sensor_msgs', 'std_msgs'],
  });
  workspace.write('src/bench/bench.urdf', description);
  workspace.write('src/bench/controllers.yaml', controllers);
  workspace.write('src/bench/bench.launch.py', launch);
  workspace.write('src/bench/checker', `#!/usr/bin/env python3${checker}`);
  workspace.write('workspace.yaml', 'schema: 1\nname: bench\npackages: [src/*]\nlaunch: src/bench/bench.launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stdout + packed.stderr);
}, watchdog);
after(() => workspace.close());

test('groups, several interfaces, cars of two driven wheels and a gripper do what the formulas say', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--for', '120s', '--until', 'all is checked']);
  const said = run.stdout.split('\n').filter((line) => line.startsWith('[checker')).map((line) => line.replace(/^.*?\] /, ''));
  // A twist of 0.5 m/s and 0.5 rad/s turns on 1 m: wheels of 0.1 m on a track of 0.4 m, steered by atan(1 / (1 +- 0.2)) or atan(1).
  assert.deepEqual(said, [
    'spin velocity 2.500',
    'pull effort -4.000',
    'plain position 0.700',
    'several position 0.200',
    'several velocity 1.500',
    'deactivated True',
    'spin velocity 0.000',
    'pull effort 0.000',
    'plain position 0.700',
    'finger reached True, stalled False, 0.030',
    'trike_right velocity 6.000',
    'trike_left velocity 4.000',
    'trike_steer position 0.785',
    'car_right velocity 6.000',
    'car_left velocity 4.000',
    'car_steer_right position 0.695',
    'car_steer_left position 0.896',
    'all is checked',
  ], run.stdout + run.stderr);
});
