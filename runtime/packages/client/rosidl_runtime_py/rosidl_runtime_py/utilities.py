"""Interfaces by their full names: `std_msgs/msg/String`, or `std_msgs/String` where the kind is known."""
from __future__ import annotations

from typing import Any

from ros2wasm.slot_types import NamespacedType

from rosidl_runtime_py.import_message import import_message_from_namespaced_type


def _type_of(identifier: str, kind: str | None = None) -> NamespacedType:
    *namespaces, name = identifier.split('/')
    if len(namespaces) == 1 and kind is not None:
        namespaces.append(kind)
    return NamespacedType(tuple(namespaces), name)


def get_namespaced_type(identifier: str) -> NamespacedType:
    return _type_of(identifier)


def get_message_namespaced_type(identifier: str) -> NamespacedType:
    return _type_of(identifier, 'msg')


def get_service_namespaced_type(identifier: str) -> NamespacedType:
    return _type_of(identifier, 'srv')


def get_action_namespaced_type(identifier: str) -> NamespacedType:
    return _type_of(identifier, 'action')


def get_interface(identifier: str) -> Any:
    return import_message_from_namespaced_type(get_namespaced_type(identifier))


def get_message(identifier: str) -> Any:
    interface = import_message_from_namespaced_type(get_message_namespaced_type(identifier))
    if not is_message(interface):
        raise ValueError(f"Expected the full name of a message, got '{identifier}'")
    return interface


def get_service(identifier: str) -> Any:
    interface = import_message_from_namespaced_type(get_service_namespaced_type(identifier))
    if not is_service(interface):
        raise ValueError(f"Expected the full name of a service, got '{identifier}'")
    return interface


def get_action(identifier: str) -> Any:
    interface = import_message_from_namespaced_type(get_action_namespaced_type(identifier))
    if not is_action(interface):
        raise ValueError(f"Expected the full name of an action, got '{identifier}'")
    return interface


def is_message(interface: Any) -> bool:
    return hasattr(interface, 'SLOT_TYPES')


def is_service(interface: Any) -> bool:
    return hasattr(interface, 'Request') and hasattr(interface, 'Response')


def is_action(interface: Any) -> bool:
    return all(hasattr(interface, part) for part in ('Goal', 'Result', 'Feedback'))
