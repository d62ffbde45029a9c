// The waypoint follower of Nav2: tours, loops, waypoints that are missed, and tasks at waypoints, its own and one of the workspace.
// Navigation itself is an action server of the workspace, which succeeds, fails, refuses or takes its time. Headless.

// Compatibility, works: Nav2's `waypoint_follower`: `follow_waypoints`, `follow_gps_waypoints` by `fromLL`, loops, missed waypoints with
// their error codes, preemption and cancellation, as a program and a component; WaitAtWaypoint, InputAtWaypoint, PhotoAtWaypoint and tasks of the workspace

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { said } from '../support/room_robot.ts';

const watchdog = { timeout: 500_000 };

const launchFile = `
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    params = os.path.join(get_package_share_directory('mail_tasks'), 'params', 'nav2_params.yaml')
    names = ['', 'asking', 'photos', 'own', 'lonely']

    def follower(name):
        return Node(package='nav2_waypoint_follower', executable='waypoint_follower', name='waypoint_follower', namespace=name, parameters=[params])

    return LaunchDescription([
        *[follower(name) for name in names[:-1]],
        ComposableNodeContainer(name='box', namespace='', package='rclcpp_components', executable='component_container',
                                composable_node_descriptions=[ComposableNode(
                                    package='nav2_waypoint_follower', plugin='nav2_waypoint_follower::WaypointFollower',
                                    name='waypoint_follower', namespace=names[-1])]),
        follower('broken'),
        follower('tiff'),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation', parameters=[{
            'autostart': True, 'bond_timeout': 0.0, 'node_names': [f'{name}/waypoint_follower'.strip('/') for name in names]}]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_broken', parameters=[{
            'autostart': True, 'bond_timeout': 0.0, 'node_names': ['broken/waypoint_follower']}]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_tiff', parameters=[{
            'autostart': True, 'bond_timeout': 0.0, 'node_names': ['tiff/waypoint_follower']}]),
        Node(package='mail', executable='navigation'),
        Node(package='mail', executable='driver'),
    ])
`;

const parameters = `
waypoint_follower:
  ros__parameters:
    loop_rate: 20
    stop_on_failure: true
    waypoint_task_executor_plugin: "wait_at_waypoint"
    wait_at_waypoint:
      plugin: "nav2_waypoint_follower::WaitAtWaypoint"
      enabled: true
      waypoint_pause_duration: 200
asking:
  waypoint_follower:
    ros__parameters:
      stop_on_failure: false
      waypoint_task_executor_plugin: "ask"
      ask:
        plugin: "nav2_waypoint_follower::InputAtWaypoint"
        timeout: 0.75
        input_topic: "/button"
photos:
  waypoint_follower:
    ros__parameters:
      stop_on_failure: true
      waypoint_task_executor_plugin: "photo"
      photo:
        plugin: "nav2_waypoint_follower::PhotoAtWaypoint"
        image_topic: "/camera"
        save_dir: "/tmp/pictures"
own:
  waypoint_follower:
    ros__parameters:
      stop_on_failure: true
      waypoint_task_executor_plugin: "stamp"
      stamp:
        plugin: "mail_tasks::Stamp"
        ink: 1
broken:
  waypoint_follower:
    ros__parameters:
      waypoint_task_executor_plugin: "paint"
      paint:
        plugin: "mail_tasks::Paint"
tiff:
  waypoint_follower:
    ros__parameters:
      waypoint_task_executor_plugin: "photo"
      photo:
        plugin: "nav2_waypoint_follower::PhotoAtWaypoint"
        image_format: "tiff"
`;

const tasks = `
#include "nav2_core/waypoint_task_executor.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace mail_tasks {

/// Stamps as often as there is ink.
class Stamp : public nav2_core::WaypointTaskExecutor {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, const std::string& plugin_name) override {
    const auto node = parent.lock();
    logger_ = node->get_logger();
    ink_ = node->declare_parameter<int>(plugin_name + ".ink", 0);
  }
  bool processAtWaypoint(const geometry_msgs::msg::PoseStamped& pose, const int& index) override {
    RCLCPP_INFO(logger_, "stamping %d at %.1f", index, pose.pose.position.x);
    return ink_-- > 0;
  }

 private:
  rclcpp::Logger logger_ = rclcpp::get_logger("stamp");
  int ink_ = 0;
};

}  // namespace mail_tasks
PLUGINLIB_EXPORT_CLASS(mail_tasks::Stamp, nav2_core::WaypointTaskExecutor)
`;

const xml = `<library path="mail_tasks">
  <class type="mail_tasks::Stamp" base_class_type="nav2_core::WaypointTaskExecutor"><description>a stamp</description></class>
</library>
`;

const navigation = `
from nav2_msgs.action import NavigateToPose
import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.node import Node
from rclpy.task import Future
from robot_localization.srv import FromLL


class Navigation(Node):
    """By x: 50 cannot be reached, 60 is refused, 70 takes until it is cancelled or another goal comes; else the robot is there."""

    def __init__(self):
        super().__init__('navigation')
        self.waiting = None
        self.create_service(FromLL, '/fromLL', self.convert)
        self.servers = [
            ActionServer(self, NavigateToPose, f'{space}/navigate_to_pose', self.drive, goal_callback=self.asked, cancel_callback=self.cancel)
            for space in ('', '/asking', '/photos', '/own')]

    def convert(self, request, response):
        response.map_point.x = (request.ll_point.longitude - 8.0) * 1000
        response.map_point.y = (request.ll_point.latitude - 47.0) * 1000
        return response

    def asked(self, goal):
        self.wake()
        return GoalResponse.REJECT if goal.pose.pose.position.x == 60 else GoalResponse.ACCEPT

    def cancel(self, handle):
        self.wake()
        return CancelResponse.ACCEPT

    def wake(self):
        if self.waiting is not None:
            self.waiting.set_result(True)
            self.waiting = None

    async def drive(self, handle):
        pose = handle.request.pose
        x = pose.pose.position.x
        self.get_logger().info(f'to {x:.0f} {pose.pose.position.y:.0f} {pose.pose.orientation.w:.1f} in {pose.header.frame_id}')
        if x == 70:
            self.waiting = Future()
            await self.waiting
            if handle.is_cancel_requested:
                self.get_logger().info('cancelled')
                handle.canceled()
            else:
                handle.abort()
        elif x == 50:
            handle.abort()
            return NavigateToPose.Result(error_code=204)
        else:
            handle.succeed()
        return NavigateToPose.Result()


def main():
    rclpy.init()
    rclpy.spin(Navigation())
`;

const driver = `
import time

from geographic_msgs.msg import GeoPose
from geometry_msgs.msg import PoseStamped
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
from nav2_msgs.action import FollowGPSWaypoints, FollowWaypoints
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import SetParameters
import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from sensor_msgs.msg import Image
from std_msgs.msg import Empty


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.followers = {space: ActionClient(self, FollowWaypoints, f'{space}/follow_waypoints') for space in ('', '/asking', '/photos', '/own', '/lonely')}
        self.gps = ActionClient(self, FollowGPSWaypoints, 'follow_gps_waypoints')
        self.settings = self.create_client(SetParameters, '/waypoint_follower/set_parameters')
        self.button = self.create_publisher(Empty, '/button', 1)
        self.camera = self.create_publisher(Image, '/camera', 1)
        self.indices = []

    def say(self, text):
        self.get_logger().info(text)

    def wait(self, future):
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def sent(self, client, goal):
        self.indices = []

        def feedback(message):
            index = message.feedback.current_waypoint
            if self.indices[-1:] != [index]:
                self.indices.append(index)

        return self.wait(client.send_goal_async(goal, feedback))

    def tell(self, what, handle):
        answer = self.wait(handle.get_result_async())
        missed = [(one.index, one.goal.pose.position.x, one.error_code) for one in answer.result.missed_waypoints]
        self.say(f'{what}: status {answer.status} missed {missed} error {answer.result.error_code} visited {self.indices}')

    def follow(self, what, places, space='', **options):
        goal = FollowWaypoints.Goal(poses=[pose(x) for x in places], **options)
        self.tell(what, self.sent(self.followers[space], goal))

    def set(self, name, value):
        kind = ParameterType.PARAMETER_BOOL if isinstance(value, bool) else ParameterType.PARAMETER_INTEGER
        field = 'bool_value' if isinstance(value, bool) else 'integer_value'
        request = SetParameters.Request(parameters=[Parameter(name=name, value=ParameterValue(type=kind, **{field: value}))])
        result = self.wait(self.settings.call_async(request)).results[0]
        self.say(f'{name}: {result.successful} {result.reason}'.rstrip())

    def deactivate(self, space):
        change = self.create_client(ChangeState, f'{space}/waypoint_follower/change_state')
        change.wait_for_service()
        request = ChangeState.Request()
        request.transition.id = Transition.TRANSITION_DEACTIVATE
        self.say(f'deactivated {self.wait(change.call_async(request)).success}')

    def pause(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            rclpy.spin_once(self, timeout_sec=0.02)


def pose(x):
    result = PoseStamped()
    result.header.frame_id = 'map'
    result.pose.position.x = float(x)
    return result


def main():
    rclpy.init()
    driver = Driver()
    # A server accepts goals once it is active.
    for space, client in driver.followers.items():
        client.wait_for_server()
        while not driver.sent(client, FollowWaypoints.Goal(poses=[])).accepted:
            driver.pause(0.1)
    driver.pause(0.5)
    begin = time.monotonic()
    driver.follow('three', [1, 2, 3])
    driver.say(f'pauses {time.monotonic() - begin >= 0.6}')
    driver.follow('two loops', [1, 2], number_of_loops=1)
    driver.follow('from the second', [1, 2, 3], goal_index=1)
    driver.follow('from nowhere', [1, 2, 3], goal_index=3)
    driver.follow('none', [])
    driver.follow('stopped', [1, 50, 3])
    driver.follow('refused', [60, 3])
    driver.set('stop_on_failure', False)
    driver.set('loop_rate', 0)
    driver.set('loop_rate', 4294967346)
    driver.set('loop_rate', 50)
    driver.follow('went on', [1, 50, 3, 60, 5])

    handle = driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[pose(1), pose(70)]))
    while driver.indices[-1:] != [1]:
        driver.pause(0.05)
    driver.pause(0.3)
    driver.wait(handle.cancel_goal_async())
    driver.tell('cancelled', handle)

    first = driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[pose(70), pose(2)]))
    driver.pause(0.5)
    second = driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[pose(8), pose(9)]))
    driver.say(f'preempted: status {driver.wait(first.get_result_async()).status}')
    driver.tell('second', second)
    # Missed waypoints belong to the goal that they are part of.
    first = driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[pose(50), pose(70)]))
    while driver.indices[-1:] != [1]:
        driver.pause(0.05)
    driver.pause(0.3)
    second = driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[pose(8)]))
    driver.tell('after a miss', second)
    # A goal that cannot be used ends the one before, and its navigation.
    first = driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[pose(70)]))
    driver.pause(0.5)
    driver.tell('none, later', driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[])))
    driver.pause(0.3)
    driver.say('nothing is followed')

    place = GeoPose()
    place.position.latitude = 47.004
    place.position.longitude = 8.003
    place.orientation.w = 0.5
    driver.tell('on the globe', driver.sent(driver.gps, FollowGPSWaypoints.Goal(gps_poses=[place])))
    first = driver.sent(driver.followers[''], FollowWaypoints.Goal(poses=[pose(70)]))
    driver.pause(0.5)
    driver.tell('on the globe, too', driver.sent(driver.gps, FollowGPSWaypoints.Goal(gps_poses=[place])))
    driver.wait(first.cancel_goal_async())
    driver.tell('alone', first)

    goal = FollowWaypoints.Goal(poses=[pose(1), pose(2)])
    handle = driver.sent(driver.followers['/asking'], goal)
    while driver.indices[-1:] != [1]:
        driver.button.publish(Empty())
        driver.pause(0.05)
    driver.tell('asked', handle)

    driver.follow('no picture', [1], '/photos')
    driver.camera.publish(Image(width=2, height=1, step=6, encoding='bgr8', data=bytes([1, 2, 3, 4, 5, 6])))
    driver.pause(0.3)
    driver.follow('picture', [1], '/photos')
    driver.follow('stamps', [4, 5, 6], '/own')
    # There is nobody who navigates.
    handle = driver.sent(driver.followers['/lonely'], FollowWaypoints.Goal(poses=[pose(1)]))
    driver.pause(0.3)
    driver.wait(handle.cancel_goal_async())
    driver.tell('given up', handle)
    handle = driver.sent(driver.followers['/lonely'], FollowWaypoints.Goal(poses=[pose(1)]))
    driver.pause(0.3)
    driver.deactivate('/lonely')
    driver.tell('stopped by its manager', handle)
    handle = driver.sent(driver.followers['/own'], FollowWaypoints.Goal(poses=[pose(70)]))
    driver.pause(0.5)
    driver.deactivate('/own')
    driver.tell('stopped on its way', handle)
    driver.say(f'accepted by an inactive server: {driver.sent(driver.followers["/lonely"], FollowWaypoints.Goal(poses=[pose(1)])).accepted}')
    driver.say('driver is over')
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  const libraries = ['nav2_core', 'pluginlib', 'rclcpp', 'rclcpp_lifecycle'];
  workspace.addPackage('mail_tasks', {}, {
    depends: [...libraries, 'nav2_waypoint_follower', 'nav2_lifecycle_manager'],
    cmake: `${libraries.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
add_library(mail_tasks SHARED src/tasks.cpp)
ament_target_dependencies(mail_tasks ${libraries.join(' ')})
pluginlib_export_plugin_description_file(nav2_waypoint_follower plugins.xml)
install(TARGETS mail_tasks DESTINATION lib)
install(DIRECTORY launch params DESTINATION share/\${PROJECT_NAME})
`,
  });
  workspace.write('src/mail_tasks/src/tasks.cpp', tasks);
  workspace.write('src/mail_tasks/plugins.xml', xml);
  workspace.write('src/mail_tasks/launch/navigation_launch.py', launchFile);
  workspace.write('src/mail_tasks/params/nav2_params.yaml', parameters);
  workspace.addPythonPackage('mail', { navigation, driver }, ['rclpy', 'nav2_msgs', 'geographic_msgs', 'geometry_msgs', 'robot_localization', 'rcl_interfaces',
    'sensor_msgs', 'std_msgs', 'mail_tasks']);
  workspace.write('workspace.yaml', 'schema: 1\nname: mail\npackages: [src/*]\nlaunch: src/mail_tasks/launch/navigation_launch.py\n');
  const packed = await workspace.run(['pack', '--quick']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared')) {
  test(`${link}: waypoints are visited, missed ones have their codes, and tasks are done`, watchdog, async () => {
    const kept = mkdtempSync(join(tmpdir(), 'ros2wasm-photos-'));
    try {
      const run = await workspace.run(['run', 'site', '--link', link, '--bags', kept, '--for', '120s', '--until', 'driver is over']);
      const output = run.stdout + run.stderr;
      assert.equal(run.code, 0, output);
      assert.deepEqual(said(output, 'driver'), [
        'three: status 4 missed [] error 0 visited [0, 1, 2]',
        'pauses True',
        'two loops: status 4 missed [] error 0 visited [0, 1, 0, 1]',
        'from the second: status 4 missed [] error 0 visited [1, 2]',
        'from nowhere: status 6 missed [] error 0 visited []',
        'none: status 6 missed [] error 0 visited []',
        'stopped: status 6 missed [(1, 50.0, 204)] error 0 visited [0, 1]',
        'refused: status 6 missed [(0, 60.0, 0)] error 0 visited [0]',
        'stop_on_failure: True',
        'loop_rate: False loop_rate must be from 1 to 1000 Hz',
        'loop_rate: False loop_rate must be from 1 to 1000 Hz',
        'loop_rate: True',
        'went on: status 4 missed [(1, 50.0, 204), (3, 60.0, 0)] error 0 visited [0, 1, 2, 3, 4]',
        'cancelled: status 5 missed [] error 0 visited [0, 1]',
        'preempted: status 6',
        'second: status 4 missed [] error 0 visited [0, 1]',
        'after a miss: status 4 missed [] error 0 visited [0]',
        'none, later: status 6 missed [] error 0 visited []',
        'nothing is followed',
        'on the globe: status 4 missed [] error 0 visited [0]',
        'on the globe, too: status 6 missed [] error 0 visited [0]',
        'alone: status 5 missed [] error 0 visited [0]',
        'asked: status 4 missed [(1, 2.0, 601)] error 0 visited [0, 1]',
        'no picture: status 6 missed [(0, 1.0, 601)] error 0 visited [0]',
        'picture: status 4 missed [] error 0 visited [0]',
        'stamps: status 6 missed [(1, 5.0, 601)] error 0 visited [0, 1]',
        'given up: status 5 missed [] error 0 visited [0]',
        'deactivated True',
        'stopped by its manager: status 6 missed [] error 0 visited [0]',
        'deactivated True',
        'stopped on its way: status 6 missed [] error 0 visited [0]',
        'accepted by an inactive server: False',
        'driver is over',
      ], output);
      const places = said(output, 'navigation');
      assert.ok(places.includes('to 3 4 0.5 in map'), output);
      // By a cancelled goal twice, by a goal that cannot be used, and by a server that is deactivated.
      assert.equal(places.filter((line) => line === 'cancelled').length, 4, output);
      const follower = said(output, 'waypoint_follower');
      for (
        const line of ['Received follow waypoint request with 3 waypoints.', "Arrived at 2'th waypoint, sleeping for 200 milliseconds",
          'Starting a new loop, current loop count is 0', 'Completed all 2 waypoints requested.', 'Preempting the goal pose.',
          'Waypoint 3 does not exist; the last one is 2.', 'Converting GPS waypoints to map Frame..',
          'A goal of the other action is being followed. Cancel it first. Terminating this goal.',
          'navigate_to_pose action client failed to send goal to server.', 'Failed to process waypoint 1, moving to next.',
          'Failed to process waypoint 1 in waypoint list and stop on failure is enabled. Terminating action.']
      ) assert.ok(follower.includes(line), `waypoint_follower does not say: ${line}\n${output}`);
      assert.match(output, /\[broken\.waypoint_follower\]: Failed to create waypoint_task_executor\. Exception: .*mail_tasks::Paint/);
      assert.match(output, /Exception: photo\.image_format: the format 'tiff' is not supported; use png, jpg, jpeg or bmp/);
      assert.match(output, /Couldn't take photo at waypoint 0! Caught exception: the image has no pixels/);
      assert.match(output, /\[lonely\.waypoint_follower\]: Waiting for the action server navigate_to_pose/);
      assert.match(output, /\[asking\.waypoint_follower\]: Unable to get external input at wp 1\. Moving on\./);
      const photos = readdirSync(kept, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.png'));
      assert.equal(photos.length, 1, output);
      assert.match(readFileSync(join(kept, photos[0] ?? '')).toString('latin1'), /^\x89PNG/); // eslint-disable-line no-control-regex
    } finally {
      rmSync(kept, { recursive: true });
    }
  });
}
