"""Between messages and what the buffer computes with."""
from __future__ import annotations

import warnings
from typing import Any

from geometry_msgs.msg import Quaternion, TransformStamped, Vector3

from tf2_py.time_cache import NS
from tf2_py.transform import Transform, settled


def nanoseconds(value: Any, what: str) -> int:
    """Of a time or a duration, a message or rclpy's."""
    if hasattr(value, 'sec') and hasattr(value, 'nanosec'):
        return int(value.sec) * NS + int(value.nanosec)
    if hasattr(value, 'nanoseconds'):
        return int(value.nanoseconds)
    raise TypeError(f'{what} must have sec and nanosec, or nanoseconds.')


def transform_of(message: Any) -> Transform:
    """What a TransformStamped says. A quaternion of any length will do."""
    translation, rotation = message.transform.translation, message.transform.rotation
    if not isinstance(translation, Vector3):
        warnings.warn('translation should be of type Vector3', UserWarning, stacklevel=3)
        raise TypeError('transform.translation must have members x, y, z')
    if not isinstance(rotation, Quaternion):
        warnings.warn('translation should be of type Quaternion', UserWarning, stacklevel=3)
    return Transform((float(translation.x), float(translation.y), float(translation.z)),
                     settled((float(rotation.x), float(rotation.y), float(rotation.z), float(rotation.w))))


def message_of(transform: Transform, stamp: int, target: str, source: str) -> Any:
    message = TransformStamped(child_frame_id=source)
    message.header.frame_id = target
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp, NS)
    translation, rotation = message.transform.translation, message.transform.rotation
    translation.x, translation.y, translation.z = transform.shift
    rotation.x, rotation.y, rotation.z, rotation.w = transform.turn
    return message
