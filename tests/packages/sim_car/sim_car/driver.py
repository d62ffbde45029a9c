"""Drives 4 m to the east and then half a circle to the north; satellites and gyroscope must agree with the way."""
import math

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Imu, NavSatFix

EARTH_RADIUS = 6378137.0  # of WGS84, at the equator


class Driver(Node):

    def __init__(self):
        super().__init__('driver')
        self.radius = self.declare_parameter('radius', 1.0).get_parameter_value().double_value
        self.commands = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(Odometry, 'odom', self.on_odom, 10)
        self.create_subscription(NavSatFix, 'gps/fix', self.on_fix, qos_profile_sensor_data)
        self.create_subscription(Imu, 'imu/data', self.on_imu, qos_profile_sensor_data)
        self.fix = self.first_fix = None
        self.rates = []
        self.since = 0
        self.state = 'east'
        self.x = 0.0
        self.turn_rate = None
        self.widest = 0.0

    def on_fix(self, msg):
        self.fix = msg
        self.first_fix = self.first_fix or msg

    def on_imu(self, msg):
        self.rates.append(msg.angular_velocity.z)

    def on_odom(self, msg):
        p, q = msg.pose.pose.position, msg.pose.pose.orientation
        if self.fix is None or not self.rates:
            return
        command = Twist()
        yaw = math.atan2(2 * q.w * q.z, 1 - 2 * q.z * q.z)
        if self.state == 'east':
            # Slower towards the end, so that it stops where it should.
            command.linear.x = min(1.0, 0.1 + 4.0 - p.x)
            if p.x >= 4.0:
                command.linear.x = 0.0
                self.state = 'stop'
                self.since = len(self.rates)
        elif self.state == 'stop' and len(self.rates) > self.since + 60:
            east = math.radians(self.fix.longitude - self.first_fix.longitude) * EARTH_RADIUS
            self.get_logger().info(f'drove {p.x:.1f} m, by satellite {east:.1f} m east and '
                                   f'{abs(self.fix.latitude) * 111000:.1f} m north, {self.fix.altitude:.1f} m high')
            self.x = p.x
            self.state = 'circle'
        elif self.state == 'circle':
            command.linear.x = 1.0
            command.angular.z = 1.0 / self.radius
            self.widest = max(self.widest, p.x - self.x)
            if yaw > math.radians(85) and self.turn_rate is None:
                self.turn_rate = sum(self.rates[-50:]) / 50
            if p.y > self.radius and (yaw > math.radians(175) or yaw < 0):
                self.state = 'done'
                north = math.radians(self.fix.latitude) * EARTH_RADIUS
                self.get_logger().info(f'half a circle of {p.y / 2:.1f} m, {self.widest:.1f} m wide, '
                                       f'turning with {self.turn_rate:.2f} rad/s, by satellite {north:.0f} m north')
        self.commands.publish(command)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Driver())


if __name__ == '__main__':
    main()
