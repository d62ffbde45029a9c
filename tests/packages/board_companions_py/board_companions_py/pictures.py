"""pictures TOPIC: publishes a small picture every half second."""
import sys
from contextlib import suppress

import rclpy
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import Image


def main():
    with suppress(KeyboardInterrupt, ExternalShutdownException), rclpy.init():
        node = rclpy.create_node('pictures')
        publisher = node.create_publisher(Image, sys.argv[1], 10)

        def publish():
            picture = Image(width=4, height=2, encoding='mono8', step=4, data=bytes(8))
            picture.header.stamp = node.get_clock().now().to_msg()
            publisher.publish(picture)
        node.create_timer(0.5, publish)
        rclpy.spin(node)
