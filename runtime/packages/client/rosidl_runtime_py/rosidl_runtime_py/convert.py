"""Messages as dictionaries, YAML and lines of commas."""
from __future__ import annotations

import sys
from array import array
from collections import OrderedDict
from collections.abc import Iterator
from typing import Any

import yaml

from ros2wasm import slot_types

#: Ends what was cut off.
CUT = '...'


def is_sequence(value: Any) -> bool:
    """Also numpy's arrays, which are not there in every site."""
    return isinstance(value, (list, tuple, array)) or hasattr(value, 'ndim') and value.ndim > 0


def fields_of(msg: Any) -> Iterator[tuple[str, Any, Any]]:
    """Name, value and type of each field."""
    for name, type_ in get_message_slot_types(msg).items():
        yield name, getattr(msg, name), type_


def get_message_slot_types(msg: Any) -> OrderedDict[str, Any]:
    return OrderedDict(zip(msg.get_fields_and_field_types(), msg.SLOT_TYPES))


def type_name(type_: Any) -> str:
    if isinstance(type_, slot_types.BasicType):
        return type_.typename
    if isinstance(type_, slot_types.NamespacedType):
        return '/'.join(type_.namespaced_name())
    return 'wstring' if isinstance(type_, (slot_types.UnboundedWString, slot_types.BoundedWString)) else 'string'


def in_place_of(value: Any, type_: Any) -> str:
    """What stands for a sequence that is skipped."""
    element = type_name(type_.value_type)
    if isinstance(type_, slot_types.Array):
        return f'<array type: {element}[{type_.size}]>'
    if isinstance(type_, slot_types.BoundedSequence):
        return f'<sequence type: {element}[{type_.maximum_size}], length: {len(value)}>'
    return f'<sequence type: {element}, length: {len(value)}>'


class MessageDumper(yaml.Dumper):
    """Keeps the order of fields."""


MessageDumper.add_representer(OrderedDict, lambda dumper, data: dumper.represent_mapping(
    'tag:yaml.org,2002:map', list(data.items())))


def message_to_yaml(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False,
    flow_style: bool = False
) -> str:
    values = message_to_ordereddict(msg, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    return str(yaml.dump(
        values, Dumper=MessageDumper, allow_unicode=True, width=sys.maxsize, default_flow_style=flow_style))


def message_to_ordereddict(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> OrderedDict[str, Any]:
    """Field -> value. What is longer than `truncate_length` is cut; `no_arr`, `no_str`: only lengths are told."""
    return OrderedDict((name, _convert_value(
        value, field_type=type_, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str))
        for name, value, type_ in fields_of(msg))


def _convert_value(
    value: Any, *, field_type: Any = None, truncate_length: int | None = None, no_arr: bool = False,
    no_str: bool = False
) -> Any:
    def convert(one: Any) -> Any:
        return _convert_value(one, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)

    if isinstance(value, bytes):
        return cut(value.decode('latin-1'), truncate_length)
    if isinstance(value, str):
        return f'<string length: <{len(value)}>>' if no_str else cut(value, truncate_length)
    if is_sequence(value):
        if no_arr and field_type is not None:
            return in_place_of(value, field_type)
        is_cut = truncate_length is not None and len(value) > truncate_length
        items = [convert(one) for one in (value[:truncate_length] if is_cut else value)] + [CUT] * is_cut
        return tuple(items) if isinstance(value, tuple) else items
    if isinstance(value, dict):
        # Keys stay whole: two that are cut might be the same.
        return type(value)((_convert_value(key), convert(one)) for key, one in value.items())
    if isinstance(value, (bool, float, int)):
        # numpy's double is a float too.
        return value.item() if hasattr(value, 'item') else value
    if hasattr(value, 'item'):
        return value.item()
    return message_to_ordereddict(value, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)


def cut(text: Any, length: int | None) -> Any:
    if length is None or len(text) <= length:
        return text
    return text[:length] + (CUT.encode() if isinstance(text, bytes) else CUT)


def message_to_csv(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> str:
    def text_of(value: Any, type_: Any = None) -> str:
        if is_sequence(value):
            if no_arr and type_ is not None:
                return in_place_of(value, type_)
            is_cut = truncate_length is not None and len(value) > truncate_length
            return ','.join([text_of(one) for one in (value[:truncate_length] if is_cut else value)] + [CUT] * is_cut)
        if isinstance(value, str) and no_str:
            return f'<string length: <{len(value)}>>'
        if isinstance(value, (bytes, str)):
            return str(cut(value, truncate_length))
        if isinstance(value, (bool, float, int)) or hasattr(value, 'item'):
            return str(value)
        return message_to_csv(value, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    return ','.join(text_of(value, type_) for _, value, type_ in fields_of(msg))
