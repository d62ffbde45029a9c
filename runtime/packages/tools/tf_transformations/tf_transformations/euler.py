"""Euler angles: three turns about axes of a sequence, which stay (`sxyz`) or turn along (`rzyx`)."""
from __future__ import annotations

import math
from typing import Any

import numpy as np

from tf_transformations.quaternions import Quaternion, product, quaternion_about_axis, rotation_of
from tf_transformations.vectors import EPS, ROTATION_IDENTITY, homogeneous

Angles = tuple[float, float, float]
LETTERS = 'xyz'


def _code(axes: str) -> tuple[int, int, int, int]:
    """A sequence as numbers: first axis, odd, first axis again, turning. Turning ones count from behind."""
    turning = axes[0] == 'r'
    first, second, third = (LETTERS.index(one) for one in (axes[:0:-1] if turning else axes[1:]))
    return first, int(second != (first + 1) % 3), int(first == third), int(turning)


_SEQUENCES = [frame + a + b + c for frame in 'sr' for a in LETTERS for b in LETTERS for c in LETTERS
              if b not in (a, c)]
_AXES2TUPLE = {axes: _code(axes) for axes in _SEQUENCES}
_TUPLE2AXES = {code: axes for axes, code in _AXES2TUPLE.items()}


def _turning(axes: Any) -> tuple[list[int], bool]:
    """Axes that turn along, and whether the angles are in that order."""
    name: str = axes.lower() if isinstance(axes, str) else _TUPLE2AXES[axes]
    if name not in _AXES2TUPLE:
        raise KeyError(axes)
    order = [LETTERS.index(one) for one in name[1:]]
    return (order, True) if name[0] == 'r' else (order[::-1], False)


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Any = 'sxyz') -> Quaternion:
    order, as_given = _turning(axes)
    angles = (ai, aj, ak) if as_given else (ak, aj, ai)
    first, second, third = (quaternion_about_axis(angle, ROTATION_IDENTITY[axis]) for angle, axis in zip(angles, order))
    return product(product(first, second), third)


def euler_matrix(ai: float, aj: float, ak: float, axes: Any = 'sxyz') -> Any:
    return homogeneous(rotation_of(quaternion_from_euler(ai, aj, ak, axes)))


def euler_from_quaternion(quaternion: Any, axes: Any = 'sxyz') -> Angles:
    return euler_from_matrix(rotation_of(quaternion), axes)


def euler_from_matrix(matrix: Any, axes: Any = 'sxyz') -> Angles:
    """Of a rotation, 3 x 3 or homogeneous. Where only two angles can be told apart, one is zero."""
    m = np.asarray(matrix, dtype=float)[:3, :3].tolist()
    (i, j, last), as_given = _turning(axes)
    sign = 1 if j == (i + 1) % 3 else -1
    k = 3 - i - j
    if i == last:
        sine = math.hypot(m[i][j], m[i][k])
        second = sign * math.atan2(sine, m[i][i])
        if sine > EPS:
            first, third = math.atan2(sign * m[j][i], -m[k][i]), math.atan2(sign * m[i][j], m[i][k])
        else:
            first, third = 0.0, math.atan2(-sign * m[j][k], m[j][j])
    else:
        cosine = math.hypot(m[i][i], m[i][j])
        second = math.atan2(sign * m[i][k], cosine)
        if cosine > EPS:
            first, third = math.atan2(-sign * m[j][k], m[k][k]), math.atan2(-sign * m[i][j], m[i][i])
        else:
            first, third = 0.0, math.atan2(sign * m[j][i], m[j][j])
    return (first, second, third) if as_given else (third, second, first)
