"""Gazebo Classic: the server, and the client, which is the page."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir


def part(name: str, argument: str) -> IncludeLaunchDescription:
    return IncludeLaunchDescription(PathJoinSubstitution([ThisLaunchFileDir(), name]),
                                    condition=IfCondition(LaunchConfiguration(argument)))


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([
        DeclareLaunchArgument('gui', default_value='true', description='Set to "false" to run headless.'),
        DeclareLaunchArgument('server', default_value='true', description='Set to "false" not to run gzserver.'),
        part('gzserver.launch.py', 'server'),
        part('gzclient.launch.py', 'gui'),
    ])
