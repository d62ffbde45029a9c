"""What rclpy's C extension raises, under the names by which programs catch it and tracebacks show it."""
from __future__ import annotations

import builtins
from collections.abc import Sequence


class RCLError(RuntimeError):
    """What was asked cannot be done in this state."""


class RCLInvalidROSArgsError(RCLError):
    """What stands between --ros-args and -- cannot be read."""


class NodeNameNonExistentError(RCLError):
    """The graph has no such node."""


class UnsupportedEventTypeError(RCLError):
    """There is no such event of endpoints; a site has all."""


class UnknownROSArgsError(RuntimeError):
    """Between --ros-args and -- stands what nobody knows."""

    def __init__(self, arguments: Sequence[str]) -> None:
        super().__init__(f"Found unknown ROS arguments: {list(arguments)}")
        self.arguments = list(arguments)


class InvalidHandle(RuntimeError):
    """What is used was destroyed."""


class RCUtilsError(RuntimeError):
    """Of a part that a site has not."""


class RMWError(RuntimeError):
    """Of a part that a site has not."""


NotImplementedError = builtins.NotImplementedError
