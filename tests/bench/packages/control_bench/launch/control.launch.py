"""Six joints of mock hardware with three controllers and the meter; `control:=false` starts the rest only."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

LINK = """<link name="link{0}"><inertial><mass value="1"/>
  <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>"""
JOINT = """<joint name="joint{0}" type="revolute"><parent link="link{1}"/><child link="link{0}"/><axis xyz="0 0 1"/>
  <limit lower="-3" upper="3" effort="10" velocity="3"/></joint>"""
DRIVEN = """<joint name="joint{0}"><command_interface name="position"/>
  <state_interface name="position"/><state_interface name="velocity"/></joint>"""


def description() -> str:
    links = ''.join(LINK.format(i) for i in range(7))
    joints = ''.join(JOINT.format(i, i - 1) for i in range(1, 7))
    driven = ''.join(DRIVEN.format(i) for i in range(1, 7))
    return (f'<robot name="arm">{links}{joints}<ros2_control name="arm" type="system"><hardware>'
            f'<plugin>mock_components/GenericSystem</plugin></hardware>{driven}</ros2_control></robot>')


def generate_launch_description() -> LaunchDescription:
    controllers = os.path.join(get_package_share_directory('control_bench'), 'launch', 'controllers.yaml')
    control = IfCondition(LaunchConfiguration('control'))
    return LaunchDescription([
        DeclareLaunchArgument('control', default_value='true'),
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': description()}]),
        Node(package='controller_manager', executable='ros2_control_node', parameters=[controllers], condition=control),
        Node(package='controller_manager', executable='spawner',
             arguments=['joint_state_broadcaster', 'arm', 'wrist', 'meter'], condition=control),
    ])
