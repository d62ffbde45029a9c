"""The saver of maps, activated by a lifecycle manager of its own."""
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    saver = {'save_map_timeout': 2.0, 'free_thresh_default': 0.25, 'occupied_thresh_default': 0.65}
    manager = {'use_sim_time': True, 'autostart': True, 'node_names': ['map_saver']}
    return LaunchDescription([
        Node(package='nav2_map_server', executable='map_saver_server', output='screen', parameters=[saver]),
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager',
             output='screen', parameters=[manager]),
    ])
