"""Quaternions (x, y, z, w)."""
from __future__ import annotations

import math
from typing import Any

import numpy as np

from tf_transformations.parts import parts_of
from tf_transformations.vectors import EPS, ROTATION_IDENTITY, homogeneous, unit_vector

Quaternion = tuple[float, float, float, float]
SHORTEST = float(np.finfo(float).eps)


def product(a: Any, b: Any) -> Quaternion:
    """First `b`, then `a`."""
    ax, ay, az, aw = (float(one) for one in a)
    bx, by, bz, bw = (float(one) for one in b)
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by + ay * bw + az * bx - ax * bz,
            aw * bz + az * bw + ax * by - ay * bx, aw * bw - ax * bx - ay * by - az * bz)


def rotation_of(quaternion: Any) -> Any:
    """The 3 x 3 matrix of a quaternion of any length; of none the identity."""
    x, y, z, w = (float(one) for one in quaternion)
    length2 = x * x + y * y + z * z + w * w
    if length2 < SHORTEST:
        return ROTATION_IDENTITY.copy()
    s = 2 / length2
    return np.array([
        [1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)],
        [s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)],
        [s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)]])


def of_rotation(rotation: Any) -> Quaternion:
    """The quaternion of a 3 x 3 matrix, with w that is not negative."""
    m = np.asarray(rotation, dtype=float)
    # Four times the products of all pairs of parts; the row with the biggest square tells the most exactly.
    squares = np.array([
        [1 + m[0, 0] - m[1, 1] - m[2, 2], m[1, 0] + m[0, 1], m[2, 0] + m[0, 2], m[2, 1] - m[1, 2]],
        [m[1, 0] + m[0, 1], 1 - m[0, 0] + m[1, 1] - m[2, 2], m[2, 1] + m[1, 2], m[0, 2] - m[2, 0]],
        [m[2, 0] + m[0, 2], m[2, 1] + m[1, 2], 1 - m[0, 0] - m[1, 1] + m[2, 2], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1 + m[0, 0] + m[1, 1] + m[2, 2]]])
    row = unit_vector(squares[int(np.argmax(np.diagonal(squares)))])
    x, y, z, w = (float(one) for one in (-row if row[3] < 0 else row))
    return x, y, z, w


def quaternion_about_axis(angle: float, axis: Any) -> Quaternion:
    x, y, z = (float(one) for one in unit_vector(axis) * math.sin(angle / 2))
    return x, y, z, math.cos(angle / 2)


def quaternion_matrix(quaternion: Any) -> Any:
    return homogeneous(rotation_of(quaternion))


def quaternion_from_matrix(matrix: Any) -> Quaternion:
    """Of a homogeneous matrix, without its zoom and shear."""
    return of_rotation(parts_of(matrix)[1])


def quaternion_multiply(quaternion1: Any, quaternion0: Any) -> Quaternion:
    """First `quaternion0`, then `quaternion1`."""
    return product(quaternion1, quaternion0)


def quaternion_conjugate(quaternion: Any) -> Any:
    return np.array([-quaternion[0], -quaternion[1], -quaternion[2], quaternion[3]], dtype=float)


def quaternion_inverse(quaternion: Any) -> Any:
    return quaternion_conjugate(quaternion) / np.dot(quaternion, quaternion)


def quaternion_slerp(quat0: Any, quat1: Any, fraction: float, spin: int = 0, shortestpath: bool = True) -> Any:
    """On the way from one to the other, at constant speed. `spin`: half turns more."""
    start, end = unit_vector(quat0[:4]), unit_vector(quat1[:4])
    if fraction == 0.0:
        return start
    if fraction == 1.0:
        return end
    cosine = float(np.dot(start, end))
    if abs(abs(cosine) - 1.0) < EPS:
        return start
    if shortestpath and cosine < 0.0:
        end, cosine = -end, -cosine
    angle = math.acos(cosine) + spin * math.pi
    if abs(angle) < EPS:
        return start
    return (math.sin((1.0 - fraction) * angle) * start + math.sin(fraction * angle) * end) / math.sin(angle)


def random_quaternion(rand: Any = None) -> Any:
    """Any rotation, all as likely. `rand`: three numbers from 0 to 1 that choose it."""
    if rand is None:
        rand = np.random.rand(3)
    assert len(rand) == 3
    inner, outer = math.sqrt(1.0 - rand[0]), math.sqrt(rand[0])
    first, second = 2 * math.pi * rand[1], 2 * math.pi * rand[2]
    return np.array([math.sin(first) * inner, math.cos(first) * inner,
                     math.sin(second) * outer, math.cos(second) * outer])


def random_rotation_matrix(rand: Any = None) -> Any:
    return quaternion_matrix(random_quaternion(rand))
