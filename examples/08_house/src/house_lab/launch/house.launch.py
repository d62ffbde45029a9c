"""A house in Gazebo Sim with the robot, the bridge, and the nodes that can drive it."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    world = os.path.join(get_package_share_directory('house_lab'), 'worlds', 'house.sdf')
    simulator = os.path.join(get_package_share_directory('ros_gz_sim'), 'launch', 'gz_sim.launch.py')
    robot_file = PathJoinSubstitution([FindPackageShare('scout_description'), 'urdf', 'scout.urdf.xacro'])
    robot = Command(['xacro ', robot_file])
    arguments = [
        DeclareLaunchArgument('wall', default_value='false', description='Whether it follows the wall at once'),
        DeclareLaunchArgument('line', default_value='false', description='Whether it follows the line at once'),
        DeclareLaunchArgument('x', default_value='-2.0', description='Where the robot begins, in metres'),
        DeclareLaunchArgument('y', default_value='0.0'),
        DeclareLaunchArgument('yaw', default_value='0.0', description='Radians'),
    ]

    def switch(name):
        return ParameterValue(LaunchConfiguration(name), value_type=bool)

    return LaunchDescription(arguments + [
        IncludeLaunchDescription(PythonLaunchDescriptionSource(simulator),
                                 launch_arguments={'gz_args': f'-r {world}'}.items()),
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': ParameterValue(robot, value_type=str), 'use_sim_time': True}]),
        Node(package='ros_gz_sim', executable='create', output='screen', arguments=[
            '-topic', 'robot_description', '-name', 'scout', '-z', '0.01',
            '-x', LaunchConfiguration('x'), '-y', LaunchConfiguration('y'), '-Y', LaunchConfiguration('yaw')]),
        # [ carries from Gazebo to ROS, ] from ROS to Gazebo.
        Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[
            '/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock',
            '/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist',
            '/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry',
            '/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V',
            '/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan',
            '/imu@sensor_msgs/msg/Imu[gz.msgs.IMU',
            '/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model',
            '/camera/camera_info@sensor_msgs/msg/CameraInfo[gz.msgs.CameraInfo',
        ]),
        Node(package='ros_gz_image', executable='image_bridge', arguments=['/camera/image_raw']),
        Node(package='house_lab', executable='wall_follower', output='screen',
             parameters=[{'use_sim_time': True, 'enabled': switch('wall')}]),
        Node(package='house_lab', executable='line_follower.py', output='screen',
             parameters=[{'use_sim_time': True, 'enabled': switch('line')}]),
    ])
