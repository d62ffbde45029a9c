"""Reaching the parameters of other nodes."""
from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import Any

from rcl_interfaces.msg import ParameterEvent
from rcl_interfaces.srv import (
    DescribeParameters, GetParameters, GetParameterTypes, ListParameters, SetParameters, SetParametersAtomically,
)
from rclpy.callback_groups import CallbackGroup
from rclpy.client import Client
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.impl.elsewhere import names_of
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file
from rclpy.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from rclpy.qos_overriding_options import QoSOverridingOptions
from rclpy.subscription import Subscription
from rclpy.task import Future

__getattr__ = names_of(__name__, {
    'rcl_interfaces.msg': 'Parameter=ParameterMsg',
    'rclpy.node': 'Node',
    'typing': 'List Optional Union',
})


class AsyncParameterClient:
    """Asks the parameter services of one node; each answer is a Future."""

    def __init__(
        self, node: Any, remote_node_name: str, qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None
    ) -> None:
        self.remote_node_name = remote_node_name
        self.node = node

        def make(type_: Any, name: str) -> Client:
            client: Client = node.create_client(
                type_, f'{remote_node_name}/{name}', qos_profile=qos_profile, callback_group=callback_group)
            return client
        self._get_parameter_client = make(GetParameters, 'get_parameters')
        self._list_parameter_client = make(ListParameters, 'list_parameters')
        self._set_parameter_client = make(SetParameters, 'set_parameters')
        self._get_parameter_types_client = make(GetParameterTypes, 'get_parameter_types')
        self._describe_parameters_client = make(DescribeParameters, 'describe_parameters')
        self._set_parameters_atomically_client = make(SetParametersAtomically, 'set_parameters_atomically')
        self._clients = (
            self._get_parameter_client, self._list_parameter_client, self._set_parameter_client,
            self._get_parameter_types_client, self._describe_parameters_client,
            self._set_parameters_atomically_client)

    def services_are_ready(self) -> bool:
        """Are all services there?"""
        return all(client.service_is_ready() for client in self._clients)

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Wait for all services. False: the time was over before."""
        end = None if timeout_sec is None else time.monotonic() + timeout_sec
        return all(client.wait_for_service(None if end is None else max(0.0, end - time.monotonic()))
                   for client in self._clients)

    def _ask(self, client: Client, request: Any, callback: Callable[[Future], None] | None) -> Future:
        future = client.call_async(request)
        if callback is not None:
            future.add_done_callback(callback)
        return future

    def _messages(self, parameters: Sequence[Any]) -> list[Any]:
        return [one.to_parameter_msg() if isinstance(one, Parameter) else one for one in parameters]

    def list_parameters(
        self, prefixes: list[str] | None = None, depth: int | None = None,
        callback: Callable[[Future], None] | None = None
    ) -> Future:
        request = ListParameters.Request(depth=depth or 0)
        if prefixes:
            request.prefixes = list(prefixes)
        return self._ask(self._list_parameter_client, request, callback)

    def get_parameters(self, names: list[str], callback: Callable[[Future], None] | None = None) -> Future:
        return self._ask(self._get_parameter_client, GetParameters.Request(names=list(names)), callback)

    def set_parameters(
        self, parameters: Sequence[Any], callback: Callable[[Future], None] | None = None
    ) -> Future:
        request = SetParameters.Request(parameters=self._messages(parameters))
        return self._ask(self._set_parameter_client, request, callback)

    def describe_parameters(self, names: list[str], callback: Callable[[Future], None] | None = None) -> Future:
        return self._ask(self._describe_parameters_client, DescribeParameters.Request(names=list(names)), callback)

    def get_parameter_types(self, names: list[str], callback: Callable[[Future], None] | None = None) -> Future:
        return self._ask(self._get_parameter_types_client, GetParameterTypes.Request(names=list(names)), callback)

    def set_parameters_atomically(
        self, parameters: Sequence[Any], callback: Callable[[Future], None] | None = None
    ) -> Future:
        request = SetParametersAtomically.Request(parameters=self._messages(parameters))
        return self._ask(self._set_parameters_atomically_client, request, callback)

    def delete_parameters(self, names: list[str], callback: Callable[[Future], None] | None = None) -> Future:
        """Unset them; what was declared with a type cannot be."""
        parameters = [Parameter(name=name).to_parameter_msg() for name in names]
        return self._ask(self._set_parameter_client, SetParameters.Request(parameters=parameters), callback)

    def load_parameter_file(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callable[[Future], None] | None = None
    ) -> Future:
        """Set what a file says."""
        return self.set_parameters(self._of_file(parameter_file, use_wildcard), callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callable[[Future], None] | None = None
    ) -> Future:
        return self.set_parameters_atomically(self._of_file(parameter_file, use_wildcard), callback)

    def on_parameter_event(
        self, callback: Callable[..., Any], qos_profile: QoSProfile = qos_profile_parameter_events, *,
        callback_group: CallbackGroup | None = None, event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None, raw: bool = False
    ) -> Subscription:
        """Hear of the parameters of all nodes."""
        made: Subscription = self.node.create_subscription(
            ParameterEvent, '/parameter_events', callback, qos_profile, callback_group=callback_group,
            event_callbacks=event_callbacks, qos_overriding_options=qos_overriding_options, raw=raw)
        return made

    def _of_file(self, parameter_file: str, use_wildcard: bool) -> list[Any]:
        return list(parameter_dict_from_yaml_file(parameter_file, use_wildcard).values())
