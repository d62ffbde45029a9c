"""What a node is before it has anything: names, remapping, a logger, clocks, a place on the bus."""
from __future__ import annotations

from collections.abc import Sequence

from rclpy._rclpy_pybind11 import RCLInvalidROSArgsError, UnknownROSArgsError
from rclpy.clock import ROSClock
from rclpy.context import Context
from rclpy.exceptions import (
    InvalidNamespaceException, InvalidNodeNameException, InvalidServiceNameException, InvalidTopicNameException,
    NotInitializedException,
)
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.logging import get_logger
from rclpy.utilities import get_default_context
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_topic_name import validate_topic_name
from ros2wasm import host, names
from ros2wasm.arguments import ArgumentError, Arguments, parse, remap_name, remap_namespace, remap_topic


class NodeBase:
    """
    The part of Node that its other parts stand on.

    What a node has and rclpy's has not begins with `_rw_`: programs give their nodes any other name.
    """

    def _rw_begin(
        self, node_name: str, context: Context | None, cli_args: Sequence[str] | None, namespace: str | None,
        use_global_arguments: bool
    ) -> None:
        self._context = get_default_context() if context is None else context
        if not self._context.ok():
            raise NotInitializedException('cannot create node')
        self._rw_sources: list[Arguments] = []
        if cli_args is not None:
            self._rw_sources.append(self._rw_local_arguments(cli_args))
        if use_global_arguments:
            self._rw_sources.append(self._context._arguments)
        space = namespace or '/'
        space = space if space.startswith('/') else f'/{space}'
        problem = names.check_namespace(space)
        if problem is not None:
            raise InvalidNamespaceException(space, *problem)
        problem = names.check_node_name(node_name)
        if problem is not None:
            raise InvalidNodeNameException(node_name, *problem)
        self._rw_name = remap_name(self._rw_sources, node_name)
        self._rw_namespace = remap_namespace(self._rw_sources, node_name, space)
        self._rw_bus_node = host.node_create(self._rw_name, self._rw_namespace)
        self._logger = get_logger(names.join(self._rw_namespace, self._rw_name)[1:].replace('/', '.'))
        self._clock = ROSClock()

    def _rw_local_arguments(self, cli_args: Sequence[str]) -> Arguments:
        try:
            found = parse(list(cli_args))
        except ArgumentError as error:
            raise RCLInvalidROSArgsError(str(error)) from None
        if found.unknown:
            raise UnknownROSArgsError(found.unknown)
        return found

    @property
    def context(self) -> Context:
        return self._context

    def get_name(self) -> str:
        return self._rw_name

    def get_namespace(self) -> str:
        return self._rw_namespace

    def get_fully_qualified_name(self) -> str:
        return names.join(self._rw_namespace, self._rw_name)

    def get_clock(self) -> ROSClock:
        return self._clock

    def get_logger(self) -> RcutilsLogger:
        return self._logger

    def _rw_expand(self, name: str, is_service: bool) -> str:
        try:
            return names.expand(name, self._rw_name, self._rw_namespace)
        except ValueError as error:
            kind = InvalidServiceNameException if is_service else InvalidTopicNameException
            raise kind(name, str(error), name.find('{')) from None

    def _rw_resolve(self, name: str, is_service: bool, only_expand: bool = False) -> str:
        validate_topic_name(name, is_service=is_service)
        full = self._rw_expand(name, is_service)
        if not only_expand:
            full = remap_topic(self._rw_sources, full, is_service, self._rw_name, self._rw_namespace)
        validate_full_topic_name(full, is_service=is_service)
        return full

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        return self._rw_resolve(topic, False, only_expand)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        return self._rw_resolve(service, True, only_expand)
