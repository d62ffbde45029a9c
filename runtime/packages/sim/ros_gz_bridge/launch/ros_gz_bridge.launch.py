"""A bridge between Gazebo and ROS. It is a process of its own, also where a component is asked for."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

ARGUMENTS = [
    ('container_name', 'ros_gz_container', 'Name of container that nodes will load in if use composition'),
    ('create_own_container', 'False', 'Whether the bridge should start its own ROS container.'),
    ('namespace', '', 'Top-level namespace'),
    ('use_composition', 'False', 'Use composed bringup if True'),
    ('use_respawn', 'False', 'Whether to respawn if a node crashes.'),
    ('log_level', 'info', 'log level'),
]


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([
        DeclareLaunchArgument('bridge_name', description='Name of the bridge'),
        DeclareLaunchArgument('config_file', description='YAML config file'),
        *[DeclareLaunchArgument(name, default_value=value, description=text) for name, value, text in ARGUMENTS],
        Node(package='ros_gz_bridge', executable='bridge_node', name=LaunchConfiguration('bridge_name'),
             namespace=LaunchConfiguration('namespace'), output='screen',
             respawn=LaunchConfiguration('use_respawn'), respawn_delay=2.0,
             parameters=[{'config_file': ParameterValue(LaunchConfiguration('config_file'), value_type=str)}],
             arguments=['--ros-args', '--log-level', LaunchConfiguration('log_level')]),
    ])
