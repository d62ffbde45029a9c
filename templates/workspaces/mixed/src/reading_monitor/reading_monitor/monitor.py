"""Warns when a reading is above the parameter `limit`."""
import rclpy
from rclpy.node import Node
from readings.msg import Reading


class Monitor(Node):

    def __init__(self) -> None:
        super().__init__('monitor')
        self.declare_parameter('limit', 0.9)
        self.is_high = False
        self.subscription = self.create_subscription(Reading, 'reading', self.look, 10)

    def look(self, reading: Reading) -> None:
        limit = self.get_parameter('limit').value
        was_high, self.is_high = self.is_high, reading.value > limit
        if self.is_high and not was_high:
            self.get_logger().warning(f'{reading.value:.3f} is above {limit}')
        if was_high and not self.is_high:
            self.get_logger().info(f'{reading.value:.3f} is fine again')


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Monitor())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
