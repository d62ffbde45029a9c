"""Values of launch files as texts with substitutions, `$(name 'argument')`, as the evaluator reads them."""
from __future__ import annotations

import json
import math
import pathlib
from collections.abc import Iterable, Mapping
from typing import Any

from launch.substitution import Substitution

_SPECIAL = str.maketrans({one: f'\\{one}' for one in '\\$\'"'})


def plain(text: str) -> str:
    """A text that stands for itself."""
    return text.translate(_SPECIAL)


def text_of(value: Any) -> str:
    """Of a text, a path, a substitution, or several to be put together."""
    if isinstance(value, str):
        return plain(value)
    if isinstance(value, pathlib.PurePath):
        return plain(str(value))
    if isinstance(value, Substitution):
        return value._text()
    if isinstance(value, Iterable):
        return ''.join(text_of(one) for one in value)
    raise TypeError(f'{value!r} is not text, no substitution and no list of these')


def call(name: str, *arguments: Any) -> str:
    return f'$({name}' + ''.join(f" '{text_of(one)}'" for one in arguments) + ')'


def is_text(value: Any) -> bool:
    """Whether text_of() takes it as one text: no list of more than these."""
    if isinstance(value, (str, Substitution, pathlib.PurePath)):
        return True
    return isinstance(value, (list, tuple)) and all(isinstance(one, (str, Substitution)) for one in value)


def flag(value: Any) -> Any:
    """Of what may be a boolean, a number or a text."""
    return value if isinstance(value, (bool, int, float)) else text_of(value)


def as_yaml_text(value: str) -> str:
    """A text that is read as YAML and stays the same text."""
    return plain(json.dumps(value, ensure_ascii=False))


def parameter_value(value: Any) -> Any:
    """An attribute: what is plain keeps its type, what is substituted gets one as YAML has it."""
    if isinstance(value, float) and not math.isfinite(value):
        return '.nan' if math.isnan(value) else '.inf' if value > 0 else '-.inf'
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, str):
        return as_yaml_text(value)
    if isinstance(value, Substitution):
        return text_of(value)
    if isinstance(value, (bytes, Mapping)) or not isinstance(value, Iterable):
        raise TypeError(f'{value!r} is not a value that a parameter can have')
    return _list_value(list(value))


def _list_value(items: list[Any]) -> Any:
    if any(isinstance(one, Substitution) for one in items) and is_text(items):
        return text_of(items)  # one text of parts
    result: list[Any] = []
    for one in items:
        if isinstance(one, str):
            result.append(as_yaml_text(one))
        elif isinstance(one, (bool, int, float)):
            result.append(parameter_value(one))
        else:
            result.append(text_of(one))
    if any(isinstance(one, str) for one in result):
        return [one if isinstance(one, str) else json.dumps(one) for one in result]
    return result
