"""The server of Gazebo Classic."""
import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, Shutdown
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.substitutions import FindPackageShare
from ros2wasm_launch.gazebo_paths import exported_paths

# Arguments that become a flag: their default, the flag and what it does.
FLAGS = [
    ('version', 'false', '--version', 'Set to "true" to output version information'),
    ('verbose', 'false', '--verbose', 'Set to "true" to increase messages written to terminal'),
    ('lockstep', 'false', '--lockstep', 'Set to "true" to respect update rates'),
    ('help', 'false', '--help', 'Set to "true" to produce gzserver help message'),
    ('pause', 'false', '--pause', 'Set to "true" to start the server in a paused state'),
    ('record', 'false', '--record', 'Set to "true" to record state data'),
    ('minimal_comms', 'false', '--minimal_comms', 'Set to "true" to reduce the network traffic output by gzserver'),
    ('init', 'true', '-s libgazebo_ros_init.so', 'Set to "false" not to load "libgazebo_ros_init.so"'),
    ('factory', 'true', '-s libgazebo_ros_factory.so', 'Set to "false" not to load "libgazebo_ros_factory.so"'),
    ('force_system', 'true', '-s libgazebo_ros_force_system.so',
     'Set to "false" not to load "libgazebo_ros_force_system.so"'),
]
# Arguments with a value, and what it is.
OPTIONS = [
    ('initial_sim_time', 'Specify the initial simulation time (seconds)'),
    ('physics', 'Specify a physics engine (ode|bullet|dart|simbody)'),
    ('play', 'Play the specified log file'),
    ('record_encoding', 'Specify compression encoding format for log data (zlib|bz2|txt)'),
    ('record_path', 'Absolute path in which to store state data'),
    ('record_period', 'Specify recording period (seconds)'),
    ('record_filter', 'Specify recording filter (supports wildcard and regular expression)'),
    ('seed', 'Start with a given a random number seed'),
    ('iters', 'Specify number of iterations to simulate'),
    ('profile', 'Specify physics preset profile name from the options in the world file'),
]


def search_path(attribute: str, variable: str) -> str:
    return ':'.join([*exported_paths(attribute), *filter(None, [os.environ.get(variable, '')])])


def flag(name: str, words: str) -> PythonExpression:
    """Only the exact text `true` is true."""
    return PythonExpression(['" ', words, '" if "true" == "', LaunchConfiguration(name), '" else ""'])


def option(name: str, before: str, after: str = '') -> PythonExpression:
    value = LaunchConfiguration(name)
    return PythonExpression(['" ', before, ' ', value, after, '" if "" != "', value, '" else ""'])


def generate_launch_description() -> LaunchDescription:
    command = [['gzserver ', LaunchConfiguration('world'), *[flag(name, words) for name, _, words, _ in FLAGS],
                *[option(name, f'--{name}') for name, _ in OPTIONS],
                ' ', LaunchConfiguration('extra_gazebo_args'),
                option('params_file', '--ros-args --params-file', ' --')]]
    paths = {
        'GAZEBO_MODEL_PATH': search_path('gazebo_model_path', 'GAZEBO_MODEL_PATH'),
        'GAZEBO_PLUGIN_PATH': search_path('plugin_path', 'GAZEBO_PLUGIN_PATH'),
        'GAZEBO_RESOURCE_PATH': search_path('gazebo_media_path', 'GAZEBO_RESOURCE_PATH'),
    }
    is_required = PythonExpression(['"true" == "', LaunchConfiguration('server_required'), '"'])
    world = PathJoinSubstitution([FindPackageShare('gazebo_ros'), 'worlds', 'empty.world'])
    return LaunchDescription([
        DeclareLaunchArgument('world', default_value=world, description='Specify world file name'),
        *[DeclareLaunchArgument(name, default_value=value, description=text) for name, value, _, text in FLAGS],
        *[DeclareLaunchArgument(name, default_value='', description=text) for name, text in OPTIONS],
        DeclareLaunchArgument('extra_gazebo_args', default_value='',
                              description='Extra arguments to be passed to Gazebo'),
        DeclareLaunchArgument('params_file', default_value='', description='Path to ROS 2 yaml parameter file'),
        DeclareLaunchArgument('gdb', default_value='false', description='Set to "true" to run gzserver with gdb'),
        DeclareLaunchArgument('valgrind', default_value='false',
                              description='Set to "true" to run gzserver with valgrind'),
        DeclareLaunchArgument('server_required', default_value='false',
                              description='Set to "true" to shut down launch script when server is terminated'),
        ExecuteProcess(cmd=command, output='both', additional_env=paths, shell=True,
                       condition=UnlessCondition(is_required)),
        ExecuteProcess(cmd=command, output='both', additional_env=paths, shell=True, on_exit=Shutdown(),
                       condition=IfCondition(is_required)),
    ])
