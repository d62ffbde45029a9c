"""Positions of GNSS in the frames of a robot, with the example's parameters."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    params = os.path.join(get_package_share_directory('robot_localization'), 'params', 'navsat_transform.yaml')
    return LaunchDescription([
        Node(package='robot_localization', executable='navsat_transform_node', name='navsat_transform_node',
             output='screen', parameters=[params]),
    ])
