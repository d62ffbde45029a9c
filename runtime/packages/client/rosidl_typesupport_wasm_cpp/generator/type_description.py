"""Type descriptions and their RIHS01 hashes, as REP 2011 and ROS 2 Jazzy define them.

A description is plain data: {'type_name': str, 'fields': [{'name', 'type', 'default_value'}]}.
The order of keys matters, because the hash is taken of the JSON text.
"""

import hashlib
import json
from typing import Any, Dict, Iterable, List

from rosidl_parser import definition as idl

Description = Dict[str, Any]

NESTED_TYPE = 1
STRING = 17
WSTRING = 18
BOUNDED_STRING = 21
BOUNDED_WSTRING = 22
# The number of a container is added to the number of its element.
ARRAY = 48
BOUNDED_SEQUENCE = 96
UNBOUNDED_SEQUENCE = 144

# Numbers of type_description_interfaces/msg/FieldType.
BASIC_TYPES = {
    'int8': 2, 'uint8': 3, 'int16': 4, 'uint16': 5, 'int32': 6, 'uint32': 7, 'int64': 8,
    'uint64': 9, 'float': 10, 'double': 11, 'long double': 12, 'char': 13, 'wchar': 14,
    'boolean': 15, 'octet': 16,
}


def field_type(type_: idl.AbstractType) -> Dict[str, Any]:
    """Describe the type of one field."""
    container, capacity, element = 0, 0, type_
    if isinstance(type_, idl.AbstractNestedType):
        element = type_.value_type
        if isinstance(type_, idl.Array):
            container, capacity = ARRAY, type_.size
        elif isinstance(type_, idl.BoundedSequence):
            container, capacity = BOUNDED_SEQUENCE, type_.maximum_size
        else:
            container = UNBOUNDED_SEQUENCE
    string_capacity, nested = 0, ''
    if isinstance(element, idl.BasicType):
        if element.typename not in BASIC_TYPES:
            raise ValueError(f"type '{element.typename}' has no ROS interface equivalent")
        number = BASIC_TYPES[element.typename]
    elif isinstance(element, idl.BoundedString):
        number, string_capacity = BOUNDED_STRING, element.maximum_size
    elif isinstance(element, idl.BoundedWString):
        number, string_capacity = BOUNDED_WSTRING, element.maximum_size
    elif isinstance(element, idl.AbstractString):
        number = STRING
    elif isinstance(element, idl.AbstractWString):
        number = WSTRING
    elif isinstance(element, idl.NamespacedType):
        number, nested = NESTED_TYPE, '/'.join(element.namespaced_name())
    else:
        raise ValueError(f'unsupported type {element}')
    return {
        'type_id': number + container,
        'capacity': capacity,
        'string_capacity': string_capacity,
        'nested_type_name': nested,
    }


def _describe(name: str, members: Iterable[idl.Member]) -> Description:
    fields = []
    for member in members:
        default = ''
        if member.has_annotation('default'):
            default = str(member.get_annotation_value('default')['value'])
        fields.append(
            {'name': member.name, 'type': field_type(member.type), 'default_value': default})
    return {'type_name': name, 'fields': fields}


def _nested_field(name: str, type_name: str, type_id: int = NESTED_TYPE,
                  capacity: int = 0) -> Dict[str, Any]:
    return {
        'name': name,
        'type': {'type_id': type_id, 'capacity': capacity, 'string_capacity': 0,
                 'nested_type_name': type_name},
        'default_value': '',
    }


def describe_message(message: idl.Message) -> List[Description]:
    """Describe one message."""
    name = '/'.join(message.structure.namespaced_type.namespaced_name())
    return [_describe(name, message.structure.members)]


def describe_service(service: idl.Service) -> List[Description]:
    """Describe a service, its request and response, and the event message Jazzy adds to it."""
    name = '/'.join(service.namespaced_type.namespaced_name())
    parts = [name + '_Request', name + '_Response', name + '_Event']
    fields = ['request_message', 'response_message', 'event_message']
    event = {'type_name': parts[2], 'fields': [
        _nested_field('info', 'service_msgs/msg/ServiceEventInfo'),
        _nested_field('request', parts[0], NESTED_TYPE + BOUNDED_SEQUENCE, 1),
        _nested_field('response', parts[1], NESTED_TYPE + BOUNDED_SEQUENCE, 1),
    ]}
    return [
        {'type_name': name, 'fields': [_nested_field(f, p) for f, p in zip(fields, parts)]},
        *describe_message(service.request_message),
        *describe_message(service.response_message),
        event,
    ]


def describe_action(action: idl.Action) -> List[Description]:
    """Describe an action with the messages and services derived from it."""
    name = '/'.join(action.namespaced_type.namespaced_name())
    fields = {
        'goal': '_Goal', 'result': '_Result', 'feedback': '_Feedback',
        'send_goal_service': '_SendGoal', 'get_result_service': '_GetResult',
        'feedback_message': '_FeedbackMessage',
    }
    return [
        {'type_name': name,
         'fields': [_nested_field(field, name + end) for field, end in fields.items()]},
        *describe_message(action.goal),
        *describe_message(action.result),
        *describe_message(action.feedback),
        *describe_service(action.send_goal_service),
        *describe_service(action.get_result_service),
        *describe_message(action.feedback_message),
    ]


def _service_event_info() -> List[Description]:
    """Describe what every service event carries, so that packages need not name service_msgs."""
    uint8, int32, uint32, int64 = (BASIC_TYPES[t] for t in ('uint8', 'int32', 'uint32', 'int64'))

    def plain(name: str, type_id: int, capacity: int = 0) -> Dict[str, Any]:
        return _nested_field(name, '', type_id, capacity)

    return [
        {'type_name': 'service_msgs/msg/ServiceEventInfo', 'fields': [
            plain('event_type', uint8),
            _nested_field('stamp', 'builtin_interfaces/msg/Time'),
            plain('client_gid', uint8 + ARRAY, 16),
            plain('sequence_number', int64),
        ]},
        {'type_name': 'builtin_interfaces/msg/Time',
         'fields': [plain('sec', int32), plain('nanosec', uint32)]},
    ]


class TypeTable:
    """All descriptions in reach, by name."""

    def __init__(self) -> None:
        self._by_name: Dict[str, Description] = {d['type_name']: d for d in _service_event_info()}

    def add(self, descriptions: Iterable[Description]) -> None:
        for description in descriptions:
            self._by_name[description['type_name']] = description

    def __contains__(self, name: str) -> bool:
        return name in self._by_name

    def __getitem__(self, name: str) -> Description:
        return self._by_name[name]

    def full(self, name: str) -> Dict[str, Any]:
        """Return a description with all that it refers to, sorted by name."""
        found: Dict[str, Description] = {}
        queue = [name]
        while queue:
            for field in self._by_name[queue.pop()]['fields']:
                nested = field['type']['nested_type_name']
                if nested and nested not in found:
                    if nested not in self._by_name:
                        raise ValueError(f"type '{nested}', used by '{name}', is not known")
                    found[nested] = self._by_name[nested]
                    queue.append(nested)
        return {
            'type_description': self._by_name[name],
            'referenced_type_descriptions': [found[n] for n in sorted(found)],
        }

    def hash(self, name: str) -> str:
        """Return the RIHS01 hash of a type."""
        return rihs01(self.full(name))

    def to_json(self, name: str) -> str:
        """Return the file that Jazzy installs beside an interface."""
        full = self.full(name)
        names = [name] + [d['type_name'] for d in full['referenced_type_descriptions']]
        hashes = [{'type_name': n, 'hash_string': self.hash(n)} for n in names]
        return json.dumps({'type_description_msg': full, 'type_hashes': hashes}, indent=1) + '\n'


def rihs01(full: Dict[str, Any]) -> str:
    """Hash a full description; default values do not count."""
    def bare(description: Description) -> Description:
        return {
            'type_name': description['type_name'],
            'fields': [{'name': f['name'], 'type': f['type']} for f in description['fields']],
        }

    text = json.dumps({
        'type_description': bare(full['type_description']),
        'referenced_type_descriptions': [bare(d) for d in full['referenced_type_descriptions']],
    }, separators=(', ', ': '), ensure_ascii=True)
    return 'RIHS01_' + hashlib.sha256(text.encode('ascii')).hexdigest()
