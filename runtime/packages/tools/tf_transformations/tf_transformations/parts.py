"""What a homogeneous matrix is made of."""
from __future__ import annotations

from typing import Any

import numpy as np

#: Places of the shears x-y, x-z and y-z.
SHEARS = ((0, 1), (0, 2), (1, 2))


def parts_of(matrix: Any) -> tuple[Any, Any, Any, Any]:
    """Shift, rotation, zooms and shears of a homogeneous matrix."""
    matrix = np.asarray(matrix, dtype=float)
    linear = matrix[:3, :3]
    # Zooms and shears are the triangle of which the rotation takes nothing away.
    triangle = np.linalg.cholesky(linear.T @ linear).T
    if np.linalg.det(linear) < 0:
        triangle[0] *= -1
    zooms = np.diagonal(triangle).copy()
    shears = np.array([triangle[i, j] / zooms[i] for i, j in SHEARS])
    return matrix[:3, 3].copy(), linear @ np.linalg.inv(triangle), zooms, shears
