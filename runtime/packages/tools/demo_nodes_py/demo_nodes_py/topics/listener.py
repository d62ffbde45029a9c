"""Prints what is said."""
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):

    def __init__(self):
        super().__init__('listener')
        self.subscription = self.create_subscription(String, 'chatter', self.hear, 10)

    def hear(self, message):
        self.get_logger().info(f'I heard: [{message.data}]')


def main(args=None):
    try:
        with rclpy.init(args=args):
            rclpy.spin(Listener())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
