"""Turns and shifts in space, as plain tuples: vectors (x, y, z), quaternions (x, y, z, w) of length one."""
from __future__ import annotations

import math
from typing import NamedTuple

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

NO_TURN: Quaternion = (0.0, 0.0, 0.0, 1.0)
NO_SHIFT: Vector = (0.0, 0.0, 0.0)


def dot(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return sum(x * y for x, y in zip(a, b))


def plus(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scaled(a: Vector, factor: float) -> Vector:
    return a[0] * factor, a[1] * factor, a[2] * factor


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def turned_after(a: Quaternion, b: Quaternion) -> Quaternion:
    """The product: first `b`, then `a`."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by,
            aw * by + ay * bw + az * bx - ax * bz,
            aw * bz + az * bw + ax * by - ay * bx,
            aw * bw - ax * bx - ay * by - az * bz)


def turned_back(q: Quaternion) -> Quaternion:
    return -q[0], -q[1], -q[2], q[3]


def turned(q: Quaternion, v: Vector) -> Vector:
    """The vector `v`, turned by `q`."""
    x, y, z, w = q
    tx, ty, tz = 2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])
    return (v[0] + w * tx + y * tz - z * ty,
            v[1] + w * ty + z * tx - x * tz,
            v[2] + w * tz + x * ty - y * tx)


def settled(q: Quaternion) -> Quaternion:
    """Of length one, and of the two signs the one that a rotation matrix becomes. Without a length: not numbers."""
    x, y, z, w = q
    length = math.sqrt(x * x + y * y + z * z + w * w)
    if length == 0:
        return math.nan, math.nan, math.nan, math.nan
    biggest = max(x, y, z, key=abs)
    negative = w < 0 if 4 * w * w > length * length else biggest < 0
    factor = -1 / length if negative else 1 / length
    # Adding zero makes 0.0 of -0.0.
    return x * factor + 0.0, y * factor + 0.0, z * factor + 0.0, w * factor + 0.0


def between(a: Vector, b: Vector, ratio: float) -> Vector:
    return plus(scaled(a, 1 - ratio), scaled(b, ratio))


def slerp(a: Quaternion, b: Quaternion, ratio: float) -> Quaternion:
    """On the shorter way from `a` to `b`, at constant speed."""
    cosine = dot(a, b)
    if cosine < 0:
        b, cosine = (-b[0], -b[1], -b[2], -b[3]), -cosine
    angle = math.acos(min(cosine, 1.0))
    if angle == 0:
        return a
    from_a, from_b = math.sin((1 - ratio) * angle) / math.sin(angle), math.sin(ratio * angle) / math.sin(angle)
    return (a[0] * from_a + b[0] * from_b, a[1] * from_a + b[1] * from_b,
            a[2] * from_a + b[2] * from_b, a[3] * from_a + b[3] * from_b)


class Transform(NamedTuple):
    """First turns, then shifts."""

    shift: Vector
    turn: Quaternion

    def of_point(self, point: Vector) -> Vector:
        return plus(turned(self.turn, point), self.shift)

    def after(self, first: Transform) -> Transform:
        return Transform(self.of_point(first.shift), turned_after(self.turn, first.turn))

    def inverse(self) -> Transform:
        back = turned_back(self.turn)
        return Transform(turned(back, scaled(self.shift, -1.0)), back)


IDENTITY = Transform(NO_SHIFT, NO_TURN)
