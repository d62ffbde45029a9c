"""A bridge, and a model that is put into the world of a running Gazebo Sim."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

BRIDGE = ['bridge_name', 'config_file', 'namespace', 'use_respawn', 'container_name', 'create_own_container',
          'use_composition', 'log_level']
MODEL = {'world': '', 'file': '', 'model_string': '', 'topic': '', 'entity_name': '', 'allow_renaming': 'False',
         'x': '0.0', 'y': '0.0', 'z': '0.0', 'R': '0.0', 'P': '0.0', 'Y': '0.0'}


def included(package: str, file: str, names: list[str]) -> IncludeLaunchDescription:
    return IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare(package), 'launch', file]),
                                    launch_arguments=[(name, LaunchConfiguration(name)) for name in names])


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([
        DeclareLaunchArgument('bridge_name', description='Name of the bridge'),
        DeclareLaunchArgument('config_file', description='YAML config file'),
        DeclareLaunchArgument('container_name', default_value='ros_gz_container'),
        DeclareLaunchArgument('create_own_container', default_value='False'),
        DeclareLaunchArgument('namespace', default_value='', description='Top-level namespace'),
        DeclareLaunchArgument('use_composition', default_value='True'),
        DeclareLaunchArgument('use_respawn', default_value='False'),
        DeclareLaunchArgument('log_level', default_value='info', description='log level'),
        *[DeclareLaunchArgument(name, default_value=value) for name, value in MODEL.items()],
        included('ros_gz_bridge', 'ros_gz_bridge.launch.py', BRIDGE),
        included('ros_gz_sim', 'gz_spawn_model.launch.py', list(MODEL)),
    ])
