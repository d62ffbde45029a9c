"""Parameters of nodes, and the parts of a node that they and remappings become."""
from __future__ import annotations

import pathlib
from collections.abc import Iterable, Mapping
from typing import Any

from launch.substitution import Substitution
from ros2wasm_launch.entities import Entity, entity
from ros2wasm_launch.texts import flag, parameter_value, plain, text_of

_TYPES = {str: 'str', int: 'int', float: 'float', bool: 'bool'}


def _type_of(value_type: Any) -> str | None:
    """`list_of_` when it is one; None: as YAML has it."""
    if value_type is None:
        return None
    of = getattr(value_type, '__args__', None)
    if of and of[0] in _TYPES:
        return 'list_of_' + _TYPES[of[0]]
    if value_type in _TYPES:
        return _TYPES[value_type]
    raise TypeError(f'{value_type!r} is not a type of parameters')


class ParameterValue:
    """A value with the type that it shall have."""

    def __init__(self, value: Any, *, value_type: Any = None) -> None:
        self.value, self.value_type = value, value_type
        self._type = _type_of(value_type)

    def _attributes(self) -> dict[str, Any]:
        value = self.value
        if isinstance(value, (list, tuple)) and self._type is not None and self._type.startswith('list_of_'):
            if not any(isinstance(one, Substitution) for one in value):
                items = [text_of(one) if not isinstance(one, (bool, int, float)) else str(one) for one in value]
                return {'value': items, 'type': self._type.removeprefix('list_of_')}
        if isinstance(value, str) and self._type is None:
            return {'value': parameter_value(value)}
        if isinstance(value, (str, Substitution)) or (isinstance(value, (list, tuple)) and any(
                isinstance(one, (str, Substitution)) for one in value)):
            return {'value': text_of(value), 'type': self._type}
        if self._type == 'str':
            return {'value': plain(str(value)), 'type': 'str'}
        return {'value': parameter_value(value), 'type': self._type}


class Parameter(ParameterValue):
    """One with its name."""

    def __init__(self, name: Any, value: Any, *, value_type: Any = None) -> None:
        super().__init__(value, value_type=value_type)
        self.name = name


class ParameterFile:
    def __init__(self, param_file: Any, *, allow_substs: Any = False) -> None:
        self.param_file, self.allow_substs = param_file, allow_substs


def parameter_parts(parameters: Any, place: Mapping[str, Any]) -> list[Entity]:
    """`param` entities of what a node was given."""
    if parameters is None:
        return []
    if isinstance(parameters, (str, Mapping)) or not isinstance(parameters, Iterable):
        raise TypeError(f'parameters are a list of files and dictionaries, found {parameters!r}')
    result: list[Entity] = []
    for one in parameters:
        if isinstance(one, Mapping):
            result += [_parameter(name, value, place) for name, value in one.items() if value != {}]
        elif isinstance(one, Parameter):
            result.append(entity('param', place, {'name': text_of(one.name), **one._attributes()}))
        elif isinstance(one, ParameterFile):
            result.append(entity('param', place, {'from': text_of(one.param_file),
                                                  'allow_substs': flag(one.allow_substs)}))
        elif isinstance(one, (str, Substitution, pathlib.PurePath, list, tuple)):
            result.append(entity('param', place, {'from': text_of(one)}))
        else:
            raise TypeError(f'{one!r} is neither a file of parameters nor a dictionary of them')
    return result


def _parameter(name: Any, value: Any, place: Mapping[str, Any]) -> Entity:
    named = {'name': text_of(name)}
    if isinstance(value, Mapping):
        inner = [_parameter(key, one, place) for key, one in value.items() if one != {}]
        return entity('param', place, named, inner)
    if isinstance(value, ParameterValue):
        return entity('param', place, {**named, **value._attributes()})
    return entity('param', place, {**named, 'value': parameter_value(value)})


def remap_parts(remappings: Any, place: Mapping[str, Any]) -> list[Entity]:
    return [entity('remap', place, {'from': text_of(old), 'to': text_of(new)}) for old, new in remappings or ()]
