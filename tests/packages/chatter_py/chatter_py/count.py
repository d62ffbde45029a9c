"""Counts aloud, ten numbers a second, on the topic that the compiled nodes of the test use too."""
from contextlib import suppress
from itertools import count

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String


def main():
    numbers = count()
    with suppress(KeyboardInterrupt, ExternalShutdownException), rclpy.init():
        node = rclpy.create_node('counter')
        mouth = node.create_publisher(String, 'chatter', 5)

        def say_next():
            line = f'Python counts {next(numbers)}'
            mouth.publish(String(data=line))
            node.get_logger().info(f'said: {line}')
        node.create_timer(0.1, say_next)
        rclpy.spin(node)
