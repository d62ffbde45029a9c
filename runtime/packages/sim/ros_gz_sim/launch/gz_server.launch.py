"""The server of Gazebo Sim, running. It is a process of its own, also where a component is asked for."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, LogError, Shutdown
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import AndSubstitution, EqualsSubstitution, LaunchConfiguration, NotSubstitution

ARGUMENTS = [
    ('world_sdf_file', '', 'Path to the SDF world file'),
    ('world_sdf_string', '', 'SDF world string'),
    ('initial_sim_time', '0.0', 'Initial simulation time (in seconds)'),
    ('container_name', 'ros_gz_container', 'Name of container that nodes will load in if use composition'),
    ('create_own_container', 'False', 'Whether to start a ROS container when using composition.'),
    ('use_composition', 'False', 'Use composed bringup if True'),
]
SERVER = ['gz', 'sim', '-r', '-s', '-v', '4', '--simulation-interfaces',
          '--initial-sim-time', LaunchConfiguration('initial_sim_time')]


def generate_launch_description() -> LaunchDescription:
    has_no_file = EqualsSubstitution(LaunchConfiguration('world_sdf_file'), '')
    has_no_text = EqualsSubstitution(LaunchConfiguration('world_sdf_string'), '')
    has_nothing = AndSubstitution(has_no_file, has_no_text)
    only_text = AndSubstitution(has_no_file, NotSubstitution(has_no_text))
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value=value, description=text) for name, value, text in ARGUMENTS],
        LogError(msg='Must specify either world_sdf_file or world_sdf_string', condition=IfCondition(has_nothing)),
        Shutdown(reason='no world is given', condition=IfCondition(has_nothing)),
        ExecuteProcess(cmd=[*SERVER, LaunchConfiguration('world_sdf_file')], output='screen',
                       condition=UnlessCondition(has_no_file)),
        ExecuteProcess(cmd=[*SERVER, '--sdf-string', LaunchConfiguration('world_sdf_string')], output='screen',
                       condition=IfCondition(only_text)),
    ])
