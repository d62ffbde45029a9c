"""Gazebo Sim. With `-g` in its arguments only the client is asked for, which is the page."""
from __future__ import annotations

import os
from collections.abc import Iterator
from xml.etree import ElementTree

from ament_index_python.packages import get_packages_with_prefixes
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, LogInfo, Shutdown
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import EnvironmentVariable, LaunchConfiguration, PythonExpression

ARGUMENTS = [
    ('gz_args', '', 'Arguments to be passed to Gazebo Sim'),
    ('gz_version', '8', "Gazebo Sim's major version"),
    ('ign_args', '', 'Deprecated: Arguments to be passed to Gazebo Sim'),
    ('ign_version', '', "Deprecated: Gazebo Sim's major version"),
    ('debugger', 'false', 'Run in Debugger'),
    ('on_exit_shutdown', 'false', 'Shutdown on gz-sim exit'),
]


def exported(attribute: str) -> Iterator[str]:
    """The folders that packages have for Gazebo: `<export><gazebo_ros ATTRIBUTE="${prefix}/models"/></export>`."""
    for name, prefix in sorted(get_packages_with_prefixes().items()):
        share = os.path.join(prefix, 'share', name)
        try:
            with open(os.path.join(share, 'package.xml'), encoding='utf-8') as file:
                text = file.read()
        except OSError:
            continue  # a site has package.xml only where something is exported
        if '<gazebo_ros ' in text:
            for export in ElementTree.fromstring(text).iterfind('export/gazebo_ros'):
                if attribute in export.attrib:
                    yield export.attrib[attribute].replace('${prefix}', share)


def is_given(name: str) -> PythonExpression:
    return PythonExpression(['"" != "', LaunchConfiguration(name), '"'])


def generate_launch_description() -> LaunchDescription:
    both = ('"', LaunchConfiguration('gz_args'), '"')
    command = [['gz sim ', PythonExpression([*both, ' or "', LaunchConfiguration('ign_args'), '"']),
                ' --force-version ', LaunchConfiguration('gz_version')]]
    paths = {variable: [EnvironmentVariable(variable, default_value=''), *[f':{one}' for one in exported(attribute)]]
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
