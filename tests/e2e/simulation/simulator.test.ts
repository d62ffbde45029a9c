// Launch files that start Gazebo, Classic and Sim, as courses write them: a robot is spawned, drives by its wheels, and senses a
// wall with its lidar and its motion with an IMU. Headless on both links, and in Chromium.

// Compatibility, works: launch files that start Gazebo Classic (`gazebo.launch.py`, `spawn_entity.py`) or Gazebo Sim
// (`gz_sim.launch.py`, `create`, `parameter_bridge`): worlds of SDF, robots of URDF and SDF, wheels, lidar, IMU, joint states, `/clock`

// Compatibility, differs: the physics of the simulator -> MuJoCo, with Gazebo's rules for friction, motors and lumping; heightmaps,
// and meshes other than STL, OBJ and COLLADA are skipped, with a warning

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

/** A base on two wheels of 5 cm, 30 cm apart, with the wheels' axle through its origin, and a caster behind. */
const robot = (gazebo: string): string =>
  `<robot name="scout">
  <link name="base_footprint"/>
  <joint name="footprint" type="fixed"><parent link="base_footprint"/><child link="base"/><origin xyz="0 0 0.05"/></joint>
  <link name="base">
    <inertial><origin xyz="-0.05 0 0.02"/><mass value="2.5"/><inertia ixx="0.015" iyy="0.02" izz="0.03" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 0.06"/><geometry><box size="0.3 0.26 0.1"/></geometry></collision>
    <visual><origin xyz="0 0 0.06"/><geometry><box size="0.3 0.26 0.1"/></geometry></visual>
  </link>
  ${
    [['left', '0.15'], ['right', '-0.15']].map(([side, y]) => `
  <link name="${side}_wheel">
    <inertial><mass value="0.2"/><inertia ixx="0.00014" iyy="0.00025" izz="0.00014" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin rpy="1.5707963 0 0"/><geometry><cylinder radius="0.05" length="0.03"/></geometry></collision>
  </link>
  <joint name="${side}_joint" type="continuous">
    <parent link="base"/><child link="${side}_wheel"/><origin xyz="0 ${y} 0"/><axis xyz="0 1 0"/>
  </joint>`).join('')
  }
  <link name="caster"><inertial><mass value="0.1"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><sphere radius="0.05"/></geometry></collision></link>
  <joint name="caster_joint" type="fixed"><parent link="base"/><child link="caster"/><origin xyz="-0.12 0 0"/></joint>
  <gazebo reference="caster"><mu1>0.001</mu1><mu2>0.001</mu2></gazebo>
  <link name="head"/>
  <joint name="head_joint" type="fixed"><parent link="base"/><child link="head"/><origin xyz="0.1 0 0.15"/></joint>
  ${gazebo}
</robot>
`;

const scan = '<scan><horizontal><samples>181</samples><min_angle>-1.5708</min_angle><max_angle>1.5708</max_angle></horizontal></scan>'
  + '<range><min>0.12</min><max>8</max></range>';

const classicTags = `
  <gazebo reference="head">
    <sensor name="lidar" type="ray"><update_rate>10</update_rate><ray>${scan}</ray>
      <plugin name="lidar" filename="libgazebo_ros_ray_sensor.so"><ros><remapping>~/out:=scan</remapping></ros>
        <output_type>sensor_msgs/LaserScan</output_type><frame_name>head</frame_name></plugin></sensor>
    <sensor name="imu" type="imu"><update_rate>50</update_rate>
      <plugin name="imu" filename="libgazebo_ros_imu_sensor.so"><ros><remapping>~/out:=imu</remapping></ros></plugin></sensor>
  </gazebo>
  <gazebo>
    <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
      <left_joint>left_joint</left_joint><right_joint>right_joint</right_joint><wheel_separation>0.3</wheel_separation>
      <wheel_diameter>0.1</wheel_diameter><max_wheel_torque>10</max_wheel_torque>
      <publish_odom>true</publish_odom><publish_odom_tf>true</publish_odom_tf></plugin>
    <plugin name="joints" filename="libgazebo_ros_joint_state_publisher.so">
      <joint_name>left_joint</joint_name><joint_name>right_joint</joint_name></plugin>
    <plugin name="truth" filename="libgazebo_ros_p3d.so"><ros><remapping>odom:=truth</remapping></ros>
      <body_name>base_footprint</body_name></plugin>
    <plugin name="smoke" filename="libsmoke_machine.so"/>
  </gazebo>`;

const simTags = `
  <gazebo reference="head">
    <sensor name="lidar" type="gpu_lidar"><topic>scan</topic><gz_frame_id>head</gz_frame_id><update_rate>10</update_rate>
      <lidar>${scan}</lidar></sensor>
    <sensor name="imu" type="imu"><topic>imu</topic><update_rate>50</update_rate></sensor>
  </gazebo>
  <gazebo>
    <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
      <left_joint>left_joint</left_joint><right_joint>right_joint</right_joint><wheel_separation>0.3</wheel_separation>
      <wheel_radius>0.05</wheel_radius><topic>cmd_vel</topic><odom_topic>odom</odom_topic><tf_topic>tf</tf_topic>
      <frame_id>odom</frame_id><child_frame_id>base_footprint</child_frame_id></plugin>
    <plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher"><topic>joint_states</topic></plugin>
    <plugin filename="gz-sim-odometry-publisher-system" name="gz::sim::systems::OdometryPublisher">
      <odom_topic>truth</odom_topic><tf_topic>truth_tf</tf_topic></plugin>
    <plugin filename="gz-sim-pose-publisher-system" name="gz::sim::systems::PosePublisher"/>
    <plugin filename="gz-sim-smoke-machine-system" name="gz::sim::systems::SmokeMachine"/>
  </gazebo>`;

const box = '<geometry><box><size>0.2 6 1</size></box></geometry>';
const mesh = '<geometry><mesh><uri>model://scout/wall.obj</uri></mesh></geometry>';
/** The same box: its corners, and its sides by their numbers. */
const wallObject = `${[-0.1, 0.1].flatMap((x) => [-3, 3].flatMap((y) => [-0.5, 0.5].map((z) => `v ${x} ${y} ${z}`))).join('\n')}
f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4
`;
const plane = '<geometry><plane><normal>0 0 1</normal><size>20 20</size></plane></geometry>';
const world = (version: string, systems: string, wall: string, more = ''): string =>
  `<sdf version="${version}"><world name="room">${systems}
  <model name="floor"><static>true</static><link name="l"><collision name="c">${plane}</collision></link></model>
  <model name="wall"><static>true</static><pose>3.1 0 0.5 0 0 0</pose><link name="l">
    <collision name="c">${wall}</collision><visual name="v">${wall}</visual></link></model>${more}
</world></sdf>
`;
/** It has no wheels: its plugin moves it. */
const glider = `
  <plugin name="states" filename="libgazebo_ros_state.so"/>
  <model name="glider"><pose>0 -3 0.1 0 0 1.5708</pose><link name="body">
    <inertial><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>
    <collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry><surface><friction><ode><mu>0</mu></ode></friction></surface></collision></link>
    <plugin name="glide" filename="libgazebo_ros_planar_move.so"><ros><namespace>glider</namespace></ros>
      <publish_odom_tf>false</publish_odom_tf></plugin></model>`;
const systems = ['Physics', 'UserCommands', 'SceneBroadcaster', 'Sensors', 'Imu']
  .map((name) => `<plugin filename="gz-sim-${name.toLowerCase()}-system" name="gz::sim::systems::${name}"/>`).join('');

const launch = (simulator: string): string => `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('scout')
    with open(os.path.join(share, 'scout.urdf')) as file:
        description = file.read()
    return LaunchDescription([
        ${simulator}
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': description, 'use_sim_time': True}]),
        Node(package='scout', executable='pilot', parameters=[{'use_sim_time': True}], output='screen'),
    ])
`;

const classicLaunch = launch(`
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gazebo.launch.py')),
            launch_arguments={'world': os.path.join(share, 'room.world')}.items()),
        Node(package='gazebo_ros', executable='spawn_entity.py', arguments=['-topic', 'robot_description', '-entity', 'scout']),
        Node(package='gazebo_ros', executable='spawn_entity.py', name='again',
             arguments=['-topic', 'robot_description', '-entity', 'wall']),`);

const simLaunch = launch(`
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('ros_gz_sim'), 'launch', 'gz_sim.launch.py')),
            launch_arguments={'gz_args': '-r ' + os.path.join(share, 'room.world')}.items()),
        Node(package='ros_gz_sim', executable='create', arguments=['-topic', 'robot_description', '-name', 'scout']),
        Node(package='ros_gz_sim', executable='create', name='again', arguments=['-topic', 'robot_description', '-name', 'wall']),
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[
            '/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock', '/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist',
            '/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry', '/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V',
            '/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan', '/imu@sensor_msgs/msg/Imu[gz.msgs.IMU',
            '/truth@nav_msgs/msg/Odometry[gz.msgs.Odometry', '/model/scout/pose@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V',
            '/world/room/control@ros_gz_interfaces/srv/ControlWorld', '/world/room/set_pose@ros_gz_interfaces/srv/SetEntityPose',
            '/world/room/remove@ros_gz_interfaces/srv/DeleteEntity',
            '/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model']),`);

/** Drives 1 m forward in 5 s of the clock, and reports what it sensed before and behind. */
const pilot = `
#include <cmath>
#include <memory>
#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

class Pilot : public rclcpp::Node {
 public:
  Pilot() : Node("pilot") {
    commands_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    glide_ = create_publisher<geometry_msgs::msg::Twist>("glider/cmd_vel", 10);
    glides_by_ = create_subscription<nav_msgs::msg::Odometry>("glider/odom", 10, [this](const nav_msgs::msg::Odometry& m) {
      glider_y_ = m.pose.pose.position.y;
      glides_ = true;
    });
    odometry_ = create_subscription<nav_msgs::msg::Odometry>("odom", 10, [this](const nav_msgs::msg::Odometry& m) {
      x_ = m.pose.pose.position.x;
      knows_ = true;
    });
    scans_ = create_subscription<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS(), [this](const sensor_msgs::msg::LaserScan& m) {
      ahead_ = m.ranges[90];
      rays_ = m.ranges.size();
      frame_ = m.header.frame_id;
      beside_ = m.ranges[0];
    });
    imus_ = create_subscription<sensor_msgs::msg::Imu>("imu", rclcpp::SensorDataQoS(), [this](const sensor_msgs::msg::Imu& m) { up_ = m.linear_acceleration.z; });
    joints_ = create_subscription<sensor_msgs::msg::JointState>("joint_states", 10, [this](const sensor_msgs::msg::JointState& m) {
      for (size_t i = 0; i < m.name.size(); ++i) if (m.name[i] == "left_joint") wheel_ = m.position[i];
    });
    truths_ = create_subscription<nav_msgs::msg::Odometry>("truth", rclcpp::SensorDataQoS(), [this](const nav_msgs::msg::Odometry& m) { true_x_ = m.pose.pose.position.x; });
    frames_ = create_subscription<tf2_msgs::msg::TFMessage>("/tf", 100, [this](const tf2_msgs::msg::TFMessage& m) {
      for (const auto& one : m.transforms)
        if (one.header.frame_id == "odom" && one.child_frame_id == "base_footprint") frame_x_ = one.transform.translation.x;
    });
    timer_ = create_timer(std::chrono::milliseconds(20), [this] { tick(); });
  }

 private:
  void tick() {
    if (!knows_ || rays_ == 0 || up_ == 0 || done_) return;
    const double now = get_clock()->now().seconds();
    if (begin_ < 0) {
      begin_ = now + 1;  // it comes to rest first
      return;
    }
    if (now < begin_) {
      first_x_ = x_;
      first_wheel_ = wheel_;
      first_true_x_ = true_x_;
      return;
    }
    if (now < begin_ + 0.04)
      RCLCPP_INFO(get_logger(), "%zu rays of %s, %.2f m ahead, nothing beside: %d, up %.2f", rays_, frame_.c_str(), ahead_, std::isinf(beside_), up_);
    geometry_msgs::msg::Twist command;
    if (now < begin_ + 5) command.linear.x = 0.2;
    commands_->publish(command);
    glide_->publish(command);
    if (now < begin_ + 6) return;
    done_ = true;
    if (glides_) RCLCPP_INFO(get_logger(), "the glider, which looks to the left, went %.1f m to the left", 3 + glider_y_);
    RCLCPP_INFO(get_logger(), "drove %.1f m, in truth %.1f m, by its frame %.1f m, the wheel rolled %.1f m, %.1f m ahead", x_ - first_x_,
                true_x_ - first_true_x_, frame_x_ - first_x_, 0.05 * (wheel_ - first_wheel_), ahead_);
  }

  double x_ = 0, first_x_ = 0, ahead_ = 0, beside_ = 0, up_ = 0, wheel_ = 0, first_wheel_ = 0, begin_ = -1, true_x_ = 0, first_true_x_ = 0, frame_x_ = 0;
  size_t rays_ = 0;
  std::string frame_;
  double glider_y_ = 0;
  bool knows_ = false, done_ = false, glides_ = false;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_, glide_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odometry_, truths_, glides_by_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr frames_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr scans_;
  rclcpp::Subscription<sensor_msgs::msg::Imu>::SharedPtr imus_;
  rclcpp::Subscription<sensor_msgs::msg::JointState>::SharedPtr joints_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Pilot>());
  rclcpp::shutdown();
}
`;

const messages = ['geometry_msgs', 'nav_msgs', 'sensor_msgs', 'tf2_msgs'];
const cmake = `find_package(rclcpp REQUIRED)
${messages.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(pilot rclcpp ${messages.join(' ')})
install(FILES scout.urdf room.world wall.obj sim.launch.py DESTINATION share/\${PROJECT_NAME})
`;

interface Lab {
  readonly name: string;
  readonly depends: readonly string[];
  readonly urdf: string;
  readonly world: string;
  readonly launch: string;
  readonly argument: string;
  /** Lines of the console, in any order. */
  readonly said: readonly RegExp[];
}

const common = [
  /\[pilot\]: 181 rays of head, 2\.90 m ahead, nothing beside: 1, up 9\.80$/m,
  /\[pilot\]: drove 1\.0 m, in truth 1\.0 m, by its frame 1\.0 m, the wheel rolled 1\.0 m, 1\.9 m ahead$/m,
];
const labs: readonly Lab[] = [
  {
    name: 'classic',
    depends: ['gazebo_ros'],
    urdf: robot(classicTags),
    world: world('1.6', '', mesh, glider),
    launch: classicLaunch,
    argument: 'verbose:=true',
    said: [
      ...common,
      /\[spawn_entity\]: Spawn status: SpawnEntity: Successfully spawned entity \[scout\]$/m,
      /\[pilot\]: the glider, which looks to the left, went 1\.0 m to the left$/m,
      /\[again\]: Spawn status: Entity \[wall\] already exists\.$/m,
      /\[drive\]: Publishing odom transforms between \[odom\] and \[base_footprint\]$/m,
      /WARN.*\[imu\]: <initial_orientation_as_reference> is unset/,
      /WARN.*\[gazebo\]: plugin \[smoke\] \(libsmoke_machine\.so\) is skipped: the simulator does not have it$/m,
    ],
  },
  {
    name: 'sim',
    depends: ['ros_gz_sim', 'ros_gz_bridge'],
    urdf: robot(simTags),
    world: world('1.9', systems, box),
    launch: simLaunch,
    argument: 'debugger:=true',
    said: [
      ...common,
      /\[ros_gz_sim\]: Entity creation successful\.$/m,
      /\[again\]: Entity creation failed\./m,
      /DiffDrive subscribing to twist messages on \[\/cmd_vel\]$/m,
      /WARN.*\[_gz_sim\]: Entity named \[wall\] already exists/,
      /WARN.*\[_gz_sim\]: plugin \[gz::sim::systems::SmokeMachine\] \(gz-sim-smoke-machine-system\) is skipped: the simulator does not have it$/m,
    ],
  },
];

const workspaces = new Map<string, PackWorkspace>();
before(async () => {
  for (const lab of labs) {
    const workspace = new PackWorkspace('shared');
    workspaces.set(lab.name, workspace);
    workspace.addPackage('scout', { pilot }, { cmake, depends: ['rclcpp', ...messages, 'robot_state_publisher', ...lab.depends] });
    workspace.write('src/scout/scout.urdf', lab.urdf);
    workspace.write('src/scout/room.world', lab.world);
    workspace.write('src/scout/wall.obj', wallObject);
    workspace.write('src/scout/sim.launch.py', lab.launch);
    workspace.write('workspace.yaml', 'schema: 1\nname: scout\npackages: [src/*]\nlaunch: src/scout/sim.launch.py\n');
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 0, packed.stderr);
  }
}, watchdog);
after(() => {
  for (const workspace of workspaces.values()) workspace.close();
});

for (const [index, lab] of labs.entries()) {
  const workspace = (): PackWorkspace => workspaces.get(lab.name) ?? assert.fail();
  const links = index === 0 ? played('shared', 'port') : played('port', 'shared');
  for (const link of links) {
    test(`${lab.name}, Node.js, ${link}: the robot drives and senses`, watchdog, async () => {
      // An argument of the included file, so that the launch file is evaluated where the site starts.
      const run = await workspace().run(['run', 'site', lab.argument, '--link', link, '--for', '120s', '--until', 'drove']);
      assert.equal(run.code, 0, run.stdout + run.stderr);
      for (const line of lab.said) assert.match(run.stdout, line, run.stdout + run.stderr);
      // A machine that is busy may be slower than time.
      const warnings = run.stdout.match(/^.*\[WARN\].*$/gm)?.filter((line) => !line.includes('slower than time')) ?? [];
      assert.deepEqual(warnings.filter((line) => !lab.said.some((said) => said.test(line))), []);
      assert.match(run.stderr, /^\[(spawn_entity\.py|create)-\d\] process has finished cleanly$/m);
      assert.match(run.stderr, /^\[(spawn_entity\.py|create)-\d\] process has died \[exit code 1\]$/m);
    });
  }

  test(`${lab.name}, Chromium: the robot drives and senses`, watchdog, async () => {
    const browser = await chromium.launch(chromiumOptions());
    const server = await serveFolder(join(workspace().root, 'site'), { isolated: true });
    try {
      const page = await browser.newPage();
      const troubles: string[] = [];
      page.on('pageerror', (error) => troubles.push(error.message));
      await page.goto(server.url);
      await page.getByText(/drove 1\.0 m, in truth 1\.0 m, .* 1\.9 m ahead/).first().waitFor({ timeout: 120_000 });
      // In the place of Gazebo's window.
      await page.locator('.panel-simulation').waitFor();
      assert.deepEqual(troubles, []);
    } finally {
      await browser.close();
      server.close();
    }
  });
}

/** The answer as `ros2 service call` prints it, from a shell. */
async function called(lab: string, service: string, type: string, request: string): Promise<string> {
  const workspace = workspaces.get(lab) ?? assert.fail();
  const run = await workspace.run(['ros2', 'site', 'service', 'call', service, type, request]);
  assert.equal(run.code, 0, run.stdout + run.stderr);
  return run.stdout;
}

test('the services of Gazebo Classic', watchdog, async () => {
  assert.match(await called('classic', '/get_model_list', 'gazebo_msgs/srv/GetModelList', '{}'), /'floor', 'wall', 'glider'/);
  assert.match(await called('classic', '/delete_entity', 'gazebo_msgs/srv/DeleteEntity', '{name: wall}'), /Successfully deleted entity \[wall\]/);
  assert.match(await called('classic', '/delete_entity', 'gazebo_msgs/srv/DeleteEntity', '{name: hall}'), /Entity \[hall\] does not exist/);
  const state = await called('classic', '/get_entity_state', 'gazebo_msgs/srv/GetEntityState', '{name: wall}');
  assert.match(state, /Point\(x=3\.1, y=0\.0, z=0\.5\)/);
  for (const name of ['pause_physics', 'unpause_physics', 'reset_world', 'reset_simulation'])
    assert.match(await called('classic', `/${name}`, 'std_srvs/srv/Empty', '{}'), /Empty_Response/);
  const moved = '{state: {name: wall, pose: {position: {x: 5.0}}}}';
  assert.match(await called('classic', '/set_entity_state', 'gazebo_msgs/srv/SetEntityState', moved), /success=True/);
  assert.match(await called('classic', '/set_entity_state', 'gazebo_msgs/srv/SetEntityState', '{state: {name: hall}}'), /success=False/);
});

test('the services of Gazebo Sim, through the bridge', watchdog, async () => {
  const control = (what: string): Promise<string> => called('sim', '/world/room/control', 'ros_gz_interfaces/srv/ControlWorld', `{world_control: {${what}}}`);
  assert.match(await control('pause: true, multi_step: 10'), /success=True/);
  const pose = (name: string): Promise<string> =>
    called('sim', '/world/room/set_pose', 'ros_gz_interfaces/srv/SetEntityPose', `{entity: {name: ${name}, type: 2}, pose: {position: {x: 5.0}}}`);
  assert.match(await pose('wall'), /success=True/);
  assert.match(await pose('hall'), /success=False/);
  const remove = (name: string): Promise<string> =>
    called('sim', '/world/room/remove', 'ros_gz_interfaces/srv/DeleteEntity', `{entity: {name: ${name}, type: 2}}`);
  assert.match(await remove('wall'), /success=True/);
  assert.match(await remove('hall'), /success=False/);
});

test('the poses of links are published', watchdog, async () => {
  const poses = await (workspaces.get('sim') ?? assert.fail()).run(['ros2', 'site', 'topic', 'echo', '/model/scout/pose', '--once']);
  assert.match(poses.stdout, /child_frame_id: scout\/base_footprint/, poses.stderr);
});

test('the template of a simulation: its checks pass, and two stepped runs of a seed send the same', watchdog, async () => {
  const workspace = new PackWorkspace('shared');
  try {
    const begun = await workspace.run(['init', 'sim', 'lab']);
    assert.equal(begun.code, 0, begun.stderr);
    const packed = await workspace.run(['pack', 'lab/workspace.yaml', '-o', 'lab_site']);
    assert.equal(packed.code, 0, packed.stderr);
    const checked = await workspace.run(['run', 'lab_site', '--stepped', '--checks']);
    assert.equal(checked.code, 0, checked.stdout + checked.stderr);
    assert.match(checked.stdout + checked.stderr, /3 of 3 checks passed/);
    const traces = [];
    for (const name of ['first.trace', 'second.trace']) {
      const run = await workspace.run(['run', 'lab_site', '--stepped', '--seed', '7', '--for', '5s', '--trace', name]);
      const hashes = readFileSync(join(workspace.root, name), 'utf8').split('\n').filter((line) => line.includes('"/_gz/state_hash"'));
      assert.equal(hashes.length, 6, 'the state of the physics, each second of simulation');
      traces.push(/^trace: \d+ messages, sha256 \w+$/m.exec(run.stderr)?.[0] ?? assert.fail(run.stdout + run.stderr));
    }
    assert.equal(traces[0], traces[1]);
  } finally {
    workspace.close();
  }
});
