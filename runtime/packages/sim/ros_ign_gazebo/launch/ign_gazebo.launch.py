"""The older name of gz_sim.launch.py."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

ARGUMENTS = ['gz_args', 'gz_version', 'ign_args', 'ign_version']


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value='6' if name == 'gz_version' else '') for name in ARGUMENTS],
        LogInfo(msg='ros_ign_gazebo is deprecated! Please use ros_gz_sim instead!'),
        IncludeLaunchDescription(
            PathJoinSubstitution([FindPackageShare('ros_gz_sim'), 'launch', 'gz_sim.launch.py']),
            launch_arguments=[(name, LaunchConfiguration(name)) for name in ARGUMENTS]),
    ])
