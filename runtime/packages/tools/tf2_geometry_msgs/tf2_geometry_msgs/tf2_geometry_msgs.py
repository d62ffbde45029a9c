"""Takes messages of geometry_msgs to other frames. No numpy: a site need not carry it for this."""
from __future__ import annotations

from typing import Any

import tf2_ros
from geometry_msgs.msg import (
    Point32, PointStamped, PolygonStamped, Pose, PoseStamped, PoseWithCovarianceStamped, Vector3Stamped,
)
from tf2_py.transform import NO_TURN, Quaternion, Transform, Vector, settled, turned

#: Rows and columns of a covariance that belong together: of the place, of the turn.
PARTS = (range(0, 3), range(3, 6))


def to_msg_msg(msg: Any) -> Any:
    """A message is one already."""
    return msg


def from_msg_msg(msg: Any) -> Any:
    return msg


def _vector(message: Any) -> Vector:
    return float(message.x), float(message.y), float(message.z)


def _set(message: Any, vector: Vector) -> None:
    message.x, message.y, message.z = vector


def _turn(message: Any) -> Quaternion:
    """Four zeros are no turn."""
    q = (float(message.x), float(message.y), float(message.z), float(message.w))
    return settled(q) if any(q) else NO_TURN


def _transform(message: Any) -> Transform:
    return Transform(_vector(message.transform.translation), _turn(message.transform.rotation))


def do_transform_point(point: Any, transform: Any) -> Any:
    result = PointStamped(header=transform.header)
    _set(result.point, _transform(transform).of_point(_vector(point.point)))
    return result


def do_transform_vector3(vector3: Any, transform: Any) -> Any:
    """A vector has a direction and a length, and no place: it is turned alone."""
    result = Vector3Stamped(header=transform.header)
    _set(result.vector, turned(_transform(transform).turn, _vector(vector3.vector)))
    return result


def do_transform_pose(pose: Any, transform: Any) -> Any:
    moved = _transform(transform).after(Transform(_vector(pose.position), _turn(pose.orientation)))
    result = Pose()
    _set(result.position, moved.shift)
    x, y, z, w = settled(moved.turn)
    sign = -1.0 if w < 0 else 1.0
    q = result.orientation
    q.x, q.y, q.z, q.w = sign * x, sign * y, sign * z, sign * w
    return result


def do_transform_pose_stamped(pose: Any, transform: Any) -> Any:
    return PoseStamped(header=transform.header, pose=do_transform_pose(pose.pose, transform))


def do_transform_pose_with_covariance_stamped(pose: Any, transform: Any) -> Any:
    result = PoseWithCovarianceStamped(header=transform.header)
    result.pose.pose = do_transform_pose(pose.pose.pose, transform)
    result.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    return result


def do_transform_polygon_stamped(polygon: Any, transform: Any) -> Any:
    whole = _transform(transform)
    result = PolygonStamped(header=transform.header)
    for point in polygon.polygon.points:
        x, y, z = whole.of_point(_vector(point))
        result.polygon.points.append(Point32(x=x, y=y, z=z))
    return result


def transform_covariance(cov_in: Any, transform: Any) -> Any:
    """The 36 numbers of a covariance, turned: each quarter of the matrix by itself."""
    turn = _transform(transform).turn
    columns = [turned(turn, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))]
    result = PoseWithCovarianceStamped().pose.covariance
    for rows in PARTS:
        for part in PARTS:
            for i in range(3):
                for j in range(3):
                    result[6 * rows[i] + part[j]] = sum(
                        columns[k][i] * float(cov_in[6 * rows[k] + part[m]]) * columns[m][j]
                        for k in range(3) for m in range(3))
    return result


for _type in (Vector3Stamped, PoseStamped, PointStamped):
    tf2_ros.ConvertRegistration().add_to_msg(_type, to_msg_msg)
    tf2_ros.ConvertRegistration().add_from_msg(_type, from_msg_msg)
for _type, _function in (
        (PointStamped, do_transform_point), (Vector3Stamped, do_transform_vector3),
        (PoseStamped, do_transform_pose_stamped),
        (PoseWithCovarianceStamped, do_transform_pose_with_covariance_stamped),
        (PolygonStamped, do_transform_polygon_stamped)):
    tf2_ros.TransformRegistration().add(_type, _function)
