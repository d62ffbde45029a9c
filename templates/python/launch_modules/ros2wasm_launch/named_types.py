"""
Modules that launch files import for their names: rclpy, messages, launch_testing, osrf_pycommon.

Their types can be named, subclassed and used in annotations. Nodes run in the site, so what would run one here raises.
The workspace's own modules of these names come first.
"""
from __future__ import annotations

import asyncio
import importlib.abc
import importlib.machinery
import importlib.util
import logging
import re
import types
from collections.abc import Callable, Sequence
from enum import IntEnum
from typing import Any

from launch.action import Action
from ros2wasm_launch.entities import Entity

_MESSAGES = re.compile(r'(?P<package>[a-z]\w*)\.(?:msg|srv|action)')
_MESSAGE_PACKAGE = re.compile(r'[a-z]\w*_(?:msgs?|srvs?|actions|interfaces?)')
#: Of rclpy: those that have a name which launch files ask for.
_MODULES = {
    'rclpy': ('action', 'callback_groups', 'client', 'clock', 'constants', 'context', 'duration', 'exceptions',
              'executors', 'lifecycle', 'logging', 'node', 'parameter', 'publisher', 'qos', 'service', 'subscription',
              'task', 'time', 'timer', 'utilities', 'wait_for_message'),
    'launch_testing': ('actions', 'asserts', 'event_handlers', 'io_handler', 'markers', 'parametrization',
                       'proc_info_handler', 'tools', 'util'),
    'launch_testing_ros': ('actions', 'tools'),
    'osrf_pycommon': ('cli_utils', 'process_utils', 'terminal_color', 'terminal_utils'),
}
_KNOWN = {root: {root, *(f'{root}.{name}' for name in names)} for root, names in _MODULES.items()}


class NotHere:
    """A type or a function that can be named."""

    def __new__(cls, *_values: Any, **_named: Any) -> Any:
        raise RuntimeError(f'{cls.__module__}.{cls.__qualname__} cannot be used while a launch file is read: '
                           'nodes run in the site')


class Message:
    """A message, request, response or goal, with the fields that it is given."""

    def __init__(self, **fields: Any) -> None:
        self.__dict__.update(fields)

    def __repr__(self) -> str:
        given = ', '.join(f'{name}={value!r}' for name, value in vars(self).items())
        return f'{type(self).__module__}.{type(self).__name__}({given})'


class Duration:
    """A time span of rclpy."""

    def __init__(self, *, seconds: float = 0, nanoseconds: int = 0) -> None:
        self._nanoseconds = int(seconds * 1_000_000_000) + int(nanoseconds)

    @property
    def nanoseconds(self) -> int:
        return self._nanoseconds


class Time(Duration):
    """A moment of rclpy."""

    def seconds_nanoseconds(self) -> tuple[int, int]:
        return divmod(self._nanoseconds, 1_000_000_000)


class LoggingSeverity(IntEnum):
    UNSET = 0
    DEBUG = 10
    INFO = 20
    WARN = 30
    ERROR = 40
    FATAL = 50


class NoAction(Action):
    """An action of tests, which a launch outside of a test does nothing for."""

    def __init__(self, *_values: Any, **_named: Any) -> None:
        super().__init__()

    def _entities(self) -> list[Entity]:
        return []


def _unchanged(*values: Any, **_named: Any) -> Any:
    """A decorator, with or without arguments."""
    if len(values) == 1 and callable(values[0]):
        return values[0]
    return lambda function: function


_MEMBERS: dict[str, dict[str, Any]] = {
    'rclpy.duration': {'Duration': Duration},
    'rclpy.time': {'Time': Time},
    'rclpy.logging': {'get_logger': logging.getLogger, 'LoggingSeverity': LoggingSeverity},
    'launch_testing': {'parametrize': _unchanged, 'post_shutdown_test': _unchanged},
    'launch_testing.actions': {'ReadyToTest': NoAction},
    'launch_testing.markers': {'keep_alive': _unchanged},
    'launch_testing.util': {'KeepAliveProc': NoAction},
    'launch_testing_ros.actions': {'EnableRmwIsolation': NoAction},
    'osrf_pycommon.process_utils': {'get_loop': asyncio.get_event_loop},
}


def _named(module: types.ModuleType, base: type) -> Callable[[str], Any]:
    """The module's `__getattr__`: a type for each name that it does not have."""
    def get(name: str) -> Any:
        if name.startswith('__'):
            raise AttributeError(f'module {module.__name__!r} has no attribute {name!r}')
        inner = f'{module.__name__}.{name}'
        if inner in _KNOWN.get(module.__name__, ()):
            return importlib.import_module(inner)
        made = type(name, (base,), {'__module__': module.__name__})
        setattr(module, name, made)
        return made
    return get


class NamedTypesFinder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Gives what no other finder has."""

    def find_spec(self, fullname: str, path: Sequence[str] | None, target: types.ModuleType | None = None,
                  ) -> importlib.machinery.ModuleSpec | None:
        root = fullname.partition('.')[0]
        is_known = fullname in _KNOWN.get(root, ()) or _MESSAGES.fullmatch(fullname) is not None
        if not is_known and _MESSAGE_PACKAGE.fullmatch(fullname) is None:
            return None
        return importlib.util.spec_from_loader(fullname, self, is_package='.' not in fullname)

    def exec_module(self, module: types.ModuleType) -> None:
        name = module.__name__
        module.__dict__.update(_MEMBERS.get(name, {}))
        if _MESSAGES.fullmatch(name):
            setattr(module, '__getattr__', _named(module, Message))
        elif name.partition('.')[0] in _KNOWN:
            setattr(module, '__getattr__', _named(module, NotHere))
