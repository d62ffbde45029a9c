"""Publishes the frames of a robot, of a URDF or xacro file that a package installs."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    file = PathJoinSubstitution(
        [FindPackageShare(LaunchConfiguration('urdf_package')), LaunchConfiguration('urdf_package_path')])
    description = ParameterValue(Command(['xacro ', file]), value_type=str)
    return LaunchDescription([
        DeclareLaunchArgument('urdf_package', description='The package that installs the robot description'),
        DeclareLaunchArgument('urdf_package_path', description='Its place in the share folder of that package'),
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': description}]),
    ])
