"""A robot that drives along x: tells where it is, ten times a second, and what its laser sees."""
import os
from contextlib import suppress

import rclpy
import yaml
from ament_index_python.packages import get_package_share_directory
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from tf2_geometry_msgs import PointStamped
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster, TransformStamped


class Driver(Node):

    def __init__(self):
        super().__init__('driver')
        with open(os.path.join(get_package_share_directory('frames_py'), 'config', 'frames.yaml')) as file:
            self.config = yaml.safe_load(file)
        self.get_logger().info('notes: ' + self.config['notes'].splitlines()[1])
        laser = TransformStamped()
        laser.header.frame_id, laser.child_frame_id = self.config['laser']['parent'], 'laser'
        laser.transform.translation.x = self.config['laser']['x']
        laser.transform.translation.z = self.config['laser']['z']
        self.static_broadcaster = StaticTransformBroadcaster(self)
        self.static_broadcaster.sendTransform(laser)
        self.broadcaster = TransformBroadcaster(self)
        self.points = self.create_publisher(PointStamped, 'points', 10)
        self.echoes = self.create_publisher(PointStamped, 'echoes', 10)
        self.start = self.get_clock().now()
        self.create_timer(0.1, self.drive)

    def drive(self):
        now = self.get_clock().now()
        place = TransformStamped()
        place.header.stamp = now.to_msg()
        place.header.frame_id = 'map'
        place.child_frame_id = 'base'
        place.transform.translation.x = self.config['speed'] * (now - self.start).nanoseconds / 1e9
        self.broadcaster.sendTransform(place)
        # A wall, at x = 10 in the map.
        point = PointStamped()
        point.header.stamp, point.header.frame_id = place.header.stamp, 'laser'
        point.point.x = 10.0 - place.transform.translation.x - self.config['laser']['x']
        self.points.publish(point)
        self.echoes.publish(point)


def main():
    with suppress(KeyboardInterrupt, ExternalShutdownException), rclpy.init():
        rclpy.spin(Driver())
