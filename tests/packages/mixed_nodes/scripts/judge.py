#!/usr/bin/env python3
"""Hears the readings of a compiled node and says which are too high."""
import numpy as np
import rclpy
from rclpy.node import Node

from mixed_nodes.limits import highest
from mixed_nodes.msg import Reading


class Judge(Node):

    def __init__(self) -> None:
        super().__init__('judge')
        self.limit = highest()
        self.create_subscription(Reading, 'readings', self.judge, 10)

    def judge(self, reading: Reading) -> None:
        high = np.asarray(reading.values) > self.limit
        self.get_logger().info(f'{reading.sensor}: {high.sum()} of {high.size} above {self.limit}')


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Judge())
    except KeyboardInterrupt:
        pass


if __name__ == '__main__':
    main()
