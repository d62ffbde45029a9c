"""Takes a model out of the world of a running Gazebo Sim."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

ARGUMENTS = {'world': 'World name', 'entity_name': 'Name of the entity'}


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value='', description=text) for name, text in ARGUMENTS.items()],
        Node(package='ros_gz_sim', executable='remove', output='screen',
             parameters=[{name: ParameterValue(LaunchConfiguration(name), value_type=str) for name in ARGUMENTS}]),
    ])
