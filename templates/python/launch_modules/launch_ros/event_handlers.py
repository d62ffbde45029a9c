"""What is done when a managed node changes its state."""
from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from launch.event_handlers import EventHandler, Followed
from ros2wasm_launch import host
from ros2wasm_launch.texts import text_of

from .events.lifecycle import MANAGED_NODES


class OnStateTransition(EventHandler):
    def __init__(self, *, entities: Any, target_lifecycle_node: Any = None, transition: str | None = None,
                 start_state: str | None = None, goal_state: str | None = None, handle_once: bool = False,
                 **_more: Any) -> None:
        super().__init__(entities=entities, handle_once=handle_once)
        self._target = target_lifecycle_node
        self._states = {'transition': transition, 'start_state': start_state, 'goal_state': goal_state}

    def _followed(self) -> Iterator[Followed]:
        states = {key: text_of(value) for key, value in self._states.items() if value is not None}
        for node in MANAGED_NODES if self._target is None else [self._target]:
            yield self._on('transition', None, process=host.OBJECTS.number(node), **states)
