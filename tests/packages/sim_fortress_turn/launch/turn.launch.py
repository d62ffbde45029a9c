import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch_ros.actions import Node


def generate_launch_description():
    pkg_ros_ign_gazebo = get_package_share_directory('ros_ign_gazebo')
    pkg = get_package_share_directory('sim_fortress_turn')

    ign_gazebo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(os.path.join(pkg_ros_ign_gazebo, 'launch', 'ign_gazebo.launch.py')),
        launch_arguments=[('ign_args', [LaunchConfiguration('world'), TextSubstitution(text='.sdf -v 4 -r')])])
    spawn = Node(
        package='ros_ign_gazebo', executable='create', output='screen',
        arguments=['-world', 'plain', '-name', 'turtle', '-file', os.path.join(pkg, 'models', 'turtle.sdf'),
                   '-z', '0.01', '-Y', '1.0'])
    bridge = Node(
        package='ros_ign_bridge', executable='parameter_bridge', output='screen',
        arguments=['/clock@rosgraph_msgs/msg/Clock[ignition.msgs.Clock',
                   '/cmd_vel@geometry_msgs/msg/Twist]ignition.msgs.Twist',
                   '/model/turtle/odometry@nav_msgs/msg/Odometry[ignition.msgs.Odometry',
                   '/imu@sensor_msgs/msg/Imu[ignition.msgs.IMU'],
        remappings=[('/model/turtle/odometry', '/odom')])
    turner = Node(package='sim_fortress_turn', executable='turner', output='screen')

    return LaunchDescription([
        DeclareLaunchArgument('world', default_value=os.path.join(pkg, 'worlds', 'plain'),
                              description='World without .sdf'),
        ign_gazebo, spawn, bridge, turner,
    ])
