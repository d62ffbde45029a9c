"""What is done when a managed node changes its state."""
from __future__ import annotations

from typing import Any

from launch.event_handlers import EventHandler
from ros2wasm_launch.texts import text_of


class OnStateTransition(EventHandler):
    _event = 'transition'

    def __init__(self, *, entities: Any, target_lifecycle_node: Any = None, transition: str | None = None,
                 start_state: str | None = None, goal_state: str | None = None, handle_once: bool = False,
                 **_more: Any) -> None:
        super().__init__(entities=entities, handle_once=handle_once)
        self._target = target_lifecycle_node
        self._states = {'transition': transition, 'start_state': start_state, 'goal_state': goal_state}

    def _attributes(self) -> dict[str, Any]:
        states = {key: text_of(value) for key, value in self._states.items() if value is not None}
        return {**super()._attributes(), **states}
