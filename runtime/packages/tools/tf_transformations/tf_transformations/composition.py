"""Matrices out of their parts, and what else is done with whole matrices."""
from __future__ import annotations

import math
from typing import Any

import numpy as np

from tf_transformations.euler import euler_from_matrix, euler_matrix
from tf_transformations.parts import SHEARS, parts_of
from tf_transformations.quaternions import rotation_of
from tf_transformations.vectors import (
    ROTATION_IDENTITY, SHEAR_IDENTITY, TRANSLATION_IDENTITY, ZOOM_IDENTITY, homogeneous,
)


def compose_matrix(
    scale: Any = None, shear: Any = None, angles: Any = None, translate: Any = None, perspective: Any = None
) -> Any:
    """The inverse of decompose_matrix. `perspective` is not heeded, as upstream."""
    rotation = ROTATION_IDENTITY if angles is None else euler_matrix(*angles)[:3, :3]
    sheared = np.identity(3)
    for (i, j), one in zip(SHEARS, SHEAR_IDENTITY if shear is None else shear):
        sheared[i, j] = one
    zoomed = np.diag(np.asarray(ZOOM_IDENTITY if scale is None else scale, dtype=float))
    return homogeneous(rotation @ zoomed @ sheared, TRANSLATION_IDENTITY if translate is None else translate)


def decompose_matrix(matrix: Any) -> tuple[Any, Any, Any, Any, None]:
    """Scale, shear, angles, translation; no perspective."""
    shift, rotation, zooms, shears = parts_of(matrix)
    return zooms, shears, euler_from_matrix(rotation), shift, None


def inverse_matrix(matrix: Any) -> Any:
    return np.linalg.inv(matrix)


def concatenate_matrices(*matrices: Any) -> Any:
    result = np.identity(4)
    for matrix in matrices:
        result = np.dot(result, matrix)
    return result


def is_same_transform(matrix0: Any, matrix1: Any) -> bool:
    """Up to the factor of homogeneous matrices."""
    first, second = np.asarray(matrix0, dtype=float), np.asarray(matrix1, dtype=float)
    return bool(np.allclose(first / first[3, 3], second / second[3, 3]))


def orthogonalization_matrix(lengths: Any, angles: Any) -> Any:
    """From the axes of a crystal's cell to orthogonal ones. Angles in degrees."""
    a, b, c = (float(one) for one in lengths)
    alpha, beta, gamma = (math.radians(one) for one in angles)
    cosine = (math.cos(alpha) * math.cos(beta) - math.cos(gamma)) / (math.sin(alpha) * math.sin(beta))
    return homogeneous([
        [a * math.sin(beta) * math.sqrt(1 - cosine * cosine), 0, 0],
        [-a * math.sin(beta) * cosine, b * math.sin(alpha), 0],
        [a * math.cos(beta), b * math.cos(alpha), c]])


def superimposition_matrix(v0: Any, v1: Any, scaling: bool = False, usesvd: bool = True) -> Any:
    """What moves the vectors `v0` (in columns) closest to `v1`: by Kabsch's method, or by Horn's."""
    source, target = (np.asarray(one, dtype=float)[:3] for one in (v0, v1))
    if source.shape != target.shape or source.shape[1] < 3:
        raise ValueError('Vector sets are of wrong shape or type.')
    from_centre, to_centre = source.mean(axis=1), target.mean(axis=1)
    source, target = source - from_centre[:, None], target - to_centre[:, None]
    covariance = target @ source.T
    if usesvd:
        left, _, right = np.linalg.svd(covariance)
        # The third axis is turned where all else would be a mirror.
        rotation = left @ np.diag([1.0, 1.0, math.copysign(1.0, np.linalg.det(left @ right))]) @ right
    else:
        rotation = rotation_of(_closest_quaternion(covariance))
    if scaling:
        rotation = rotation * math.sqrt((target * target).sum() / (source * source).sum())
    return homogeneous(rotation, to_centre - rotation @ from_centre)


def _closest_quaternion(covariance: Any) -> Any:
    """The eigenvector, of the biggest eigenvalue, of Horn's symmetric matrix; with w last."""
    c = covariance.T
    odd = np.array([c[1, 2] - c[2, 1], c[2, 0] - c[0, 2], c[0, 1] - c[1, 0]])
    matrix = np.zeros((4, 4))
    matrix[:3, :3] = c + c.T - np.trace(c) * np.identity(3)
    matrix[3, :3] = matrix[:3, 3] = odd
    matrix[3, 3] = np.trace(c)
    return np.linalg.eigh(matrix)[1][:, -1]
