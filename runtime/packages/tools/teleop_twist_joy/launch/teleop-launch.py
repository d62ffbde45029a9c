"""A joystick and the node that drives by it, with the parameters of a gamepad (`joy_config`)."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    config = LaunchConfiguration('config_filepath')
    joystick = {'device_id': LaunchConfiguration('joy_dev'), 'deadzone': 0.3, 'autorepeat_rate': 20.0}
    return LaunchDescription([
        DeclareLaunchArgument('joy_vel', default_value='cmd_vel'),
        DeclareLaunchArgument('joy_config', default_value='ps3'),
        DeclareLaunchArgument('joy_dev', default_value='0'),
        DeclareLaunchArgument('publish_stamped_twist', default_value='false'),
        DeclareLaunchArgument('config_filepath', default_value=[
            PathJoinSubstitution([FindPackageShare('teleop_twist_joy'), 'config', '']),
            LaunchConfiguration('joy_config'), '.config.yaml']),
        Node(package='joy', executable='joy_node', name='joy_node', parameters=[joystick]),
        Node(package='teleop_twist_joy', executable='teleop_node', name='teleop_twist_joy_node',
             parameters=[config, {'publish_stamped_twist': LaunchConfiguration('publish_stamped_twist')}],
             remappings=[('/cmd_vel', LaunchConfiguration('joy_vel'))]),
    ])
