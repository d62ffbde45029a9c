"""Turns things by the pointer, as a ball under it."""
from __future__ import annotations

import math
from typing import Any

import numpy as np

from tf_transformations.quaternions import (
    quaternion_from_matrix, quaternion_matrix, quaternion_multiply, quaternion_slerp,
)
from tf_transformations.vectors import EPS, unit_vector, vector_norm


class Arcball:
    """`down` where the pointer takes hold, `drag` where it goes, `matrix` what comes of it."""

    def __init__(self, initial: Any = None) -> None:
        """Begin with a rotation: a quaternion or a matrix."""
        start = np.array([0.0, 0.0, 0.0, 1.0]) if initial is None else np.array(initial, dtype=float)
        if start.shape == (4, 4):
            start = np.array(quaternion_from_matrix(start))
        elif start.shape != (4,):
            raise ValueError('initial not a quaternion or matrix.')
        self._qdown = self._qnow = self._qpre = unit_vector(start)
        self._axis: Any = None
        self._axes: Any = None
        self._radius = 1.0
        self._center: Any = [0.0, 0.0]
        self._vdown = np.array([0.0, 0.0, 1.0])
        self._constrain = False

    def place(self, center: Any, radius: float) -> None:
        """Where the ball is, in the window."""
        self._radius = float(radius)
        self._center = [center[0], center[1]]

    def setaxes(self, *axes: Any) -> None:
        """Axes that it turns about when it is held to axes."""
        self._axes = [unit_vector(axis) for axis in axes]

    def setconstrain(self, constrain: bool) -> None:
        self._constrain = constrain is True

    def getconstrain(self) -> bool:
        return self._constrain

    def down(self, point: Any) -> None:
        self._vdown = arcball_map_to_sphere(point, self._center, self._radius)
        self._qdown = self._qpre = self._qnow
        self._axis = None
        if self._constrain and self._axes is not None:
            self._axis = arcball_nearest_axis(self._vdown, self._axes)
            self._vdown = arcball_constrain_to_axis(self._vdown, self._axis)

    def drag(self, point: Any) -> None:
        now = arcball_map_to_sphere(point, self._center, self._radius)
        if self._axis is not None:
            now = arcball_constrain_to_axis(now, self._axis)
        self._qpre = self._qnow
        turned = np.cross(self._vdown, now)
        self._qnow = self._qdown if np.dot(turned, turned) < EPS else np.array(
            quaternion_multiply([*turned, np.dot(self._vdown, now)], self._qdown))

    def next(self, acceleration: float = 0.0) -> None:
        """Go on as before."""
        self._qpre, self._qnow = self._qnow, quaternion_slerp(self._qpre, self._qnow, 2.0 + acceleration, False)

    def matrix(self) -> Any:
        return quaternion_matrix(self._qnow)


def arcball_map_to_sphere(point: Any, center: Any, radius: float) -> Any:
    """The place on a ball of radius one under a place in the window; beside the ball, on its edge."""
    x, y = (point[0] - center[0]) / radius, (center[1] - point[1]) / radius
    away = x * x + y * y
    if away > 1.0:
        return np.array([x, y, 0.0]) / math.sqrt(away)
    return np.array([x, y, math.sqrt(1.0 - away)])


def arcball_constrain_to_axis(point: Any, axis: Any) -> Any:
    """The place on the circle about an axis, in front."""
    point, axis = np.asarray(point, dtype=float), np.asarray(axis, dtype=float)
    flat = point - axis * np.dot(axis, point)
    length = vector_norm(flat)
    if length > EPS:
        return (-flat if flat[2] < 0.0 else flat) / length
    return np.array([1.0, 0.0, 0.0]) if axis[2] == 1.0 else unit_vector([-axis[1], axis[0], 0.0])


def arcball_nearest_axis(point: Any, axes: Any) -> Any:
    """The axis whose circle passes closest by."""
    return max(axes, key=lambda axis: float(np.dot(arcball_constrain_to_axis(point, axis), point)), default=None)
