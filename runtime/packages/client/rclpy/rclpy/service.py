"""Services."""
from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import partial
from types import TracebackType
from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.clock import Clock
from rclpy.exceptions import InvalidHandle
from rclpy.impl.elsewhere import names_of
from rclpy.qos import QoSProfile
from rclpy.service_introspection import ServiceEvents, ServiceIntrospectionState
from ros2wasm import host
from ros2wasm.entities import changes

__getattr__ = names_of(__name__, {
    'rclpy.type_support': 'SrvType SrvTypeRequest SrvTypeResponse',
    'typing': 'TypeVar',
})


class Service:
    """Made by Node.create_service."""

    def __init__(
        self, endpoint: host.Endpoint, srv_type: Any, srv_name: str, callback: Callable[[Any, Any], Any],
        callback_group: CallbackGroup, qos_profile: QoSProfile, logger_name: str
    ) -> None:
        self._endpoint = endpoint
        self._destroyed = False
        self._logger_name = logger_name
        self.srv_type = srv_type
        #: As it was given when the node made it; its full name is service_name.
        self.srv_name = srv_name
        self._rw_name = srv_name
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        self.qos_profile = qos_profile
        #: Set by the node, of what a user made.
        self._events: ServiceEvents | None = None

    @property
    def handle(self) -> Service:
        return self

    @property
    def service_name(self) -> str:
        return self._rw_name

    @property
    def logger_name(self) -> str:
        return self._logger_name

    def send_response(self, response: Any, header: Any) -> None:
        """Answer. `header`: the SampleInfo of the request."""
        if self._destroyed:
            raise InvalidHandle('cannot use Destroyable because destruction was requested')
        if not isinstance(response, self.srv_type.Response):
            raise TypeError()
        self._endpoint.write(self.srv_type.Response._codec, response, header.related_sequence, header.related_gid)
        if self._events is not None:
            self._events.tell('RESPONSE_SENT', header.related_gid, header.related_sequence, response)

    def _rw_take_call(self) -> Callable[[], Any] | None:
        taken = self._take_request()
        return None if taken is None else partial(self._answer, *taken)

    def _take_request(self) -> tuple[Any, host.SampleInfo] | None:
        """The next request, with the header that its answer needs; None: there is none."""
        taken: tuple[Any, host.SampleInfo] | None = self._endpoint.take(self.srv_type.Request._codec)
        if taken is not None and self._events is not None:
            request, header = taken
            self._events.tell('REQUEST_RECEIVED', header.related_gid, header.related_sequence, request)
        return taken

    def _answer(self, request: Any, header: Any) -> Any:
        response = self.callback(request, self.srv_type.Response())
        if inspect.iscoroutine(response):
            return self._answer_later(response, header)
        self.send_response(response, header)
        return None

    async def _answer_later(self, response: Any, header: Any) -> None:
        self.send_response(await response, header)

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Tell others of the calls, or no more."""
        assert self._events is not None
        self._events.configure(clock, service_event_qos_profile, introspection_state)

    def destroy(self) -> None:
        if self._destroyed:
            return
        self._destroyed = True
        if self._events is not None:
            self._events.destroy()
        self._endpoint.destroy()
        changes.add()

    def __enter__(self) -> Service:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.destroy()
