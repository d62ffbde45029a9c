"""Drives one robot towards the other, which must not move."""
import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan


class Watcher(Node):

    def __init__(self):
        super().__init__('watcher')
        self.pub = self.create_publisher(Twist, '/red/cmd_vel', 10)
        self.places = {}
        self.starts = {}
        for name in ('red', 'blue'):
            self.create_subscription(Odometry, f'/{name}/odom', lambda msg, name=name: self.on_odom(name, msg), 10)
        self.create_subscription(LaserScan, '/red/scan', self.on_scan, qos_profile_sensor_data)
        self.scans = 0
        self.still = 0

    def on_odom(self, name, msg):
        self.places[name] = msg.pose.pose.position.x
        self.starts.setdefault(name, msg.pose.pose.position.x)

    def on_scan(self, scan):
        if len(self.places) < 2:
            return
        ahead = scan.ranges[len(scan.ranges) // 2]
        self.scans += 1
        if self.scans == 10:
            self.get_logger().info('red at %.1f m sees blue at %.1f m: %.2f m between them'
                                   % (self.places['red'], self.places['blue'], ahead))
        moved = {name: self.places[name] - self.starts[name] for name in self.places}
        cmd = Twist()
        if self.scans >= 10 and moved['red'] < 1.0:
            cmd.linear.x = min(0.5, 0.1 + 2 * (1.0 - moved['red']))
        elif self.scans >= 10:
            self.still += 1
        self.pub.publish(cmd)
        if self.still == 10:
            self.get_logger().info('red moved %.1f m, blue %.3f m: %.1f m between them, the sum is %.2f m'
                                   % (moved['red'], abs(moved['blue']), ahead, moved['red'] + ahead))


def main():
    rclpy.init()
    rclpy.spin(Watcher())


if __name__ == '__main__':
    main()
