"""Maps online: `sync_slam_toolbox_node`."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    share = get_package_share_directory('slam_toolbox')
    return LaunchDescription([
        DeclareLaunchArgument('slam_params_file',
                              default_value=os.path.join(share, 'config', 'mapper_params_online_sync.yaml'),
                              description='File with the parameters'),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(share, 'launch', 'managed_launch.py')),
                                 launch_arguments={'slam_toolbox_executable': 'sync_slam_toolbox_node'}.items()),
    ])
