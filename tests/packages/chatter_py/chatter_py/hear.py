"""Hears what is said, and keeps count of it until it is stopped."""
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import String


class Hearer(Node):
    heard = 0

    def hear(self, message):
        self.heard += 1
        self.get_logger().info(f'heard <{message.data}>')


def main():
    context = rclpy.init()
    hearer = Hearer('hearer')
    hearer.create_subscription(String, 'chatter', hearer.hear, QoSProfile(depth=20))
    try:
        rclpy.spin(hearer)
    except KeyboardInterrupt:
        print('stopped by hand,', 'something' if hearer.heard else 'nothing', 'heard')
    hearer.destroy_node()
    rclpy.try_shutdown(context=context.context)
