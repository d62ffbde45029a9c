#!/usr/bin/env python3
"""Measures, moves to the left until the low wall is passed, and measures again."""
import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Range


class Look(Node):

    def __init__(self):
        super().__init__('look')
        self.cmd_pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Odometry, 'odom', self.odom_callback, 10)
        self.create_subscription(Range, 'range', self.range_callback, qos_profile_sensor_data)
        self.position = None
        self.first = None

    def odom_callback(self, msg):
        self.position = msg.pose.pose.position

    def range_callback(self, msg):
        if self.position is None:
            return
        if self.first is None:
            self.first = msg.range
            self.get_logger().info('at y = %.1f: %.2f m in %s' % (self.position.y, msg.range, msg.header.frame_id))
        cmd = Twist()
        if self.position.y < 0.8:
            cmd.linear.y = 0.5
        elif self.first is not False:
            self.first = False
            self.get_logger().info('at y > 0.8: %.2f m' % msg.range)
        self.cmd_pub.publish(cmd)


def main():
    rclpy.init()
    node = Look()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()


if __name__ == '__main__':
    main()
