"""Answers on topic_c what it hears on topic_a."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Relay(Node):
    def __init__(self):
        super().__init__('relay')
        self.answers = self.create_publisher(String, 'topic_c', 10)
        self.create_subscription(String, 'topic_a', self.hear, 10)
        self.get_logger().info('waits for topic_a')

    def hear(self, message):
        self.get_logger().info(f"heard: '{message.data}'")
        self.answers.publish(String(data=f'relay heard {message.data}'))


def main():
    with rclpy.init():
        rclpy.spin(Relay())


if __name__ == '__main__':
    main()
