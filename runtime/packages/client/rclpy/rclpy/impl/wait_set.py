"""What a user's own waitable waits for."""
from __future__ import annotations

from typing import Any

from ros2wasm import host


class WaitSet:
    """
    Stands for rcl's: a waitable adds what it waits for, and asks which of it is ready.

    Nothing waits on it: an executor looks at its waitables whenever something happened.
    """

    def __init__(self) -> None:
        self._added: dict[str, list[bool]] = {}
        self._readers: list[int] | None = None

    def _add(self, kind: str, ready: bool) -> int:
        of_kind = self._added.setdefault(kind, [])
        of_kind.append(ready)
        return len(of_kind) - 1

    def _reads(self, reader: Any) -> bool:
        """Whether a subscription, client or service has something."""
        if self._readers is None:
            self._readers = host.ready()
        return reader._endpoint.handle in self._readers

    def add_subscription(self, subscription: Any) -> int:
        return self._add('subscription', self._reads(subscription))

    def add_client(self, client: Any) -> int:
        return self._add('client', self._reads(client))

    def add_service(self, service: Any) -> int:
        return self._add('service', self._reads(service))

    def add_timer(self, timer: Any) -> int:
        return self._add('timer', timer.is_ready())

    def add_event(self, event: Any) -> int:
        return self._add('event', event._rw_ready())

    def add_guard_condition(self, guard: Any) -> int:
        # A trigger is seen once.
        triggered, guard._triggered = guard._triggered, False
        return self._add('guard_condition', triggered)

    def is_ready(self, entity_type: str, index: int) -> bool:
        return self._added[entity_type][index]
