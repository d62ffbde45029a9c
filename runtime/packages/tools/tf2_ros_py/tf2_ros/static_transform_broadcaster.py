"""Tells the graph where frames stand that do not move."""
from __future__ import annotations

from typing import Any

from rclpy.impl.elsewhere import names_of
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tf2_msgs.msg import TFMessage

from tf2_ros.transform_broadcaster import as_list

__getattr__ = names_of(__name__, {
    'geometry_msgs.msg': 'TransformStamped',
    'rclpy.node': 'Node',
    'typing': 'List Optional Union',
})


class StaticTransformBroadcaster:
    """
    On /tf_static, kept for those who come later. Each message has all frames that were sent.

    A frame that was sent stays where it was said first; that of C++ moves it.
    """

    def __init__(self, node: Any, qos: QoSProfile | int | None = None) -> None:
        if qos is None:
            qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST)
        self.pub_tf = node.create_publisher(TFMessage, '/tf_static', qos)
        self.net_message = TFMessage()

    def sendTransform(self, transform: Any) -> None:
        known = self.net_message.transforms
        for one in as_list(transform):
            if all(old.child_frame_id != one.child_frame_id for old in known):
                known.append(one)
        self.pub_tf.publish(self.net_message)
