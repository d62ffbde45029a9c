"""Helpers that launch files call."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .substitution import Substitution


def normalize_to_list_of_substitutions(subs: Any) -> list[Substitution]:
    from .substitutions import TextSubstitution

    if isinstance(subs, Substitution):
        return [subs]
    if isinstance(subs, str):
        return [TextSubstitution(text=subs)]
    return [part for one in subs for part in normalize_to_list_of_substitutions(one)]


def perform_substitutions(context: Any, subs: Iterable[Substitution]) -> str:
    return ''.join(context.perform_substitution(one) for one in subs)


def normalize_to_list_of_entities(entities: Any) -> list[Any]:
    if isinstance(entities, (list, tuple)):
        return [part for one in entities for part in normalize_to_list_of_entities(one)]
    return [entities]


def ensure_argument_type(argument: Any, types: Any, argument_name: str, caller: str | None = None) -> None:
    wanted = tuple(types) if isinstance(types, (list, tuple)) else (types,)
    if not isinstance(argument, wanted):
        names = ', '.join(one.__name__ for one in wanted)
        raise TypeError(f'{argument_name} of {caller or "the caller"} is of {names}, found {argument!r}')


def is_a(thing: Any, kind: type) -> bool:
    return isinstance(thing, kind)


def is_a_subclass(thing: Any, kind: type) -> bool:
    return isinstance(thing, type) and issubclass(thing, kind)
