from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('x_pose', default_value='0.0'),
        DeclareLaunchArgument('y_pose', default_value='0.0'),
        Node(
            package='gazebo_ros',
            executable='spawn_entity.py',
            arguments=['-entity', 'rover', '-topic', 'robot_description',
                       '-x', LaunchConfiguration('x_pose'), '-y', LaunchConfiguration('y_pose'), '-z', '0.01'],
            output='screen',
        ),
    ])
