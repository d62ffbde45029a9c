"""Asks a buffer that another node keeps, by its action."""
from __future__ import annotations

import threading
import warnings
from typing import Any

import builtin_interfaces.msg
from rclpy.action import ActionClient
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_msgs.action import LookupTransform
from tf2_py import (
    ConnectivityException, ExtrapolationException, InvalidArgumentException, LookupException, TimeoutException,
    TransformException,
)

from tf2_ros.buffer_interface import BufferInterface

NS = 1_000_000_000


class BufferClient(BufferInterface):
    """Waits for answers, so that its node must be spun in another thread."""

    def __init__(
        self, node: Any, ns: str, check_frequency: float = 10.0, timeout_padding: Duration = Duration(seconds=2.0)
    ) -> None:
        super().__init__()
        self.node = node
        self.action_client = ActionClient(node, LookupTransform, action_name=ns)
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()
    ) -> Any:
        if isinstance(time, builtin_interfaces.msg.Time):
            warnings.warn('builtin_interfaces.msg.Time is deprecated here: use rclpy.time.Time', stacklevel=2)
            time = Time.from_msg(time)
        elif not isinstance(time, Time):
            raise TypeError('Must pass a rclpy.time.Time object.')
        return self._ask(LookupTransform.Goal(
            target_frame=target_frame, source_frame=source_frame, source_time=time.to_msg(),
            timeout=timeout.to_msg(), advanced=False), timeout)

    def lookup_transform_full(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str,
        timeout: Duration = Duration()
    ) -> Any:
        return self._ask(LookupTransform.Goal(
            target_frame=target_frame, source_frame=source_frame, source_time=source_time.to_msg(),
            timeout=timeout.to_msg(), target_time=target_time.to_msg(), fixed_frame=fixed_frame,
            advanced=True), timeout)

    def can_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()
    ) -> bool:
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
        except TransformException:
            return False
        return True

    def can_transform_full(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str,
        timeout: Duration = Duration()
    ) -> bool:
        try:
            self.lookup_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        except TransformException:
            return False
        return True

    def _ask(self, goal: Any, timeout: Duration) -> Any:
        if not self.action_client.server_is_ready():
            raise TimeoutException('The BufferServer is not ready.')
        answered = threading.Event()
        sent = self.action_client.send_goal_async(goal)
        sent.add_done_callback(lambda _: answered.set())
        answered.wait((timeout.nanoseconds + self.timeout_padding.nanoseconds) / NS)
        if not sent.done():
            raise TimeoutException('The BufferServer did not answer in time.')
        handle = sent.result()
        if not handle.accepted:
            raise TimeoutException('The BufferServer did not accept the goal.')
        return transform_in(self.action_client._get_result(handle).result)

    def destroy(self) -> None:
        self.action_client.destroy()


def transform_in(result: Any) -> Any:
    """The transform of an answer; raises what the server says instead."""
    error = result.error
    if error.error == error.NO_ERROR:
        return result.transform
    raise {
        error.LOOKUP_ERROR: LookupException, error.CONNECTIVITY_ERROR: ConnectivityException,
        error.EXTRAPOLATION_ERROR: ExtrapolationException, error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
        error.TIMEOUT_ERROR: TimeoutException,
    }.get(error.error, TransformException)(error.error_string)
