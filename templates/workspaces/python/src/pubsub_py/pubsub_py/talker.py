"""Publishes a counted greeting on "topic" twice a second."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):

    def __init__(self) -> None:
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'topic', 10)
        self.timer = self.create_timer(0.5, self.publish)
        self.count = 0

    def publish(self) -> None:
        message = String(data=f'Hello, world! {self.count}')
        self.get_logger().info(f"Publishing: '{message.data}'")
        self.publisher.publish(message)
        self.count += 1


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Talker())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
