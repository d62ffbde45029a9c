"""Reads .msg, .srv and .action files, and derives the messages that services and actions are made of.

Pure: text in, structures out. What a name stands for is asked of the caller.
"""
from __future__ import annotations

import ast
import re
from dataclasses import dataclass, field
from typing import Any

#: As written in a definition -> as rosidl calls it.
PRIMITIVES = {
    'bool': 'boolean', 'byte': 'octet', 'char': 'uint8', 'float32': 'float', 'float64': 'double',
    'int8': 'int8', 'uint8': 'uint8', 'int16': 'int16', 'uint16': 'uint16', 'int32': 'int32', 'uint32': 'uint32',
    'int64': 'int64', 'uint64': 'uint64', 'string': 'string', 'wstring': 'wstring',
}
INTEGERS = {'octet', 'int8', 'uint8', 'int16', 'uint16', 'int32', 'uint32', 'int64', 'uint64'}
TYPE = re.compile(r'(?P<base>[A-Za-z0-9_/]+)(?:<=(?P<bound>\d+))?(?P<array>\[(?P<limit><=)?(?P<size>\d+)?\])?$')
CONSTANT = re.compile(r'(?P<type>\S+)\s+(?P<name>[A-Z][A-Z0-9_]*)\s*=\s*(?P<value>.*)$')
FIELD = re.compile(r'(?P<type>\S+)\s+(?P<name>[a-z][a-z0-9_]*)(?:\s+(?P<value>\S.*))?$')


class DefinitionError(ValueError):
    """A definition that cannot be read."""


@dataclass(frozen=True)
class FieldType:
    """The type of one field. `container`: '', 'array', 'bounded' or 'sequence'."""

    base: str
    container: str = ''
    size: int = 0
    string_bound: int = 0

    @property
    def is_message(self) -> bool:
        return '/' in self.base


@dataclass(frozen=True)
class Field:
    name: str
    type: FieldType
    #: A Python value; None when the definition has no default.
    default: Any = None


@dataclass(frozen=True)
class Structure:
    """A message. `name`: such as std_msgs/msg/String or pkg/srv/X_Request."""

    name: str
    fields: tuple[Field, ...] = ()
    constants: dict[str, Any] = field(default_factory=dict)


def parse_type(text: str, package: str) -> FieldType:
    match = TYPE.match(text)
    if match is None:
        raise DefinitionError(f'not a type: {text}')
    base = match['base']
    if base in PRIMITIVES:
        base = PRIMITIVES[base]
    elif '/' in base:
        parts = base.split('/')
        base = f'{parts[0]}/msg/{parts[-1]}'
    else:
        base = f'{package}/msg/{base}'
    bound = int(match['bound'] or 0)
    if match['array'] is None:
        return FieldType(base, string_bound=bound)
    size = int(match['size'] or 0)
    container = 'bounded' if match['limit'] else 'array' if size else 'sequence'
    return FieldType(base, container, size, bound)


def parse_text(text: str) -> str:
    text = text.strip()
    for quote in ('"', "'"):
        if text.startswith(quote):
            if len(text) < 2 or not text.endswith(quote):
                return text
            return text[1:-1].replace('\\' + quote, quote)
    return text


def parse_single(base: str, text: str) -> Any:
    if base in ('string', 'wstring'):
        return parse_text(text)
    text = text.strip()
    if base == 'boolean':
        if text.lower() in ('true', '1'):
            return True
        if text.lower() in ('false', '0'):
            return False
        raise DefinitionError(f'not a bool: {text}')
    if base in ('float', 'double'):
        return float(text)
    if base not in INTEGERS:
        raise DefinitionError(f'{base} cannot have a value')
    value = int(text, 0) if re.match(r'[+-]?0[xXbBoO]', text) else int(text)
    return bytes([value]) if base == 'octet' else value


def parse_list(base: str, text: str) -> list[Any]:
    inner = text.strip()
    if not inner.startswith('[') or not inner.endswith(']'):
        raise DefinitionError(f'not a list: {text}')
    if base in ('string', 'wstring'):
        parsed = ast.literal_eval(inner)
        return [str(one) for one in parsed]
    return [parse_single(base, one) for one in inner[1:-1].split(',') if one.strip()]


def parse_value(type_: FieldType, text: str) -> Any:
    return parse_list(type_.base, text) if type_.container else parse_single(type_.base, text)


def parse_structure(name: str, lines: list[str]) -> Structure:
    """Read one section of a definition."""
    package = name.split('/')[0]
    fields: list[Field] = []
    constants: dict[str, Any] = {}
    for line in lines:
        line = line.partition('#')[0].strip()
        if not line:
            continue
        match = CONSTANT.match(line)
        if match is not None and not match['type'].endswith('<'):
            constants[match['name']] = parse_single(parse_type(match['type'], package).base, match['value'])
            continue
        match = FIELD.match(line)
        if match is None:
            raise DefinitionError(f'{name}: not a definition: {line}')
        type_ = parse_type(match['type'], package)
        value = match['value']
        fields.append(Field(match['name'], type_, None if value is None else parse_value(type_, value)))
    return Structure(name, tuple(fields), constants)


def _sections(text: str, name: str, count: int) -> list[list[str]]:
    sections: list[list[str]] = [[]]
    for line in text.splitlines():
        if line.strip() == '---':
            sections.append([])
        else:
            sections[-1].append(line)
    if len(sections) != count:
        raise DefinitionError(f'{name}: {len(sections)} sections where {count} are wanted')
    return sections


def _nested(name: str, base: str, container: str = '', size: int = 0) -> Field:
    return Field(name, FieldType(base, container, size))


def _service(name: str, request: Structure, response: Structure) -> list[Structure]:
    event = Structure(f'{name}_Event', (
        _nested('info', 'service_msgs/msg/ServiceEventInfo'),
        _nested('request', request.name, 'bounded', 1),
        _nested('response', response.name, 'bounded', 1)))
    whole = Structure(name, (
        _nested('request_message', request.name), _nested('response_message', response.name),
        _nested('event_message', event.name)))
    return [whole, request, response, event]


def parse_service(name: str, text: str) -> list[Structure]:
    """Return the service, its request, its response and its event message."""
    request, response = _sections(text, name, 2)
    return _service(
        name, parse_structure(f'{name}_Request', request), parse_structure(f'{name}_Response', response))


def parse_action(name: str, text: str) -> list[Structure]:
    """Return the action, its goal, result and feedback, and all that is derived of them."""
    parts = [parse_structure(f'{name}_{part}', lines)
             for part, lines in zip(('Goal', 'Result', 'Feedback'), _sections(text, name, 3))]
    goal_id = _nested('goal_id', 'unique_identifier_msgs/msg/UUID')
    stamp = _nested('stamp', 'builtin_interfaces/msg/Time')
    send, get = f'{name}_SendGoal', f'{name}_GetResult'
    whole = Structure(name, (
        _nested('goal', f'{name}_Goal'), _nested('result', f'{name}_Result'), _nested('feedback', f'{name}_Feedback'),
        _nested('send_goal_service', send), _nested('get_result_service', get),
        _nested('feedback_message', f'{name}_FeedbackMessage')))
    return [
        whole,
        *parts,
        *_service(
            send, Structure(f'{send}_Request', (goal_id, _nested('goal', f'{name}_Goal'))),
            Structure(f'{send}_Response', (Field('accepted', FieldType('boolean')), stamp))),
        *_service(
            get, Structure(f'{get}_Request', (goal_id,)),
            Structure(f'{get}_Response', (Field('status', FieldType('int8')), _nested('result', f'{name}_Result')))),
        Structure(f'{name}_FeedbackMessage', (goal_id, _nested('feedback', f'{name}_Feedback'))),
    ]


def parse_file(name: str, text: str) -> list[Structure]:
    """Read the definition of pkg/msg/X, pkg/srv/X or pkg/action/X."""
    kind = name.split('/')[1]
    if kind == 'srv':
        return parse_service(name, text)
    if kind == 'action':
        return parse_action(name, text)
    return [parse_structure(name, text.splitlines())]


def definition_of(name: str) -> str:
    """Return the name of the file's interface that a derived message comes from."""
    package, kind, short = name.split('/')
    if kind == 'msg':
        return name
    for end in ('_SendGoal_Request', '_SendGoal_Response', '_SendGoal_Event', '_GetResult_Request',
                '_GetResult_Response', '_GetResult_Event', '_FeedbackMessage', '_Goal', '_Result', '_Feedback',
                '_SendGoal', '_GetResult', '_Request', '_Response', '_Event'):
        if short.endswith(end):
            return f'{package}/{kind}/{short[:-len(end)]}'
    return name
