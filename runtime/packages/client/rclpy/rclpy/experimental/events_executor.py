"""The executor that events wake. All of ours are: none looks at what nothing has happened to."""
from __future__ import annotations

from rclpy.executors import SingleThreadedExecutor


class EventsExecutor(SingleThreadedExecutor):
    """One callback after the other."""
