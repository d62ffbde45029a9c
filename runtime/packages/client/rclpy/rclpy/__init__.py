"""
The Python client library of a site: rclpy's interface, on the site's bus.

Made for programs that were written for ROS 2: init, nodes, spinning, shutdown.
"""
from __future__ import annotations

from collections.abc import Sequence
from types import TracebackType
from typing import Any

from rclpy import _rclpy_pybind11 as _rclpy_pybind11  # noqa: F401
from rclpy.context import Context
from rclpy.executors import Executor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.signals import SignalHandlerOptions, install_signal_handlers, uninstall_signal_handlers
from rclpy.task import Future
from rclpy.utilities import get_default_context, get_rmw_implementation_identifier, ok, try_shutdown
from rclpy.utilities import shutdown as _shutdown

__all__ = [
    'InitContextManager', 'create_node', 'get_default_context', 'get_global_executor',
    'get_rmw_implementation_identifier', 'init', 'ok', 'shutdown', 'spin', 'spin_once',
    'spin_until_future_complete', 'try_shutdown',
]


class InitContextManager:
    """What init returns: `with rclpy.init():` shuts down at its end."""

    def __init__(
        self, args: Sequence[str] | None = None, context: Context | None = None, domain_id: int | None = None,
        signal_handler_options: SignalHandlerOptions | None = None
    ) -> None:
        self.context = get_default_context() if context is None else context
        if signal_handler_options is None:
            signal_handler_options = SignalHandlerOptions.ALL if context is None or \
                context is get_default_context() else SignalHandlerOptions.NO
        self.context.init(args, domain_id=domain_id)
        self.installed_signal_handlers = signal_handler_options != SignalHandlerOptions.NO
        install_signal_handlers(signal_handler_options)

    def __enter__(self) -> InitContextManager:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        if self.context.ok():
            self.context.try_shutdown()
        if self.installed_signal_handlers:
            uninstall_signal_handlers()


def init(
    *, args: Sequence[str] | None = None, context: Context | None = None, domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None
) -> InitContextManager:
    """Begin: arguments are read, signals are handled."""
    return InitContextManager(args, context, domain_id, signal_handler_options)


#: Of the functions below that are given none; it lasts, so that coroutines go on at the next call.
__executor: SingleThreadedExecutor | None = None


def get_global_executor() -> Executor:
    global __executor
    if __executor is None or __executor._is_shutdown or not __executor.context.ok():
        __executor = SingleThreadedExecutor()

        def reset() -> None:
            global __executor
            __executor = None
        get_default_context().on_shutdown(reset)
    return __executor


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """End what init began."""
    _shutdown(context=context)
    if uninstall_handlers or (uninstall_handlers is None and context is None):
        uninstall_signal_handlers()


def create_node(
    node_name: str, *, context: Context | None = None, cli_args: Sequence[str] | None = None,
    namespace: str | None = None, use_global_arguments: bool = True, enable_rosout: bool = True,
    start_parameter_services: bool = True, parameter_overrides: list[Parameter] | None = None,
    allow_undeclared_parameters: bool = False, automatically_declare_parameters_from_overrides: bool = False,
    enable_logger_service: bool = False
) -> Node:
    """A node without a class of its own."""
    return Node(
        node_name, context=context, cli_args=cli_args, namespace=namespace,
        use_global_arguments=use_global_arguments, enable_rosout=enable_rosout,
        start_parameter_services=start_parameter_services, parameter_overrides=parameter_overrides,
        allow_undeclared_parameters=allow_undeclared_parameters,
        automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
        enable_logger_service=enable_logger_service)


def spin_once(node: Any, *, executor: Executor | None = None, timeout_sec: float | None = None) -> None:
    """Call back once, or return when the time is over."""
    executor = get_global_executor() if executor is None else executor
    added = executor.add_node(node)
    try:
        executor.spin_once(timeout_sec=timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


def spin(node: Any, executor: Executor | None = None) -> None:
    """Call back until the end."""
    executor = get_global_executor() if executor is None else executor
    added = executor.add_node(node)
    try:
        while executor.context.ok():
            executor.spin_once()
    finally:
        if added:
            executor.remove_node(node)


def spin_until_future_complete(
    node: Any, future: Future, executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Call back until the future is done or the time is over."""
    executor = get_global_executor() if executor is None else executor
    added = executor.add_node(node)
    try:
        executor.spin_until_future_complete(future, timeout_sec)
    finally:
        if added:
            executor.remove_node(node)
