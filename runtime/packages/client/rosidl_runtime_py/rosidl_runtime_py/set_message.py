"""Fills messages out of dictionaries, as they come from YAML."""
from __future__ import annotations

from array import array
from functools import partial
from typing import Any

from ros2wasm.slot_types import AbstractNestedType, NamespacedType

from rosidl_runtime_py.convert import get_message_slot_types
from rosidl_runtime_py.import_message import import_message_from_namespaced_type


def set_message_fields(
    msg: Any, values: dict[str, Any], expand_header_auto: bool = False, expand_time_now: bool = False
) -> list[Any]:
    """
    Fill a message. AttributeError: there is no such field; TypeError: a value is of a wrong type.

    Returns functions that set times to what they are given: of headers that are `auto` and times that are `now`, where
    these words are allowed.
    """
    timestamps: list[Any] = []
    if not hasattr(values, 'items'):
        raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {type(values).__name__}")
    types = get_message_slot_types(msg)
    for name, given in values.items():
        field = getattr(msg, name)
        full = f'{type(field).__module__}.{type(field).__name__}'
        if expand_header_auto and given == 'auto' and full == 'std_msgs.msg._header.Header':
            timestamps.append(partial(setattr, field, 'stamp'))
            continue
        if expand_time_now and given == 'now' and full == 'builtin_interfaces.msg._time.Time':
            timestamps.append(partial(setattr, msg, name))
            continue
        value, inner = _value(field, given, expand_header_auto, expand_time_now)
        timestamps += inner
        type_ = types[name]
        if isinstance(type_, AbstractNestedType) and isinstance(type_.value_type, NamespacedType):
            element = import_message_from_namespaced_type(type_.value_type)
            value = list(value)
            for i, one in enumerate(value):
                value[i] = element()
                timestamps += set_message_fields(value[i], one, expand_header_auto, expand_time_now)
        setattr(msg, name, value)
    return timestamps


def _value(field: Any, given: Any, auto: bool, now: bool) -> tuple[Any, list[Any]]:
    """What a field becomes, and the times within it that are set later."""
    if isinstance(field, array):
        return array(field.typecode, given), []
    if hasattr(field, 'astype'):
        changed = field.copy()
        changed[...] = given
        return changed, []
    if type(given) is type(field):
        return given, []
    if hasattr(field, 'SLOT_TYPES'):
        value = type(field)()
        return value, set_message_fields(value, given, auto, now)
    return type(field)(given), []
