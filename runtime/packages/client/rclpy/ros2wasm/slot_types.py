"""The types of fields as rosidl_parser.definition names them, for those who look at SLOT_TYPES."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ros2wasm.definition import FieldType


class AbstractType:
    """Any type of a field."""


class AbstractGenericString(AbstractType):
    """Any text."""


class AbstractNestedType(AbstractType):
    """A type that has elements of another."""

    value_type: Any


class AbstractSequence(AbstractNestedType):
    """Elements whose number may change."""


@dataclass(frozen=True)
class BasicType(AbstractType):
    typename: str


@dataclass(frozen=True)
class UnboundedString(AbstractGenericString):
    pass


@dataclass(frozen=True)
class BoundedString(AbstractGenericString):
    maximum_size: int


@dataclass(frozen=True)
class UnboundedWString(AbstractGenericString):
    pass


@dataclass(frozen=True)
class BoundedWString(AbstractGenericString):
    maximum_size: int


@dataclass(frozen=True)
class NamespacedType(AbstractType):
    namespaces: tuple[str, ...]
    name: str

    def namespaced_name(self) -> tuple[str, ...]:
        return (*self.namespaces, self.name)


@dataclass(frozen=True)
class Array(AbstractNestedType):
    value_type: Any
    size: int


@dataclass(frozen=True)
class BoundedSequence(AbstractSequence):
    value_type: Any
    maximum_size: int


@dataclass(frozen=True)
class UnboundedSequence(AbstractSequence):
    value_type: Any


def element_type(type_: FieldType) -> AbstractType:
    bound = type_.string_bound
    if type_.is_message:
        *namespaces, name = type_.base.split('/')
        return NamespacedType(tuple(namespaces), name)
    if type_.base == 'string':
        return BoundedString(bound) if bound else UnboundedString()
    if type_.base == 'wstring':
        return BoundedWString(bound) if bound else UnboundedWString()
    return BasicType(type_.base)


def slot_type(type_: FieldType) -> AbstractType:
    element = element_type(type_)
    if type_.container == 'array':
        return Array(element, type_.size)
    if type_.container == 'bounded':
        return BoundedSequence(element, type_.size)
    return UnboundedSequence(element) if type_.container else element
