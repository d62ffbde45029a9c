"""Starts the servers that plan, control and lead, one program each."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, SetEnvironmentVariable
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, SetParameter
from launch_ros.descriptions import ParameterFile
from nav2_common.launch import RewrittenYaml

# Package and program of each server, in the order in which they are activated. The node has the program's name.
SERVERS = [
    ('nav2_controller', 'controller_server'),
    ('nav2_smoother', 'smoother_server'),
    ('nav2_planner', 'planner_server'),
    ('nav2_behaviors', 'behavior_server'),
    ('nav2_velocity_smoother', 'velocity_smoother'),
    ('nav2_collision_monitor', 'collision_monitor'),
    ('nav2_bt_navigator', 'bt_navigator'),
    ('nav2_waypoint_follower', 'waypoint_follower'),
]

# The velocity goes through the smoother and the monitor: cmd_vel_nav, cmd_vel_smoothed, cmd_vel.
MOVERS = ('controller_server', 'behavior_server', 'velocity_smoother')


def generate_launch_description():
    params_file = os.path.join(get_package_share_directory('nav2_bringup'), 'params', 'nav2_params.yaml')
    arguments = [
        DeclareLaunchArgument('namespace', default_value='', description='Namespace of all nodes'),
        DeclareLaunchArgument('use_sim_time', default_value='false', description='Whether time is that of /clock'),
        DeclareLaunchArgument('params_file', default_value=params_file, description='File with the parameters'),
        DeclareLaunchArgument('autostart', default_value='true', description='Whether the servers are activated'),
        # A site has a program for each server.
        DeclareLaunchArgument('use_composition', default_value='False', description='Without effect'),
        DeclareLaunchArgument('container_name', default_value='nav2_container', description='Without effect'),
        DeclareLaunchArgument('use_respawn', default_value='False', description='Whether a program starts again'),
        DeclareLaunchArgument('log_level', default_value='info', description='Level of messages'),
    ]
    namespace = LaunchConfiguration('namespace')
    autostart = LaunchConfiguration('autostart')
    log_arguments = ['--ros-args', '--log-level', LaunchConfiguration('log_level')]
    parameters = ParameterFile(
        RewrittenYaml(source_file=LaunchConfiguration('params_file'), root_key=namespace,
                      param_rewrites={'autostart': autostart}, convert_types=True),
        allow_substs=True)
    managed = [{'autostart': autostart}, {'node_names': [program for _, program in SERVERS]}]

    def remappings(node):
        frames = [('/tf', 'tf'), ('/tf_static', 'tf_static')]
        return frames + ([('cmd_vel', 'cmd_vel_nav')] if node in MOVERS else [])

    programs = GroupAction(
        [SetParameter('use_sim_time', LaunchConfiguration('use_sim_time'))] + [
            Node(package=package, executable=program, name=program, output='screen',
                 respawn=LaunchConfiguration('use_respawn'), respawn_delay=2.0, parameters=[parameters],
                 arguments=log_arguments, remappings=remappings(program))
            for package, program in SERVERS
        ] + [
            Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation',
                 output='screen', arguments=log_arguments, parameters=managed),
        ])
    return LaunchDescription(
        [SetEnvironmentVariable('RCUTILS_LOGGING_BUFFERED_STREAM', '1'), *arguments, programs])
