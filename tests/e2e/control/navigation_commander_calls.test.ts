// The calls of nav2_simple_commander: action servers of the workspace show what each goal asks for, and refuse it; amcl is waited for.
// Headless.

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
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('postman')
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_server', parameters=[{'yaml_filename': os.path.join(share, 'maps', 'room.yaml')}]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_localization',
             parameters=[{'autostart': True, 'node_names': ['map_server', 'amcl']}]),
        Node(package='nav2_amcl', executable='amcl', parameters=[{'base_frame_id': 'base_link', 'max_beams': 30}]),
        Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--frame-id', 'base_link', '--child-frame-id', 'base_scan']),
        Node(package='nav2_loopback_sim', executable='loopback_simulator',
             parameters=[{'base_frame_id': 'base_link', 'publish_map_odom_tf': False, 'publish_clock': False, 'scan_angle_increment': 0.0}]),
        Node(package='postman', executable='servers'),
        Node(package='postman', executable='calls'),
    ])
`;

const servers = `
from nav2_msgs.action import (
    AssistedTeleop, BackUp, ComputePathToPose, DockRobot, DriveOnHeading, FollowGPSWaypoints, FollowWaypoints, NavigateThroughPoses,
    NavigateToPose, SmoothPath, Spin, UndockRobot,
)
from nav2_msgs.srv import ClearCostmapAroundPose, ClearCostmapAroundRobot, ClearCostmapExceptRegion
import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.node import Node
from rclpy.task import Future
from std_srvs.srv import SetBool


class Servers(Node):
    def __init__(self):
        super().__init__('servers')
        self.refuses = False
        self.cancelled = Future()
        self.create_service(SetBool, 'refuse', self.refuse)
        self.cleared = [
            self.create_service(kind, f'local_costmap/clear_costmap_{name}', self.clear(name))
            for name, kind in (('except_region', ClearCostmapExceptRegion), ('around_robot', ClearCostmapAroundRobot),
                               ('around_pose', ClearCostmapAroundPose))]
        kinds = {
            'navigate_to_pose': NavigateToPose, 'navigate_through_poses': NavigateThroughPoses, 'follow_waypoints': FollowWaypoints,
            'follow_gps_waypoints': FollowGPSWaypoints, 'spin': Spin, 'backup': BackUp, 'drive_on_heading': DriveOnHeading,
            'assisted_teleop': AssistedTeleop, 'dock_robot': DockRobot, 'undock_robot': UndockRobot, 'smooth_path': SmoothPath,
            'compute_path_to_pose': ComputePathToPose,
        }
        self.servers = [
            ActionServer(self, kind, name, self.work(name, kind), goal_callback=self.asked, cancel_callback=self.cancel)
            for name, kind in kinds.items()]

    def refuse(self, request, response):
        self.refuses = request.data
        response.success = True
        return response

    def clear(self, name):
        def answer(request, response):
            place = request.pose.pose.position.x if name == 'around_pose' else ''
            self.get_logger().info(f'{name}: {request.reset_distance} {place}'.rstrip())
            return response
        return answer

    def asked(self, goal):
        return GoalResponse.REJECT if self.refuses else GoalResponse.ACCEPT

    def cancel(self, handle):
        self.cancelled.set_result(True)
        return CancelResponse.ACCEPT

    def work(self, name, kind):
        async def run(handle):
            goal = handle.request
            shown = {
                'navigate_to_pose': lambda: f'{goal.pose.pose.position.x} {goal.behavior_tree}',
                'navigate_through_poses': lambda: f'{[one.pose.position.y for one in goal.poses]} {goal.behavior_tree}',
                'follow_waypoints': lambda: f'{[one.pose.position.x for one in goal.poses]}',
                'follow_gps_waypoints': lambda: f'{[one.position.latitude for one in goal.gps_poses]}',
                'spin': lambda: f'{goal.target_yaw:.2f} {goal.time_allowance.sec}',
                'backup': lambda: f'{goal.target.x} {goal.speed:.3f} {goal.time_allowance.sec}',
                'drive_on_heading': lambda: f'{goal.target.x} {goal.speed:.3f} {goal.time_allowance.sec}',
                'assisted_teleop': lambda: f'{goal.time_allowance.sec}',
                'dock_robot': lambda: f'{goal.use_dock_id} {goal.dock_id} {goal.dock_type} {goal.navigate_to_staging_pose}',
                'undock_robot': lambda: f'{goal.dock_type}',
                'smooth_path': lambda: f'{len(goal.path.poses)} {goal.smoother_id} {goal.max_smoothing_duration.sec} {goal.check_for_collisions}',
                'compute_path_to_pose': lambda: f'{goal.use_start}',
            }[name]()
            self.get_logger().info(f'{name}: {shown}'.rstrip())
            if name == 'navigate_to_pose':
                handle.publish_feedback(NavigateToPose.Feedback(distance_remaining=2.5))
                if goal.pose.pose.position.x > 90:
                    await self.cancelled
                    handle.canceled()
                    return kind.Result()
                if goal.pose.pose.position.x > 80:
                    handle.abort()
                    return kind.Result(error_code=7)
            handle.succeed()
            if name == 'smooth_path':
                return kind.Result(path=goal.path)
            return kind.Result()
        return run


def main():
    rclpy.init()
    rclpy.spin(Servers())
`;

const calls = `
import math

from geographic_msgs.msg import GeoPose
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from nav2_simple_commander.line_iterator import LineIterator
from nav2_simple_commander.robot_navigator import BasicNavigator
from nav_msgs.msg import Path
import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_srvs.srv import SetBool

AMCL_POSE_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def pose(x, y=0.0):
    result = PoseStamped()
    result.header.frame_id = 'map'
    result.pose.position.x = x
    result.pose.position.y = y
    return result


def points(*arguments):
    line = LineIterator(*arguments)
    found = []
    while line.isValid() and len(found) < 50:
        found.append((line.getX(), line.getY()))
        line.advance()
    return found


def lines(say):
    say(f'line {points(0, 0, 2, 2)} {points(0, 0, -1, 2, 0.5)} {points(1, 3, 1, 1)} {points(0, 0, 1 / 3, 0, 0.3)} {points(0, 0, 5, 5, 10)}')
    line = LineIterator(0, 0, 3, 4)
    say(f'length {line.get_line_length()} from {line.getX0()} {line.getY0()} to {line.getX1()} {line.getY1()}')
    for wrong in ((0, 0, '10', 10), (0, 0, 10, 10, -2), (2, 2, 2, 2), (0, 0, float('inf'), 0), (0, 0, 1, float('nan'))):
        try:
            LineIterator(*wrong)
        except (TypeError, ValueError) as error:
            say(f'{type(error).__name__}: {error}')


def main():
    rclpy.init()
    navigator = BasicNavigator()
    say = navigator.info
    poses = []
    lines(say)
    say(f'before any task: {navigator.isTaskComplete()} {navigator.getResult()} {navigator.getFeedback()}')
    navigator.create_subscription(PoseWithCovarianceStamped, 'amcl_pose', poses.append, AMCL_POSE_QOS)
    navigator.initial_pose = pose(-1.0, -1.0)
    navigator.waitUntilNav2Active(navigator='map_server')
    place = poses[-1].pose.pose.position
    say(f'amcl is there {math.dist((place.x, place.y), (-1.0, -1.0)) < 0.3}')
    navigator.waitUntilNav2Active(navigator='map_server', localizer='robot_localization')
    refuse = navigator.create_client(SetBool, 'refuse')
    refuse.wait_for_service()
    tasks = [
        lambda: navigator.goToPose(pose(1.5), 'tree.xml'),
        lambda: navigator.goThroughPoses([pose(0.0, 1.0), pose(0.0, 2.0)], 'trees.xml'),
        lambda: navigator.followWaypoints([pose(1.0), pose(2.0), pose(3.0)]),
        lambda: navigator.followGpsWaypoints([GeoPose()]),
        lambda: navigator.spin(),
        lambda: navigator.spin(spin_dist=-1.0, time_allowance=5),
        lambda: navigator.backup(),
        lambda: navigator.driveOnHeading(0.5, 0.1, 7),
        lambda: navigator.assistedTeleop(),
        lambda: navigator.dockRobotByID('home', False),
        lambda: navigator.dockRobotByPose(pose(3.0), 'charger'),
        lambda: navigator.undockRobot('charger'),
    ]

    def run(task):
        accepted = task()
        while accepted and not navigator.isTaskComplete():
            pass
        say(f'{accepted} {navigator.getResult()}')

    for task in tasks:
        run(task)
    say(f'feedback {navigator.getFeedback().distance_remaining}')
    smooth = navigator.smoothPath(Path(poses=[pose(1.0), pose(2.0)]), 'simple_smoother', 3.0, True)
    say(f'smooth {len(smooth.poses)}')
    navigator.clearCostmapExceptRegion(1.5)
    navigator.clearCostmapAroundRobot(2.5)
    navigator.clearCostmapAroundPose(pose(4.0), 3.5)
    run(lambda: navigator.goToPose(pose(85.0)))
    accepted = navigator.goToPose(pose(99.0))
    say(f'complete {navigator.isTaskComplete()}')
    navigator.cancelTask()
    while not navigator.isTaskComplete():
        pass
    say(f'{accepted} {navigator.getResult()}')
    rclpy.spin_until_future_complete(navigator, refuse.call_async(SetBool.Request(data=True)))
    for task in tasks:
        run(task)
    say(f'{navigator.smoothPath(Path())} {navigator.getPath(pose(0.0), pose(1.0))}')
    navigator.lifecycleStartup()
    navigator.destroy_node()
    print('calls are over', flush=True)
    rclpy.shutdown()
`;

const goals = [
  'navigate_to_pose: 1.5 tree.xml',
  'navigate_through_poses: [1.0, 2.0] trees.xml',
  'follow_waypoints: [1.0, 2.0, 3.0]',
  'follow_gps_waypoints: [0.0]',
  'spin: 1.57 10',
  'spin: -1.00 5',
  'backup: 0.15 0.025 10',
  'drive_on_heading: 0.5 0.100 7',
  'assisted_teleop: 30',
  'dock_robot: True home  False',
  'dock_robot: False  charger True',
  'undock_robot: charger',
  'smooth_path: 2 simple_smoother 3 True',
  'except_region: 1.5',
  'around_robot: 2.5',
  'around_pose: 3.5 4.0',
  'navigate_to_pose: 85.0',
  'navigate_to_pose: 99.0',
];

/** The text of each task, and of its refusal. */
const texts: readonly (readonly [begin: readonly string[], refusal: string])[] = [
  [['Navigating to goal: 1.5 0.0...'], 'Goal to 1.5 0.0 was rejected!'],
  [['Navigating with 2 goals....'], 'Goal with 2 poses was rejected!'],
  [['Following 3 goals....'], 'Following 3 waypoints request was rejected!'],
  [['Following 1 gps goals....'], 'Following 1 gps waypoints request was rejected!'],
  [['Spinning to angle 1.57....'], 'Spin request was rejected!'],
  [['Spinning to angle -1.0....'], 'Spin request was rejected!'],
  [['Backing up 0.15 m at 0.025 m/s....'], 'Backup request was rejected!'],
  [['Drive 0.5 m on heading at 0.1 m/s....'], 'Drive On Heading request was rejected!'],
  [["Running 'assisted_teleop'...."], 'Assisted Teleop request was rejected!'],
  [["Waiting for 'DockRobot' action server", 'Docking at dock ID: home...'], 'Docking request was rejected!'],
  [["Waiting for 'DockRobot' action server", 'Docking at pose: ...'], 'Docking request was rejected!'],
  [["Waiting for 'UndockRobot' action server", 'Undocking from dock of type: charger...'], 'Undocking request was rejected!'],
];

const answers = [
  'line [(0, 0), (1.0, 1.0), (2, 2.0)] [(0, 0), (-0.5, 1.0), (-1, 2.0)] [(1, 3), (1, 2.0), (1, 1)] [(0, 0), (0.3, 0.0), (0.3333333333333333, 0.0)] '
  + '[(0, 0), (5, 5.0)]',
  'length 5.0 from 0 0 to 3 4',
  'TypeError: x1 must be a number (int or float)',
  'ValueError: step_size must be a positive number',
  'ValueError: Line has zero length (All 4 points have same coordinates)',
  'ValueError: x1 must be finite',
  'ValueError: y1 must be finite',
  'before any task: True TaskResult.UNKNOWN None',
  'Nav2 is ready for use!',
  'amcl is there True',
  'Nav2 is ready for use!',
  ...texts.flatMap(([begin]) => [...begin, 'True TaskResult.SUCCEEDED']),
  'feedback 2.5',
  'Smoothing path...',
  'smooth 2',
  'Navigating to goal: 85.0 0.0...',
  'True TaskResult.FAILED',
  'Navigating to goal: 99.0 0.0...',
  'complete False',
  'Canceling current task.',
  'True TaskResult.CANCELED',
  ...texts.flatMap(([begin, refusal]) => [...begin, refusal, 'False TaskResult.CANCELED']),
  'Smoothing path...',
  'Smooth path was rejected!',
  'Getting path failed with status code: 5',
  'Getting path...',
  'Get path was rejected!',
  'Getting path failed with status code: 5',
  'None None',
  'Starting up lifecycle nodes based on lifecycle_manager.',
  'Starting up /lifecycle_manager_localization/manage_nodes',
  'Nav2 is ready for use!',
];

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPythonPackage('postman', { servers, calls }, ['rclpy', 'nav2_simple_commander', 'nav2_loopback_sim', 'nav2_map_server', 'nav2_lifecycle_manager',
    'tf2_ros', 'nav_msgs', 'nav2_amcl', 'nav2_msgs', 'geographic_msgs', 'std_srvs']);
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/postman/${path}`, content);
  const setup = workspace.read('src/postman/setup.py').toString().replace('data_files=[', `data_files=[
      ('share/postman/launch', ['launch/navigation_launch.py']), ('share/postman/maps', ['maps/room.yaml', 'maps/room.pgm']),`);
  file('setup.py', setup);
  file('launch/navigation_launch.py', launchFile);
  file('maps/room.pgm', room());
  file('maps/room.yaml', 'image: room.pgm\nresolution: 0.05\norigin: [-2.5, -2.5, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n');
  workspace.write('workspace.yaml', 'schema: 1\nname: postman\npackages: [src/*]\nlaunch: src/postman/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared', 'port')) {
  test(`${link}: each call sends its goal, and says how it ends`, watchdog, async () => {
    const stepped = link === 'shared' ? ['--stepped', '--seed', '5'] : [];
    const run = await workspace.run(['run', 'site', '--link', link, ...stepped, '--for', '200s', '--until', 'calls are over']);
    const output = run.stdout + run.stderr;
    assert.equal(run.code, 0, output);
    const lines = said(output, 'basic_navigator').map((line) => line.replace(/(Docking at pose: ).*frame_id='map'.*x=3\.0.*\.\.\./, '$1...'));
    // How often it repeats the pose depends on the time that amcl takes.
    const repeated = ['Setting initial pose', 'Publishing Initial Pose', 'Waiting for amcl_pose to be received'];
    for (const line of repeated) assert.ok(lines.includes(line), `basic_navigator does not say: ${line}\n${output}`);
    assert.deepEqual(lines.filter((line) => !repeated.includes(line)), answers, output);
    assert.ok(said(output, 'loopback_simulator').includes('scan_angle_increment must be greater than 0, 0.0261 is used'), output);
    assert.deepEqual(said(output, 'servers'), goals, output);
  });
}
