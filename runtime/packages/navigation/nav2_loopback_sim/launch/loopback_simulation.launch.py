"""Start the loopback simulator with a file of parameters."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    default = PathJoinSubstitution([FindPackageShare('nav2_bringup'), 'params', 'nav2_params.yaml'])
    return LaunchDescription([
        DeclareLaunchArgument('scan_frame_id', default_value='base_scan'),
        DeclareLaunchArgument(
            'params_file', default_value=default,
            description='Full path to the ROS2 parameters file to use for all launched nodes'),
        Node(
            package='nav2_loopback_sim', executable='loopback_simulator', name='loopback_simulator', output='screen',
            parameters=[LaunchConfiguration('params_file'), {'scan_frame_id': LaunchConfiguration('scan_frame_id')}]),
    ])
