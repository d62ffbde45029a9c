"""Hearing of changes of parameters, of any node."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rclpy.callback_groups import CallbackGroup
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.impl.elsewhere import names_of
from rclpy.qos import QoSProfile, qos_profile_parameter_events
from rclpy.qos_overriding_options import QoSOverridingOptions

__getattr__ = names_of(__name__, {
    'rclpy.node': 'Node',
    'rclpy.parameter': 'Parameter',
    'typing': 'Dict Iterable List Optional Tuple Union',
})


class ParameterCallbackHandle:
    """Returned by add_parameter_callback."""

    def __init__(self, parameter_name: str, node_name: str, callback: Callable[[Any], None]) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """Returned by add_parameter_event_callback."""

    def __init__(self, callback: Callable[[Any], None]) -> None:
        self.callback = callback


class ParameterEventHandler:
    """Listens to /parameter_events and calls those whom it concerns; the last added comes first."""

    def __init__(
        self, node: Any, qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: CallbackGroup | None = None, event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None, raw: bool = False
    ) -> None:
        self.node = node
        self.qos_profile = qos_profile
        self._parameter_callbacks: list[ParameterCallbackHandle] = []
        self._event_callbacks: list[ParameterEventCallbackHandle] = []
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent, '/parameter_events', self._on_event, qos_profile, callback_group=callback_group,
            event_callbacks=event_callbacks, qos_overriding_options=qos_overriding_options, raw=raw)

    def destroy(self) -> None:
        self.node.destroy_subscription(self.parameter_event_subscription)

    def _on_event(self, event: Any) -> None:
        for one in list(self._parameter_callbacks):
            parameter = self.get_parameter_from_event(event, one.parameter_name, one.node_name)
            if parameter is not None:
                one.callback(parameter)
        for handle in list(self._event_callbacks):
            handle.callback(event)

    def _full(self, node_name: str | None) -> str:
        if not node_name:
            return str(self.node.get_fully_qualified_name())
        if node_name.startswith('/'):
            return node_name
        return f"{self.node.get_namespace().rstrip('/')}/{node_name}"

    @staticmethod
    def get_parameter_from_event(event: Any, parameter_name: str, node_name: str) -> Any:
        """The parameter in an event, if it is there and was not deleted."""
        if event.node != node_name:
            return None
        for one in (*event.new_parameters, *event.changed_parameters):
            if one.name == parameter_name:
                return one
        return None

    @staticmethod
    def get_parameters_from_event(event: Any) -> Any:
        """All that an event sets."""
        yield from (*event.new_parameters, *event.changed_parameters)

    def add_parameter_event_callback(self, callback: Callable[[Any], None]) -> ParameterEventCallbackHandle:
        """Be told of all events."""
        handle = ParameterEventCallbackHandle(callback)
        self._event_callbacks.insert(0, handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        self._event_callbacks.remove(handle)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str | None, callback: Callable[[Any], None]
    ) -> ParameterCallbackHandle:
        """Be told of one parameter, of the own node when none is named."""
        handle = ParameterCallbackHandle(parameter_name, self._full(node_name), callback)
        self._parameter_callbacks.insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        self._parameter_callbacks.remove(handle)
