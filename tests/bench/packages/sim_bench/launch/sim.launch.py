import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    gazebo = os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gzserver.launch.py')
    world = os.path.join(get_package_share_directory('sim_bench'), 'launch', 'bench.world')
    return LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource(gazebo), launch_arguments={'world': world}.items()),
        Node(package='sim_bench', executable='meter', output='screen'),
    ])
