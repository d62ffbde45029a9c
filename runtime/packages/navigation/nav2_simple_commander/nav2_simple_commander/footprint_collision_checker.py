"""The cost of a footprint on a map of costs."""
from __future__ import annotations

from math import cos, sin
from typing import Any

from geometry_msgs.msg import Point32, Polygon
from nav2_simple_commander.costmap_2d import PyCostmap2D
from nav2_simple_commander.line_iterator import LineIterator

NO_INFORMATION = 255
LETHAL_OBSTACLE = 254
INSCRIBED_INFLATED_OBSTACLE = 253
MAX_NON_OBSTACLE = 252
FREE_SPACE = 0


class FootprintCollisionChecker:
    """Looks at the cells below the outline of a footprint."""

    def __init__(self) -> None:
        self.costmap_: PyCostmap2D | None = None

    def setCostmap(self, costmap: PyCostmap2D) -> None:
        """Use this map from now on."""
        self.costmap_ = costmap

    def footprintCost(self, footprint: Any) -> float:
        """Get the highest cost below an outline in the frame of the map; LETHAL_OBSTACLE when it leaves the map."""
        if not footprint.points:
            raise ValueError('The footprint has no points')
        cells = [self.worldToMapValidated(point.x, point.y) for point in footprint.points]
        highest = 0.0
        for (x0, y0), (x1, y1) in zip(cells, cells[1:] + cells[:1]):
            if x0 is None or y0 is None or x1 is None or y1 is None:
                return LETHAL_OBSTACLE
            highest = max(highest, float(self.lineCost(x0, x1, y0, y1)))
            if highest == LETHAL_OBSTACLE:
                break
        return highest

    def lineCost(self, x0: float, x1: float, y0: float, y1: float, step_size: float = 0.5) -> float:
        """Get the highest cost below a line between two cells, which may be one."""
        if x0 == x1 and y0 == y1:
            return float(self.pointCost(int(x0), int(y0)))
        line = LineIterator(x0, y0, x1, y1, step_size)
        highest = 0.0
        while line.isValid() and highest != LETHAL_OBSTACLE:
            cost = float(self.pointCost(int(line.getX()), int(line.getY())))
            highest = cost if cost == LETHAL_OBSTACLE else max(highest, cost)
            line.advance()
        return highest

    def worldToMapValidated(self, wx: float, wy: float) -> tuple[int, int] | tuple[None, None]:
        """Get the cell of a place [m]; twice None outside of the map. Raise ValueError without a map."""
        return self._costmap().worldToMapValidated(wx, wy)

    def pointCost(self, x: int, y: int) -> Any:
        """Get the cost of a cell. Raise ValueError without a map, IndexError behind its last cell."""
        return self._costmap().getCostXY(x, y)

    def footprintCostAtPose(self, x: float, y: float, theta: float, footprint: Any) -> float:
        """Get the highest cost below a footprint that is moved to a place [m] and turned [rad]."""
        moved = Polygon()
        for point in footprint.points:
            moved.points.append(Point32(
                x=x + (point.x * cos(theta) - point.y * sin(theta)),
                y=y + (point.x * sin(theta) + point.y * cos(theta))))
        return self.footprintCost(moved)

    def _costmap(self) -> PyCostmap2D:
        if self.costmap_ is None:
            raise ValueError('Costmap not specified, use setCostmap to specify the costmap first')
        return self.costmap_
