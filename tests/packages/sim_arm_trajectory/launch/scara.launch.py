import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    world = os.path.join(get_package_share_directory('sim_arm_trajectory'), 'worlds', 'scara.sdf')
    return LaunchDescription([
        ExecuteProcess(cmd=['gz', 'sim', '-r', '-v', '3', world], output='screen'),
        Node(package='ros_gz_bridge', executable='parameter_bridge', output='screen', arguments=[
            '/joint_trajectory@trajectory_msgs/msg/JointTrajectory]gz.msgs.JointTrajectory',
            '/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model']),
        Node(package='sim_arm_trajectory', executable='player', output='screen'),
    ])
