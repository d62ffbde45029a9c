"""Puts messages in the order of their times."""
from __future__ import annotations

import threading
from bisect import insort_right
from typing import Any

from builtin_interfaces.msg import Time as TimeMsg
from rclpy.duration import Duration
from rclpy.time import Time

from message_filters.simple_filter import SimpleFilter


def duration(value: Duration | float) -> Duration:
    return value if isinstance(value, Duration) else Duration(seconds=value)


class TimeSequencer(SimpleFilter):
    """Passes each message on when it is `delay` old; what is older than one that was passed on is dropped."""

    def __init__(
        self, input_filter: SimpleFilter | None, delay: Duration | float, update_rate: Duration | float,
        queue_size: int, node: Any, msg_stamp_attr: str = 'header.stamp'
    ) -> None:
        super().__init__()
        self.delay = duration(delay)
        self.update_rate = duration(update_rate)
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self.messages: list[tuple[int, Any]] = []
        self.last_time = Time()
        self.node = node
        self.msg_stamp_attrs = msg_stamp_attr.split('.')
        self.incoming_connection: int | None = None
        self.update_timer = node.create_timer(self.update_rate.nanoseconds / 1e9, self._dispatch)
        if input_filter is not None:
            self.connectInput(input_filter)

    def connectInput(self, input_filter: SimpleFilter) -> None:
        if self.incoming_connection is not None:
            raise RuntimeError('Already connected to an input filter.')
        self.incoming_connection = input_filter.registerCallback(self._add)

    def _add(self, msg: Any) -> None:
        stamp = self._stamp(msg)
        if stamp is None:
            return
        with self.lock:
            if stamp.nanoseconds < self.last_time.nanoseconds:
                return
            insort_right(self.messages, (stamp.nanoseconds, msg), key=lambda pair: pair[0])
            if self.queue_size and len(self.messages) > self.queue_size:
                del self.messages[0]

    def _stamp(self, msg: Any) -> Time | None:
        stamp = msg
        for attribute in self.msg_stamp_attrs:
            stamp = getattr(stamp, attribute, None)
        if stamp is None:
            self.node.get_logger().warning('Cannot use message without timestamp; discarding message.')
            return None
        if not isinstance(stamp, TimeMsg):
            raise TypeError(f"Expected {TimeMsg}, got {type(stamp)} in msg attribute {'.'.join(self.msg_stamp_attrs)}")
        return Time.from_msg(stamp)

    def _dispatch(self) -> None:
        due = []
        with self.lock:
            ripe = self.node.get_clock().now().nanoseconds - self.delay.nanoseconds
            while self.messages and self.messages[0][0] <= ripe:
                stamp, msg = self.messages.pop(0)
                self.last_time = Time(nanoseconds=stamp)
                due.append(msg)
        for msg in due:
            self.signalMessage(msg)

    def shutdown(self) -> None:
        self.update_timer.cancel()
        self.node.destroy_timer(self.update_timer)
