"""Substitutions that stand for the path of a changed copy of a file, below /tmp, or for what a file says."""
from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping
from typing import Any

import yaml
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions
from ros2wasm_launch import host

_PARAMETERS = 'ros__parameters'


def _written(text: str) -> str:
    with tempfile.NamedTemporaryFile(mode='w', suffix='.yaml', delete=False) as file:
        file.write(text)
    return file.name


class _OfFile(Substitution):
    def __init__(self, source_file: Any) -> None:
        self._source = normalize_to_list_of_substitutions(source_file)

    @property
    def name(self) -> list[Substitution]:
        return self._source

    def describe(self) -> str:
        return ''

    def _path(self, context: Any) -> str:
        return perform_substitutions(context, self._source)

    def _yaml(self, context: Any) -> Any:
        with open(self._path(context), encoding='utf-8') as file:
            return yaml.safe_load(file)


def _performed(context: Any, pairs: Mapping[str, list[Substitution]]) -> dict[str, str]:
    return {key: perform_substitutions(context, value) for key, value in pairs.items()}


def _normalized(pairs: Mapping[str, Any] | None) -> dict[str, list[Substitution]]:
    return {key: normalize_to_list_of_substitutions(value) for key, value in (pairs or {}).items()}


def _leaves(value: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """The way to each value that holds no others."""
    if not isinstance(value, (dict, list)):
        yield path
        return
    for key in value if isinstance(value, dict) else range(len(value)):
        yield from _leaves(value[key], (*path, str(key)))


def _put(value: Any, path: list[str], new: Any) -> None:
    """What is missing on the way is made."""
    for key in path[:-1]:
        value = value[int(key)] if isinstance(value, list) else value.setdefault(key, {})
    value[int(path[-1]) if isinstance(value, list) else path[-1]] = new


class RewrittenYaml(_OfFile):
    """
    The file with other values and keys.

    `param_rewrites`: by a key, wherever it stands, or by the whole way to a value with `.` between keys; a way with
    `ros__parameters` in it that the file has not is added. `root_key`: below which all of the file then stands.
    """

    def __init__(self, source_file: Any, param_rewrites: Mapping[str, Any], root_key: Any = None,
                 key_rewrites: Mapping[str, Any] | None = None, convert_types: bool = False,
                 value_rewrites: Mapping[str, Any] | None = None) -> None:
        super().__init__(source_file)
        self._params, self._keys = _normalized(param_rewrites), _normalized(key_rewrites)
        self._values = _normalized(value_rewrites)
        self._root = None if root_key is None else normalize_to_list_of_substitutions(root_key)
        self._converts = convert_types

    def perform(self, context: Any) -> str:
        data = self._yaml(context)
        params = {key: self._converted(value) for key, value in _performed(context, self._params).items()}
        self._rewrite(data, params)
        ways = {'.'.join(path) for path in _leaves(data)}
        for way, value in params.items():
            keys = way.split('.')
            if way in ways or _PARAMETERS in keys:
                _put(data, keys, value)
        data = self._with_values(data, _performed(context, self._values))
        data = _with_keys(data, _performed(context, self._keys))
        root = perform_substitutions(context, self._root) if self._root is not None else ''
        return _written(yaml.dump({root: data} if root else data) or '')

    def _rewrite(self, data: Any, params: Mapping[str, Any]) -> None:
        if not isinstance(data, dict):
            return
        for key, value in data.items():
            self._rewrite(value, params)
            if key in params:
                data[key] = params[key]

    def _with_values(self, data: Any, values: Mapping[str, str]) -> Any:
        if isinstance(data, dict):
            return {key: self._with_values(value, values) for key, value in data.items()}
        if isinstance(data, list):
            return [self._with_values(value, values) for value in data]
        return self._converted(values[data]) if isinstance(data, str) and data in values else data

    def _converted(self, text: str) -> Any:
        if self._converts:
            try:
                return float(text) if '.' in text else int(text)
            except ValueError:
                pass
        return {'true': True, 'false': False}.get(text.lower(), text)


def _with_keys(data: Any, keys: Mapping[str, str]) -> Any:
    if not isinstance(data, dict):
        return data
    return {keys.get(key, key): _with_keys(value, keys) for key, value in data.items()}


class ReplaceString(_OfFile):
    """The file with other texts in its lines; the file itself when the condition does not hold."""

    def __init__(self, source_file: Any, replacements: Mapping[str, Any], condition: Any = None) -> None:
        super().__init__(source_file)
        self._replacements = _normalized(replacements)
        self.condition = condition

    def perform(self, context: Any) -> str:
        path = self._path(context)
        if self.condition is not None and not self.condition.evaluate(context):
            return path
        with open(path, encoding='utf-8') as file:
            text = file.read()
        for old, new in _performed(context, self._replacements).items():
            text = text.replace(old, new)
        return _written(text)


class HasNodeParams(_OfFile):
    """`True` or `False`: whether the file has something for a node of that name."""

    def __init__(self, source_file: Any, node_name: str) -> None:
        super().__init__(source_file)
        self._node = node_name

    def perform(self, context: Any) -> str:
        return str(self._node in self._yaml(context))


class ParseMultiRobotPose:
    """Robots and where they are, in an argument of the launch: `one={x: 1.0, y: 1.0, yaw: 0.0}; two={x: 2.0}`."""

    def __init__(self, target_argument: str) -> None:
        self._text = host.GIVEN.get(target_argument, '')

    def value(self) -> dict[str, dict[str, Any]]:
        """Name -> x, y, z, roll, pitch and yaw; 0 for what is not there. Parts without one `=` are passed over."""
        robots = {}
        for part in self._text.split(';'):
            name, *texts = part.strip().split('=')
            if len(texts) == 1:
                pose = yaml.safe_load(texts[0].strip())
                robots[name.strip()] = {key: 0.0 for key in ('x', 'y', 'z', 'roll', 'pitch', 'yaw')} | pose
        return robots
