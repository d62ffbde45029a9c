"""Changes of managed nodes' states."""
from __future__ import annotations

from typing import Any

from launch.events import Event
from ros2wasm_launch import host
from ros2wasm_launch.texts import text_of

#: Those that the launch files have made.
MANAGED_NODES: list[Any] = []


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

    def _transition(self) -> list[dict[str, Any]]:
        """Of each node that is meant, its attributes."""
        ids, matcher = [self.transition_id], self.lifecycle_node_matcher
        name = getattr(matcher, 'name', None)
        if name is not None:
            return [{'lifecycle_node_names': [text_of(name)], 'transition_ids': ids}]
        target = getattr(matcher, 'action', None)
        meant = [target] if target is not None else [one for one in MANAGED_NODES if matcher(one)]
        return [{'process': host.OBJECTS.number(one), 'transition_ids': ids} for one in meant]


class StateTransition(Event):
    """Told by a node; a launch file only names it."""
