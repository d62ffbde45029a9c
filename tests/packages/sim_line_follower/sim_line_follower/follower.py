"""Steers so that the dark pixels stay in the middle of the picture."""
import math

import numpy as np
import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image


class Follower(Node):

    def __init__(self):
        super().__init__('follower')
        self.publisher_ = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Image, 'image', self.image_callback, qos_profile_sensor_data)
        self.create_subscription(Odometry, 'odom', self.odom_callback, 10)
        self.pictures = 0
        self.way = 0.0
        self.aside = 0.0
        self.last = None
        self.done = False

    def image_callback(self, msg):
        picture = np.frombuffer(bytes(msg.data), dtype=np.uint8).reshape(msg.height, msg.width, 3)
        dark = picture[msg.height // 2:].max(axis=2) < 90
        self.pictures += 1
        if self.pictures == 1:
            rows = dark.sum(axis=1)
            self.get_logger().info(f'{msg.width} x {msg.height} {msg.encoding}, '
                                   f'the line is {rows[-1]} pixels wide at the bottom')
        twist = Twist()
        columns = np.nonzero(dark)[1]
        if len(columns) > 0 and not self.done:
            error = columns.mean() - (msg.width - 1) / 2
            twist.linear.x = 0.3
            twist.angular.z = -0.02 * float(error)
        self.publisher_.publish(twist)

    def odom_callback(self, msg):
        p, q = msg.pose.pose.position, msg.pose.pose.orientation
        if self.last is not None and not self.done:
            self.way += math.hypot(p.x - self.last.x, p.y - self.last.y)
            # From the nearer one of the two straight parts.
            turned = abs((p.y - 0.0) * math.cos(math.pi / 6) - (p.x - 1.0) * math.sin(math.pi / 6))
            self.aside = max(self.aside, min(abs(p.y), turned))
            if self.way >= 2.0:
                self.done = True
                heading = math.degrees(2 * math.atan2(q.z, q.w))
                self.get_logger().info(f'followed the line for {self.way:.1f} m, at most {100 * self.aside:.0f} cm '
                                       f'beside it, {100 * turned:.0f} cm at the end, heading {heading:.0f} degrees')
        self.last = p


def main(args=None):
    rclpy.init(args=args)
    follower = Follower()
    rclpy.spin(follower)
    follower.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
