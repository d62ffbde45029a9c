import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node

ROVER_MODEL = os.environ['ROVER_MODEL']


def generate_launch_description():
    share = get_package_share_directory('sim_classic_models')
    model_folder = 'rover_' + ROVER_MODEL
    sdf_path = os.path.join(share, 'models', model_folder, 'model.sdf')

    return LaunchDescription([
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(
                os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gazebo.launch.py')),
            launch_arguments={'world': os.path.join(share, 'worlds', 'walls.world'), 'gui': 'false'}.items()),
        Node(package='gazebo_ros', executable='spawn_entity.py', output='screen',
             arguments=['-entity', ROVER_MODEL, '-file', sdf_path, '-x', '0.5', '-y', '0.0', '-z', '0.01']),
        Node(package='sim_classic_models', executable='look.py', output='screen'),
    ])
