"""Starts slam_toolbox, and the server that saves its map."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, SetParameter
from launch_ros.descriptions import ParameterFile
from nav2_common.launch import HasNodeParams, RewrittenYaml


def generate_launch_description():
    params_file = LaunchConfiguration('params_file')
    use_sim_time = LaunchConfiguration('use_sim_time')
    share = get_package_share_directory('nav2_bringup')
    arguments = [
        DeclareLaunchArgument('namespace', default_value='', description='Namespace of all nodes'),
        DeclareLaunchArgument('params_file', default_value=os.path.join(share, 'params', 'nav2_params.yaml'),
                              description='File with the parameters'),
        DeclareLaunchArgument('use_sim_time', default_value='True', description='Whether time is that of /clock'),
        DeclareLaunchArgument('autostart', default_value='True', description='Whether the servers are activated'),
        DeclareLaunchArgument('use_respawn', default_value='False', description='Whether a program starts again'),
        DeclareLaunchArgument('log_level', default_value='info', description='Level of messages'),
    ]
    parameters = ParameterFile(
        RewrittenYaml(source_file=params_file, root_key=LaunchConfiguration('namespace'), param_rewrites={},
                      convert_types=True),
        allow_substs=True)
    log_arguments = ['--ros-args', '--log-level', LaunchConfiguration('log_level')]
    saver = GroupAction([
        SetParameter('use_sim_time', use_sim_time),
        Node(package='nav2_map_server', executable='map_saver_server', output='screen',
             respawn=LaunchConfiguration('use_respawn'), respawn_delay=2.0, arguments=log_arguments,
             parameters=[parameters]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_slam',
             output='screen', arguments=log_arguments,
             parameters=[{'autostart': LaunchConfiguration('autostart')}, {'node_names': ['map_saver']}]),
    ])

    def slam(condition, **more):
        path = os.path.join(get_package_share_directory('slam_toolbox'), 'launch', 'online_sync_launch.py')
        return IncludeLaunchDescription(PythonLaunchDescriptionSource(path), condition=condition,
                                        launch_arguments={'use_sim_time': use_sim_time, **more}.items())

    # The file may have parameters of slam_toolbox, too.
    has_parameters = HasNodeParams(source_file=params_file, node_name='slam_toolbox')
    return LaunchDescription([
        *arguments, saver,
        slam(UnlessCondition(has_parameters)),
        slam(IfCondition(has_parameters), slam_params_file=params_file),
    ])
