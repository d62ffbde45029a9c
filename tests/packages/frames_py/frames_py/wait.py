"""Waits for a transform in its main thread, while the listener's own thread hears."""
import rclpy
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_ros import Buffer, LookupException, TransformListener


def main():
    rclpy.init()
    node = rclpy.create_node('waiter')
    buffer = Buffer(node=node)
    TransformListener(buffer, node, spin_thread=True)
    found = buffer.lookup_transform('map', 'laser', Time(), timeout=Duration(seconds=60))
    print(f'waited for {found.header.frame_id}, {found.transform.translation.z}')
    try:
        buffer.lookup_transform('map', 'wheel', Time(), timeout=Duration(seconds=0.1))
    except LookupException as error:
        print(f'in vain: {error}')
    later = buffer.get_latest_common_time('map', 'laser') + Duration(seconds=0.3)
    at = buffer.lookup_transform('map', 'laser', later, timeout=Duration(seconds=60))
    print('a later time is waited for', Time.from_msg(at.header.stamp).nanoseconds == later.nanoseconds)
    print('frames', sorted(buffer.all_frames_as_string().splitlines()))
    rclpy.shutdown()
