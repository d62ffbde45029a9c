"""The default context, arguments, and the like."""
from __future__ import annotations

import sys
from collections.abc import Sequence

from rclpy._rclpy_pybind11 import UnknownROSArgsError as UnknownROSArgsError  # noqa: F401
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from ros2wasm.arguments import parse

g_default_context: Context | None = None


def get_default_context(*, shutting_down: bool = False) -> Context:
    """The context of those who name none. `shutting_down`: the next call makes another."""
    global g_default_context
    if g_default_context is None:
        g_default_context = Context()
    if shutting_down:
        context = g_default_context
        g_default_context = None
        return context
    return g_default_context


def remove_ros_args(args: Sequence[str] | None = None) -> list[str]:
    """What stands outside of --ros-args ... --."""
    return parse(list(args if args is not None else sys.argv)).others


def ok(*, context: Context | None = None) -> bool:
    """Is the context between init and shutdown?"""
    return (get_default_context() if context is None else context).ok()


def shutdown(*, context: Context | None = None) -> None:
    """End a context."""
    (get_default_context(shutting_down=True) if context is None else context).shutdown()


def try_shutdown(*, context: Context | None = None) -> None:
    """End a context that has not ended."""
    if context is not None:
        context.try_shutdown()
    elif g_default_context is not None:
        g_default_context.try_shutdown()


def get_rmw_implementation_identifier() -> str:
    return 'rmw_wasm_cpp'


def get_available_rmw_implementations() -> set[str]:
    """All that a site has: one."""
    return {get_rmw_implementation_identifier()}


def timeout_sec_to_nsec(timeout_sec: int | float | None) -> int:
    """Nanoseconds; -1: without end."""
    if timeout_sec is None or timeout_sec < 0:
        return -1
    return int(timeout_sec * S_TO_NS)
