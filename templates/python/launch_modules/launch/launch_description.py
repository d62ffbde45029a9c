"""The list of actions that a launch file gives back."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ros2wasm_launch.entities import Entity, entities_of


class LaunchDescriptionEntity:
    """What can stand in a description."""

    def _entities(self) -> list[Entity]:
        raise NotImplementedError(f'{type(self).__name__} cannot stand in a launch description')


class LaunchDescription(LaunchDescriptionEntity):
    def __init__(self, initial_entities: Iterable[Any] | None = None, *, deprecated_reason: str | None = None) -> None:
        self._held = list(initial_entities or ())
        self.deprecated_reason = deprecated_reason

    @property
    def entities(self) -> list[Any]:
        return self._held

    @property
    def deprecated(self) -> bool:
        return self.deprecated_reason is not None

    def add_entity(self, entity: Any) -> None:
        self._held.append(entity)

    def add_action(self, action: Any) -> None:
        self._held.append(action)

    def get_launch_arguments(self, conditional_inclusion: bool = False) -> list[Any]:
        """The declared arguments of this description itself."""
        from .actions import DeclareLaunchArgument

        return [one for one in self._held if isinstance(one, DeclareLaunchArgument)]

    def _entities(self) -> list[Entity]:
        return entities_of(self._held)


def __getattr__(name: str) -> Any:
    """Upstream's module imports this action, and so users find it here."""
    if name == 'DeclareLaunchArgument':
        from .actions import DeclareLaunchArgument

        return DeclareLaunchArgument
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
