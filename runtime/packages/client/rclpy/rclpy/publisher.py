"""Publishers."""
from __future__ import annotations

from types import TracebackType
from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.duration import Duration
from rclpy.exceptions import InvalidHandle
from rclpy.impl.elsewhere import names_of
from rclpy.qos import QoSProfile
from ros2wasm import host

__getattr__ = names_of(__name__, {
    'rclpy.event_handler': 'EventHandler PublisherEventCallbacks',
    'rclpy.type_support': 'MsgType',
    'typing': 'TypeVar Union',
})


class Publisher:
    """Made by Node.create_publisher."""

    def __init__(
        self, endpoint: host.Endpoint, msg_type: Any, topic: str, qos_profile: QoSProfile,
        event_callbacks: Any, callback_group: CallbackGroup, logger_name: str = ''
    ) -> None:
        self._endpoint: host.Endpoint = endpoint
        self._codec = msg_type._codec
        self._destroyed = False
        self.msg_type = msg_type
        #: As it was given when the node made it; its full name is topic_name.
        self.topic = topic
        self._rw_name = topic
        self.qos_profile = qos_profile
        self._logger_name = logger_name
        self.event_handlers: list[Any] = [] if event_callbacks is None else event_callbacks.create_event_handlers(
            callback_group, self, topic)

    @property
    def handle(self) -> Publisher:
        return self

    def _check(self) -> None:
        if self._destroyed:
            raise InvalidHandle('cannot use Destroyable because destruction was requested')

    def publish(self, msg: Any) -> None:
        """Send a message, or bytes that are serialised already."""
        if self._destroyed:
            self._check()
        if isinstance(msg, self.msg_type):
            self._endpoint.publish(self._codec, msg)
        elif isinstance(msg, bytes):
            self._endpoint.write_bytes(msg)
        else:
            raise TypeError(f'Expected {self.msg_type}, got {type(msg)}')

    def get_subscription_count(self) -> int:
        """How many subscriptions match."""
        self._check()
        return self._endpoint.matched()

    @property
    def topic_name(self) -> str:
        self._check()
        return self._rw_name

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

    def assert_liveliness(self) -> None:
        """A sign of life."""
        self._check()
        self._endpoint.assert_liveliness()

    def wait_for_all_acked(self, timeout: Duration = Duration(seconds=-1)) -> bool:
        """Wait until all reliable subscriptions have taken what was sent. They share our memory: at once."""
        self._check()
        return True

    def __enter__(self) -> Publisher:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.destroy()
