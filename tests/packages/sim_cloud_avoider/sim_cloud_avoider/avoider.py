"""Drives about a room, and turns away from the points of the lidar that are near."""
import math

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py import point_cloud2


class Avoider(Node):

    def __init__(self):
        super().__init__('avoider')
        self.cmd_vel = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(PointCloud2, 'points', self.on_points, qos_profile_sensor_data)
        self.create_subscription(Odometry, 'odom', self.on_odom, 10)
        self.clouds = 0
        self.turns = 0
        self.turning = False
        self.nearest = math.inf
        self.way = 0.0
        self.last = None
        self.done = False

    def on_points(self, cloud):
        read = point_cloud2.read_points(cloud, field_names=('x', 'y'), skip_nans=True)
        points = [(float(x), float(y)) for x, y in read]
        ahead = min((math.hypot(x, y) for x, y in points if x > 0 and abs(y) < 0.25), default=math.inf)
        self.clouds += 1
        if self.clouds == 5:
            # The sides of the room: the points furthest to the left and to the right.
            left, right = max(y for _, y in points), min(y for _, y in points)
            self.get_logger().info(f'{len(points)} points of {cloud.header.frame_id}, {ahead:.2f} m ahead, '
                                   f'{left - right:.2f} m from wall to wall')
        self.nearest = min([self.nearest] + [math.hypot(x, y) for x, y in points])
        twist = Twist()
        if ahead < 0.5:
            if not self.turning:
                self.turns += 1
            self.turning = True
        elif ahead > 0.8:
            self.turning = False
        if self.turning:
            twist.angular.z = 1.0
        else:
            twist.linear.x = 0.4
        self.cmd_vel.publish(twist)

    def on_odom(self, odom):
        p = odom.pose.pose.position
        if self.last is not None:
            self.way += math.hypot(p.x - self.last.x, p.y - self.last.y)
        self.last = p
        if self.way >= 4.0 and not self.done:
            self.done = True
            inside = max(abs(p.x), abs(p.y)) < 1.5
            self.get_logger().info(f'drove {self.way:.1f} m with {self.turns} turns, never nearer than '
                                   f'{self.nearest:.1f} m, inside: {inside}')


def main():
    rclpy.init()
    rclpy.spin(Avoider())


if __name__ == '__main__':
    main()
