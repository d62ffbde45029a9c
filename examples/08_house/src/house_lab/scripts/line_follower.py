#!/usr/bin/env python3
"""Follows a dark line on the floor with the robot's camera."""
import math
import sys

import cv2
import rclpy
from cv_bridge import CvBridge
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image
from std_msgs.msg import Float64

DARK = 60  # of 255
ROWS = (0.75, 0.95)  # of the picture's height: the floor before the robot


def described(text, low, high):
    return ParameterDescriptor(description=text,
                               floating_point_range=[FloatingPointRange(from_value=low, to_value=high)])


class LineFollower(Node):
    def __init__(self):
        super().__init__('line_follower')
        self.declare_parameter('enabled', False)
        self.declare_parameter('speed', 0.2, described('m/s', 0.0, 0.5))
        self.declare_parameter('k', 1.5, described('rad/s when the line is at the edge of the picture', 0.0, 5.0))
        self.commands = self.create_publisher(Twist, 'cmd_vel', 10)
        self.errors = self.create_publisher(Float64, 'line_error', 10)
        self.create_subscription(Image, 'camera/image_raw', self.look, qos_profile_sensor_data)
        self.create_subscription(Odometry, 'odom', self.count, 10)
        self.bridge = CvBridge()
        self.was_enabled = self.went_around = False
        self.error = 0.0
        self.way = 0.0
        self.last = self.first = None

    def look(self, image):
        if not self.get_parameter('enabled').value:
            if self.was_enabled:
                self.commands.publish(Twist())
            self.was_enabled = False
            return
        if not self.was_enabled:
            self.way, self.first, self.went_around = 0.0, None, False
        self.was_enabled = True
        picture = self.bridge.imgmsg_to_cv2(image, desired_encoding='bgr8')
        upper, lower = (int(share * image.height) for share in ROWS)
        dark = cv2.inRange(picture[upper:lower], (0, 0, 0), (DARK, DARK, DARK))
        moments = cv2.moments(dark, True)
        command = Twist()
        if moments['m00'] > 0:
            middle = moments['m10'] / moments['m00']
            self.error = 2 * middle / image.width - 1  # from -1, at the left, to 1
            command.linear.x = self.get_parameter('speed').value
        # Without a line it turns to where it was last.
        command.angular.z = -self.get_parameter('k').value * self.error
        self.commands.publish(command)
        self.errors.publish(Float64(data=self.error))

    def count(self, odometry):
        place = odometry.pose.pose.position
        if self.was_enabled and self.last is not None:
            self.way += math.hypot(place.x - self.last.x, place.y - self.last.y)
            if self.way < 1 or self.first is None:
                self.first = place
            away = math.hypot(place.x - self.first.x, place.y - self.first.y)
            if not self.went_around and self.way > 6 and away < 0.3:
                self.went_around = True
                self.get_logger().info(f'once around: {self.way - 1:.1f} m')
        self.last = place


rclpy.init(args=sys.argv)
rclpy.spin(LineFollower())
