"""Nodes."""
from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from types import TracebackType
from typing import Any

from rclpy._rclpy_pybind11 import NodeNameNonExistentError as NodeNameNonExistentError  # noqa: F401
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock
from rclpy.constants import S_TO_NS
from rclpy.context import Context
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.guard_condition import GuardCondition
from rclpy.impl import best_available, rosout
from rclpy.impl.elsewhere import names_of
from rclpy.impl.node_graph import NodeGraph
from rclpy.impl.node_parameters import NodeParameters
from rclpy.parameter import Parameter
from rclpy.parameter_service import ParameterService
from rclpy.publisher import Publisher
from rclpy.qos import (
    QoSProfile, qos_profile_parameter_events, qos_profile_rosout_default, qos_profile_services_default, to_bus,
)
from rclpy.qos_overriding_options import QoSOverridingOptions, declare_qos_parameters
from rclpy.service import Service
from rclpy.service_introspection import ServiceEvents
from rclpy.subscription import Subscription
from rclpy.time_source import TimeSource
from rclpy.timer import Rate, Timer
from rclpy.type_description_service import TypeDescriptionService
from rclpy.type_support import check_is_valid_msg_type, check_is_valid_srv_type
from ros2wasm import host
from ros2wasm.constants import EndpointKind
from ros2wasm.entities import changes
from ros2wasm.types import type_hash, type_name

HIDDEN_NODE_PREFIX = '_'
ROSOUT_TOPIC, EVENTS_TOPIC = '/rosout', '/parameter_events'

__getattr__ = names_of(__name__, {
    'rcl_interfaces.msg': 'FloatingPointRange IntegerRange ListParametersResult Parameter=ParameterMsg '
                          'ParameterDescriptor ParameterEvent ParameterType ParameterValue SetParametersResult',
    'rcl_interfaces.srv': 'ListParameters',
    'rclpy.callback_groups': 'ReentrantCallbackGroup',
    'rclpy.clock': 'ROSClock',
    'rclpy.exceptions': 'InvalidHandle InvalidParameterTypeException InvalidParameterValueException '
                        'InvalidTopicNameException NotInitializedException ParameterAlreadyDeclaredException '
                        'ParameterImmutableException ParameterNotDeclaredException ParameterUninitializedException',
    'rclpy.executors': 'Executor',
    'rclpy.expand_topic_name': 'expand_topic_name',
    'rclpy.logging': 'get_logger',
    'rclpy.logging_service': 'LoggingService',
    'rclpy.parameter': 'PARAMETER_SEPARATOR_STRING',
    'rclpy.topic_endpoint_info': 'TopicEndpointInfo',
    'rclpy.type_support': 'MsgType SrvType SrvTypeRequest SrvTypeResponse',
    'rclpy.utilities': 'get_default_context',
    'rclpy.validate_full_topic_name': 'validate_full_topic_name',
    'rclpy.validate_namespace': 'validate_namespace',
    'rclpy.validate_node_name': 'validate_node_name',
    'rclpy.validate_parameter_name': 'validate_parameter_name',
    'rclpy.validate_topic_name': 'validate_topic_name',
    'rclpy.waitable': 'Waitable',
    'typing': 'Dict List Optional Tuple Type TypeVar Union',
})


class Node(NodeParameters, NodeGraph):
    """Has a name in the graph, and makes what speaks there."""

    def __init__(
        self, node_name: str, *, context: Context | None = None, cli_args: Sequence[str] | None = None,
        namespace: str | None = None, use_global_arguments: bool = True, enable_rosout: bool = True,
        rosout_qos_profile: QoSProfile | int = qos_profile_rosout_default, start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None, allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False, enable_logger_service: bool = False
    ) -> None:
        self._publishers: list[Publisher] = []
        self._subscriptions: list[Subscription] = []
        self._clients: list[Client] = []
        self._services: list[Service] = []
        self._timers: list[Timer] = []
        self._guards: list[GuardCondition] = []
        self._rw_rates: list[Rate] = []
        self._rw_waitables: list[Any] = []
        self._rw_used_types: dict[str, str] = {}
        self._rw_executor: Any = None
        self._rw_rosout: Publisher | None = None
        self._parameter_event_publisher: Publisher | None = None
        self._default_callback_group: CallbackGroup = MutuallyExclusiveCallbackGroup()
        self._rw_destroyed = False
        self._rw_begin(node_name, context, cli_args, namespace, use_global_arguments)
        if enable_rosout and self._context._arguments.log_rosout:
            from rcl_interfaces.msg import Log
            self._rw_rosout = self.create_publisher(Log, ROSOUT_TOPIC, rosout_qos_profile)
            self._publishers.remove(self._rw_rosout)
            rosout.add(self._logger.name, self._rw_rosout)
        self._rw_begin_parameters(parameter_overrides, allow_undeclared_parameters)
        from rcl_interfaces.msg import ParameterEvent
        self._parameter_event_publisher = self.create_publisher(
            ParameterEvent, EVENTS_TOPIC, qos_profile_parameter_events)
        if automatically_declare_parameters_from_overrides:
            from rcl_interfaces.msg import ParameterDescriptor
            self.declare_parameters('', [
                (name, one.value, ParameterDescriptor(dynamic_typing=True))
                for name, one in self._parameter_overrides.items()], ignore_override=True)
        self._time_source = TimeSource(node=self)
        self._time_source.attach_clock(self._clock)
        if start_parameter_services:
            self._parameter_service = ParameterService(self)
        if enable_logger_service:
            from rclpy.logging_service import LoggingService
            self._logger_service = LoggingService(self)
        self._type_description_service = TypeDescriptionService(self)

    # ---- what it has

    @property
    def publishers(self) -> Iterator[Publisher]:
        yield from self._publishers

    @property
    def subscriptions(self) -> Iterator[Subscription]:
        yield from self._subscriptions

    @property
    def clients(self) -> Iterator[Client]:
        yield from self._clients

    @property
    def services(self) -> Iterator[Service]:
        yield from self._services

    @property
    def timers(self) -> Iterator[Timer]:
        yield from self._timers

    @property
    def guards(self) -> Iterator[GuardCondition]:
        yield from self._guards

    @property
    def waitables(self) -> Iterator[Any]:
        yield from self._rw_waitables

    @property
    def executor(self) -> Any:
        return self._rw_executor

    @executor.setter
    def executor(self, new_executor: Any) -> None:
        current = self._rw_executor
        if current is new_executor:
            return
        if current is not None:
            current.remove_node(self)
        self._rw_executor = new_executor
        if new_executor is not None:
            new_executor.add_node(self)

    def _wake_executor(self) -> None:
        host.wake()

    @property
    def default_callback_group(self) -> CallbackGroup:
        return self._default_callback_group

    @property
    def handle(self) -> Node:
        return self

    def add_waitable(self, waitable: Any) -> None:
        self._rw_waitables.append(waitable)
        changes.add()
        host.wake()

    def remove_waitable(self, waitable: Any) -> None:
        self._rw_waitables.remove(waitable)
        changes.add()
        host.wake()

    # ---- what it makes

    def _rw_endpoint(
        self, kind: EndpointKind, interface: Any, full_name: str, qos: QoSProfile
    ) -> host.Endpoint:
        name = type_name(interface)
        hash_ = type_hash(name)
        self._rw_used_types[hash_] = name
        return host.Endpoint(kind, self._rw_bus_node, full_name, name, hash_, to_bus(qos))

    def _rw_closed(self, qos: QoSProfile, topic: str, others: EndpointKind) -> QoSProfile:
        """Without open policies: they are chosen by those who are on the topic already."""
        if not best_available.is_open(qos):
            return qos
        found = [one.qos for one in host.graph()[1] if one.kind == others and one.name == topic]
        return best_available.choose(qos, found, others == EndpointKind.PUBLISHER)

    def _validate_qos_or_depth_parameter(self, qos_or_depth: QoSProfile | int) -> QoSProfile:
        if isinstance(qos_or_depth, QoSProfile):
            return qos_or_depth
        if not isinstance(qos_or_depth, int):
            raise TypeError(f'Expected QoSProfile or int, but received {type(qos_or_depth)!r}')
        if qos_or_depth < 0:
            raise ValueError('history depth must be greater than or equal to zero')
        return QoSProfile(depth=qos_or_depth)

    def create_publisher(
        self, msg_type: Any, topic: str, qos_profile: QoSProfile | int, *,
        callback_group: CallbackGroup | None = None, event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None, publisher_class: type[Any] = Publisher
    ) -> Any:
        qos = self._validate_qos_or_depth_parameter(qos_profile)
        check_is_valid_msg_type(msg_type)
        full = self._rw_resolve(topic, False)
        if qos_overriding_options is not None:
            qos = declare_qos_parameters(Publisher, self, full, qos, qos_overriding_options)
        qos = self._rw_closed(qos, full, EndpointKind.SUBSCRIPTION)
        endpoint = self._rw_endpoint(EndpointKind.PUBLISHER, msg_type, full, qos)
        publisher = publisher_class(
            endpoint, msg_type, full, qos, event_callbacks or PublisherEventCallbacks(),
            callback_group or self.default_callback_group, self._logger.name)
        publisher.topic = topic
        self._publishers.append(publisher)
        self._rw_adopt_events(publisher)
        return publisher

    def create_subscription(
        self, msg_type: Any, topic: str, callback: Callable[..., Any], qos_profile: QoSProfile | int, *,
        callback_group: CallbackGroup | None = None, event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None, raw: bool = False
    ) -> Subscription:
        qos = self._validate_qos_or_depth_parameter(qos_profile)
        check_is_valid_msg_type(msg_type)
        full = self._rw_resolve(topic, False)
        if qos_overriding_options is not None:
            qos = declare_qos_parameters(Subscription, self, full, qos, qos_overriding_options)
        group = callback_group or self.default_callback_group
        qos = self._rw_closed(qos, full, EndpointKind.PUBLISHER)
        endpoint = self._rw_endpoint(EndpointKind.SUBSCRIPTION, msg_type, full, qos)
        subscription = Subscription(
            endpoint, msg_type, full, callback, group, qos, raw, event_callbacks or SubscriptionEventCallbacks(),
            self._logger.name)
        subscription.topic = topic
        self._rw_add(self._subscriptions, subscription, group)
        self._rw_adopt_events(subscription)
        return subscription

    def _rw_add(self, to: list[Any], entity: Any, group: CallbackGroup) -> None:
        to.append(entity)
        group.add_entity(entity)
        changes.add()
        host.wake()

    def _rw_adopt_events(self, owner: Any) -> None:
        for handler in owner.event_handlers:
            self.add_waitable(handler)

    def create_client(
        self, srv_type: Any, srv_name: str, *, qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None
    ) -> Client:
        check_is_valid_srv_type(srv_type)
        full = self._rw_resolve(srv_name, True)
        client = self._rw_client(srv_type, full, qos_profile, callback_group or self.default_callback_group)
        client.srv_name = srv_name
        client._events = ServiceEvents(self, srv_type, full)
        self._rw_add(self._clients, client, client.callback_group)
        return client

    def _rw_client(self, srv_type: Any, full_name: str, qos: QoSProfile, group: CallbackGroup) -> Client:
        """One that the node does not list."""
        endpoint = self._rw_endpoint(EndpointKind.CLIENT, srv_type, full_name, qos)
        return Client(
            self._context, endpoint, srv_type, full_name, qos, group, self._logger.name, lambda: self._rw_executor)

    def create_service(
        self, srv_type: Any, srv_name: str, callback: Callable[[Any, Any], Any], *,
        qos_profile: QoSProfile = qos_profile_services_default, callback_group: CallbackGroup | None = None
    ) -> Service:
        check_is_valid_srv_type(srv_type)
        full = self._rw_resolve(srv_name, True)
        service = self._rw_service(srv_type, full, callback, qos_profile, callback_group or self.default_callback_group)
        service.srv_name = srv_name
        service._events = ServiceEvents(self, srv_type, full)
        self._rw_add(self._services, service, service.callback_group)
        return service

    def _rw_service(
        self, srv_type: Any, full_name: str, callback: Callable[[Any, Any], Any], qos: QoSProfile, group: CallbackGroup
    ) -> Service:
        """One that the node does not list."""
        endpoint = self._rw_endpoint(EndpointKind.SERVER, srv_type, full_name, qos)
        return Service(endpoint, srv_type, full_name, callback, group, qos, self._logger.name)

    def create_timer(
        self, timer_period_sec: float, callback: Callable[[], Any] | None,
        callback_group: CallbackGroup | None = None, clock: Clock | None = None, autostart: bool = True
    ) -> Timer:
        group = callback_group or self.default_callback_group
        timer = Timer(
            callback, group, int(float(timer_period_sec) * S_TO_NS), clock or self._clock, context=self._context,
            autostart=autostart)
        self._rw_add(self._timers, timer, group)
        return timer

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        group = callback_group or self.default_callback_group
        guard = GuardCondition(callback, group, context=self._context)
        self._rw_add(self._guards, guard, group)
        return guard

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        if frequency <= 0:
            raise ValueError('frequency must be > 0')
        # A group of its own, so that other callbacks do not keep it from its beat.
        timer = self.create_timer(1 / frequency, None, MutuallyExclusiveCallbackGroup(), clock)
        rate = Rate(timer, context=self._context, find_executor=lambda: self.executor)
        self._rw_rates.append(rate)
        return rate

    # ---- what it ends

    def _rw_drop(self, of: list[Any], entity: Any) -> bool:
        if entity not in of:
            return False
        for handler in getattr(entity, 'event_handlers', ()):
            if handler in self._rw_waitables:
                self._rw_waitables.remove(handler)
        of.remove(entity)
        entity.destroy()
        changes.add()
        host.wake()
        return True

    def destroy_publisher(self, publisher: Publisher) -> bool:
        return self._rw_drop(self._publishers, publisher)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        return self._rw_drop(self._subscriptions, subscription)

    def destroy_client(self, client: Client) -> bool:
        return self._rw_drop(self._clients, client)

    def destroy_service(self, service: Service) -> bool:
        return self._rw_drop(self._services, service)

    def destroy_timer(self, timer: Timer) -> bool:
        return self._rw_drop(self._timers, timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        return self._rw_drop(self._guards, guard)

    def destroy_rate(self, rate: Rate) -> bool:
        self._rw_drop(self._timers, rate._timer)
        return self._rw_drop(self._rw_rates, rate)

    def destroy_node(self) -> None:
        """Destroy the node and all that it made."""
        if self._rw_destroyed:
            return
        self._rw_destroyed = True
        executor, self._rw_executor = self._rw_executor, None
        if executor is not None:
            executor.remove_node(self)
        self._time_source.detach_node()
        if self._rw_rosout is not None:
            rosout.remove(self._logger.name, self._rw_rosout)
            self._rw_rosout.destroy()
        self._parameter_event_publisher = None
        for waitable in list(self._rw_waitables):
            waitable.destroy()
        self._rw_waitables.clear()
        made: list[list[Any]] = [self._publishers, self._subscriptions, self._clients, self._services, self._timers,
                                 self._guards, self._rw_rates]
        for entities in made:
            for entity in list(entities):
                self._rw_drop(entities, entity)
        host.node_destroy(self._rw_bus_node)

    def __enter__(self) -> Node:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.destroy_node()
