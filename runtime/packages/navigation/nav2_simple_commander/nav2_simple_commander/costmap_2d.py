"""A map of costs, from a message."""
from __future__ import annotations

from typing import Any

import numpy as np


class PyCostmap2D:
    """The cells of a nav_msgs/OccupancyGrid as costs from 0 to 255, and where they are."""

    def __init__(self, occupancy_map: Any) -> None:
        info = occupancy_map.info
        self.size_x: int = info.width
        self.size_y: int = info.height
        self.resolution: float = info.resolution
        self.origin_x: float = info.origin.position.x
        self.origin_y: float = info.origin.position.y
        self.global_frame_id: str = occupancy_map.header.frame_id
        self.costmap_timestamp = occupancy_map.header.stamp
        # -1, an unknown cell, becomes 255.
        self.costmap = np.asarray(occupancy_map.data).astype(np.uint8)

    def getSizeInCellsX(self) -> int:
        """Get the number of cells along x."""
        return self.size_x

    def getSizeInCellsY(self) -> int:
        """Get the number of cells along y."""
        return self.size_y

    def getSizeInMetersX(self) -> float:
        """Get the distance from the edge to the middle of the last cell along x [m]."""
        return (self.size_x - 1 + 0.5) * self.resolution

    def getSizeInMetersY(self) -> float:
        """Get the distance from the edge to the middle of the last cell along y [m]."""
        return (self.size_y - 1 + 0.5) * self.resolution

    def getOriginX(self) -> float:
        """Get x of the corner of the first cell [m]."""
        return self.origin_x

    def getOriginY(self) -> float:
        """Get y of the corner of the first cell [m]."""
        return self.origin_y

    def getResolution(self) -> float:
        """Get the length of a cell [m]."""
        return self.resolution

    def getGlobalFrameID(self) -> str:
        """Get the frame of the map."""
        return self.global_frame_id

    def getCostmapTimestamp(self) -> Any:
        """Get the time of the message."""
        return self.costmap_timestamp

    def getCostXY(self, mx: int, my: int) -> Any:
        """Get the cost of a cell (np.uint8)."""
        return self.costmap[self.getIndex(mx, my)]

    def getCostIdx(self, index: int) -> Any:
        """Get the cost of a cell (np.uint8) by its index."""
        return self.costmap[index]

    def setCost(self, mx: int, my: int, cost: Any) -> None:
        """Change the cost of a cell."""
        self.costmap[self.getIndex(mx, my)] = cost

    def mapToWorld(self, mx: int, my: int) -> tuple[float, float]:
        """Get the middle of a cell [m]."""
        return (self.origin_x + (mx + 0.5) * self.resolution, self.origin_y + (my + 0.5) * self.resolution)

    def worldToMapValidated(self, wx: float, wy: float) -> tuple[int, int] | tuple[None, None]:
        """Get the cell of a place [m]; twice None outside of the map."""
        if not (wx >= self.origin_x and wy >= self.origin_y):
            return (None, None)
        x = (wx - self.origin_x) // self.resolution
        y = (wy - self.origin_y) // self.resolution
        return (int(x), int(y)) if x < self.size_x and y < self.size_y else (None, None)

    def getIndex(self, mx: int, my: int) -> int:
        """Get the index of a cell."""
        return my * self.size_x + mx
