"""Waiting for one message."""
from __future__ import annotations

from typing import Any

from rclpy.impl.waiting import wait_until
from rclpy.qos import QoSProfile


def wait_for_message(
    msg_type: Any, node: Any, topic: str, *, qos_profile: QoSProfile | int = 1, time_to_wait: int | float = -1
) -> tuple[bool, Any]:
    """The next message of a topic, or (False, None) when the time is over. Nobody need spin."""
    subscription = node.create_subscription(msg_type, topic, lambda _: None, qos_profile=qos_profile)
    # Executors leave it alone.
    node._subscriptions.remove(subscription)
    taken: list[Any] = []

    def take() -> bool:
        found = subscription.take_message(msg_type, False)
        if found is not None:
            taken.append(found[0])
        return found is not None
    try:
        heard = wait_until(take, node.context, None if time_to_wait < 0 else time_to_wait)
        return (True, taken[0]) if heard else (False, None)
    finally:
        node._subscriptions.append(subscription)
        node.destroy_subscription(subscription)
