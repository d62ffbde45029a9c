from geometry_msgs.msg import PointStamped
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
import tf2_geometry_msgs  # noqa: F401  (registers the conversions)
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener


class FrameListener(Node):

    def __init__(self):
        super().__init__('frame_listener')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.timer = self.create_timer(0.1, self.on_timer)
        self.found = False
        self.misses = 0

    def on_timer(self):
        try:
            t = self.tf_buffer.lookup_transform('world', 'cup', rclpy.time.Time())
        except TransformException as ex:
            if self.misses == 0:
                self.get_logger().info(f'Could not transform: {ex}')
            self.misses += 1
            return
        where = t.transform.translation
        self.get_logger().info('the cup is at %.1f %.1f %.1f' % (where.x, where.y, where.z))
        point = PointStamped()
        point.header.frame_id = 'cup'
        point.point.x = 1.0
        seen = self.tf_buffer.transform(point, 'world', timeout=Duration(seconds=1.0))
        self.get_logger().info('its handle is at %.1f %.1f' % (seen.point.x, seen.point.y))
        try:
            self.tf_buffer.lookup_transform('world', 'plate', rclpy.time.Time())
        except TransformException as ex:
            self.get_logger().info('no plate: %s' % type(ex).__name__)
        self.found = True


def main():
    rclpy.init()
    node = FrameListener()
    while rclpy.ok() and not node.found:
        rclpy.spin_once(node)
    node.destroy_node()
    rclpy.shutdown()
