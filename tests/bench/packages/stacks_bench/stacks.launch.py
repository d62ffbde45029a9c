"""One of the programs that are measured."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import LaunchConfigurationEquals
from launch_ros.actions import Node


def generate_launch_description():
    parameters = os.path.join(get_package_share_directory('stacks_bench'), 'dwb.yaml')
    return LaunchDescription([
        DeclareLaunchArgument('what', default_value='navfn', choices=['navfn', 'dwb']),
        *(Node(package='stacks_bench', executable=name, output='screen', parameters=[parameters],
               condition=LaunchConfigurationEquals('what', name)) for name in ('navfn', 'dwb')),
    ])
