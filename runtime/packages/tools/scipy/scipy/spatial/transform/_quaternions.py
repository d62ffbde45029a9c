"""Quaternions (x, y, z, w) of many rotations at once, and what else describes them. Arrays of shape (count, ...)."""
from __future__ import annotations

import warnings
from typing import Any

import numpy as np

AXES = 'xyz'
#: As near to a half or no turn as this, two angles of three turn about one axis.
LOCKED = 1e-7
#: Below it a series is better than a quotient.
SMALL = 1e-3
W = 3


def normalized(quaternions: Any) -> Any:
    norms = np.linalg.norm(quaternions, axis=1, keepdims=True)
    if np.any(norms == 0):
        raise ValueError('a quaternion of zeros is not a rotation')
    return quaternions / norms


def product(first: Any, second: Any) -> Any:
    """That turns by the second one, then by the first one."""
    a, b = np.broadcast_arrays(first, second)
    made = np.empty(a.shape)
    made[:, :W] = a[:, W:] * b[:, :W] + b[:, W:] * a[:, :W] + np.cross(a[:, :W], b[:, :W])
    made[:, W] = a[:, W] * b[:, W] - np.sum(a[:, :W] * b[:, :W], axis=1)
    return made


def to_matrices(quaternions: Any) -> Any:
    x, y, z, w = quaternions.T
    rows = ((x * x - y * y - z * z + w * w, 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), y * y - x * x - z * z + w * w, 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), z * z - x * x - y * y + w * w))
    return np.moveaxis(np.array(rows), -1, 0)


def from_matrices(matrices: Any) -> Any:
    """By the largest of the four, so that nothing is divided by what is nearly zero."""
    diagonal = np.einsum('nii->ni', matrices)
    trace = diagonal.sum(axis=1)
    largest = np.argmax(np.column_stack((diagonal, trace)), axis=1)
    made = np.empty((len(matrices), 4))
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        chosen = largest == i
        m = matrices[chosen]
        made[chosen, i] = 1 - trace[chosen] + 2 * m[:, i, i]
        made[chosen, j] = m[:, j, i] + m[:, i, j]
        made[chosen, k] = m[:, k, i] + m[:, i, k]
        made[chosen, W] = m[:, k, j] - m[:, j, k]
    chosen = largest == W
    m = matrices[chosen]
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        made[chosen, i] = m[:, k, j] - m[:, j, k]
    made[chosen, W] = 1 + trace[chosen]
    return normalized(made)


def to_vectors(quaternions: Any) -> Any:
    """Rotation vectors, of at most half a turn."""
    shorter = np.where(quaternions[:, W:] < 0, -quaternions, quaternions)
    lengths = np.linalg.norm(shorter[:, :W], axis=1)
    angles = 2 * np.arctan2(lengths, shorter[:, W])
    squares = angles ** 2
    small = angles <= SMALL
    divisors = np.where(small, 1, np.sin(angles / 2))
    scales = np.where(small, 2 + squares / 12 + 7 * squares ** 2 / 2880, angles / divisors)
    return scales[:, None] * shorter[:, :W]


def from_vectors(vectors: Any) -> Any:
    angles = np.linalg.norm(vectors, axis=1)
    squares = angles ** 2
    small = angles <= SMALL
    divisors = np.where(small, 1, angles)
    scales = np.where(small, 0.5 - squares / 48 + squares ** 2 / 3840, np.sin(angles / 2) / divisors)
    return np.column_stack((scales[:, None] * vectors, np.cos(angles / 2)))


def about_axis(axis: str, angles: Any) -> Any:
    made = np.zeros((len(angles), 4))
    made[:, AXES.index(axis)] = np.sin(angles / 2)
    made[:, W] = np.cos(angles / 2)
    return made


def to_angles(quaternions: Any, axes: str, extrinsic: bool) -> Any:
    """
    Angles about three axes, none next to itself; see Bernardes and Viollet, "Quaternion to Euler angles conversion"
    (2022). Where the first and the last axis fall together, the last angle is 0.
    """
    i, j, k = (AXES.index(axis) for axis in (axes if extrinsic else axes[::-1]))
    first, last = (0, 2) if extrinsic else (2, 0)
    proper = i == k
    if proper:
        k = 3 - i - j
    sign = (i - j) * (j - k) * (k - i) // 2
    a, b, c, d = quaternions[:, W], quaternions[:, i], quaternions[:, j], sign * quaternions[:, k]
    if not proper:
        a, b, c, d = a - c, b + d, c + a, d - b
    middle = 2 * np.arctan2(np.hypot(c, d), np.hypot(a, b))
    half_sum, half_difference = np.arctan2(b, a), np.arctan2(d, c)
    at_none, at_half = np.abs(middle) <= LOCKED, np.abs(middle - np.pi) <= LOCKED
    made = np.empty((len(quaternions), 3))
    made[:, first], made[:, 1], made[:, last] = half_sum - half_difference, middle, half_sum + half_difference
    locked = at_none | at_half
    made[at_none, 0] = 2 * half_sum[at_none]
    made[at_half, 0] = (-2 if extrinsic else 2) * half_difference[at_half]
    made[locked, 2] = 0
    if not proper:
        made[:, last] *= sign
        made[:, 1] -= np.pi / 2
    if locked.any():
        warnings.warn('gimbal lock: two of the axes fall together, the third angle is set to 0', stacklevel=3)
    return np.where(made < -np.pi, made + 2 * np.pi, np.where(made > np.pi, made - 2 * np.pi, made))
