"""Tells how far turtle1 went, each time that it is one unit more."""
from __future__ import annotations

import math

import rclpy
from rclpy.node import Node
from turtlesim.msg import Pose


class Odometer(Node):

    def __init__(self) -> None:
        super().__init__('odometer')
        self.last: Pose | None = None
        self.way = 0.0
        self.subscription = self.create_subscription(Pose, 'turtle1/pose', self.measure, 10)

    def measure(self, pose: Pose) -> None:
        before = self.way
        if self.last is not None:
            self.way += math.hypot(pose.x - self.last.x, pose.y - self.last.y)
        self.last = pose
        if math.floor(self.way) > math.floor(before):
            self.get_logger().info(f'the turtle went {self.way:.1f} units')


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Odometer())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
