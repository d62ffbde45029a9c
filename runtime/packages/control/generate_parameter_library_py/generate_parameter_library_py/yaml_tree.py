"""
YAML as a tree whose values know their lines. The only module that knows PyYAML.

A file may be large, nested deeply, or refer to itself: all of these are refused before they cost time.
"""
from __future__ import annotations

import contextlib
import dataclasses
import os
from collections.abc import Iterator
from typing import Any

import yaml

from generate_parameter_library_py.errors import ParameterFileError

LARGEST = 1_000_000  # bytes; the largest file of ros2_controllers has 20,000
DEEPEST = 64
MOST_VALUES = 20_000  # with keys, and with those that aliases and merges repeat
LONGEST_NUMBER = 400  # characters; a double written without an exponent has up to 309 before the dot
MERGE = 'tag:yaml.org,2002:merge'
NUMBERS = ('tag:yaml.org,2002:int', 'tag:yaml.org,2002:float')
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
        self._spend(node, 1)
        with self._inside(node):
            return Value(self._content(node), node.start_mark.line + 1)

    def _spend(self, node: yaml.Node, values: int) -> None:
        self._count += values
        if self._count > MOST_VALUES:
            raise self.error(node, TOO_MANY, 'make several libraries')

    @contextlib.contextmanager
    def _inside(self, node: yaml.Node) -> Iterator[None]:
        if len(self._open) >= DEEPEST:
            raise self.error(node, f'values are nested more than {DEEPEST} deep')
        self._open.add(id(node))
        yield
        self._open.discard(id(node))

    def _content(self, node: yaml.Node) -> Any:
        if isinstance(node, yaml.MappingNode):
            return self._mapping(node)
        if isinstance(node, yaml.SequenceNode):
            return [self.value(one) for one in node.value]
        content = self._scalar(node)
        if content is None or isinstance(content, (bool, int, float, str)):
            return content
        return node.value  # a date, for one, is a text

    def _scalar(self, node: yaml.ScalarNode) -> Any:
        if node.tag in NUMBERS and len(node.value) > LONGEST_NUMBER:
            raise self.error(node, f'a number has more than {LONGEST_NUMBER} characters')
        try:
            content = self._loader.construct_object(node)
            str(content).encode()
        except UnicodeEncodeError:
            raise self.error(node, 'a text has half of a surrogate pair, which is not a character',
                             'write the character itself') from None
        except (ValueError, LookupError, AttributeError):  # the date 2024-13-45, `!!bool maybe`
            kind = node.tag.rpartition(':')[2]
            raise self.error(node, f'`{node.value}` cannot be read as {kind}', 'put texts in quotes') from None
        return content

    def _merged(self, node: yaml.Node) -> list[Any]:
        """The pairs that `<<` brings from a mapping, or from a list of mappings, of which the first counts most."""
        if isinstance(node, yaml.SequenceNode):
            with self._inside(node):
                return [pair for one in reversed(node.value) for pair in self._merged(one)]
        if not isinstance(node, yaml.MappingNode):
            raise self.error(node, '`<<` merges something that is not a mapping', 'name a mapping, or a list of them')
        if id(node) in self._open:
            return []
        with self._inside(node):
            pairs = self._pairs(node)
        self._spend(node, len(pairs))
        return pairs

    def _pairs(self, node: yaml.MappingNode) -> list[Any]:
        """Its keys and values behind those that it merges, over which they win."""
        merged = [pair for key, value in node.value if key.tag == MERGE for pair in self._merged(value)]
        return [*merged, *(pair for pair in node.value if pair[0].tag != MERGE)]

    def _mapping(self, node: yaml.MappingNode) -> Mapping:
        pairs = self._pairs(node)
        first_own = len(pairs) - sum(key.tag != MERGE for key, _ in node.value)
        own: set[str] = set()
        result = Mapping({}, {}, {})
        for place, (key, value) in enumerate(pairs):
            name = self._scalar(key) if isinstance(key, yaml.ScalarNode) else key
            if not isinstance(name, str):
                shown = f'`{key.value}`' if isinstance(key, yaml.ScalarNode) else 'a key'
                raise self.error(key, f'{shown} is not a text, which a name must be', 'put it in quotes')
            if name in own:
                result.repeated[name] = key.start_mark.line + 1
            if place >= first_own:
                own.add(name)
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
    except TooManyValues:
        raise ParameterFileError(path, 0, TOO_MANY, 'make several libraries') from None
    except RecursionError:
        raise ParameterFileError(path, 0, 'values are nested too deeply') from None
