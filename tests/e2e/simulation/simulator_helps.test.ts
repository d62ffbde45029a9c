// Worlds, robots and bridges with many mistakes at once: the simulator, the bridge and the spawners say each one once, with a way out.

// Compatibility, works: common mistakes of simulated robots and bridges (wheels, inertia, names, directions, types) are reported, once

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const plane = '<geometry><plane><normal>0 0 1</normal><size>20 20</size></plane></geometry>';
const floor = `<model name="floor"><static>true</static><link name="l"><collision name="c">${plane}</collision></link></model>`;
const inertial = (mass: number, moment: number): string =>
  `<inertial><mass>${mass}</mass><inertia><ixx>${moment}</ixx><iyy>${moment}</iyy><izz>${moment}</izz></inertia></inertial>`;
const cylinder = '<collision name="c"><geometry><cylinder><radius>0.05</radius><length>0.03</length></cylinder></geometry></collision>';
const wheel = (side: string, y: number, z: number): string => `
  <link name="${side}_wheel"><pose>0 ${y} ${z} -1.5707963 0 0</pose>${inertial(0.2, 0.0002)}${cylinder}</link>
  <joint name="${side}_joint" type="revolute"><parent>base</parent><child>${side}_wheel</child>
    <axis><xyz expressed_in="__model__">0 1 0</xyz></axis></joint>`;
/** Its base is 4 cm lower than its wheels. */
const stranded = (plugins: string, sensor = ''): string => `
  <model name="stranded"><pose>2 0 0.12 0 0 0</pose>
    <link name="base">${inertial(2.5, 0.03)}<collision name="c"><geometry><box><size>0.3 0.2 0.2</size></box></geometry></collision>${sensor}</link>
    ${wheel('left', 0.15, -0.01)}${wheel('right', -0.15, -0.01)}${plugins}</model>`;
const sunk = `
  <model name="sunk"><pose>4 0 -0.1 0 0 0</pose><link name="base">${inertial(0.1, 1)}
    <collision name="c"><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision></link>
    <link name="arm">${inertial(1, 0.01)}</link>
    <joint name="j" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint></model>`;

const simWorld = `<sdf version="1.9"><world name="yard">
  ${['Physics', 'UserCommands', 'Sensors'].map((name) => `<plugin filename="gz-sim-${name.toLowerCase()}-system" name="gz::sim::systems::${name}"/>`).join('')}
  ${floor}${sunk}${
  stranded(`
    <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"><left_joint>left_joint</left_joint>
      <right_joint>right_joint</right_joint><wheel_separation>0.5</wheel_separation><wheel_radius>0.1</wheel_radius>
      <odom_publisher_frequency>30</odom_publisher_frequency></plugin>
    <plugin filename="libgazebo_ros_diff_drive.so" name="old"/>`,
    '<sensor name="lidar" type="gpu_lidar"><topic>scan</topic><update_rate>5</update_rate></sensor>')
}
</world></sdf>
`;
const classicWorld = `<sdf version="1.6"><world name="yard">${floor}${
  stranded(`
    <plugin filename="libgazebo_ros_diff_drive.so" name="drive"><left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>
      <wheel_separation>0.3</wheel_separation><wheel_diameter>0.05</wheel_diameter><command_topic>robot/cmd_vel</command_topic></plugin>
    <plugin filename="libgazebo_ros_laser.so" name="laser"/>
    <plugin filename="libgazebo_ros_joint_state_publisher.so" name="joints"><joint_name>left_wheel_joint</joint_name></plugin>`)
}
</world></sdf>
`;

/** Its mast has no mass, its mesh is not installed, and its plugin names a joint that it does not have. */
const urdf = `<robot name="scout">
  <link name="base"><inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="package://yard/meshes/hull.stl"/></geometry></visual>
    <collision><geometry><box size="0.2 0.2 0.1"/></geometry></collision></link>
  <link name="mast"/><joint name="mast_joint" type="revolute"><parent link="base"/><child link="mast"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <link name="left_wheel"><inertial><mass value="0.2"/><inertia ixx="0.0002" iyy="0.0002" izz="0.0002" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="left_wheel_joint" type="continuous"><parent link="base"/><child link="left_wheel"/><axis xyz="0 1 0"/></joint>
  <gazebo reference="mst"><mu1>0.1</mu1></gazebo>
  <gazebo><plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"><left_joint>left_wheel_jiont</left_joint></plugin></gazebo>
</robot>
`;

/** Publishes commands with a stamp, and the transform that another node of its kind publishes too. */
const pilot = `
#include <memory>
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("pilot");
  const auto commands = node->create_publisher<geometry_msgs::msg::TwistStamped>("cmd_vel", 10);
  const auto frames = node->create_publisher<tf2_msgs::msg::TFMessage>("/tf", 10);
  const auto timer = node->create_wall_timer(std::chrono::milliseconds(100), [&] {
    commands->publish(geometry_msgs::msg::TwistStamped());
    tf2_msgs::msg::TFMessage message;
    message.transforms.resize(1);
    message.transforms[0].header.frame_id = "odom";
    message.transforms[0].child_frame_id = "base";
    message.transforms[0].transform.rotation.w = 1;
    frames->publish(message);
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
}
`;

const launch = (simulator: string): string => `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('yard')
    world = os.path.join(share, 'yard.world')
    with open(os.path.join(share, 'scout.urdf')) as file:
        description = file.read()
    return LaunchDescription([
        ${simulator}
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': description}]),
        Node(package='yard', executable='pilot', parameters=[{'use_sim_time': True}]),
        Node(package='yard', executable='pilot', name='second', remappings=[('cmd_vel', 'other')]),
    ])
`;
const include = (name: string, file: string, launched: string): string =>
  `IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(get_package_share_directory('${name}'), 'launch', '${file}')),
            launch_arguments=${launched}.items()),`;

interface Lab {
  readonly name: string;
  readonly depends: readonly string[];
  readonly world: string;
  readonly launch: string;
  /** Each is said once. */
  readonly said: readonly RegExp[];
}
const common = [
  /WARN.*the wheels on the left of \[stranded\] do not touch the ground: there are 0\.04 m below them\./g,
  /WARN.*two nodes publish the transform from \[odom\] to \[base\]: \[(pilot|second)\] and \[(pilot|second)\]\./g,
  /WARN.*nobody publishes \[\/description\]: robot_state_publisher does, .* There is \[\/robot_description\]: write `-topic \/robot_description`/g,
];
const labs: readonly Lab[] = [
  {
    name: 'Gazebo Sim',
    depends: ['ros_gz_sim', 'ros_gz_bridge'],
    world: simWorld,
    launch: launch(`${include('ros_gz_sim', 'gz_sim.launch.py', "{'gz_args': '-r -s ' + world}")}
        Node(package='ros_gz_sim', executable='create', arguments=['-topic', 'robot_description', '-z', '0.1']),
        Node(package='ros_gz_sim', executable='create', name='silent', arguments=['-topic', 'description']),
        Node(package='ros_gz_sim', executable='create', name='lost', arguments=['-world', 'garden', '-topic', 'robot_description']),
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[
            '/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist', '/model/stranded/odometry@nav_msgs/msg/Odometry]gz.msgs.Odometry',
            '/scan@sensor_msgs/msg/LaserScan@gz.msgs.LaserScan', '/imu@sensor_msgs/msg/Imu[gz.msgs.IMU']),`),
    said: [
      ...common,
      /WARN.*\[sunk\] begins inside of the ground.*: its lowest collision, of the link \[base\], is 0\.15 m below it\. Spawn it at z = 0\.05/g,
      /WARN.*the link \[base\] of \[sunk\] has a moment of inertia of 1 kg m\^2, which is the default/g,
      /WARN.*<wheel_separation> of \[stranded\] is 0\.5 m, but its wheels are 0\.3 m apart/g,
      /WARN.*<wheel_radius> of \[stranded\] is 0\.1 m, but the collision of its wheel has 0\.05 m/g,
      /WARN.*<odom_publisher_frequency> is not read by this plugin: write <odom_publish_frequency> in its place/g,
      /WARN.*plugin \[old\].* is skipped: .* Gazebo Sim has <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">/g,
      /WARN.*the mesh package:\/\/yard\/meshes\/hull\.stl is not found \(searched: .*\)\. The package `yard` is there without it: .* installs `meshes`/g,
      /WARN.*link\[mast\] has no <inertial> block defined\..*connect it with a fixed joint/g,
      /WARN.*<gazebo reference="mst"> names no link or joint of the robot, so it is skipped; the nearest name is `mast`/g,
      /ERROR.*Failed to find left joint \[left_wheel_jiont\] for model \[scout\]; the nearest joint is \[left_wheel_joint\]/g,
      /WARN.*no bridge for \/clock: \[pilot\] runs with use_sim_time/g,
      /WARN.*\[pilot\] publishes \[\/cmd_vel\] as geometry_msgs\/msg\/TwistStamped, but the bridge has it as geometry_msgs\/msg\/Twist, .*`stamped`/g,
      /WARN.*nothing in Gazebo reads \[\/cmd_vel\]; the nearest topic is \[\/model\/stranded\/cmd_vel\]/g,
      /WARN.*the bridge of \[\/model\/stranded\/odometry\] goes the wrong way: Gazebo publishes it\./g,
      /WARN.*nothing in Gazebo publishes \[\/imu\]\. Topics that it publishes: /g,
      /WARN.*the bridge carries \[\/scan\] both ways, but only Gazebo publishes there: write `\[`/g,
      /WARN.*the world that runs is \[yard\]: write `-world yard`/g,
    ],
  },
  {
    name: 'Gazebo Classic',
    depends: ['gazebo_ros'],
    world: classicWorld,
    launch: launch(`${include('gazebo_ros', 'gzserver.launch.py', "{'world': world}")}
        Node(package='gazebo_ros', executable='spawn_entity.py', arguments=['-topic', 'description', '-entity', 'scout']),`),
    said: [
      ...common,
      /WARN.*<wheel_diameter> of \[stranded\] is 0\.05 m, but the collision of its wheel has 0\.1 m/g,
      /WARN.*plugin \[drive\] of \[stranded\]: <command_topic> is not read by this plugin: write <ros><remapping>cmd_vel:=NAME/g,
      /WARN.*plugin \[laser\].* is skipped: .* it is a plugin of ROS 1; in ROS 2 it is libgazebo_ros_ray_sensor\.so/g,
      /ERROR.*Joint left_wheel_joint does not exist!; the nearest joint is \[left_joint\]/g,
    ],
  },
];

const messages = ['geometry_msgs', 'tf2_msgs'];
const workspaces = new Map<string, PackWorkspace>();
before(async () => {
  for (const lab of labs) {
    const workspace = new PackWorkspace('shared');
    workspaces.set(lab.name, workspace);
    const cmake = `find_package(rclcpp REQUIRED)
${messages.map((name) => `find_package(${name} REQUIRED)`).join('\n')}
ament_target_dependencies(pilot rclcpp ${messages.join(' ')})
install(FILES yard.world scout.urdf sim.launch.py DESTINATION share/\${PROJECT_NAME})
`;
    workspace.addPackage('yard', { pilot }, { cmake, depends: ['rclcpp', 'robot_state_publisher', ...messages, ...lab.depends] });
    workspace.write('src/yard/yard.world', lab.world);
    workspace.write('src/yard/scout.urdf', urdf);
    workspace.write('src/yard/sim.launch.py', lab.launch);
    workspace.write('workspace.yaml', 'schema: 1\nname: yard\npackages: [src/*]\nlaunch: src/yard/sim.launch.py\n');
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 0, packed.stderr);
  }
}, watchdog);
after(() => {
  for (const workspace of workspaces.values()) workspace.close();
});

for (const lab of labs)
  test(`${lab.name}: each mistake is said once`, watchdog, async () => {
    const workspace = workspaces.get(lab.name) ?? assert.fail();
    const run = await workspace.run(['run', 'site', '--stepped', '--seed', '1', '--for', '20s']);
    assert.equal(run.code, 0, run.stdout + run.stderr);
    for (const line of lab.said) assert.equal(run.stdout.match(line)?.length, 1, `${line.source}\n${run.stdout}${run.stderr}`);
  });
