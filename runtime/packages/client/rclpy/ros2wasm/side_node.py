"""A hidden node that libraries use for windows and devices, beside the nodes of the program.

It has its own context, so that it works before rclpy.init() and after rclpy.shutdown(), and its own executor.
"""
from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from ros2wasm import host


class SideNode:
    """The node is created at the first use."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.executor: Any = None
        self._node: Any = None
        self._heard = 0

    @property
    def node(self) -> Any:
        if self._node is None:
            from rclpy.context import Context, g_contexts
            from rclpy.executors import SingleThreadedExecutor
            from rclpy.node import Node
            context = Context()
            context.init(args=[], initialize_logging=False)
            # A signal shuts down the contexts of the program. Figures may be shown after that.
            g_contexts[:] = [one for one in g_contexts if one() is not context]
            self._node = Node(
                self.name, context=context, start_parameter_services=False, enable_rosout=False)
            self.executor = SingleThreadedExecutor(context=context)
            self.executor.add_node(self._node)
        return self._node

    def publisher(self, kind: Any, topic: str, qos: Any) -> Any:
        return self.node.create_publisher(kind, topic, qos)

    def subscription(self, kind: Any, topic: str, callback: Callable[[Any], None], qos: Any) -> Any:
        def hear(message: Any) -> None:
            self._heard += 1
            callback(message)
        return self.node.create_subscription(kind, topic, hear, qos)

    def destroy(self, *endpoints: Any) -> None:
        for one in endpoints:
            if not self.node.destroy_publisher(one):
                self.node.destroy_subscription(one)

    def wait(self, seconds: float) -> None:
        """Wait for a message, for at most that time; take all that have arrived."""
        if self.executor is None:
            time.sleep(seconds)
            return
        self.executor.spin_once(timeout_sec=seconds)
        before = -1
        while self._heard != before:
            before = self._heard
            self.executor.spin_once(timeout_sec=0)


def has_page() -> bool:
    """Whether the program runs in a browser. A headless run has no page."""
    return bool(host.js.has_page())


def newest() -> Any:
    """A latched topic: late subscriptions get the last message."""
    from rclpy.qos import DurabilityPolicy, QoSProfile
    return QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
