"""The collision detector, activated by a lifecycle manager of its own."""
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushROSNamespace, SetParameter
from launch_ros.descriptions import ParameterFile
from nav2_common.launch import RewrittenYaml


def generate_launch_description():
    share = get_package_share_directory('nav2_collision_monitor')
    namespace = LaunchConfiguration('namespace')
    params = RewrittenYaml(source_file=LaunchConfiguration('params_file'), root_key=namespace, param_rewrites={},
                           convert_types=True)
    manager = {'autostart': True, 'node_names': ['collision_detector']}
    remappings = [('/tf', 'tf'), ('/tf_static', 'tf_static')]
    return LaunchDescription([
        DeclareLaunchArgument('namespace', default_value='', description='Top-level namespace'),
        DeclareLaunchArgument('use_sim_time', default_value='True', description='Whether time comes from /clock'),
        DeclareLaunchArgument('params_file',
                              default_value=os.path.join(share, 'params', 'collision_detector_params.yaml'),
                              description='Parameters of the node'),
        GroupAction([
            SetParameter('use_sim_time', LaunchConfiguration('use_sim_time')),
            PushROSNamespace(namespace),
            Node(package='nav2_lifecycle_manager', executable='lifecycle_manager',
                 name='lifecycle_manager_collision_detector', output='screen', parameters=[manager],
                 remappings=remappings),
            Node(package='nav2_collision_monitor', executable='collision_detector', output='screen',
                 parameters=[ParameterFile(params, allow_substs=True)], remappings=remappings),
        ]),
    ])
