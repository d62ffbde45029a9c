"""Two components in one container, and a line when it runs."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    counter = ComposableNode(
        package='composed_talkers', plugin='composed_talkers::Counter', name=LaunchConfiguration('counter'))
    echo = ComposableNode(package='composed_talkers', plugin='composed_talkers::Echo')
    container = ComposableNodeContainer(
        package='rclcpp_components', executable='component_container', name='talkers', namespace='',
        composable_node_descriptions=[counter, echo])
    return LaunchDescription([
        DeclareLaunchArgument('counter', description='name of the node that counts'),
        RegisterEventHandler(OnProcessStart(target_action=container, on_start=[LogInfo(msg='the container runs')])),
        container,
    ])
