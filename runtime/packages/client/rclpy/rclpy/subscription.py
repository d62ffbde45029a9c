"""Subscriptions."""
from __future__ import annotations

import inspect
from collections.abc import Callable
from enum import Enum
from functools import partial
from types import TracebackType
from typing import Any, TypedDict

from rclpy.callback_groups import CallbackGroup
from rclpy.exceptions import InvalidHandle
from rclpy.impl.elsewhere import names_of
from rclpy.qos import QoSProfile
from ros2wasm import host
from ros2wasm.entities import changes

__getattr__ = names_of(__name__, {
    'rclpy.event_handler': 'EventHandler SubscriptionEventCallbacks',
    'rclpy.type_support': 'MsgType',
    'typing': 'TypeVar',
})


class MessageInfo(TypedDict):
    """What a callback with two arguments gets beside the message."""

    source_timestamp: int
    received_timestamp: int
    publication_sequence_number: int | None
    reception_sequence_number: int | None


class Subscription:
    """Made by Node.create_subscription."""

    class CallbackType(Enum):
        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self, endpoint: host.Endpoint, msg_type: Any, topic: str, callback: Callable[..., Any],
        callback_group: CallbackGroup, qos_profile: QoSProfile, raw: bool, event_callbacks: Any, logger_name: str = ''
    ) -> None:
        self._endpoint = endpoint
        self._codec = msg_type._codec
        self._destroyed = False
        self._logger_name = logger_name
        self.msg_type = msg_type
        #: As it was given when the node made it; its full name is topic_name.
        self.topic = topic
        self._rw_name = topic
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        self.qos_profile = qos_profile
        self.raw = raw
        self.event_handlers: list[Any] = [] if event_callbacks is None else event_callbacks.create_event_handlers(
            callback_group, self, topic)

    @property
    def handle(self) -> Subscription:
        return self

    def _check(self) -> None:
        if self._destroyed:
            raise InvalidHandle('cannot use Destroyable because destruction was requested')

    def get_publisher_count(self) -> int:
        """How many publishers match."""
        self._check()
        return self._endpoint.matched()

    def take_message(self, msg_type: Any = None, raw: bool | None = None) -> tuple[Any, MessageInfo] | None:
        """The next message, or its bytes, with its info; None: there is none."""
        self._check()
        as_bytes = self.raw if raw is None else raw
        taken = self._endpoint.take_bytes() if as_bytes else self._endpoint.take(self._codec)
        if taken is None:
            return None
        message, info = taken
        return message, {
            'source_timestamp': info.source_timestamp_ns,
            'received_timestamp': host.system_ns(),
            'publication_sequence_number': info.sequence,
            'reception_sequence_number': None,
        }

    def _rw_take_call(self) -> Callable[[], Any] | None:
        """Take the next message; what remains is to call the callback with it."""
        if self._with_info:
            found = self.take_message()
            if found is None:
                return None
            message, about = found
            return partial(self._callback, message, about)
        if self.raw:
            taken = self._endpoint.take_bytes()
            return None if taken is None else partial(self._callback, taken[0])
        only = self._endpoint.take_message(self._codec)
        return None if only is None else partial(self._callback, only)

    @property
    def topic_name(self) -> str:
        self._check()
        return self._rw_name

    @property
    def callback(self) -> Callable[..., Any]:
        return self._callback

    @callback.setter
    def callback(self, value: Callable[..., Any]) -> None:
        self._callback = value
        self._callback_type = Subscription.CallbackType.MessageOnly
        try:
            inspect.signature(value).bind(object())
        except TypeError:
            try:
                inspect.signature(value).bind(object(), object())
            except TypeError:
                raise RuntimeError(
                    'Subscription.__init__(): callback should be either be callable with one argument'
                    '(to get only the message) or two (to get message and message info)') from None
            self._callback_type = Subscription.CallbackType.WithMessageInfo
        except ValueError:
            # A callable whose arguments nobody knows.
            pass
        self._with_info = self._callback_type is Subscription.CallbackType.WithMessageInfo

    @property
    def logger_name(self) -> str:
        return self._logger_name

    def destroy(self) -> None:
        if self._destroyed:
            return
        self._destroyed = True
        for handler in self.event_handlers:
            handler.destroy()
        self._endpoint.destroy()
        changes.add()

    def __enter__(self) -> Subscription:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.destroy()
