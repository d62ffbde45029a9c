"""An unscented Kalman filter, with the example's parameters."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    params = os.path.join(get_package_share_directory('robot_localization'), 'params', 'ukf.yaml')
    return LaunchDescription([
        Node(package='robot_localization', executable='ukf_node', name='ukf_filter_node',
             output='screen', parameters=[params]),
    ])
