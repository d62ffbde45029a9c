"""The multiplexer with the parameters of two files, and an arrow that shows what comes out."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

CONFIG = PathJoinSubstitution([FindPackageShare('twist_mux'), 'config'])


def generate_launch_description() -> LaunchDescription:
    use_sim_time = {'use_sim_time': LaunchConfiguration('use_sim_time')}
    output = LaunchConfiguration('cmd_vel_out')
    return LaunchDescription([
        DeclareLaunchArgument('config_locks', default_value=PathJoinSubstitution([CONFIG, 'twist_mux_locks.yaml']),
                              description='File with the locks'),
        DeclareLaunchArgument('config_topics', default_value=PathJoinSubstitution([CONFIG, 'twist_mux_topics.yaml']),
                              description='File with the sources'),
        DeclareLaunchArgument('cmd_vel_out', default_value='twist_mux/cmd_vel', description='Topic of the output'),
        DeclareLaunchArgument('use_sim_time', default_value='False', description='Whether time comes from /clock'),
        Node(package='twist_mux', executable='twist_mux', output='screen', remappings=[('/cmd_vel_out', output)],
             parameters=[use_sim_time, LaunchConfiguration('config_locks'), LaunchConfiguration('config_topics')]),
        Node(package='twist_mux', executable='twist_marker', output='screen', remappings=[('/twist', output)],
             parameters=[use_sim_time, {'frame_id': 'base_link', 'scale': 1.0, 'vertical_position': 2.0}]),
    ])
