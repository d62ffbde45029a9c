"""The server of Gazebo Sim and a bridge."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

BRIDGE = ['bridge_name', 'config_file', 'namespace', 'use_respawn', 'container_name', 'create_own_container',
          'use_composition']
SERVER = ['world_sdf_file', 'world_sdf_string', 'container_name', 'create_own_container', 'use_composition']


def included(package: str, file: str, names: list[str], more: dict[str, object]) -> IncludeLaunchDescription:
    arguments = {name: LaunchConfiguration(name) for name in names} | more
    return IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare(package), 'launch', file]),
                                    launch_arguments=arguments.items())


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([
        DeclareLaunchArgument('bridge_name', description='Name of the bridge'),
        DeclareLaunchArgument('config_file', description='YAML config file'),
        DeclareLaunchArgument('container_name', default_value='ros_gz_container'),
        DeclareLaunchArgument('create_own_container', default_value='False'),
        DeclareLaunchArgument('namespace', default_value='', description='Top-level namespace'),
        DeclareLaunchArgument('use_composition', default_value='False'),
        DeclareLaunchArgument('use_respawn', default_value='False'),
        DeclareLaunchArgument('bridge_log_level', default_value='info', description='log level'),
        DeclareLaunchArgument('world_sdf_file', default_value='', description='Path to the SDF world file'),
        DeclareLaunchArgument('world_sdf_string', default_value='', description='SDF world string'),
        included('ros_gz_sim', 'gz_server.launch.py', SERVER, {}),
        included('ros_gz_bridge', 'ros_gz_bridge.launch.py', BRIDGE,
                 {'log_level': LaunchConfiguration('bridge_log_level')}),
    ])
