"""Puts a model into the world of a running Gazebo Sim."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

# Argument, parameter of `create`, default, description.
TEXTS = [
    ('world', 'world', '', 'World name'),
    ('file', 'file', '', 'SDF filename'),
    ('model_string', 'string', '', 'XML string'),
    ('topic', 'topic', '', 'Get XML from this topic'),
    ('entity_name', 'name', '', 'Name of the entity'),
]
POSE = {'x': 'X coordinate', 'y': 'Y coordinate', 'z': 'Z coordinate', 'R': 'Roll angle', 'P': 'Pitch angle',
        'Y': 'Yaw angle'}


def generate_launch_description() -> LaunchDescription:
    def typed(name: str, kind: type) -> ParameterValue:
        return ParameterValue(LaunchConfiguration(name), value_type=kind)

    parameters = {parameter: typed(name, str) for name, parameter, _, _ in TEXTS}
    parameters |= {'allow_renaming': typed('allow_renaming', bool)} | {name: typed(name, float) for name in POSE}
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value=value, description=text) for name, _, value, text in TEXTS],
        DeclareLaunchArgument('allow_renaming', default_value='False',
                              description='Whether the entity allows renaming or not'),
        *[DeclareLaunchArgument(name, default_value='0.0', description=text) for name, text in POSE.items()],
        Node(package='ros_gz_sim', executable='create', output='screen', parameters=[parameters]),
    ])
