"""Poses on the ground: x and y [m], and the turn about z [rad]."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from geometry_msgs.msg import Quaternion


@dataclass(frozen=True)
class Planar:
    """A pose, or a transform, of which the height and other turns do not count."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0

    def __matmul__(self, inner: Planar) -> Planar:
        """Get a pose of the frame at this one, in the frame of this one."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        return Planar(
            self.x + cos * inner.x - sin * inner.y, self.y + sin * inner.x + cos * inner.y, self.yaw + inner.yaw)

    def inverse(self) -> Planar:
        """Get the pose of the outer frame in that of this pose."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        return Planar(-cos * self.x - sin * self.y, sin * self.x - cos * self.y, -self.yaw)

    def rotation(self) -> Any:
        """Get the turn as a message."""
        return Quaternion(z=math.sin(self.yaw / 2), w=math.cos(self.yaw / 2))


def planar(translation: Any, rotation: Any) -> Planar:
    """Get a pose from the parts of a message. Raise ValueError when they are not numbers or have no direction."""
    x, y, z, w = rotation.x, rotation.y, rotation.z, rotation.w
    size = x * x + y * y + z * z + w * w
    if not (math.isfinite(translation.x) and math.isfinite(translation.y) and math.isfinite(size) and size > 1e-6):
        raise ValueError('a pose needs finite numbers and an orientation')
    return Planar(translation.x, translation.y, math.atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z))
