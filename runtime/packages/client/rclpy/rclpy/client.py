"""Service clients."""
from __future__ import annotations

from collections.abc import Callable
from types import TracebackType
from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.clock import Clock
from rclpy.context import Context
from rclpy.exceptions import InvalidHandle
from rclpy.impl.elsewhere import names_of
from rclpy.impl.waiting import wait_for_answer, wait_until
from rclpy.qos import QoSProfile
from rclpy.service_introspection import ServiceEvents, ServiceIntrospectionState
from rclpy.task import Future
from ros2wasm import host
from ros2wasm.entities import changes

__getattr__ = names_of(__name__, {
    'rclpy.type_support': 'SrvType SrvTypeRequest SrvTypeResponse',
    'typing': 'Dict Optional TypeVar',
})


class Client:
    """Made by Node.create_client."""

    def __init__(
        self, context: Context, endpoint: host.Endpoint, srv_type: Any, srv_name: str, qos_profile: QoSProfile,
        callback_group: CallbackGroup, logger_name: str, find_executor: Callable[[], Any]
    ) -> None:
        self.context = context
        self._endpoint = endpoint
        self._destroyed = False
        self._logger_name = logger_name
        self.srv_type = srv_type
        #: As it was given when the node made it; its full name is service_name.
        self.srv_name = srv_name
        self._rw_name = srv_name
        self.qos_profile = qos_profile
        #: By the sequence number of the request.
        self._pending_requests: dict[int, Future] = {}
        self.callback_group = callback_group
        self._executor_event = False
        #: The executor of the client's node.
        self._find_executor = find_executor
        #: Set by the node, of what a user made.
        self._events: ServiceEvents | None = None

    @property
    def handle(self) -> Client:
        return self

    @property
    def service_name(self) -> str:
        return self._rw_name

    @property
    def logger_name(self) -> str:
        return self._logger_name

    def _check(self) -> None:
        if self._destroyed:
            raise InvalidHandle('cannot use Destroyable because destruction was requested')

    def call(self, request: Any, timeout_sec: float | None = None) -> Any:
        """
        Ask, and wait for the answer.

        An executor must take it meanwhile, which that of the calling callback cannot do with one thread. None after
        timeout_sec.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError()
        future = self.call_async(request)
        if not wait_for_answer(future, self.context, self._find_executor(), self, 'Client.call', timeout_sec):
            self.remove_pending_request(future)
        return future.result()

    def call_async(self, request: Any) -> Future:
        """Ask; a Future of the answer."""
        self._check()
        if not isinstance(request, self.srv_type.Request):
            raise TypeError()
        info = self._endpoint.write(self.srv_type.Request._codec, request)
        future = Future(executor=self._find_executor())
        self._pending_requests[info.sequence] = future
        if self._events is not None:
            self._events.tell('REQUEST_SENT', self._endpoint.gid, info.sequence, request)
        future.add_done_callback(self.remove_pending_request)
        return future

    def get_pending_request(self, sequence_number: int) -> Future:
        return self._pending_requests[sequence_number]

    def remove_pending_request(self, future: Future) -> None:
        """Forget a request: its answer is dropped."""
        for sequence, pending in self._pending_requests.items():
            if pending is future:
                del self._pending_requests[sequence]
                return

    def service_is_ready(self) -> bool:
        """Does a server match?"""
        self._check()
        return self._endpoint.matched() > 0

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server. False: the time was over before."""
        return wait_until(self.service_is_ready, self.context, timeout_sec)

    def _rw_take_call(self) -> Callable[[], Any] | None:
        return (lambda: None) if self._receive() else None

    def _receive(self) -> bool:
        """Give one response to its future. False: there is none."""
        taken = self._endpoint.take(self.srv_type.Response._codec)
        if taken is None:
            return False
        response, info = taken
        if self._events is not None:
            self._events.tell('RESPONSE_RECEIVED', self._endpoint.gid, info.related_sequence, response)
        future = self._pending_requests.get(info.related_sequence)
        # Nobody may want the answer any more.
        if future is not None:
            future.set_result(response)
        return True

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Tell others of the calls, or no more."""
        self._check()
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

    def __enter__(self) -> Client:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.destroy()
