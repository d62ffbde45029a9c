"""The client of Gazebo Classic. The page takes its place, so the process starts nothing."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration

FLAGS = {
    'version': 'Set to "true" to output version information.',
    'verbose': 'Set to "true" to increase messages written to the terminal.',
    'help': 'Set to "true" to produce the help message.',
    'gdb': 'Set to "true" to run gzclient with gdb',
    'valgrind': 'Set to "true" to run gzclient with valgrind',
    'gui_required': 'Set to "true" to shut down the launch when the GUI ends',
}


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value='false', description=text) for name, text in FLAGS.items()],
        DeclareLaunchArgument('extra_gazebo_args', default_value='', description='Extra arguments for Gazebo'),
        ExecuteProcess(cmd=['gzclient ', LaunchConfiguration('extra_gazebo_args')], output='screen', shell=True),
    ])
