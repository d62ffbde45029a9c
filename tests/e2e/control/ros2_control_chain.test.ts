// A chain: diff_drive_controller over the PIDs of its wheels. A node in Python switches it on and off by the rules of the manager,
// and drives; headless.

// Compatibility, works: ros2_control: chains of controllers: switches of a whole chain, refusals of a part, chained mode, references of the
// controller below

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const SIDES = ['left', 'right'] as const;

const description = `<robot name="base"><link name="base_link"/>
${
  SIDES.map((side) =>
    `<link name="${side}_link"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="${side}" type="continuous"><parent link="base_link"/><child link="${side}_link"/><axis xyz="0 1 0"/></joint>`
  ).join('\n')
}
<ros2_control name="base" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
${
  SIDES.map((side) => `<joint name="${side}"><command_interface name="velocity"/><state_interface name="position"/><state_interface name="velocity"/></joint>`)
    .join('\n')
}
</ros2_control></robot>
`;
const controllers = `controller_manager:
  ros__parameters:
    joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}
    pid_left: {type: pid_controller/PidController}
    pid_right: {type: pid_controller/PidController}
    base: {type: diff_drive_controller/DiffDriveController}
${
  SIDES.map((side) =>
    `pid_${side}:
  ros__parameters:
    dof_names: [${side}]
    command_interface: velocity
    reference_and_state_interfaces: [velocity]
    enable_feedforward: true
    gains: {${side}: {p: 0.0, feedforward_gain: 1.0}}
`
  ).join('')
}base:
  ros__parameters:
    left_wheel_names: [pid_left/left]
    right_wheel_names: [pid_right/right]
    wheel_separation: 0.4
    wheel_radius: 0.1
    open_loop: true
    position_feedback: false
`;
const launch = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('chain')
    with open(os.path.join(share, 'base.urdf')) as file:
        description = file.read()
    spawners = [Node(package='controller_manager', executable='spawner', arguments=['joint_state_broadcaster']),
                Node(package='controller_manager', executable='spawner', arguments=['pid_left', 'pid_right', 'base', '--inactive'])]
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': description}]),
        Node(package='controller_manager', executable='ros2_control_node', parameters=[os.path.join(share, 'controllers.yaml')]),
        spawners[0], RegisterEventHandler(OnProcessExit(target_action=spawners[0], on_exit=[spawners[1]])),
        RegisterEventHandler(OnProcessExit(target_action=spawners[1], on_exit=[Node(package='chain', executable='checker')]))])
`;
const checker = `
import time

import rclpy
from controller_manager_msgs.srv import ListControllers, SwitchController
from geometry_msgs.msg import TwistStamped
from rclpy.node import Node
from sensor_msgs.msg import JointState

CHAIN = ['base', 'pid_left', 'pid_right']


class Checker(Node):
    def __init__(self):
        super().__init__('checker')
        self.speeds = {}
        self.create_subscription(JointState, '/joint_states', lambda one: self.speeds.update(zip(one.name, one.velocity)), 10)
        self.out = self.create_publisher(TwistStamped, '/base/cmd_vel', 10)
        self.create_timer(0.05, self.drive)

    def drive(self):
        message = TwistStamped()
        message.header.stamp = self.get_clock().now().to_msg()
        message.twist.linear.x, message.twist.angular.z = 0.5, 0.5
        self.out.publish(message)

    def ask(self, kind, name, request):
        client = self.create_client(kind, '/controller_manager/' + name)
        client.wait_for_service()
        done = client.call_async(request)
        rclpy.spin_until_future_complete(self, done)
        return done.result()

    def switch(self, on=(), off=()):
        request = SwitchController.Request(activate_controllers=list(on), deactivate_controllers=list(off), strictness=2)
        print('on', list(on), 'off', list(off), self.ask(SwitchController, 'switch_controller', request).ok, flush=True)

    def states(self):
        found = {one.name: one for one in self.ask(ListControllers, 'list_controllers', ListControllers.Request()).controller}
        print(*[f'{name} {found[name].state} {found[name].is_chained}' for name in CHAIN], sep=', ', flush=True)

    def wheels(self, left, right):
        end = time.monotonic() + 20.0
        while time.monotonic() < end:
            rclpy.spin_once(self, timeout_sec=0.1)
            if abs(self.speeds.get('left', 99) - left) < 1e-3 and abs(self.speeds.get('right', 99) - right) < 1e-3:
                break
        print(f'wheels {self.speeds["left"]:.2f} {self.speeds["right"]:.2f}', flush=True)


rclpy.init()
node = Checker()
node.states()
node.switch(on=['base'])
node.switch(on=CHAIN)
node.states()
node.wheels(4.0, 6.0)
node.switch(off=['pid_left'])
node.states()
node.switch(off=CHAIN)
node.states()
print('all is checked', flush=True)
`;

let workspace: PackWorkspace;

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('chain', {}, {
    cmake: `install(FILES base.urdf controllers.yaml chain.launch.py DESTINATION share/\${PROJECT_NAME})
install(PROGRAMS checker DESTINATION lib/\${PROJECT_NAME})\n`,
    depends: ['rclpy', 'controller_manager', 'controller_manager_msgs', 'geometry_msgs', 'robot_state_publisher', 'ros2_controllers', 'sensor_msgs'],
  });
  workspace.write('src/chain/base.urdf', description);
  workspace.write('src/chain/controllers.yaml', controllers);
  workspace.write('src/chain/chain.launch.py', launch);
  workspace.write('src/chain/checker', `#!/usr/bin/env python3${checker}`);
  workspace.write('workspace.yaml', 'schema: 1\nname: chain\npackages: [src/*]\nlaunch: src/chain/chain.launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stdout + packed.stderr);
}, watchdog);
after(() => workspace.close());

test('a chain is switched as a whole, and drives', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--for', '60s', '--until', 'all is checked']);
  const said = run.stdout.split('\n').filter((line) => line.startsWith('[checker')).map((line) => line.replace(/^.*?\] /, ''));
  const chain = "['base', 'pid_left', 'pid_right']";
  const inactive = 'base inactive False, pid_left inactive False, pid_right inactive False';
  const active = 'base active False, pid_left active True, pid_right active True';
  // 0.5 m/s and 0.5 rad/s: (0.5 -+ 0.5 * 0.2) / 0.1.
  assert.deepEqual(said, [
    inactive,
    "on ['base'] off [] False",
    `on ${chain} off [] True`,
    active,
    'wheels 4.00 6.00',
    "on [] off ['pid_left'] False",
    active,
    `on [] off ${chain} True`,
    inactive,
    'all is checked',
  ], run.stdout + run.stderr);
});
