// A Python program that sends a robot somewhere: nav2_simple_commander with the servers of Nav2 and the loopback simulator. Headless.

// Compatibility, works: nav2_loopback_sim: a robot without physics with odometry, transforms, a lidar that sees the map, a clock, and its launch file

// Compatibility, works: nav2_simple_commander: BasicNavigator with all calls of upstream, TaskResult, PyCostmap2D,
// FootprintCollisionChecker, LineIterator

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';
import { costmap, room, said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('postman')
    params = os.path.join(share, 'params', 'nav2_params.yaml')
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_server', parameters=[{'yaml_filename': os.path.join(share, 'maps', 'room.yaml')}]),
        Node(package='nav2_controller', executable='controller_server', parameters=[params]),
        Node(package='nav2_planner', executable='planner_server', name='planner_server', parameters=[params]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation',
             parameters=[{'autostart': True, 'node_names': ['map_server', 'controller_server', 'planner_server']}]),
        Node(package='tf2_ros', executable='static_transform_publisher',
             arguments=['--x', '0.12', '--z', '0.2', '--frame-id', 'base_link', '--child-frame-id', 'base_scan']),
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('nav2_loopback_sim'), 'loopback_simulation.launch.py')),
            launch_arguments={'params_file': params}.items()),
        Node(package='postman', executable='drive'),
    ])
`;

const parameters = `
loopback_simulator:
  ros__parameters:
    base_frame_id: "base_link"
    odom_frame_id: "odom"
    map_frame_id: "map"
    scan_frame_id: "base_scan"
    update_duration: 0.02
controller_server:
  ros__parameters:
    goal_checker_plugins: ["general_goal_checker"]
    controller_plugins: ["FollowPath"]
    general_goal_checker:
      plugin: "nav2_controller::SimpleGoalChecker"
      xy_goal_tolerance: 0.1
      yaw_goal_tolerance: 0.2
    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
      desired_linear_vel: 0.5
      lookahead_dist: 0.4
      use_cost_regulated_linear_velocity_scaling: false
planner_server:
  ros__parameters:
    planner_plugins: ["GridBased"]
    GridBased:
      plugin: "nav2_navfn_planner::NavfnPlanner"
${costmap('global_costmap', 'map', '      plugins: ["static_layer", "inflation_layer"]')}
${costmap('local_costmap', 'odom', '      rolling_window: true\n      width: 3\n      height: 3\n      plugins: ["static_layer", "inflation_layer"]')}
`;

const drive = `
import math

from geometry_msgs.msg import Point32, Polygon, PoseStamped
from nav2_simple_commander.costmap_2d import PyCostmap2D
from nav2_simple_commander.footprint_collision_checker import FootprintCollisionChecker
from nav2_simple_commander.robot_navigator import BasicNavigator, TaskResult
from nav_msgs.msg import OccupancyGrid, Odometry
import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformListener


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
    heard = {}

    def hear(name, kind, topic, qos=10):
        heard[name] = []
        navigator.create_subscription(kind, topic, heard[name].append, qos)

    hear('scan', LaserScan, 'scan', qos_profile_sensor_data)
    hear('odom', Odometry, 'odom')
    hear('clock', Clock, '/clock')
    hear('map', OccupancyGrid, 'map', QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    buffer = Buffer()
    listener = TransformListener(buffer, navigator)

    def wait(seconds):
        end = navigator.get_clock().now().nanoseconds + seconds * 1e9
        while navigator.get_clock().now().nanoseconds < end:
            rclpy.spin_once(navigator, timeout_sec=0.05)

    def place():
        found = buffer.lookup_transform('map', 'base_link', rclpy.time.Time()).transform
        return found.translation.x, found.translation.y

    while navigator.initial_pose_pub.get_subscription_count() == 0:
        wait(0.1)
    navigator.setInitialPose(pose(navigator, -1.98, -1.98))
    navigator.waitUntilNav2Active(navigator='planner_server', localizer='map_server')
    wait(1.0)
    say('at %.2f %.2f' % place())
    scan = heard['scan'][-1]
    ahead = round(-scan.angle_min / scan.angle_increment)
    left = round((math.pi / 2 - scan.angle_min) / scan.angle_increment)
    say(f'rays {len(scan.ranges)}, ahead {scan.ranges[ahead]:.2f}, left {scan.ranges[left]:.2f}, behind {scan.ranges[0]}, in {scan.header.frame_id}')
    clock = heard['clock']
    wait(1.0)
    say(f'clock {9 <= sum(1 for one in clock if one.clock.sec == clock[-1].clock.sec - 1) <= 11}, odometry while it stands {len(heard["odom"])}')

    path = navigator.getPath(pose(navigator, 0.0, 0.0), pose(navigator, 2.0, -2.0, 1.57), 'GridBased')
    length = sum(math.dist((a.pose.position.x, a.pose.position.y), (b.pose.position.x, b.pose.position.y))
                 for a, b in zip(path.poses, path.poses[1:]))
    say(f'path of {length:.1f} m, result {navigator.getResult()}')
    navigator.followPath(path)
    distances = []
    while not navigator.isTaskComplete():
        if navigator.getFeedback():
            distances.append(navigator.getFeedback().distance_to_goal)
    say(f'followed: {navigator.getResult()}, feedback from {distances[0]:.1f} to less than a metre {distances[-1] < 1}')
    x, y = place()
    odometry = heard['odom'][-1]
    say(f'at the goal {math.dist((x, y), (2.0, -2.0)) < 0.15}, odometry {odometry.header.frame_id} {odometry.child_frame_id} '
        f'{math.dist((odometry.pose.pose.position.x - 1.98, odometry.pose.pose.position.y - 1.98), (x, y)) < 0.1}')

    through = navigator.getPathThroughPoses(pose(navigator, 2.0, -2.0), [pose(navigator, 2.0, 0.0), pose(navigator, 1.0, 1.0)], use_start=True)
    say(f'through poses {len(through.poses) > 50}')
    say(f'no path {navigator.getPath(pose(navigator, 0.0, 0.0), pose(navigator, 9.0, 9.0))} {navigator.status}')
    navigator.followPath(through, 'FollowPath', 'general_goal_checker')
    wait(1.0)
    navigator.cancelTask()
    while not navigator.isTaskComplete():
        pass
    say(f'cancelled: {navigator.getResult()}')
    navigator.followPath(through, 'Nobody')
    while not navigator.isTaskComplete():
        pass
    say(f'unknown controller: {navigator.getResult()} {navigator.result_future.result().result.error_code}')
    wait(1.5)
    before = place()
    navigator.setInitialPose(pose(navigator, -2.0, 2.0, math.pi / 2))
    wait(0.5)
    say('moved by hand from %d to %.2f %.2f' % (before[0] > 0, *place()))

    navigator.clearAllCostmaps()
    costs = navigator.getGlobalCostmap()
    say(f'costs {costs.metadata.size_x} x {costs.metadata.size_y} at {costs.metadata.resolution:.2f}, local {navigator.getLocalCostmap().metadata.size_x}')
    navigator.changeMap('/nowhere/nothing.yaml')

    grid = PyCostmap2D(heard['map'][-1])
    say(f'map {grid.getSizeInCellsX()} {grid.getSizeInCellsY()} {grid.getResolution():.2f} {grid.getGlobalFrameID()} {grid.getOriginX()} {grid.getOriginY()}')
    say(f'cells {grid.getCostXY(50, 10)} {grid.getCostXY(20, 10)} {grid.worldToMapValidated(0.01, -1.98)} {grid.worldToMapValidated(3.0, 0.0)}')
    say('middle %.3f %.3f, size %.3f' % (*grid.mapToWorld(50, 10), grid.getSizeInMetersX()))
    unknown = OccupancyGrid(data=[-1, 0, 100, 7])
    unknown.info.width = unknown.info.height = 2
    unknown.info.resolution = 1.0
    small = PyCostmap2D(unknown)
    small.setCost(1, 0, 254)
    say(f'unknown {small.getCostIdx(0)}, set {small.getCostXY(1, 0)}, of {small.costmap.dtype}')
    checker = FootprintCollisionChecker()
    try:
        checker.pointCost(0, 0)
    except ValueError as error:
        say(str(error))
    checker.setCostmap(grid)
    square = Polygon(points=[Point32(x=x, y=y) for x, y in ((0.2, 0.2), (-0.2, 0.2), (-0.2, -0.2), (0.2, -0.2))])
    dot = Polygon(points=[Point32(x=0.01, y=0.0), Point32(x=0.0, y=0.01)])
    say(f'footprint free {checker.footprintCostAtPose(-1.0, 0.0, 0.5, square)}, on the wall {checker.footprintCostAtPose(0.1, 0.0, 0.5, square)}, '
        f'outside {checker.footprintCostAtPose(2.4, 0.0, 0.0, square)}, in a cell {checker.footprintCostAtPose(-1.03, 0.02, 0.0, dot)}')
    navigator.lifecycleShutdown()
    say('drive is over')
    navigator.destroyNode()
    rclpy.shutdown()
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPythonPackage('postman', { drive }, ['rclpy', 'nav2_simple_commander', 'nav2_loopback_sim', 'nav2_map_server', 'nav2_lifecycle_manager',
    'tf2_ros', 'nav_msgs', 'nav2_controller', 'nav2_planner', 'tf2_ros_py', 'sensor_msgs', 'rosgraph_msgs']);
  const file = (path: string, content: string | Uint8Array): string => workspace.write(`src/postman/${path}`, content);
  const setup = workspace.read('src/postman/setup.py').toString().replace('data_files=[', `data_files=[
      ('share/postman/launch', ['launch/navigation_launch.py']), ('share/postman/params', ['params/nav2_params.yaml']),
      ('share/postman/maps', ['maps/room.yaml', 'maps/room.pgm']),`);
  file('setup.py', setup);
  file('launch/navigation_launch.py', launchFile);
  file('params/nav2_params.yaml', parameters);
  file('maps/room.pgm', room());
  file('maps/room.yaml', 'image: room.pgm\nresolution: 0.05\norigin: [-2.5, -2.5, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n');
  workspace.write('workspace.yaml', 'schema: 1\nname: postman\npackages: [src/*]\nlaunch: src/postman/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

test('a Python program drives a robot without physics through a room', watchdog, async () => {
  const run = await workspace.run(['run', 'site', '--for', '200s', '--until', 'drive is over']);
  const output = run.stdout + run.stderr;
  assert.equal(run.code, 0, output);
  assert.deepEqual(said(output, 'basic_navigator'), [
    'Publishing Initial Pose',
    'Nav2 is ready for use!',
    'at -1.98 -1.98',
    // The lidar is 0.12 m ahead of the middle of the robot. The first column of a map is not seen.
    'rays 240, ahead 1.90, left 4.45, behind inf, in base_scan',
    'clock True, odometry while it stands 0',
    'Getting path...',
    'path of 8.2 m, result TaskResult.SUCCEEDED',
    'Executing path...',
    'followed: TaskResult.SUCCEEDED, feedback from 8.2 to less than a metre True',
    'at the goal True, odometry odom base_link True',
    'Getting path...',
    'through poses True',
    'Getting path...',
    'Getting path failed with status code: 6',
    'no path None 6',
    'Executing path...',
    'Canceling current task.',
    'cancelled: TaskResult.CANCELED',
    'Executing path...',
    'unknown controller: TaskResult.FAILED 101',
    'Publishing Initial Pose',
    'moved by hand from 1 to -2.00 2.00',
    'costs 100 x 100 at 0.05, local 60',
    'Change map request failed!',
    'map 100 100 0.05 map -2.5 -2.5',
    'cells 100 0 (50, 10) (None, None)',
    'middle 0.025 -1.975, size 4.975',
    'unknown 255, set 254, of uint8',
    'Costmap not specified, use setCostmap to specify the costmap first',
    'footprint free 0.0, on the wall 100.0, outside 254, in a cell 0.0',
    'Shutting down lifecycle nodes based on lifecycle_manager.',
    'Shutting down /lifecycle_manager_navigation/manage_nodes',
    'drive is over',
  ], output);
  const simulator = said(output, 'loopback_simulator');
  for (const line of ['Laser scan will be populated using map data', 'Loopback simulator initialized', 'Received initial pose!']) {
    assert.ok(simulator.includes(line), `loopback_simulator does not say: ${line}\n${output}`);
  }
});
