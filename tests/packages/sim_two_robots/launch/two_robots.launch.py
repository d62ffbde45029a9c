import os

import xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node, PushRosNamespace

ROBOTS = [
    {'name': 'red', 'x_pose': '0.0', 'y_pose': '0.0'},
    {'name': 'blue', 'x_pose': '3.0', 'y_pose': '0.0'},
]


def generate_launch_description():
    share = get_package_share_directory('sim_two_robots')
    xacro_file = os.path.join(get_package_share_directory('sim_rover_description'), 'urdf', 'rover.urdf.xacro')
    robot_desc = xacro.process_file(xacro_file).toxml()

    ld = LaunchDescription()
    ld.add_action(IncludeLaunchDescription(
        PythonLaunchDescriptionSource(
            os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gazebo.launch.py')),
        launch_arguments={'world': os.path.join(share, 'worlds', 'empty.world')}.items()))
    for robot in ROBOTS:
        namespace = '/' + robot['name']
        ld.add_action(GroupAction([
            PushRosNamespace(namespace),
            Node(package='robot_state_publisher', executable='robot_state_publisher', output='screen',
                 parameters=[{'robot_description': robot_desc, 'use_sim_time': True,
                              'frame_prefix': robot['name'] + '/'}],
                 remappings=[('/tf', 'tf'), ('/tf_static', 'tf_static')]),
            Node(package='gazebo_ros', executable='spawn_entity.py', output='screen',
                 arguments=['-topic', 'robot_description', '-entity', robot['name'], '-robot_namespace', namespace,
                            '-x', robot['x_pose'], '-y', robot['y_pose'], '-z', '0.01']),
        ]))
    ld.add_action(Node(package='sim_two_robots', executable='watcher', output='screen'))
    return ld
