"""Changes of managed nodes' states."""
from __future__ import annotations

from typing import Any

from launch.events import Event
from ros2wasm_launch import host


class MatchesName:
    def __init__(self, name: str) -> None:
        self.name = name

    def __call__(self, action: Any) -> bool:
        return getattr(action, 'node_name', None) == self.name


def matches_node_name(node_name: str) -> MatchesName:
    return MatchesName(node_name)


class ChangeState(Event):
    def __init__(self, *, lifecycle_node_matcher: Any, transition_id: int) -> None:
        self.lifecycle_node_matcher, self.transition_id = lifecycle_node_matcher, transition_id

    def _transition(self) -> dict[str, Any]:
        target = getattr(self.lifecycle_node_matcher, 'action', None)
        if target is not None:
            return {'process': host.OBJECTS.number(target), 'transition': self.transition_id}
        return {'name': getattr(self.lifecycle_node_matcher, 'name', ''), 'transition': self.transition_id}


class StateTransition(Event):
    """Told by a node; a launch file only names it."""
