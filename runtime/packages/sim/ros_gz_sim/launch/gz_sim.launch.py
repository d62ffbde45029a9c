"""Gazebo Sim. With `-g` in its arguments only the client is asked for, which is the page."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, LogInfo, Shutdown
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import EnvironmentVariable, IfElseSubstitution, LaunchConfiguration, NotEqualsSubstitution
from ros2wasm_launch.gazebo_paths import exported_paths

ARGUMENTS = [
    ('gz_args', '', 'Arguments to be passed to Gazebo Sim'),
    ('gz_version', '8', "Gazebo Sim's major version"),
    ('ign_args', '', 'Deprecated: Arguments to be passed to Gazebo Sim'),
    ('ign_version', '', "Deprecated: Gazebo Sim's major version"),
    ('debugger', 'false', 'Run in Debugger'),
    ('on_exit_shutdown', 'false', 'Shutdown on gz-sim exit'),
]


def is_given(name: str) -> NotEqualsSubstitution:
    return NotEqualsSubstitution(LaunchConfiguration(name), '')


def generate_launch_description() -> LaunchDescription:
    arguments = IfElseSubstitution(is_given('gz_args'), LaunchConfiguration('gz_args'),
                                   LaunchConfiguration('ign_args'))
    command = [['gz sim ', arguments, ' --force-version ', LaunchConfiguration('gz_version')]]
    paths = {variable: [EnvironmentVariable(variable, default_value=''),
                        *[f':{one}' for one in exported_paths(attribute)]]
             for variable, attribute in (('GZ_SIM_RESOURCE_PATH', 'gazebo_model_path'),
                                         ('GZ_SIM_SYSTEM_PLUGIN_PATH', 'plugin_path'))}
    # Any text asks for it, `false` too, as in ros_gz_sim.
    ends_all = is_given('on_exit_shutdown')
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value=value, description=text) for name, value, text in ARGUMENTS],
        *[LogInfo(msg=f'{old} is deprecated, migrate to {new}!', condition=IfCondition(is_given(old)))
          for old, new in (('ign_args', 'gz_args'), ('ign_version', 'gz_version'))],
        ExecuteProcess(cmd=command, name='gazebo', output='screen', additional_env=paths, shell=True,
                       on_exit=Shutdown(), condition=IfCondition(ends_all)),
        ExecuteProcess(cmd=command, name='gazebo', output='screen', additional_env=paths, shell=True,
                       condition=UnlessCondition(ends_all)),
    ])
