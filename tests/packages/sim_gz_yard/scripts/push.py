#!/usr/bin/env python3
"""Drives 1 m against a crate, and says how far the crate went with it."""
import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node


class Push(Node):

    def __init__(self):
        super().__init__('push')
        self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Odometry, 'odom', self.on_odometry, 10)
        self.create_subscription(Odometry, 'crate', self.on_crate, 10)
        self.driven = self.crate = self.crate_start = None
        self.done = False
        self.timer = self.create_timer(0.05, self.tick)

    def on_odometry(self, msg):
        self.driven = msg.pose.pose.position.x

    def on_crate(self, msg):
        self.crate = msg.pose.pose.position
        if self.crate_start is None:
            self.crate_start = self.crate.x

    def tick(self):
        if self.driven is None or self.crate is None:
            return
        cmd = Twist()
        if self.driven < 1.0:
            cmd.linear.x = min(0.5, 0.05 + 1.0 - self.driven)
        elif not self.done:
            self.done = True
            moved = self.crate.x - self.crate_start
            self.get_logger().info(
                f'drove {self.driven:.2f} m, pushed the crate {moved:.2f} m, '
                f'the way to it was {self.driven - moved:.1f} m, it went {abs(self.crate.y):.2f} m aside')
        self.publisher.publish(cmd)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Push())


if __name__ == '__main__':
    main()
