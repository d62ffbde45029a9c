"""Takes point clouds to other frames."""
from __future__ import annotations

from typing import Any

import numpy as np
import tf2_ros
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py.point_cloud2 import create_cloud, read_points
from std_msgs.msg import Header
from tf2_py.transform import NO_TURN, settled, turned

PLACE = ('x', 'y', 'z')


def to_msg_msg(msg: Any) -> Any:
    """A message is one already."""
    return msg


def from_msg_msg(msg: Any) -> Any:
    return msg


def transform_points(point_cloud: Any, transform: Any) -> Any:
    """Rows of x, y and z, by a geometry_msgs.msg.Transform."""
    q, shift = transform.rotation, transform.translation
    turn = settled((q.x, q.y, q.z, q.w)) if any((q.x, q.y, q.z, q.w)) else NO_TURN
    axes = np.array([turned(turn, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))])
    return np.asarray(point_cloud) @ axes + np.array([shift.x, shift.y, shift.z])


def do_transform_cloud(cloud: Any, transform: Any) -> Any:
    """The cloud elsewhere, its other fields as they are. A TransformStamped also says the frame."""
    header = Header(stamp=cloud.header.stamp, frame_id=cloud.header.frame_id)
    if isinstance(transform, TransformStamped):
        header.frame_id = transform.header.frame_id
        transform = transform.transform
    assert {*PLACE} <= {field.name for field in cloud.fields}, \
        'Point cloud needs the fields x, y, and z for the transformation'
    points = read_points(cloud).copy()
    moved = transform_points(np.stack([points[name] for name in PLACE], axis=-1), transform)
    for i, name in enumerate(PLACE):
        points[name] = moved[..., i]
    return create_cloud(header, cloud.fields, points, cloud.point_step)


tf2_ros.ConvertRegistration().add_to_msg(PointCloud2, to_msg_msg)
tf2_ros.ConvertRegistration().add_from_msg(PointCloud2, from_msg_msg)
tf2_ros.TransformRegistration().add(PointCloud2, do_transform_cloud)
