"""Tells the graph where frames stand."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rclpy.impl.elsewhere import names_of
from rclpy.qos import QoSProfile
from tf2_msgs.msg import TFMessage

__getattr__ = names_of(__name__, {
    'geometry_msgs.msg': 'TransformStamped',
    'rclpy.node': 'Node',
    'typing': 'List Optional Union',
})


def as_list(transform: Any) -> list[Any]:
    """One transform or several, as a list."""
    return list(transform) if isinstance(transform, Iterable) else [transform]


class TransformBroadcaster:
    """Of frames that move: on /tf."""

    def __init__(self, node: Any, qos: QoSProfile | int | None = None) -> None:
        self.pub_tf = node.create_publisher(TFMessage, '/tf', QoSProfile(depth=100) if qos is None else qos)

    def sendTransform(self, transform: Any) -> None:
        self.pub_tf.publish(TFMessage(transforms=as_list(transform)))
