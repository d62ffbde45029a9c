"""Names that arguments had in ROS 2 Foxy and before, and launch files of that time still give."""
from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from launch.logging import get_logger

_NAMES = {'node_executable': 'executable', 'node_name': 'name', 'node_namespace': 'namespace', 'node_plugin': 'plugin'}


def takes_older_names(initialize: Callable[..., None]) -> Callable[..., None]:
    """Wraps an `__init__`: an older name is said to be one, and stands for the newer."""
    @functools.wraps(initialize)
    def wrapped(self: Any, *arguments: Any, **named: Any) -> None:
        for old, new in _NAMES.items():
            if old in named:
                get_logger('launch_ros').warning(f"The parameter '{old}' is deprecated, use '{new}' instead")
                named[new] = named.pop(old)
        initialize(self, *arguments, **named)
    return wrapped
