"""Starts localization on a map, and navigation."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, SetEnvironmentVariable
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import PushROSNamespace
from nav2_common.launch import ReplaceString


def generate_launch_description():
    share = get_package_share_directory('nav2_bringup')
    folder = os.path.join(share, 'launch')
    arguments = [
        DeclareLaunchArgument('namespace', default_value='', description='Namespace of all nodes'),
        DeclareLaunchArgument('use_namespace', default_value='false', description='Whether the namespace counts'),
        DeclareLaunchArgument('slam', default_value='False', description='Whether the map is made meanwhile'),
        DeclareLaunchArgument('map', default_value='', description='File of the map'),
        DeclareLaunchArgument('use_localization', default_value='True', description='Whether a localization starts'),
        DeclareLaunchArgument('use_sim_time', default_value='false', description='Whether time is that of /clock'),
        DeclareLaunchArgument('params_file', default_value=os.path.join(share, 'params', 'nav2_params.yaml'),
                              description='File with the parameters'),
        DeclareLaunchArgument('autostart', default_value='true', description='Whether the servers are activated'),
        DeclareLaunchArgument('use_composition', default_value='False', description='Without effect'),
        DeclareLaunchArgument('use_respawn', default_value='False', description='Whether a program starts again'),
        DeclareLaunchArgument('log_level', default_value='info', description='Level of messages'),
    ]
    namespace = LaunchConfiguration('namespace')
    slam = LaunchConfiguration('slam')
    use_localization = LaunchConfiguration('use_localization')
    shared = {name: LaunchConfiguration(name) for name in
              ('namespace', 'use_sim_time', 'autostart', 'params_file', 'use_composition', 'use_respawn', 'log_level')}
    # One file serves several robots.
    shared['params_file'] = ReplaceString(source_file=LaunchConfiguration('params_file'),
                                          replacements={'<robot_namespace>': ('/', namespace)},
                                          condition=IfCondition(LaunchConfiguration('use_namespace')))

    def include(name, condition=None, **more):
        return IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(folder, name)), condition=condition,
                                        launch_arguments={**shared, **more}.items())

    started = GroupAction([
        PushROSNamespace(condition=IfCondition(LaunchConfiguration('use_namespace')), namespace=namespace),
        include('slam_launch.py', IfCondition(PythonExpression([slam, ' and ', use_localization]))),
        include('localization_launch.py', IfCondition(PythonExpression(['not ', slam, ' and ', use_localization])),
                map=LaunchConfiguration('map')),
        include('navigation_launch.py'),
    ])
    return LaunchDescription([SetEnvironmentVariable('RCUTILS_LOGGING_BUFFERED_STREAM', '1'), *arguments, started])
