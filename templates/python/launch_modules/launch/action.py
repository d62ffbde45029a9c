"""The base of actions."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ros2wasm_launch import host
from ros2wasm_launch.entities import Entity, entity

from .launch_description import LaunchDescriptionEntity


class Action(LaunchDescriptionEntity):
    """One with an `execute` of its own is asked what it comes to when the evaluator comes to it."""

    #: File and line where it was made.
    _place: dict[str, Any]

    def __init_subclass__(cls, **more: Any) -> None:
        super().__init_subclass__(**more)
        if '__init__' in cls.__dict__:
            setattr(cls, '__init__', host.noted_place(cls.__dict__['__init__']))

    @host.noted_place
    def __init__(self, *, condition: Any = None) -> None:
        self.condition = condition

    def execute(self, context: Any) -> Any:
        raise NotImplementedError(f'{type(self).__name__} has no execute()')

    def visit(self, context: Any) -> Any:
        return self.execute(context)

    def describe(self) -> str:
        return type(self).__name__

    def _conditions(self) -> dict[str, str]:
        return dict([self.condition._attribute()]) if self.condition is not None else {}

    def _entity(self, tag: str, attributes: dict[str, Any] | None = None, children: Iterable[Entity] = ()) -> Entity:
        return entity(tag, self._place, {**(attributes or {}), **self._conditions()}, children)

    def _part(self, tag: str, **attributes: Any) -> Entity:
        """A child that is not an action: in the same place."""
        return entity(tag, self._place, attributes)

    def _entities(self) -> list[Entity]:
        return [self._entity('python', {'call': host.OBJECTS.number(self.execute)})]
