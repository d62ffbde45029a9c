"""What an executor waits for beside messages and timers: events of endpoints, actions, what users make themselves."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.impl.wait_set import WaitSet
from rclpy.task import Future


class NumberOfEntities:
    """How many of each kind a waitable waits for."""

    __slots__ = (
        'num_subscriptions', 'num_guard_conditions', 'num_timers', 'num_clients', 'num_services', 'num_events')

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

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        return NumberOfEntities(*(getattr(self, name) + getattr(other, name) for name in self.__slots__))

    def __iadd__(self, other: NumberOfEntities) -> NumberOfEntities:
        for name in self.__slots__:
            setattr(self, name, getattr(self, name) + getattr(other, name))
        return self

    def __repr__(self) -> str:
        counts = ', '.join(str(getattr(self, name)) for name in self.__slots__)
        return f'{type(self).__name__}({counts})'


class Waitable:
    """
    Several readers of the bus, or a condition, that the executor sees as one entity.

    Those of users say by add_to_wait_set and is_ready when they are ready, and by take_data and execute what is done.
    """

    def __init__(self, callback_group: CallbackGroup) -> None:
        self.callback_group = callback_group
        self._destroyed = False
        self._executor_event = False
        self._futures: list[Future] = []
        #: It was ready, and its data has not been taken since.
        self._rw_due = False

    def __enter__(self) -> Waitable:
        return self

    def __exit__(self, t: Any, v: Any, tb: Any) -> None:
        self.destroy()

    def add_future(self, future: Future) -> None:
        self._futures.append(future)

    def remove_future(self, future: Future) -> None:
        self._futures.remove(future)

    def is_ready(self, wait_set: WaitSet) -> bool:
        raise NotImplementedError('Must be implemented by subclass')

    def take_data(self) -> Any:
        raise NotImplementedError('Must be implemented by subclass')

    async def execute(self, taken_data: Any) -> None:
        raise NotImplementedError('Must be implemented by subclass')

    def get_num_entities(self) -> NumberOfEntities:
        raise NotImplementedError('Must be implemented by subclass')

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        raise NotImplementedError('Must be implemented by subclass')

    def _rw_handles(self) -> list[int]:
        """Endpoints whose messages make it ready."""
        return []

    def _rw_ready(self) -> bool:
        """Whether something else made it ready."""
        if not self._rw_due:
            wait_set = WaitSet()
            self.add_to_wait_set(wait_set)
            self._rw_due = bool(self.is_ready(wait_set))
        return self._rw_due

    def _rw_take_call(self) -> Callable[[], Any] | None:
        """Take what is there; what remains is to call. None: nothing is."""
        self._rw_due = False
        return partial(self.execute, self.take_data())

    def destroy(self) -> None:
        self._destroyed = True
