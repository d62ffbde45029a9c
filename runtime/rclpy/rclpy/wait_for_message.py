"""Waiting for one message."""
from __future__ import annotations

import time
from typing import Any

from rclpy.qos import QoSProfile
from ros2wasm import background, host

NS = 1_000_000_000


def wait_for_message(
    msg_type: Any, node: Any, topic: str, *, qos_profile: QoSProfile | int = 1, time_to_wait: int | float = -1
) -> tuple[bool, Any]:
    """The next message of a topic, or (False, None) when the time is over. Nobody need spin."""
    context = node.context
    subscription = node.create_subscription(msg_type, topic, lambda _: None, qos_profile=qos_profile)
    # Executors leave it alone.
    node._subscriptions.remove(subscription)
    end = None if time_to_wait < 0 else time.monotonic_ns() + int(time_to_wait * NS)
    try:
        while context.ok():
            token = host.wake_token()
            taken = subscription.take_message(msg_type, False)
            if taken is not None:
                return True, taken[0]
            left = -1 if end is None else end - time.monotonic_ns()
            if end is not None and left <= 0:
                break
            background.run()
            host.wait(token, left)
        return False, None
    finally:
        subscription.destroy()
