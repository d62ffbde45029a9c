"""Waits for transforms without blocking, and takes points to the map."""
from contextlib import suppress

import message_filters
import rclpy
import tf2_geometry_msgs  # noqa: F401  so that points can be transformed
from geometry_msgs.msg import PointStamped
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.time import Time
from rosidl_runtime_py import message_to_yaml
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener


class Follower(Node):

    def __init__(self):
        super().__init__('follower')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        try:
            self.buffer.lookup_transform('map', 'laser', Time())
        except TransformException as error:
            self.get_logger().info(f'at first: {type(error).__name__}: {error}')
        points = message_filters.Subscriber(self, PointStamped, 'points')
        echoes = message_filters.Subscriber(self, PointStamped, 'echoes')
        self.both = message_filters.TimeSynchronizer([points, echoes], 10)
        self.both.registerCallback(self.on_both)
        self.heard = 0
        self.timer = self.create_timer(0.2, self.on_timer)

    async def on_timer(self):
        self.timer.cancel()
        found = await self.buffer.lookup_transform_async('map', 'laser', Time())
        self.get_logger().info(f'awaited {found.child_frame_id} at height {found.transform.translation.z}')

    def on_both(self, point, echo):
        self.heard += 1
        if self.heard != 5:
            return
        same = point.header.stamp == echo.header.stamp
        # It may come before its transform: another thread of the executor takes that in.
        there = self.buffer.transform(point, 'map', timeout=Duration(seconds=10))
        self.get_logger().info(f'the wall is at {there.point.x:.3f} {there.point.z} of {there.header.frame_id} {same}')
        self.get_logger().info('as text ' + message_to_yaml(there.point, flow_style=True).split(',')[2].strip())


def main():
    with suppress(KeyboardInterrupt, ExternalShutdownException), rclpy.init():
        executor = MultiThreadedExecutor()
        executor.add_node(Follower())
        executor.spin()
