"""Type descriptions and their RIHS01 hashes, as REP 2011 has them. The order of keys matters: the text is hashed."""
from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from typing import Any

from ros2wasm.definition import Field, FieldType, Structure

#: Numbers of type_description_interfaces/msg/FieldType.
TYPE_IDS = {
    'int8': 2, 'uint8': 3, 'int16': 4, 'uint16': 5, 'int32': 6, 'uint32': 7, 'int64': 8, 'uint64': 9, 'float': 10,
    'double': 11, 'boolean': 15, 'octet': 16, 'string': 17, 'wstring': 18,
}
NESTED = 1
BOUNDED_STRING_STEP = 4
CONTAINERS = {'': 0, 'array': 48, 'bounded': 96, 'sequence': 144}
#: What a structure without fields has in its place.
FILLER = Field('structure_needs_at_least_one_member', FieldType('uint8'))

Description = dict[str, Any]


def describe_field(type_: FieldType) -> Description:
    number = NESTED if type_.is_message else TYPE_IDS[type_.base]
    if type_.string_bound:
        number += BOUNDED_STRING_STEP
    return {
        'type_id': number + CONTAINERS[type_.container],
        'capacity': type_.size,
        'string_capacity': type_.string_bound,
        'nested_type_name': type_.base if type_.is_message else '',
    }


def describe(structure: Structure) -> Description:
    return {
        'type_name': structure.name,
        'fields': [{'name': one.name, 'type': describe_field(one.type)} for one in structure.fields or (FILLER,)],
    }


def full_description(name: str, find: Callable[[str], Structure]) -> Description:
    """Describe a type and all that it refers to. `find` knows every structure by its name."""
    found: dict[str, Description] = {}
    queue = [name]
    while queue:
        for field in find(queue.pop()).fields:
            base = field.type.base
            if field.type.is_message and base not in found:
                found[base] = describe(find(base))
                queue.append(base)
    return {
        'type_description': describe(find(name)),
        'referenced_type_descriptions': [found[one] for one in sorted(found)],
    }


def rihs01(full: Description) -> str:
    text = json.dumps(full, separators=(', ', ': '))
    return 'RIHS01_' + hashlib.sha256(text.encode('ascii')).hexdigest()
