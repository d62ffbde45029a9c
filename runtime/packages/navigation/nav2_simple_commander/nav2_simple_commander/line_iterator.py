"""The points of a line, from one end to the other."""
from __future__ import annotations

import math


class LineIterator:
    """
    Steps along x, or along y where the line is vertical. Both ends are points of the line.

    Coordinates have five decimals after the first point.
    """

    def __init__(self, x0: float, y0: float, x1: float, y1: float, step_size: float = 1.0) -> None:
        """Raise TypeError for what is not a number, ValueError for a step or a line that has no length."""
        numbers = {'x0': x0, 'y0': y0, 'x1': x1, 'y1': y1, 'step_size': step_size}
        for name, value in numbers.items():
            if type(value) not in (int, float):
                raise TypeError(f'{name} must be a number (int or float)')
            if not math.isfinite(value):
                raise ValueError(f'{name} must be finite')
        if step_size <= 0:
            raise ValueError('step_size must be a positive number')
        if x0 == x1 and y0 == y1:
            raise ValueError('Line has zero length (All 4 points have same coordinates)')
        self.x0_, self.y0_, self.x1_, self.y1_ = x0, y0, x1, y1
        self.x_, self.y_ = x0, y0
        self.step_size_ = step_size
        self.valid_ = True
        if x0 != x1:
            self.m_ = (y1 - y0) / (x1 - x0)
            self.b_ = y1 - self.m_ * x1

    def isValid(self) -> bool:
        """Whether the end is not passed yet."""
        return self.valid_

    def advance(self) -> None:
        """Go to the next point. The one after the last is not valid."""
        if self.x0_ != self.x1_:
            self.valid_ = self.x_ != self.x1_
        else:
            self.valid_ = self.y_ != self.y1_
        if not self.valid_:
            return
        if self.x0_ != self.x1_:
            self.x_ = self._next(self.x_, self.x0_, self.x1_)
            self.y_ = round(self.m_ * self.x_ + self.b_, 5)
        else:
            self.y_ = self._next(self.y_, self.y0_, self.y1_)

    def _next(self, now: float, first: float, last: float) -> float:
        step = self.step_size_ if last > first else -self.step_size_
        following = self.clamp(now + step, min(first, last), max(first, last))
        if following in (now, last):
            return last
        rounded = round(following, 5)
        return following if rounded == now else rounded

    def getX(self) -> float:
        """Get x of the current point."""
        return self.x_

    def getY(self) -> float:
        """Get y of the current point."""
        return self.y_

    def getX0(self) -> float:
        """Get x of the first point."""
        return self.x0_

    def getY0(self) -> float:
        """Get y of the first point."""
        return self.y0_

    def getX1(self) -> float:
        """Get x of the last point."""
        return self.x1_

    def getY1(self) -> float:
        """Get y of the last point."""
        return self.y1_

    def get_line_length(self) -> float:
        """Get the distance of both ends."""
        return math.sqrt(pow(self.x1_ - self.x0_, 2) + pow(self.y1_ - self.y0_, 2))

    def clamp(self, n: float, min_n: float, max_n: float) -> float:
        """Get the number of a range that is nearest to n."""
        return max(min_n, min(n, max_n))
