"""Vectors, and what changes nothing."""
from __future__ import annotations

from typing import Any

import numpy as np

EPS = float(np.finfo(float).eps) * 4
TRANSLATION_IDENTITY = [0.0, 0.0, 0.0]
ROTATION_IDENTITY = np.identity(3)
ZOOM_IDENTITY = [1.0, 1.0, 1.0]
SHEAR_IDENTITY = TRANSLATION_IDENTITY


def vector_norm(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """The length, along an axis where there are several."""
    data = np.asarray(data, dtype=float)
    if out is not None:
        out[...] = np.sqrt((data * data).sum(axis=axis))
        return None
    length = np.sqrt((data * data).sum(axis=axis))
    return float(length) if data.ndim == 1 else np.atleast_1d(length)


def unit_vector(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """Of length one."""
    data = np.asarray(data, dtype=float)
    length = np.sqrt((data * data).sum(axis=axis, keepdims=axis is not None))
    if out is None:
        return data / length
    out[...] = data / length
    return None


def random_vector(size: int) -> Any:
    """Numbers from 0 to 1."""
    return np.random.random(size)


def homogeneous(linear: Any, shift: Any = TRANSLATION_IDENTITY) -> Any:
    """A 4 x 4 matrix: first `linear`, then `shift`."""
    matrix = np.identity(4)
    matrix[:3, :3] = linear
    matrix[:3, 3] = np.asarray(shift, dtype=float)[:3]
    return matrix


def about_point(linear: Any, point: Any) -> Any:
    """What leaves a point where it is. None: the origin."""
    if point is None:
        return homogeneous(linear)
    point = np.asarray(point, dtype=float)[:3]
    return homogeneous(linear, point - linear @ point)


def eigenvector(matrix: Any, value: float, place: int = -1) -> Any:
    """Of the last (or another) eigenvalue of this value. ValueError: there is none."""
    values, vectors = np.linalg.eig(np.asarray(matrix, dtype=float))
    found = np.nonzero(abs(values.real - value) < 1e-8)[0]
    if not len(found):
        raise ValueError(f'no eigenvector corresponding to eigenvalue {value:g}')
    return vectors[:, found[place]].real


def fixed_point(matrix: Any) -> Any:
    """Of the points that a matrix leaves where they are the one nearest to the origin, homogeneous."""
    matrix = np.asarray(matrix, dtype=float)
    moved = np.identity(3) - matrix[:3, :3]
    point = np.linalg.lstsq(moved, matrix[:3, 3], rcond=None)[0]
    if not np.allclose(moved @ point, matrix[:3, 3]):
        raise ValueError('no point stays where it is')
    return np.append(point, 1.0)
