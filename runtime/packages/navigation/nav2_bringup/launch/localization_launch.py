"""Starts the map server and AMCL, one program each."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, SetEnvironmentVariable
from launch.conditions import IfCondition
from launch.substitutions import EqualsSubstitution, LaunchConfiguration, NotEqualsSubstitution
from launch_ros.actions import Node, SetParameter
from launch_ros.descriptions import ParameterFile
from nav2_common.launch import RewrittenYaml

FRAMES = [('/tf', 'tf'), ('/tf_static', 'tf_static')]


def generate_launch_description():
    params_file = os.path.join(get_package_share_directory('nav2_bringup'), 'params', 'nav2_params.yaml')
    arguments = [
        DeclareLaunchArgument('namespace', default_value='', description='Namespace of all nodes'),
        DeclareLaunchArgument('map', default_value='', description='File of the map, in place of yaml_filename'),
        DeclareLaunchArgument('use_sim_time', default_value='false', description='Whether time is that of /clock'),
        DeclareLaunchArgument('params_file', default_value=params_file, description='File with the parameters'),
        DeclareLaunchArgument('autostart', default_value='true', description='Whether the servers are activated'),
        # A site has a program for each server.
        DeclareLaunchArgument('use_composition', default_value='False', description='Without effect'),
        DeclareLaunchArgument('container_name', default_value='nav2_container', description='Without effect'),
        DeclareLaunchArgument('use_respawn', default_value='False', description='Whether a program starts again'),
        DeclareLaunchArgument('log_level', default_value='info', description='Level of messages'),
    ]
    map_file = LaunchConfiguration('map')
    log_arguments = ['--ros-args', '--log-level', LaunchConfiguration('log_level')]
    parameters = ParameterFile(
        RewrittenYaml(source_file=LaunchConfiguration('params_file'), root_key=LaunchConfiguration('namespace'),
                      param_rewrites={}, convert_types=True),
        allow_substs=True)
    managed = [{'autostart': LaunchConfiguration('autostart')}, {'node_names': ['map_server', 'amcl']}]

    def program(package, executable, condition=None, more=None):
        return Node(package=package, executable=executable, name=executable, output='screen', condition=condition,
                    respawn=LaunchConfiguration('use_respawn'), respawn_delay=2.0,
                    parameters=[parameters] + (more or []), arguments=log_arguments, remappings=FRAMES)

    # The argument `map` counts only when it is given.
    has_no_map = IfCondition(EqualsSubstitution(map_file, ''))
    has_map = IfCondition(NotEqualsSubstitution(map_file, ''))
    given_map = [{'yaml_filename': map_file}]
    programs = GroupAction([
        SetParameter('use_sim_time', LaunchConfiguration('use_sim_time')),
        program('nav2_map_server', 'map_server', has_no_map),
        program('nav2_map_server', 'map_server', has_map, given_map),
        program('nav2_amcl', 'amcl'),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_localization',
             output='screen', arguments=log_arguments, parameters=managed),
    ])
    return LaunchDescription(
        [SetEnvironmentVariable('RCUTILS_LOGGING_BUFFERED_STREAM', '1'), *arguments, programs])
