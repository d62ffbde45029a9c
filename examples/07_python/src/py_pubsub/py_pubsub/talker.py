"""Publishes a greeting twice a second."""
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):

    def __init__(self) -> None:
        super().__init__('talker')
        self.declare_parameter('greeting', 'Hello')
        self.publisher = self.create_publisher(String, 'topic', 10)
        self.timer = self.create_timer(0.5, self.talk)
        self.count = 0

    def talk(self) -> None:
        message = String()
        message.data = f"{self.get_parameter('greeting').value} {self.count}"
        self.publisher.publish(message)
        self.get_logger().info(f"Publishing: '{message.data}'")
        self.count += 1


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Talker())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
