"""Launch descriptions that start spawners of controllers."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def _spawner(arguments: Sequence[Any]) -> Node:
    return Node(package='controller_manager', executable='spawner', arguments=list(arguments),
                shell=True, output='screen')


def _files_of(value: Any, of: str) -> list[Any]:
    """The files that a dictionary gives for a controller: none, one or a list."""
    if not value:
        return []
    if isinstance(value, list):
        return value
    if isinstance(value, str):
        return [value]
    raise ValueError(f'Invalid {of} type parsed in the dict {value}')


def generate_controllers_spawner_launch_description(
    controller_names: Sequence[str], controller_params_files: Sequence[Any] | None = None,
    extra_spawner_args: Sequence[Any] = (),
) -> LaunchDescription:
    """Starts one spawner for all names; with the arguments controller_manager_name and unload_on_kill."""
    arguments: list[Any] = [*controller_names, '--controller-manager', LaunchConfiguration('controller_manager_name')]
    for file in controller_params_files or ():
        if file:
            arguments += ['--param-file', file]
    arguments.append(PythonExpression([
        '"--unload-on-kill"', ' if "true" == "', LaunchConfiguration('unload_on_kill'), '" else ""']))
    return LaunchDescription([
        DeclareLaunchArgument('controller_manager_name', default_value='controller_manager',
                              description='Controller manager node name'),
        DeclareLaunchArgument('unload_on_kill', default_value='false',
                              description='Wait until the node is interrupted and then unload controller'),
        _spawner([*arguments, *extra_spawner_args]),
    ])


def generate_controllers_spawner_launch_description_from_dict(
    controller_info_dict: Mapping[str, Any], extra_spawner_args: Sequence[Any] = (),
) -> LaunchDescription:
    """As above: name -> file of parameters, list of files, or None."""
    if not isinstance(controller_info_dict, dict):
        raise ValueError(f'Invalid controller_info_dict type parsed {controller_info_dict}')
    files = [file for given in controller_info_dict.values() for file in _files_of(given, 'controller_params_file')]
    return generate_controllers_spawner_launch_description(list(controller_info_dict), files, extra_spawner_args)


def generate_load_controller_launch_description(
    controller_name: str, controller_params_file: Any = None, extra_spawner_args: Sequence[Any] = (),
) -> LaunchDescription:
    """As above, for one controller."""
    files = [controller_params_file] if controller_params_file else None
    return generate_controllers_spawner_launch_description([controller_name], files, extra_spawner_args)


def _checked(value: Any, wanted: type, of: str) -> Any:
    if not isinstance(value, wanted):
        raise ValueError(
            f'Invalid {of} type parsed in the dict {value}. Expected {wanted.__name__}, got {type(value)}.')
    return value


def generate_spawner_launch_description(
    controller_info_dict: Mapping[str, Mapping[str, Any]], extra_spawner_args: Sequence[Any] = (),
) -> LaunchDescription:
    """Starts one spawner; each controller has its own param_file, load_only, inactive and ros_args."""
    if not isinstance(controller_info_dict, dict):
        raise ValueError(f'Invalid controller_info_dict type parsed {controller_info_dict}')
    arguments: list[Any] = []
    for name, own in controller_info_dict.items():
        arguments += ['--controller', name]
        for file in _files_of(own.get('param_file'), 'controller_params_file'):
            arguments += ['--param-file', file]
        for key, flag in (('load_only', '--load-only'), ('inactive', '--inactive')):
            if _checked(own.get(key, False), bool, key):
                arguments.append(flag)
        if 'ros_args' in own:
            arguments += ['--controller-ros-args', _checked(own['ros_args'], str, 'ros_args')]
    return LaunchDescription([_spawner([*arguments, *extra_spawner_args])])
