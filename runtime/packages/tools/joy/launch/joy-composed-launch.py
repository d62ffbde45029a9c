"""The component joy::Joy in a container, with the parameters of config/joy-params.yaml."""
import os

import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate_launch_description() -> LaunchDescription:
    path = os.path.join(get_package_share_directory('joy'), 'config', 'joy-params.yaml')
    with open(path) as file:
        parameters = yaml.safe_load(file)['joy_node']['ros__parameters']
    joystick = ComposableNode(package='joy', plugin='joy::Joy', name='joy_node', parameters=[parameters])
    return LaunchDescription([
        ComposableNodeContainer(
            name='joy_container', namespace='', package='rclcpp_components', executable='component_container',
            composable_node_descriptions=[joystick], output='both'),
    ])
