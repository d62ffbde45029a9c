"""
YAML as a tree whose values know their lines. The only module that knows PyYAML.

A file may be large, nested deeply, or refer to itself: all of these are refused before they cost time.
"""
from __future__ import annotations

import dataclasses
import os
from typing import Any

import yaml

from generate_parameter_library_py.errors import ParameterFileError

LARGEST = 1_000_000  # bytes; the largest file of ros2_controllers has 20,000
DEEPEST = 64
MOST_VALUES = 20_000  # with keys, and with those that aliases repeat
TOO_MANY = f'the file has more than {MOST_VALUES} values'


@dataclasses.dataclass(frozen=True)
class Value:
    """A value of a file: None, bool, int, float, str, a list of Values, or a Mapping."""

    content: Any
    line: int

    def plain(self) -> Any:
        """As Python has it: lists of plain values; no mappings."""
        return [one.plain() for one in self.content] if isinstance(self.content, list) else self.content


@dataclasses.dataclass(frozen=True)
class Mapping:
    """Keys as they are written, with their lines. Of a key that comes twice, `members` has the last."""

    members: dict[str, Value]
    lines: dict[str, int]
    repeated: dict[str, int]


class TooManyValues(Exception):
    pass


class Loader(yaml.SafeLoader):  # type: ignore[misc]
    """Stops at a file of too many values before it has read all of it."""

    count = 0

    def compose_node(self, parent: yaml.Node, index: Any) -> Any:
        self.count += 1
        if self.count > MOST_VALUES:
            raise TooManyValues
        return super().compose_node(parent, index)


class Reader:
    def __init__(self, file: str, loader: Loader) -> None:
        self._file = file
        self._loader = loader
        self._open: set[int] = set()  # nodes that are being read
        self._count = 0

    def error(self, node: yaml.Node, what: str, *ways_out: str) -> ParameterFileError:
        return ParameterFileError(self._file, node.start_mark.line + 1, what, *ways_out)

    def value(self, node: yaml.Node) -> Value:
        if id(node) in self._open:
            raise self.error(node, 'the value contains itself, by an alias', 'write the value out')
        self._count += 1
        if self._count > MOST_VALUES or len(self._open) >= DEEPEST:
            raise self.error(
                node, TOO_MANY if self._count > MOST_VALUES else f'more than {DEEPEST} groups in one another')
        self._open.add(id(node))
        result = Value(self._content(node), node.start_mark.line + 1)
        self._open.discard(id(node))
        return result

    def _content(self, node: yaml.Node) -> Any:
        if isinstance(node, yaml.MappingNode):
            return self._mapping(node)
        if isinstance(node, yaml.SequenceNode):
            return [self.value(one) for one in node.value]
        content = self._loader.construct_object(node)
        if content is None or isinstance(content, (bool, int, float, str)):
            return content
        return node.value  # a date, for one, is a text

    def _mapping(self, node: yaml.MappingNode) -> Mapping:
        self._loader.flatten_mapping(node)
        result = Mapping({}, {}, {})
        for key, value in node.value:
            name = self._loader.construct_object(key) if isinstance(key, yaml.ScalarNode) else key
            if not isinstance(name, str):
                shown = f'`{key.value}`' if isinstance(key, yaml.ScalarNode) else 'a key'
                raise self.error(key, f'{shown} is not a text, which a name must be', 'put it in quotes')
            if name in result.members:
                result.repeated[name] = key.start_mark.line + 1
            result.members[name] = self.value(value)
            result.lines[name] = key.start_mark.line + 1
        return result


def read_text(path: str, shown: str) -> str:
    try:
        if os.path.getsize(path) > LARGEST:
            raise ParameterFileError(shown, 0, f'the file has more than {LARGEST} bytes', 'make several libraries')
        with open(path, encoding='utf-8') as stream:
            return stream.read()
    except UnicodeDecodeError as error:
        raise ParameterFileError(shown, 0, f'byte {error.start} is not UTF-8', 'save the file as UTF-8') from None
    except OSError as error:
        raise ParameterFileError(shown, 0, f'cannot be read: {error.strerror}') from None


def read_yaml(path: str) -> Value:
    """The first document of a file. Raises ParameterFileError."""
    text = read_text(path, path)
    try:
        loader = Loader(text)
        node = loader.get_node() if loader.check_node() else None
        if node is None:
            raise ParameterFileError(path, 0, 'the file is empty', 'name the parameters, below one namespace')
        return Reader(path, loader).value(node)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        raise ParameterFileError(path, mark.line + 1 if mark else 0, f'not YAML: {error.problem}') from None
    except yaml.YAMLError as error:
        raise ParameterFileError(path, 0, f'not YAML: {error}') from None
    except ValueError as error:  # e.g. the date 2024-13-45
        raise ParameterFileError(path, 0, f'not YAML: {error}', 'put texts in quotes') from None
    except TooManyValues:
        raise ParameterFileError(path, 0, TOO_MANY, 'make several libraries') from None
    except RecursionError:
        raise ParameterFileError(path, 0, 'values are nested too deeply') from None
