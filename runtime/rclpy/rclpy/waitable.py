"""What an executor waits for beside messages and timers: events of endpoints, actions."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.callback_groups import CallbackGroup


class NumberOfEntities:
    """How many of each kind a waitable has."""

    __slots__ = [
        'num_subscriptions', 'num_guard_conditions', 'num_timers', 'num_clients', 'num_services', 'num_events',
    ]

    def __init__(
        self, num_subs: int = 0, num_gcs: int = 0, num_timers: int = 0, num_clients: int = 0, num_services: int = 0,
        num_events: int = 0
    ) -> None:
        self.num_subscriptions = num_subs
        self.num_guard_conditions = num_gcs
        self.num_timers = num_timers
        self.num_clients = num_clients
        self.num_services = num_services
        self.num_events = num_events

    def _sum(self, other: NumberOfEntities) -> list[int]:
        return [getattr(self, one) + getattr(other, one) for one in self.__slots__]

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        return NumberOfEntities(*self._sum(other))

    def __iadd__(self, other: NumberOfEntities) -> NumberOfEntities:
        for name, value in zip(self.__slots__, self._sum(other)):
            setattr(self, name, value)
        return self

    def __repr__(self) -> str:
        return f"<NumberOfEntities({', '.join(str(getattr(self, one)) for one in self.__slots__)})>"


class Waitable:
    """Several readers of the bus, or a condition, that the executor sees as one entity."""

    def __init__(self, callback_group: CallbackGroup) -> None:
        self.callback_group = callback_group
        self._destroyed = False
        self._executor_event = False
        self._futures: list[Any] = []

    def add_future(self, future: Any) -> None:
        self._futures.append(future)

    def remove_future(self, future: Any) -> None:
        self._futures.remove(future)

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
