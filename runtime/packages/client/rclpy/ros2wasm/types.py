"""All message, service and action types of the site, made as they are asked for, from the definitions in share/."""
from __future__ import annotations

import os
from functools import lru_cache
from typing import Any

from ros2wasm.codec import Codec
from ros2wasm.definition import Structure, definition_of, parse_file
from ros2wasm.message_class import CHECKED, make_class
from ros2wasm.type_description import full_description, rihs01

KINDS = ('msg', 'srv', 'action')


def prefixes() -> list[str]:
    return [one for one in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if one]


def folder_of(package: str, kind: str) -> str | None:
    """Where a package's definitions of a kind are."""
    for prefix in prefixes():
        folder = f'{prefix}/share/{package}/{kind}'
        if os.path.isdir(folder):
            return folder
    return None


def names_in(package: str, kind: str) -> list[str]:
    folder = folder_of(package, kind)
    end = f'.{kind}'
    return [] if folder is None else sorted(one[:-len(end)] for one in os.listdir(folder) if one.endswith(end))


def source_of(name: str) -> str:
    """The text of the file that defines a type. KeyError: there is none."""
    package, kind, short = definition_of(name).split('/')
    folder = folder_of(package, kind)
    try:
        with open(f'{folder}/{short}.{kind}', encoding='utf-8') as file:
            return file.read()
    except OSError as error:
        raise KeyError(name) from error


def names_of(name: str) -> list[str]:
    """All that the file of a type defines."""
    return [one.name for one in parse_file(name, source_of(name))]


_structures: dict[str, Structure] = {}


def find_structure(name: str) -> Structure:
    """A message, service or action by its full name. KeyError: nothing defines it."""
    if name not in _structures:
        for one in parse_file(definition_of(name), source_of(name)):
            _structures[one.name] = one
    return _structures[name]


@lru_cache(maxsize=None)
def find_message(name: str) -> Any:
    """The class of a message."""
    package, kind, short = name.split('/')
    module = f'{package}.{kind}._{snake(definition_of(name).split("/")[-1])}'
    cls = make_class(find_structure(name), module, short, find_message)
    cls._codec = Codec(cls, cls._structure, codec_of, CHECKED)
    return cls


def codec_of(name: str) -> Codec:
    codec: Codec = find_message(name)._codec
    return codec


@lru_cache(maxsize=None)
def type_hash(name: str) -> str:
    return rihs01(full_description(name, find_structure))


class LazyParts(type):
    """Metaclass of services and actions: their messages are made when they are asked for."""

    _parts: dict[str, str]

    def __getattr__(cls, name: str) -> Any:
        full = cls.__dict__.get('_parts', {}).get(name)
        if full is None:
            raise AttributeError(f"type object '{cls.__name__}' has no attribute '{name}'")
        value = find_service(full) if name.endswith('Service') else find_message(full)
        setattr(cls, name, value)
        return value


@lru_cache(maxsize=None)
def find_service(name: str) -> Any:
    find_structure(name)
    package, kind, short = name.split('/')
    module = f'{package}.{kind}._{snake(definition_of(name).split("/")[-1])}'
    parts = {part: f'{name}_{part}' for part in ('Request', 'Response', 'Event')}
    return LazyParts(short, (), {'__module__': module, '_parts': parts, '_type_name': name})


@lru_cache(maxsize=None)
def find_action(name: str) -> Any:
    find_structure(name)
    package, _, short = name.split('/')
    module = f'{package}.action._{snake(short)}'
    parts = {part: f'{name}_{part}' for part in ('Goal', 'Result', 'Feedback')}
    impl = LazyParts('Impl', (), {'__module__': module, '_parts': {
        'SendGoalService': f'{name}_SendGoal', 'GetResultService': f'{name}_GetResult',
        'FeedbackMessage': f'{name}_FeedbackMessage'}})
    setattr(impl, 'CancelGoalService', find_service('action_msgs/srv/CancelGoal'))
    setattr(impl, 'GoalStatusMessage', find_message('action_msgs/msg/GoalStatusArray'))
    return LazyParts(short, (), {'__module__': module, '_parts': parts, '_type_name': name, 'Impl': impl})


def find_interface(name: str) -> Any:
    """The class of pkg/msg/X, pkg/srv/X (also X_Request and the like) or pkg/action/X. KeyError: there is none."""
    kind = name.split('/')[1]
    whole = definition_of(name) == name
    if kind == 'srv' and whole:
        return find_service(name)
    if kind == 'action' and (whole or name.endswith(('_SendGoal', '_GetResult'))):
        return find_action(name) if whole else find_service(name)
    return find_message(name)


def snake(name: str) -> str:
    """CamelCase as rosidl turns it into the name of a file."""
    text = ''
    for i, char in enumerate(name):
        before = name[i - 1] if i else ''
        after = name[i + 1:i + 2]
        if char.isupper() and before and (not before.isupper() or after.islower()):
            text += '_'
        text += char.lower()
    return text


def type_name(interface: Any) -> str:
    """Full name of a class that this module made. AttributeError for other classes."""
    structure = getattr(interface, '_structure', None)
    return str(structure.name if structure is not None else interface._type_name)
