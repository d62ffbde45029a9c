"""Matrices that move, turn, mirror, zoom, shear, project and clip, and what they do read off them."""
from __future__ import annotations

import math
from typing import Any

import numpy as np

from tf_transformations.quaternions import of_rotation, quaternion_about_axis, rotation_of
from tf_transformations.vectors import EPS, about_point, eigenvector, fixed_point, homogeneous, unit_vector


def _vector(data: Any) -> Any:
    return np.asarray(data, dtype=float)[:3]


def identity_matrix() -> Any:
    return np.identity(4)


def translation_matrix(direction: Any) -> Any:
    return homogeneous(np.identity(3), direction)


def translation_from_matrix(matrix: Any) -> Any:
    return np.array(matrix, dtype=float)[:3, 3]


def reflection_matrix(point: Any, normal: Any) -> Any:
    """Mirrors at the plane through a point."""
    normal = unit_vector(_vector(normal))
    return about_point(np.identity(3) - 2 * np.outer(normal, normal), point)


def reflection_from_matrix(matrix: Any) -> tuple[Any, Any]:
    """A point, homogeneous, and the normal of the mirror."""
    return fixed_point(matrix), eigenvector(np.asarray(matrix)[:3, :3], -1.0, 0)


def rotation_matrix(angle: float, direction: Any, point: Any = None) -> Any:
    """Turns about the axis through a point."""
    return about_point(rotation_of(quaternion_about_axis(angle, _vector(direction))), point)


def rotation_from_matrix(matrix: Any) -> tuple[float, Any, Any]:
    """Angle, axis, and a homogeneous point of the axis."""
    x, y, z, w = of_rotation(np.asarray(matrix, dtype=float)[:3, :3])
    sine = math.sqrt(x * x + y * y + z * z)
    axis = np.array([x, y, z]) / sine if sine > EPS else np.array([1.0, 0.0, 0.0])
    return 2 * math.atan2(sine, w), axis, fixed_point(matrix)


def scale_matrix(factor: float, origin: Any = None, direction: Any = None) -> Any:
    """Zooms around a point: everywhere, or in one direction."""
    if direction is None:
        return about_point(factor * np.identity(3), origin)
    direction = unit_vector(_vector(direction))
    return about_point(np.identity(3) - (1 - factor) * np.outer(direction, direction), origin)


def scale_from_matrix(matrix: Any) -> tuple[float, Any, Any]:
    """Factor, homogeneous origin, and direction; None: everywhere."""
    linear = np.asarray(matrix, dtype=float)[:3, :3]
    factor = float(np.trace(linear)) - 2
    try:
        direction = unit_vector(eigenvector(linear, factor, 0))
    except ValueError:
        factor, direction = (factor + 2) / 3, None
    return factor, fixed_point(matrix), direction


def shear_matrix(angle: float, direction: Any, point: Any, normal: Any) -> Any:
    """Moves along a direction, the more the farther from the plane through a point."""
    normal, direction = unit_vector(_vector(normal)), unit_vector(_vector(direction))
    return about_point(np.identity(3) + math.tan(angle) * np.outer(direction, normal), point)


def shear_from_matrix(matrix: Any) -> tuple[float, Any, Any, Any]:
    """Angle, direction, a homogeneous point of the plane, and its normal."""
    sheared = np.asarray(matrix, dtype=float)[:3, :3] - np.identity(3)
    left, sizes, right = np.linalg.svd(sheared)
    return math.atan(float(sizes[0])), left[:, 0], fixed_point(matrix), right[0]


def projection_matrix(
    point: Any, normal: Any, direction: Any = None, perspective: Any = None, pseudo: bool = False
) -> Any:
    """
    Projects onto the plane through a point: from a point of view, along a direction, or at right angles.

    `pseudo`: from a point of view, what is nearer stays nearer.
    """
    point, normal = _vector(point), unit_vector(_vector(normal))
    distance = float(np.dot(point, normal))
    if perspective is None:
        along = normal if direction is None else _vector(direction)
        along = along / np.dot(along, normal)
        return homogeneous(np.identity(3) - np.outer(along, normal), distance * along)
    eye = _vector(perspective)
    matrix = np.dot(eye - point, normal) * np.identity(4)
    matrix[:3, :3] -= np.outer(eye, normal)
    matrix[:3, 3] = distance * eye
    if pseudo:
        matrix[:3, :3] -= np.outer(normal, normal)
        matrix[:3, 3] += distance * normal
    matrix[3, :3] = -normal
    matrix[3, 3] = np.dot(eye, normal)
    return matrix


def projection_from_matrix(matrix: Any, pseudo: bool = False) -> tuple[Any, Any, Any, Any, bool]:
    """The arguments of projection_matrix."""
    matrix = np.asarray(matrix, dtype=float)
    linear = matrix[:3, :3]
    values, vectors = np.linalg.eig(matrix)
    if not pseudo and (abs(values.real - 1.0) < 1e-8).any():
        point = fixed_point(matrix)
        direction = unit_vector(eigenvector(linear, 0.0, 0))
        try:
            return point, unit_vector(eigenvector(linear.T, 0.0, 0)), direction, None, False
        except ValueError:
            return point, direction, None, None, False
    found = np.nonzero(abs(values.real) > 1e-8)[0]
    if not len(found):
        raise ValueError('no eigenvector not corresponding to eigenvalue 0')
    point = vectors[:, found[-1]].real
    point = point / point[3]
    normal = -matrix[3, :3]
    eye = matrix[:3, 3] / np.dot(point[:3], normal)
    return point, normal, None, eye - normal if pseudo else eye, pseudo


def clip_matrix(
    left: float, right: float, bottom: float, top: float, near: float, far: float, perspective: bool = False
) -> Any:
    """From what a camera sees to the cube from -1 to 1."""
    if left >= right or bottom >= top or near >= far:
        raise ValueError('invalid frustrum')
    size = np.array([right - left, top - bottom, far - near], dtype=float)
    middle = np.array([right + left, top + bottom, far + near], dtype=float)
    if not perspective:
        return homogeneous(np.diag(2.0 / size), -middle / size)
    if near <= EPS:
        raise ValueError('invalid frustum: near <= 0')
    matrix = np.zeros((4, 4))
    matrix[:3, 2] = middle / size * [1, 1, -1]
    matrix[0, 0], matrix[1, 1] = -2.0 * near / size[:2]
    matrix[2, 3] = 2.0 * near * far / size[2]
    matrix[3, 2] = -1.0
    return matrix
