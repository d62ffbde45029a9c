"""Prints what it hears on "topic"."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):

    def __init__(self) -> None:
        super().__init__('listener')
        self.subscription = self.create_subscription(String, 'topic', self.hear, 10)

    def hear(self, message: String) -> None:
        self.get_logger().info(f"I heard: '{message.data}'")


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Listener())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
