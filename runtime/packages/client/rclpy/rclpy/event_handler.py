"""Events of publishers and subscriptions: statuses that changed."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from rclpy._rclpy_pybind11 import UnsupportedEventTypeError as UnsupportedEventTypeError  # noqa: F401
from rclpy.callback_groups import CallbackGroup
from rclpy.logging import get_logger
from rclpy.qos import qos_policy_name_from_kind
from ros2wasm import host
from ros2wasm.constants import StatusKind
from ros2wasm.entities import changes


class QoSPublisherEventType(IntEnum):
    """What can happen to a publisher; the numbers are those of rcl."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(IntEnum):
    """What can happen to a subscription; the numbers are those of rcl."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


@dataclass
class QoSDeadlineInfo:
    total_count: int
    total_count_change: int


class QoSRequestedDeadlineMissedInfo(QoSDeadlineInfo):
    """Deadlines that a subscription missed."""


class QoSOfferedDeadlineMissedInfo(QoSDeadlineInfo):
    """Deadlines that a publisher missed."""


class QoSLivelinessLostInfo(QoSDeadlineInfo):
    """Leases that ran out."""


class QoSMessageLostInfo(QoSDeadlineInfo):
    """Messages that never came."""


class IncompatibleTypeInfo(QoSDeadlineInfo):
    """Others of the topic with another type."""


@dataclass
class QoSLivelinessChangedInfo:
    alive_count: int
    not_alive_count: int
    alive_count_change: int
    not_alive_count_change: int


@dataclass
class QoSIncompatibleInfo:
    total_count: int
    total_count_change: int
    last_policy_kind: int


class QoSRequestedIncompatibleQoSInfo(QoSIncompatibleInfo):
    """Publishers that offer less."""


class QoSOfferedIncompatibleQoSInfo(QoSIncompatibleInfo):
    """Subscriptions that want more."""


@dataclass
class MatchedInfo:
    total_count: int
    total_count_change: int
    current_count: int
    current_count_change: int


class QoSSubscriptionMatchedInfo(MatchedInfo):
    """Publishers of a subscription."""


class QoSPublisherMatchedInfo(MatchedInfo):
    """Subscriptions of a publisher."""


def _simple(kind: type[Any]) -> Callable[[host.Status], Any]:
    return lambda s: kind(s.total_count, s.total_change)


def _incompatible(kind: type[Any]) -> Callable[[host.Status], Any]:
    return lambda s: kind(s.total_count, s.total_change, s.last_policy)


def _matched(kind: type[Any]) -> Callable[[host.Status], Any]:
    return lambda s: kind(s.total_count, s.total_change, s.current_count, s.current_change)


_P, _S = QoSPublisherEventType, QoSSubscriptionEventType
_EVENTS: dict[Any, tuple[StatusKind, Callable[[host.Status], Any]]] = {
    _P.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED:
        (StatusKind.OFFERED_DEADLINE_MISSED, _simple(QoSOfferedDeadlineMissedInfo)),
    _P.RCL_PUBLISHER_LIVELINESS_LOST: (StatusKind.LIVELINESS_LOST, _simple(QoSLivelinessLostInfo)),
    _P.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS:
        (StatusKind.OFFERED_QOS_INCOMPATIBLE, _incompatible(QoSOfferedIncompatibleQoSInfo)),
    _P.RCL_PUBLISHER_INCOMPATIBLE_TYPE: (StatusKind.PUBLISHER_INCOMPATIBLE_TYPE, _simple(IncompatibleTypeInfo)),
    _P.RCL_PUBLISHER_MATCHED: (StatusKind.PUBLICATION_MATCHED, _matched(QoSPublisherMatchedInfo)),
}
_SUBSCRIPTION_EVENTS: dict[Any, tuple[StatusKind, Callable[[host.Status], Any]]] = {
    _S.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED:
        (StatusKind.REQUESTED_DEADLINE_MISSED, _simple(QoSRequestedDeadlineMissedInfo)),
    _S.RCL_SUBSCRIPTION_LIVELINESS_CHANGED: (
        StatusKind.LIVELINESS_CHANGED,
        lambda s: QoSLivelinessChangedInfo(s.current_count, s.total_count, s.current_change, s.total_change)),
    _S.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS:
        (StatusKind.REQUESTED_QOS_INCOMPATIBLE, _incompatible(QoSRequestedIncompatibleQoSInfo)),
    _S.RCL_SUBSCRIPTION_MESSAGE_LOST: (StatusKind.MESSAGE_LOST, _simple(QoSMessageLostInfo)),
    _S.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE:
        (StatusKind.SUBSCRIPTION_INCOMPATIBLE_TYPE, _simple(IncompatibleTypeInfo)),
    _S.RCL_SUBSCRIPTION_MATCHED: (StatusKind.SUBSCRIPTION_MATCHED, _matched(QoSSubscriptionMatchedInfo)),
}


class EventHandler:
    """Watches one status of an endpoint, and calls back when it changed."""

    def __init__(
        self, *, callback_group: CallbackGroup, callback: Callable[[Any], None], event_type: Any,
        parent_impl: Any
    ) -> None:
        self.callback_group = callback_group
        self.callback = callback
        self.event_type = event_type
        self._endpoint: host.Endpoint = parent_impl._endpoint
        table = _EVENTS if isinstance(event_type, QoSPublisherEventType) else _SUBSCRIPTION_EVENTS
        self._kind, self._make = table[event_type]
        self._destroyed = False
        self._executor_event = False
        self._version = -1
        # From its first reading on, a change of the status by time alone ends a wait.
        self._found = self._endpoint.status(self._kind)

    def _rw_handles(self) -> list[int]:
        return []

    def _rw_ready(self) -> bool:
        if self._is_empty():
            self._found = None
        version = host.status_version()
        if self._found is None and version != self._version and not self._destroyed:
            self._version = version
            self._found = self._endpoint.status(self._kind)
        return self._found is not None and not self._is_empty()

    def _is_empty(self) -> bool:
        """What was read tells of no change."""
        return self._found is not None and not (self._found.total_change or self._found.current_change)

    def _rw_take_call(self) -> Callable[[], Any] | None:
        if not self._rw_ready() or self._found is None:
            return None
        info = self._make(self._found)
        self._found = None
        self._version = -1
        return lambda: self.callback(info)

    def destroy(self) -> None:
        self._destroyed = True
        changes.add()


QoSEventHandler = EventHandler


class SubscriptionEventCallbacks:
    """What to call when something happens to a subscription."""

    def __init__(
        self, *, deadline: Callable[[QoSRequestedDeadlineMissedInfo], None] | None = None,
        liveliness: Callable[[QoSLivelinessChangedInfo], None] | None = None,
        message_lost: Callable[[QoSMessageLostInfo], None] | None = None,
        incompatible_qos: Callable[[QoSRequestedIncompatibleQoSInfo], None] | None = None,
        incompatible_type: Callable[[IncompatibleTypeInfo], None] | None = None,
        matched: Callable[[QoSSubscriptionMatchedInfo], None] | None = None, use_default_callbacks: bool = True
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.message_lost = message_lost
        self.incompatible_qos = incompatible_qos
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def create_event_handlers(
        self, callback_group: CallbackGroup, subscription: Any, topic_name: str
    ) -> list[EventHandler]:
        logger = get_logger(subscription.logger_name or 'rclpy')
        kinds = QoSSubscriptionEventType

        def tell_qos(event: Any) -> None:
            policy = qos_policy_name_from_kind(event.last_policy_kind)
            logger.warning(f"New publisher discovered on topic '{topic_name}', offering incompatible QoS. "
                           f'No messages will be received from it. Last incompatible policy: {policy}')

        def tell_type(event: Any) -> None:
            logger.warning(f"Incompatible type on topic '{topic_name}', no messages will be sent to it.")
        callbacks: list[tuple[Any, Any]] = [
            (kinds.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED, self.deadline),
            (kinds.RCL_SUBSCRIPTION_LIVELINESS_CHANGED, self.liveliness),
            (kinds.RCL_SUBSCRIPTION_MESSAGE_LOST, self.message_lost),
            (kinds.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS,
             self.incompatible_qos or (tell_qos if self.use_default_callbacks else None)),
            (kinds.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
             self.incompatible_type or (tell_type if self.use_default_callbacks else None)),
            (kinds.RCL_SUBSCRIPTION_MATCHED, self.matched),
        ]
        return [EventHandler(callback_group=callback_group, callback=callback, event_type=kind,
                             parent_impl=subscription) for kind, callback in callbacks if callback is not None]


class PublisherEventCallbacks:
    """What to call when something happens to a publisher."""

    def __init__(
        self, *, deadline: Callable[[QoSOfferedDeadlineMissedInfo], None] | None = None,
        liveliness: Callable[[QoSLivelinessLostInfo], None] | None = None,
        incompatible_qos: Callable[[QoSOfferedIncompatibleQoSInfo], None] | None = None,
        incompatible_type: Callable[[IncompatibleTypeInfo], None] | None = None,
        matched: Callable[[QoSPublisherMatchedInfo], None] | None = None, use_default_callbacks: bool = True
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.incompatible_qos = incompatible_qos
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def create_event_handlers(
        self, callback_group: CallbackGroup, publisher: Any, topic_name: str
    ) -> list[EventHandler]:
        logger = get_logger(publisher.logger_name or 'rclpy')
        kinds = QoSPublisherEventType

        def tell_qos(event: Any) -> None:
            policy = qos_policy_name_from_kind(event.last_policy_kind)
            logger.warning(f"New subscription discovered on topic '{topic_name}', requesting incompatible QoS. "
                           f'No messages will be sent to it. Last incompatible policy: {policy}')

        def tell_type(event: Any) -> None:
            logger.warning(f"Incompatible type on topic '{topic_name}', no messages will be sent to it.")
        callbacks: list[tuple[Any, Any]] = [
            (kinds.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED, self.deadline),
            (kinds.RCL_PUBLISHER_LIVELINESS_LOST, self.liveliness),
            (kinds.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS,
             self.incompatible_qos or (tell_qos if self.use_default_callbacks else None)),
            (kinds.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
             self.incompatible_type or (tell_type if self.use_default_callbacks else None)),
            (kinds.RCL_PUBLISHER_MATCHED, self.matched),
        ]
        return [EventHandler(callback_group=callback_group, callback=callback, event_type=kind,
                             parent_impl=publisher) for kind, callback in callbacks if callback is not None]
