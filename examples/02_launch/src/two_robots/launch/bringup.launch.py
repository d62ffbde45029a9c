"""The same as bringup.launch.xml, in Python."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, TimerAction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource


def robot(**arguments):
    file = PathJoinSubstitution([FindPackageShare('two_robots'), 'launch', 'robot.launch.yaml'])
    source = YAMLLaunchDescriptionSource(file)
    return GroupAction([IncludeLaunchDescription(source, launch_arguments=arguments.items())])


def generate_launch_description():
    station = Node(
        package='two_robots',
        executable='station',
        remappings=[('first', '/alpha/position'), ('second', '/beta/position')],
        condition=IfCondition(LaunchConfiguration('with_station')),
    )
    return LaunchDescription([
        DeclareLaunchArgument('with_station', default_value='true', description='whether anybody listens'),
        robot(name='alpha', speed='2.0'),
        robot(name='beta'),
        TimerAction(period=1.0, actions=[station]),
        Node(package='rviz2', executable='rviz2'),
    ])
