"""A room in Gazebo Sim, a robot in it, a bridge, and the node that drives the robot."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('rover_lab')
    world = os.path.join(share, 'worlds', 'room.sdf')
    with open(os.path.join(share, 'urdf', 'rover.urdf'), encoding='utf-8') as file:
        robot = file.read()
    simulator = os.path.join(get_package_share_directory('ros_gz_sim'), 'launch', 'gz_sim.launch.py')
    return LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource(simulator),
                                 launch_arguments={'gz_args': f'-r {world}'}.items()),
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': robot, 'use_sim_time': True}]),
        Node(package='ros_gz_sim', executable='create', arguments=['-topic', 'robot_description', '-name', 'rover']),
        # [ carries from Gazebo to ROS, ] from ROS to Gazebo.
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[
            '/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock',
            '/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist',
            '/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry',
            '/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V',
            '/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan',
            '/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model',
        ]),
        Node(package='rover_lab', executable='wanderer', parameters=[{'use_sim_time': True}], output='screen'),
    ])
