"""Turns a half circle by odometry; the gyroscope, added up, must agree."""
import math

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Imu


def yaw_of(q):
    return math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))


class Turner(Node):

    def __init__(self):
        super().__init__('turner')
        self.cmd_vel = self.create_publisher(Twist, '/cmd_vel', 10)
        self.create_subscription(Odometry, '/odom', self.on_odom, 10)
        self.create_subscription(Imu, '/imu', self.on_imu, qos_profile_sensor_data)
        self.turned = 0.0
        self.last_yaw = None
        self.gyro = 0.0
        self.last_stamp = None
        self.up = 0.0
        self.done = False

    def on_imu(self, msg):
        stamp = msg.header.stamp.sec + 1e-9 * msg.header.stamp.nanosec
        if self.last_stamp is not None:
            self.gyro += msg.angular_velocity.z * (stamp - self.last_stamp)
        self.last_stamp = stamp
        self.up = msg.linear_acceleration.z

    def on_odom(self, msg):
        yaw = yaw_of(msg.pose.pose.orientation)
        if self.last_yaw is not None:
            step = yaw - self.last_yaw
            self.turned += math.atan2(math.sin(step), math.cos(step))
        self.last_yaw = yaw
        cmd = Twist()
        if self.turned < math.pi:
            cmd.angular.z = min(1.0, 0.1 + 2 * (math.pi - self.turned))
        elif not self.done:
            self.done = True
            difference = math.degrees(abs(self.gyro - self.turned))
            self.get_logger().info('turned %.1f degrees, the gyroscope differs by less than %d degrees, gravity %.1f'
                                   % (math.degrees(self.turned), math.ceil(difference), self.up))
        self.cmd_vel.publish(cmd)


def main(args=None):
    rclpy.init(args=args)
    node = Turner()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
