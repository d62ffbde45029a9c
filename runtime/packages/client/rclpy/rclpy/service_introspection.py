"""Telling of calls of a service, on `SERVICE/_service_event`."""
from __future__ import annotations

from enum import IntEnum
from typing import Any

from ros2wasm.constants import EndpointKind

TOPIC_POSTFIX = '/_service_event'
NS = 1_000_000_000


class ServiceIntrospectionState(IntEnum):
    """How much is told."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


class ServiceEvents:
    """The events of one client or service; nothing is told until it is configured."""

    def __init__(self, node: Any, srv_type: Any, srv_name: str) -> None:
        self._node = node
        self._type = srv_type
        self._name = srv_name
        self._endpoint: Any = None
        self._clock: Any = None
        self._state = ServiceIntrospectionState.OFF

    def configure(self, clock: Any, qos_profile: Any, state: ServiceIntrospectionState) -> None:
        self._state = ServiceIntrospectionState(state)
        self._clock = clock
        if self._state is ServiceIntrospectionState.OFF:
            self.destroy()
        elif self._endpoint is None:
            self._endpoint = self._node._rw_endpoint(
                EndpointKind.PUBLISHER, self._type.Event, self._name + TOPIC_POSTFIX, qos_profile)

    def tell(self, kind: str, client_gid: bytes, sequence: int, message: Any) -> None:
        """Tell of a REQUEST_SENT and the like."""
        if self._endpoint is None:
            return
        event = self._type.Event()
        event.info.event_type = getattr(type(event.info), kind)
        event.info.stamp.sec, event.info.stamp.nanosec = divmod(self._clock.now().nanoseconds, NS)
        event.info.client_gid = list(client_gid)
        event.info.sequence_number = sequence
        if self._state is ServiceIntrospectionState.CONTENTS:
            (event.request if kind.startswith('REQUEST') else event.response).append(message)
        self._endpoint.publish(self._type.Event._codec, event)

    def destroy(self) -> None:
        if self._endpoint is not None:
            self._endpoint.destroy()
            self._endpoint = None
