"""Names that a module of ROS 2 has as it imports them, and that programs import from there: found when asked for."""
from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any


def names_of(module: str, places: dict[str, str]) -> Callable[[str], Any]:
    """
    What a module gives as its `__getattr__`.

    `places`: module -> names in it, between spaces; `there=here` for one that has another name.
    """
    found: dict[str, tuple[str, str]] = {}
    for place, names in places.items():
        for name in names.split():
            there, _, here = name.partition('=')
            found[here or there] = (place, there)

    def get(name: str) -> Any:
        if name not in found:
            raise AttributeError(f'module {module!r} has no attribute {name!r}')
        place, there = found[name]
        return getattr(importlib.import_module(place), there)
    return get
