"""Transforms for the tests of this folder."""
from __future__ import annotations

import importlib
import math
from typing import Any

NS = 1_000_000_000


def transform(parent: str, child: str, seconds: float, x: float, yaw: float = 0.0) -> Any:
    message = importlib.import_module('geometry_msgs.msg').TransformStamped(child_frame_id=child)
    message.header.frame_id = parent
    message.header.stamp.sec, message.header.stamp.nanosec = divmod(round(seconds * NS), NS)
    message.transform.translation.x = x
    message.transform.rotation.z, message.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return message


def at(seconds: float) -> Any:
    return importlib.import_module('rclpy.time').Time(nanoseconds=round(seconds * NS))


def seconds_of(stamp: Any) -> float:
    return float(stamp.sec + stamp.nanosec / NS)


def yaw_of(rotation: Any) -> float:
    return 2 * math.atan2(rotation.z, rotation.w)
