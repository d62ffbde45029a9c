import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('sim_line_follower')
    gazebo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource([
            os.path.join(get_package_share_directory('gazebo_ros'), 'launch'), '/gazebo.launch.py']),
        launch_arguments={'world': os.path.join(share, 'worlds', 'track.world'), 'verbose': 'true'}.items())
    spawn = Node(package='gazebo_ros', executable='spawn_entity.py', output='screen',
                 arguments=['-file', os.path.join(share, 'models', 'tracker', 'model.sdf'),
                            '-entity', 'tracker', '-y', '0.03'])
    follower = Node(package='sim_line_follower', executable='follower', output='screen',
                    remappings=[('image', '/front/image_raw')])
    return LaunchDescription([gazebo, spawn, follower])
