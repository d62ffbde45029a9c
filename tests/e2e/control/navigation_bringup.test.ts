// nav2_bringup with its own parameters: a launch file of a lab includes bringup_launch.py beside the loopback simulator, AMCL finds the robot,
// and a Python program sends it around by BasicNavigator. All servers of Nav2 run at once. Headless.

// Compatibility, works: nav2_bringup: `bringup_launch.py`, `localization_launch.py`, `navigation_launch.py` and `nav2_params.yaml`, with
// AMCL and the loopback simulator, for programs that use BasicNavigator

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { room, said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('house_lab')
    bringup = os.path.join(get_package_share_directory('nav2_bringup'), 'launch')
    return LaunchDescription([
        DeclareLaunchArgument('map', default_value=os.path.join(share, 'maps', 'room.yaml')),
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(bringup, 'bringup_launch.py')),
            launch_arguments={'map': LaunchConfiguration('map')}.items()),
        Node(package='nav2_loopback_sim', executable='loopback_simulator', name='loopback_simulator', output='screen',
             parameters=[os.path.join(get_package_share_directory('nav2_bringup'), 'params', 'nav2_params.yaml'), {'publish_map_odom_tf': False}]),
        Node(package='tf2_ros', executable='static_transform_publisher',
             arguments=['--z', '0.01', '--frame-id', 'base_footprint', '--child-frame-id', 'base_link']),
        Node(package='tf2_ros', executable='static_transform_publisher',
             arguments=['--z', '0.2', '--frame-id', 'base_link', '--child-frame-id', 'base_scan']),
        Node(package='house_lab', executable='tour', output='screen'),
    ])
`;

const tour = `
import math

from geometry_msgs.msg import PoseStamped, Twist
from nav2_simple_commander.robot_navigator import BasicNavigator, TaskResult
from nav_msgs.msg import Odometry
import rclpy


def pose(navigator, x, y, yaw=0.0):
    result = PoseStamped()
    result.header.frame_id = 'map'
    result.header.stamp = navigator.get_clock().now().to_msg()
    result.pose.position.x = x
    result.pose.position.y = y
    result.pose.orientation.z = math.sin(yaw / 2)
    result.pose.orientation.w = math.cos(yaw / 2)
    return result


def main():
    rclpy.init()
    navigator = BasicNavigator()
    say = navigator.info
    # The odometry of the simulator begins where the initial pose is.
    start = (-2.0, -3.0)
    place = [0.0, 0.0, 0.0]
    speeds = []

    def take_odometry(message):
        place[:] = [start[0] + message.pose.pose.position.x, start[1] + message.pose.pose.position.y,
                    2 * math.atan2(message.pose.pose.orientation.z, message.pose.pose.orientation.w)]

    navigator.create_subscription(Odometry, 'odom', take_odometry, 10)
    navigator.create_subscription(Twist, 'cmd_vel', lambda message: speeds.append(message.linear.x), 10)

    def distance(x, y):
        return math.hypot(place[0] - x, place[1] - y)

    def finish(what, stop_after=None):
        began = navigator.get_clock().now()
        distances = []
        while not navigator.isTaskComplete():
            feedback = navigator.getFeedback()
            if hasattr(feedback, 'distance_remaining') and feedback.distance_remaining > 0:
                distances.append(feedback.distance_remaining)
            passed = (navigator.get_clock().now() - began).nanoseconds / 1e9
            if stop_after is not None and passed > stop_after:
                navigator.cancelTask()
                stop_after = None
        seconds = (navigator.get_clock().now() - began).nanoseconds / 1e9
        say(f'{what}: {navigator.getResult().name}')
        return distances, seconds

    while navigator.count_subscribers('initialpose') < 2:
        rclpy.spin_once(navigator, timeout_sec=0.1)
    navigator.setInitialPose(pose(navigator, *start))
    navigator.waitUntilNav2Active()

    navigator.goToPose(pose(navigator, -2.0, 1.0, 1.57))
    distances, seconds = finish('ahead')
    say(f'at the goal {distance(-2.0, 1.0) < 0.35}, turned {abs(place[2] - 1.57) < 0.35}, in 30 s {seconds < 30}, '
        f'nearer {bool(distances) and distances[0] > 3.5 and distances[-1] < 1.0}')
    say(f'at most 0.5 m/s {max(speeds) < 0.501}, in steps {all(b - a < 0.13 for a, b in zip(speeds, speeds[1:]))}')

    path = navigator.getPath(pose(navigator, 2.0, -3.0), pose(navigator, -3.0, 3.0))
    say(f'path {len(path.poses) > 20}')
    smooth = navigator.smoothPath(path)
    say(f'smoothed {len(smooth.poses) == len(path.poses)}')

    navigator.goToPose(pose(navigator, 3.0, 3.0, 1.57))
    finish('cancelled', stop_after=2.0)
    began = navigator.get_clock().now()
    while (navigator.get_clock().now() - began).nanoseconds < 5e8:
        rclpy.spin_once(navigator, timeout_sec=0.05)
    say(f'stands {abs(speeds[-1]) < 1e-9}')

    navigator.spin(spin_dist=0.5, time_allowance=10)
    finish('spin')
    navigator.backup(backup_dist=0.2, backup_speed=0.1, time_allowance=10)
    finish('backup')
    navigator.followWaypoints([pose(navigator, -1.5, 2.8, 0.78), pose(navigator, 0.0, 3.5)])
    finish('waypoints')
    say(f'at the last {distance(0.0, 3.5) < 0.35}')
    navigator.clearAllCostmaps()
    navigator.goThroughPoses([pose(navigator, 1.5, 3.0, -0.78), pose(navigator, 2.0, 1.5, -1.57)])
    finish('through')
    say(f'at the last {distance(2.0, 1.5) < 0.35}')
    say('tour is over')
    rclpy.shutdown()


if __name__ == '__main__':
    main()
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/house_lab/${path}`, content);
  const needs = ['geometry_msgs', 'nav2_bringup', 'nav2_lifecycle_manager', 'nav2_loopback_sim', 'nav2_map_server', 'nav2_simple_commander', 'nav_msgs',
    'rclpy', 'tf2_ros'];
  file('package.xml', `<?xml version="1.0"?>
<package format="3">
  <name>house_lab</name>
  <version>1.0.0</version>
  <description>A lab</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
${needs.map((name) => `  <exec_depend>${name}</exec_depend>`).join('\n')}
  <export><build_type>ament_python</build_type></export>
</package>
`);
  file('setup.py', `
from glob import glob

from setuptools import setup

setup(name='house_lab', version='1.0.0', packages=['house_lab'],
      data_files=[('share/ament_index/resource_index/packages', ['resource/house_lab']), ('share/house_lab', ['package.xml']),
                  ('share/house_lab/launch', glob('launch/*')), ('share/house_lab/maps', glob('maps/*'))],
      entry_points={'console_scripts': ['tour = house_lab.tour:main']})
`);
  file('setup.cfg', '[develop]\nscript_dir=$base/lib/house_lab\n[install]\ninstall_scripts=$base/lib/house_lab\n');
  file('resource/house_lab', '');
  file('house_lab/__init__.py', '');
  file('house_lab/tour.py', tour);
  file('launch/lab.launch.py', launchFile);
  file('maps/room.pgm', room());
  file('maps/room.yaml', 'image: room.pgm\nresolution: 0.1\norigin: [-5.0, -5.0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n');
  workspace.write('workspace.yaml', 'schema: 1\nname: lab\npackages: [src/*]\nlaunch: src/house_lab/launch/lab.launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared')) {
  test(`${link}: a robot is sent around with the parameters of nav2_bringup`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '200s', '--until', 'tour is over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const lines = said(output, 'basic_navigator');
    assert.ok(lines.includes('Nav2 is ready for use!'), output);
    const results = lines.filter((line) =>
      /^(ahead|at the goal|at most|path|smoothed|cancelled|stands|spin|backup|waypoints|at the last|through|tour)\b/.test(line)
    );
    assert.deepEqual(results, [
      'ahead: SUCCEEDED',
      'at the goal True, turned True, in 30 s True, nearer True',
      'at most 0.5 m/s True, in steps True',
      'path True',
      'smoothed True',
      'cancelled: CANCELED',
      'stands True',
      'spin: SUCCEEDED',
      'backup: SUCCEEDED',
      'waypoints: SUCCEEDED',
      'at the last True',
      'through: SUCCEEDED',
      'at the last True',
      'tour is over',
    ], output);
  });
}
