"""Distances to what stands on a grid map."""
from __future__ import annotations

from typing import Any

import numpy as np

# Points of a ray that are looked at together. Most rays end within the first ones.
BLOCK = 64


def cells_to_obstacles(occupied: Any, start: tuple[int, int], ends: Any) -> Any:
    """
    Get the distance to the first occupied cell along each line [cells]; 0 where there is none.

    `occupied` is indexed by y and x, `ends` has a row of x and y per line. A line ends where it leaves the map; the
    first row and column do not belong to it. Its points are half a cell apart along its longer side.
    """
    first = np.array(start)
    lengths = np.asarray(ends) - first
    counts = 2 * np.abs(lengths).max(axis=1)
    steps = lengths / np.maximum(counts, 1)[:, None]
    distances = np.zeros(len(lengths))
    lines = np.flatnonzero(counts)
    begin = 0
    while len(lines):
        points = np.minimum(np.arange(begin, begin + BLOCK)[None, :], counts[lines, None])
        cells = np.trunc(np.round(first + points[:, :, None] * steps[lines, None, :], 5)).astype(np.int64)
        ends_at, hits = _first_stops(occupied, cells)
        at = cells[np.arange(len(lines)), ends_at]
        distances[lines[hits]] = np.hypot(*(at[hits] - first).T)
        begin += BLOCK
        lines = lines[(ends_at < 0) & (counts[lines] >= begin)]
    return distances


def _first_stops(occupied: Any, cells: Any) -> tuple[Any, Any]:
    """Get, per line, the first point that is occupied or outside (or -1), and whether it is occupied."""
    height, width = occupied.shape
    x, y = cells[:, :, 0], cells[:, :, 1]
    inside = (x > 0) & (x < width) & (y > 0) & (y < height)
    stops = ~inside
    stops[inside] = occupied[y[inside], x[inside]]
    found = stops.any(axis=1)
    at = np.where(found, stops.argmax(axis=1), -1)
    return at, found & inside[np.arange(len(cells)), at]
