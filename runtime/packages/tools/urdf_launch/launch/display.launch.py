"""Shows a robot whose joints are moved by hand (`jsp_gui`), or stand as they are."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

HERE = FindPackageShare('urdf_launch')


def generate_launch_description() -> LaunchDescription:
    by_hand = LaunchConfiguration('jsp_gui')
    return LaunchDescription([
        DeclareLaunchArgument('jsp_gui', default_value='true', choices=['true', 'false'],
                              description='Whether joint_state_publisher_gui moves the joints'),
        DeclareLaunchArgument('rviz_config', default_value=PathJoinSubstitution([HERE, 'config', 'urdf.rviz']),
                              description='Path of a configuration for rviz'),
        IncludeLaunchDescription(
            PathJoinSubstitution([HERE, 'launch', 'description.launch.py']),
            launch_arguments=[(name, LaunchConfiguration(name)) for name in ('urdf_package', 'urdf_package_path')]),
        Node(package='joint_state_publisher', executable='joint_state_publisher', condition=UnlessCondition(by_hand)),
        Node(package='joint_state_publisher_gui', executable='joint_state_publisher_gui',
             condition=IfCondition(by_hand)),
        Node(package='rviz2', executable='rviz2', output='screen',
             arguments=['-d', LaunchConfiguration('rviz_config')]),
    ])
