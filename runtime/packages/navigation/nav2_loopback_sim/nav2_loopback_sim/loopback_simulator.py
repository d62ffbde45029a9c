"""
Stands for a robot, its odometry, its localization and its lidar: it moves exactly as commanded, without any physics.

The first `initialpose` puts it onto the map, later ones move it there.
"""
from __future__ import annotations

import math
from typing import Any

import numpy as np
import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped, Twist, TwistStamped
from nav2_loopback_sim.planar import Planar, planar
from nav2_loopback_sim.ray_casting import cells_to_obstacles
from nav_msgs.msg import Odometry
from nav_msgs.srv import GetMap
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformBroadcaster, TransformException, TransformListener

SENSOR_QOS = QoSProfile(
    reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.VOLATILE, depth=10)
# A command is valid for this long.
COMMAND_LIFE = Duration(seconds=1)
# Cells from this value on are seen by the lidar.
OCCUPIED = 60
MOST_RAYS = 100_000


class LoopbackSimulator(Node):
    """The node `loopback_simulator`."""

    def __init__(self) -> None:
        super().__init__(node_name='loopback_simulator')
        self.curr_cmd_vel: Any = None
        self.curr_cmd_vel_time = self.get_clock().now()
        self.map: Any = None
        self.map_request: Any = None
        self.occupied: Any = None
        self.is_placed = False
        self.base_to_laser: Planar | None = None
        self.map_to_odom = Planar()
        self.odom_to_base = Planar()
        self._read_parameters()
        self.tf_broadcaster = TransformBroadcaster(self)
        self.initial_pose_sub = self.create_subscription(
            PoseWithCovarianceStamped, 'initialpose', self.initialPoseCallback, 10)
        if self.use_stamped:
            self.cmd_vel_sub = self.create_subscription(TwistStamped, 'cmd_vel', self.cmdVelStampedCallback, 10)
        else:
            self.cmd_vel_sub = self.create_subscription(Twist, 'cmd_vel', self.cmdVelCallback, 10)
        self.odom_pub = self.create_publisher(Odometry, 'odom', 10)
        self.scan_pub = self.create_publisher(LaserScan, 'scan', SENSOR_QOS)
        if self.publish_clock:
            self.clock_timer = self.create_timer(0.1, self.clockTimerCallback)
            self.clock_pub = self.create_publisher(Clock, '/clock', 10)
        self.setup_timer = self.create_timer(0.1, self.setupTimerCallback)
        self.map_client = self.create_client(GetMap, '/map_server/map')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.getMap()
        self.get_logger().info('Loopback simulator initialized')

    def _read_parameters(self) -> None:
        def read(name: str, default: Any) -> Any:
            return self.declare_parameter(name, default).value

        def positive(name: str, default: float) -> float:
            value: float = read(name, default)
            if math.isfinite(value) and value > 0:
                return value
            self.get_logger().error(f'{name} must be greater than 0, {default} is used')
            return default

        self.update_dur = positive('update_duration', 0.01)
        self.base_frame_id: str = read('base_frame_id', 'base_footprint')
        self.map_frame_id: str = read('map_frame_id', 'map')
        self.odom_frame_id: str = read('odom_frame_id', 'odom')
        self.scan_frame_id: str = read('scan_frame_id', 'base_scan')
        self.use_stamped: bool = read('enable_stamped_cmd_vel', False)
        self.scan_publish_dur = positive('scan_publish_dur', 0.1)
        self.publish_map_odom_tf: bool = read('publish_map_odom_tf', True)
        self.publish_clock: bool = read('publish_clock', True)
        self.scan_range_min: float = read('scan_range_min', 0.05)
        self.scan_range_max = positive('scan_range_max', 30.0)
        self.scan_angle_min: float = read('scan_angle_min', -math.pi)
        self.scan_angle_max: float = read('scan_angle_max', math.pi)
        # 1.5 degrees
        self.scan_angle_increment = positive('scan_angle_increment', 0.0261)
        self.use_inf: bool = read('scan_use_inf', True)
        rays = (self.scan_angle_max - self.scan_angle_min) / self.scan_angle_increment
        self.ray_count = int(rays) if 0 <= rays <= MOST_RAYS else 0
        if self.ray_count == 0:
            self.get_logger().error(f'The angles of the scan have no ray, or more than {MOST_RAYS}')

    # Commands and poses

    def cmdVelCallback(self, msg: Any) -> None:
        """Take a command, once the robot is on the map."""
        self._take_command(msg, self.get_clock().now())

    def cmdVelStampedCallback(self, msg: Any) -> None:
        """Take a command, once the robot is on the map."""
        self._take_command(msg.twist, Time.from_msg(msg.header.stamp))

    def _take_command(self, twist: Any, stamp: Time) -> None:
        self.get_logger().debug('Received cmd_vel')
        if not self.is_placed:
            return
        if not all(math.isfinite(value) for value in (twist.linear.x, twist.linear.y, twist.angular.z)):
            self.get_logger().error('Velocity message contains NaNs or Infs! Ignoring as invalid!')
            return
        self.curr_cmd_vel = twist
        self.curr_cmd_vel_time = stamp

    def initialPoseCallback(self, msg: Any) -> None:
        """Put the robot somewhere. Its odometry goes on."""
        try:
            pose = planar(msg.pose.pose.position, msg.pose.pose.orientation)
        except ValueError as error:
            self.get_logger().error(f'Ignoring an initial pose: {error}')
            return
        self.get_logger().info('Received initial pose!')
        self.map_to_odom = pose @ self.odom_to_base.inverse()
        if self.is_placed:
            return
        self.is_placed = True
        self.publishTransforms()
        self.destroy_timer(self.setup_timer)
        self.timer = self.create_timer(self.update_dur, self.timerCallback)
        self.timer_laser = self.create_timer(self.scan_publish_dur, self.publishLaserScan)

    def timerCallback(self) -> None:
        """Move by what the command says for one step."""
        if self.curr_cmd_vel is None or self.get_clock().now() - self.curr_cmd_vel_time > COMMAND_LIFE:
            self.curr_cmd_vel = None
            self.publishTransforms()
            return
        command = self.curr_cmd_vel
        self.odom_to_base @= Planar(
            command.linear.x * self.update_dur, command.linear.y * self.update_dur, command.angular.z * self.update_dur)
        self.publishTransforms()
        self.publishOdometry()

    # Transforms, odometry and time

    def setupTimerCallback(self) -> None:
        """Publish that the robot stands at the origin of its odometry, and look for its lidar."""
        self.tf_broadcaster.sendTransform(self._base_transform())
        if self.base_to_laser is None:
            self.getBaseToLaserTf()

    def getBaseToLaserTf(self) -> None:
        """Ask where on the robot the lidar is."""
        try:
            found = self.tf_buffer.lookup_transform(self.base_frame_id, self.scan_frame_id, Time()).transform
            self.base_to_laser = planar(found.translation, found.rotation)
        except (TransformException, ValueError) as error:
            self.get_logger().error(f'Transform lookup failed: {error}')

    def clockTimerCallback(self) -> None:
        """Publish the time."""
        self.clock_pub.publish(Clock(clock=self.get_clock().now().to_msg()))

    def publishTransforms(self) -> None:
        """Publish where the odometry begins on the map, and where the robot is."""
        if self.publish_map_odom_tf:
            transform = self._transform(self.map_frame_id, self.odom_frame_id, self.map_to_odom)
            ahead = self.get_clock().now() + Duration(seconds=self.update_dur)
            transform.header.stamp = ahead.to_msg()
            self.tf_broadcaster.sendTransform(transform)
        self.tf_broadcaster.sendTransform(self._base_transform())

    def publishOdometry(self) -> None:
        """Publish where the robot is, and the command as its velocity."""
        odometry = Odometry()
        odometry.header.stamp = self.get_clock().now().to_msg()
        odometry.header.frame_id = 'odom'
        odometry.child_frame_id = 'base_link'
        odometry.pose.pose.position.x = self.odom_to_base.x
        odometry.pose.pose.position.y = self.odom_to_base.y
        odometry.pose.pose.orientation = self.odom_to_base.rotation()
        odometry.twist.twist = self.curr_cmd_vel
        self.odom_pub.publish(odometry)

    def _base_transform(self) -> Any:
        return self._transform(self.odom_frame_id, self.base_frame_id, self.odom_to_base)

    def _transform(self, frame: str, child: str, pose: Planar) -> Any:
        transform = TransformStamped(child_frame_id=child)
        transform.header.frame_id = frame
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.transform.translation.x = pose.x
        transform.transform.translation.y = pose.y
        transform.transform.rotation = pose.rotation()
        return transform

    # The lidar

    def getMap(self) -> None:
        """Ask the map server for its map, which the lidar sees. One that starts later is asked once it is there."""
        if self.map_client.wait_for_service(timeout_sec=5.0):
            rclpy.spin_until_future_complete(self, self._ask_for_map())
        if self.map is None:
            self.get_logger().warn('Failed to get map, Laser scan will be populated using max range')

    def _ask_for_map(self) -> Any:
        self.map_request = self.map_client.call_async(GetMap.Request())
        self.map_request.add_done_callback(lambda future: self._take_map(future.result().map))
        return self.map_request

    def _ask_again(self) -> None:
        is_asked = self.map_request is not None and not self.map_request.done()
        if self.map is None and not is_asked and self.map_client.service_is_ready():
            self._ask_for_map()

    def _take_map(self, message: Any) -> None:
        shape = (message.info.height, message.info.width)
        if not message.data or shape[0] * shape[1] != len(message.data) or not message.info.resolution > 0:
            return
        self.map = message
        self.occupied = np.asarray(message.data).reshape(shape) >= OCCUPIED
        self.get_logger().info('Laser scan will be populated using map data')

    def publishLaserScan(self) -> None:
        """Publish how far the walls of the map are."""
        self._ask_again()
        scan = LaserScan(
            angle_min=self.scan_angle_min, angle_max=self.scan_angle_max, angle_increment=self.scan_angle_increment,
            scan_time=0.1, range_min=self.scan_range_min, range_max=self.scan_range_max)
        scan.header.stamp = self.get_clock().now().to_msg()
        scan.header.frame_id = self.scan_frame_id
        scan.ranges = self.getLaserScan(self.ray_count)
        self.scan_pub.publish(scan)

    def getLaserScan(self, num_samples: int) -> list[float]:
        """Get the distances along all rays [m]."""
        laser = self._laser_on_map()
        if laser is None or num_samples == 0:
            return [math.inf if self.use_inf else self.scan_range_max - 0.1] * num_samples
        angles = laser.yaw + self.scan_angle_min + np.arange(num_samples) * self.scan_angle_increment
        ends = np.stack([
            self._cells(laser.x + self.scan_range_max * np.cos(angles), self.map.info.origin.position.x),
            self._cells(laser.y + self.scan_range_max * np.sin(angles), self.map.info.origin.position.y)], axis=1)
        distances = cells_to_obstacles(self.occupied, self._cell(laser), ends) * self.map.info.resolution
        if self.use_inf:
            distances[distances == 0] = math.inf
        ranges: list[float] = distances.tolist()
        return ranges

    def _laser_on_map(self) -> Planar | None:
        """Get the pose of the lidar on the map; None when one of both is not known or it is elsewhere."""
        if self.base_to_laser is None and self.tf_buffer.can_transform(self.base_frame_id, self.scan_frame_id, Time()):
            self.getBaseToLaserTf()
        if self.map is None or self.base_to_laser is None:
            return None
        laser = self.map_to_odom @ self.odom_to_base @ self.base_to_laser
        x, y = self._cell(laser)
        is_inside = 0 < x < self.map.info.width and 0 < y < self.map.info.height
        return laser if is_inside else None

    def _cell(self, place: Planar) -> tuple[int, int]:
        origin = self.map.info.origin.position
        return int(self._cells(place.x, origin.x)), int(self._cells(place.y, origin.y))

    def _cells(self, coordinates: Any, origin: float) -> Any:
        return np.floor((coordinates - origin) / self.map.info.resolution).astype(np.int64)


def main() -> int:
    """Run the node until it is stopped."""
    rclpy.init()
    try:
        simulator = LoopbackSimulator()
        rclpy.spin(simulator)
        simulator.destroy_node()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    rclpy.try_shutdown()
    return 0
