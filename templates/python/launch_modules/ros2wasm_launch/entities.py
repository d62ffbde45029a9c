"""Entities: the actions of a launch file, as the evaluator reads them whatever language they were written in."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

Entity = dict[str, Any]


def entity(tag: str, place: Mapping[str, Any], attributes: Mapping[str, Any] | None = None,
           children: Iterable[Entity] = ()) -> Entity:
    """Attributes that are None are skipped."""
    given = {name: value for name, value in (attributes or {}).items() if value is not None}
    return {'tag': tag, **place, 'attributes': given, 'children': list(children)}


def entities_of(value: Any) -> list[Entity]:
    """Of an action, a description, or lists of them; None is none."""
    if value is None:
        return []
    if hasattr(value, '_entities'):
        result: list[Entity] = value._entities()
        return result
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return [one for part in value for one in entities_of(part)]
    raise TypeError(f'{value!r} is not an action of a launch file')
