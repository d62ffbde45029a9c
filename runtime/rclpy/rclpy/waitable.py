"""What an executor waits for beside messages and timers: events of endpoints, actions."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.callback_groups import CallbackGroup


class Waitable:
    """Several readers of the bus, or a condition, that the executor sees as one entity."""

    def __init__(self, callback_group: CallbackGroup) -> None:
        self.callback_group = callback_group
        self._destroyed = False
        self._executor_event = False

    def __enter__(self) -> Waitable:
        return self

    def __exit__(self, t: Any, v: Any, tb: Any) -> None:
        self.destroy()

    def _handles(self) -> list[int]:
        """Endpoints whose messages make it ready."""
        return []

    def _ready(self) -> bool:
        """Whether something else made it ready."""
        raise NotImplementedError('Must be implemented by subclass')

    def _take_call(self) -> Callable[[], Any] | None:
        """Take what is there; what remains is to call. None: nothing is."""
        raise NotImplementedError('Must be implemented by subclass')

    def destroy(self) -> None:
        self._destroyed = True
