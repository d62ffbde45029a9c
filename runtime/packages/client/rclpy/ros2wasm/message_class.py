"""Makes the class of a message: attributes, defaults, constants, checks and texts as rosidl_generator_py's."""
from __future__ import annotations

import math
import os
from array import array
from collections import UserList, UserString
from collections.abc import Callable, Sequence, Set
from copy import copy
from typing import Any

from ros2wasm.codec import NUMBERS, Codec, find_numpy
from ros2wasm.definition import FieldType, Structure

#: Checks cost time; ROS 2 makes them when this says so, or the keyword check_fields of a constructor.
CHECKED = os.environ.get('ROS_PYTHON_CHECK_FIELDS', '') == '1'
PLAIN_DEFAULTS = {'boolean': False, 'octet': b'\0', 'float': 0.0, 'double': 0.0, 'string': '', 'wstring': ''}
LARGEST = {'float': (3.402823466e+38, 'a float'), 'double': (1.7976931348623157e+308, 'a double')}


def type_text(type_: FieldType) -> str:
    """What get_fields_and_field_types says of a field."""
    base = type_.base
    if type_.is_message:
        package, _, short = base.split('/')
        base = f'{package}/{short}'
    if type_.string_bound:
        base += f'<{type_.string_bound}>'
    if type_.container == 'array':
        return f'{base}[{type_.size}]'
    if type_.container == 'bounded':
        return f'sequence<{base}, {type_.size}>'
    return f'sequence<{base}>' if type_.container else base


def integer_range(base: str) -> tuple[int, int, str]:
    bits = int(base.lstrip('uint'))
    if base.startswith('u'):
        return 0, 2 ** bits, f'unsigned integer in [0, {2 ** bits - 1}]'
    low = -2 ** (bits - 1)
    return low, -low, f'integer in [{low}, {-low - 1}]'


class Checks:
    """The assertions about one field."""

    def __init__(self, name: str, type_: FieldType, find: Callable[[str], Any]) -> None:
        self.name = name
        self.type = type_
        self.find = find

    def single(self, value: Any) -> None:
        base, name = self.type.base, self.name
        if self.type.is_message:
            short = base.split('/')[-1]
            assert isinstance(value, self.find(base)), f"The '{name}' field must be a sub message of type '{short}'"
        elif base in ('string', 'wstring'):
            assert isinstance(value, str), f"The '{name}' field must be of type 'str'"
            bound = self.type.string_bound
            assert not bound or len(value) <= bound, f"The '{name}' field must be string value not longer than {bound}"
        elif base == 'octet':
            assert isinstance(value, (bytes, bytearray, memoryview)) and len(value) == 1, \
                f"The '{name}' field must be of type 'bytes' or 'ByteString' with length 1"
        elif base == 'boolean':
            assert isinstance(value, bool), f"The '{name}' field must be of type 'bool'"
        elif base in LARGEST:
            largest, what = LARGEST[base]
            assert isinstance(value, float), f"The '{name}' field must be of type 'float'"
            assert not abs(value) > largest or math.isinf(value), \
                f"The '{name}' field must be {what} in [-{largest}, {largest}]"
        else:
            low, end, what = integer_range(base)
            assert isinstance(value, int), f"The '{name}' field must be of type 'int'"
            assert low <= value < end, f"The '{name}' field must be an {what}"

    def element(self) -> tuple[Callable[[Any], bool], str]:
        """What holds for each element, and how that reads."""
        base = self.type.base
        if self.type.is_message:
            cls = self.find(base)
            return (lambda v: isinstance(v, cls)), f"'{base.split('/')[-1]}'"
        if base in ('string', 'wstring'):
            bound = self.type.string_bound
            also = f' and each string value not longer than {bound}' if bound else ''
            return (lambda v: isinstance(v, str) and (not bound or len(v) <= bound)), f"'str'{also}"
        if base == 'octet':
            return (lambda v: isinstance(v, (bytes, bytearray, memoryview)) and len(v) == 1), "'bytes'"
        if base == 'boolean':
            return (lambda v: isinstance(v, bool)), "'bool'"
        if base in LARGEST:
            largest, what = LARGEST[base]
            return (lambda v: isinstance(v, float) and (not abs(v) > largest or math.isinf(v))), \
                f"'float' and each {what[2:]} in [-{largest:f}, {largest:f}]"
        low, end, what = integer_range(base)
        return (lambda v: isinstance(v, int) and low <= v < end), f"'int' and each {what}"

    def many(self, value: Any) -> None:
        type_, name = self.type, self.name
        code = NUMBERS.get(type_.base)
        if code is not None and type_.container == 'array' and find_numpy() is not None and \
                isinstance(value, find_numpy().ndarray):
            wanted = find_numpy().dtype(code)
            assert value.dtype == wanted, f"The '{name}' numpy.ndarray() must have the dtype of 'numpy.{wanted.name}'"
            assert value.size == type_.size, f"The '{name}' numpy.ndarray() must have a size of {type_.size}"
            return
        if code is not None and isinstance(value, array):
            assert value.typecode == code, f"The '{name}' array.array() must have the type code of '{code}'"
            assert self.fits(len(value)), f"The '{name}' array.array() must have a size {self.length()}"
            return
        holds, what = self.element()
        assert isinstance(value, (Sequence, Set, UserList)) and not isinstance(value, (str, UserString)) and \
            self.fits(len(value)) and all(holds(one) for one in value), \
            f"The '{name}' field must be a set or sequence{self.length(' with length ')} and each value of type {what}"

    def fits(self, count: int) -> bool:
        if self.type.container == 'array':
            return count == self.type.size
        return self.type.container != 'bounded' or count <= self.type.size

    def length(self, before: str = '') -> str:
        size = self.type.size
        return {'array': f'{before}{size}', 'bounded': f'{before}<= {size}'}.get(self.type.container, '')


def as_array(code: str) -> Callable[[Any], Any]:
    """What a sequence field of numbers makes of a value: an array, the given one if it is of the kind."""
    def convert(value: Any) -> Any:
        if isinstance(value, array) and value.typecode == code:
            return value
        if code == 'B' and isinstance(value, (bytes, bytearray, memoryview)):
            return array('B', bytes(value))
        if hasattr(value, 'astype'):
            made = array(code)
            made.frombytes(value.astype(code).tobytes())
            return made
        return array(code, value)
    return convert


def as_fixed_array(code: str) -> Callable[[Any], Any]:
    convert = as_array(code)

    def convert_fixed(value: Any) -> Any:
        numpy = find_numpy()
        return convert(value) if numpy is None else numpy.asarray(value, dtype=numpy.dtype(code))
    return convert_fixed


def conversion(type_: FieldType) -> Callable[[Any], Any] | None:
    """What is stored for a value; None: the value itself."""
    code = NUMBERS.get(type_.base)
    if code is None or not type_.container:
        return None
    return as_fixed_array(code) if type_.container == 'array' else as_array(code)


def first_array(convert: Callable[[Any], Any], first: Any) -> Callable[[], Any]:
    """Copies an array that is made when it is first asked for: what arrays are depends on whether there is numpy."""
    start: Any = None

    def make() -> Any:
        nonlocal start
        if start is None:
            start = convert(first)
        return start[:] if isinstance(start, array) else start.copy()
    return make


def default_maker(type_: FieldType, default: Any, find: Callable[[str], Any]) -> Callable[[], Any] | None:
    """Makes a field's first value; None when one value does for all messages."""
    convert = conversion(type_)
    if convert is not None:
        first = default if default is not None else [0] * (type_.size if type_.container == 'array' else 0)
        return first_array(convert, first)
    if type_.container:
        if default is not None:
            return lambda: list(default)
        if type_.container != 'array':
            return list
        if type_.is_message:
            cls = find(type_.base)
            return lambda: [cls() for _ in range(type_.size)]
        return lambda: [PLAIN_DEFAULTS.get(type_.base, 0)] * type_.size
    if type_.is_message:
        made: Callable[[], Any] = find(type_.base)
        return made
    return None


class MessageMeta(type):
    """Metaclass of messages: what upstream's has, made when it is asked for."""

    _structure: Structure
    _find: Callable[[str], Any]

    @property
    def SLOT_TYPES(cls) -> tuple[Any, ...]:
        from ros2wasm.slot_types import slot_type
        return tuple(slot_type(field.type) for field in cls._structure.fields)


class Message(metaclass=MessageMeta):
    """What all messages have in common. Their attributes are slots of their own classes."""

    __slots__ = ()
    _fields_and_field_types: dict[str, str] = {}
    _structure: Structure
    _codec: Codec
    _message_class: Any
    _check_fields: bool

    @property
    def SLOT_TYPES(self) -> tuple[Any, ...]:
        return type(self).SLOT_TYPES  # type: ignore[return-value]

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        return copy(cls._fields_and_field_types)

    def __repr__(self) -> str:
        package_and_kind = type(self).__module__.rpartition('.')[0]
        parts = []
        for field in self._structure.fields:
            value = getattr(self, field.name)
            text = repr(value)
            if isinstance(value, array) and field.type.container != 'array':
                # The elements alone, without the name of the array's type.
                text = text[len("array('X', "):-1] if len(value) else '[]'
            parts.append(f'{field.name}={text}')
        return f"{package_and_kind}.{type(self).__name__}({', '.join(parts)})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, self._message_class):
            return False
        for field in self._structure.fields:
            same = getattr(self, field.name) == getattr(other, field.name)
            if not (same if isinstance(same, bool) else same.all()):
                return False
        return True

    __hash__ = None  # type: ignore[assignment]


def checked_property(name: str, checks: Checks, convert: Callable[[Any], Any] | None) -> property:
    slot = f'_{name}'

    def get(self: Any) -> Any:
        return getattr(self, slot)

    def put(self: Any, value: Any) -> None:
        if checks.type.container:
            checks.many(value)
        else:
            checks.single(value)
        setattr(self, slot, value if convert is None or isinstance(value, array) else convert(value))
    return property(get, put, doc=f"Message field '{name}'.")


def converted_property(name: str, slot: Any, convert: Callable[[Any], Any]) -> property:
    put_slot = slot.__set__

    def put(self: Any, value: Any) -> None:
        put_slot(self, convert(value))
    return property(slot.__get__, put, doc=f"Message field '{name}'.")


def constructor(structure: Structure, find: Callable[[str], Any]) -> Callable[..., None]:
    """__init__: stores the defaults at once, then what the keywords say."""
    names: dict[str, Any] = {}
    lines = ['def __init__(self, **kwargs):', f'    self._check_fields = {CHECKED}']
    for i, field in enumerate(structure.fields):
        make = default_maker(field.type, field.default, find)
        if make is None:
            names[f'd{i}'] = PLAIN_DEFAULTS.get(field.type.base, 0) if field.default is None else field.default
            lines.append(f'    self._{field.name} = d{i}')
        else:
            names[f'd{i}'] = make
            lines.append(f'    self._{field.name} = d{i}()')
    lines += ['    if kwargs:', '        fill(self, kwargs)']
    names['fill'] = fill
    exec(compile('\n'.join(lines), '<ros2wasm __init__>', 'exec'), names)
    made: Callable[..., None] = names['__init__']
    return made


def fill(message: Any, values: dict[str, Any]) -> None:
    """What the keywords of a constructor say. Unknown ones are an error only when fields are checked."""
    checked = values.pop('check_fields', CHECKED)
    slots = message.__slots__
    if checked:
        message.__class__ = type(message)._checked_class()
        message._check_fields = True
        unknown = sorted(key for key in values if f'_{key}' not in slots)
        assert not unknown, f"Invalid arguments passed to constructor: {', '.join(unknown)}"
    for name, value in values.items():
        if f'_{name}' in slots:
            setattr(message, name, value)


def make_class(structure: Structure, module: str, short: str, find: Callable[[str], Any]) -> Any:
    """`find` gives the class of a message by its name."""
    fields = structure.fields
    names: dict[str, Any] = {
        '__module__': module,
        '__qualname__': short,
        '__doc__': f"Message class '{short}'.",
        '__slots__': [f'_{field.name}' for field in fields] + ['_check_fields'],
        '_structure': structure,
        '_fields_and_field_types': {field.name: type_text(field.type) for field in fields},
        '__init__': constructor(structure, find),
        **structure.constants,
    }
    for field in fields:
        if field.default is not None:
            names[f'{field.name.upper()}__DEFAULT'] = field.default
    cls: Any = MessageMeta(short, (Message,), names)
    cls._message_class = cls
    for field in fields:
        slot = cls.__dict__[f'_{field.name}']
        convert = conversion(field.type)
        # A field without a conversion is its slot by another name.
        setattr(cls, field.name, slot if convert is None else converted_property(field.name, slot, convert))

    def checked_class() -> Any:
        if '_checked' not in cls.__dict__:
            checked: dict[str, Any] = {field.name: checked_property(
                field.name, Checks(field.name, field.type, find), conversion(field.type)) for field in fields}
            body: dict[str, Any] = {
                '__module__': module, '__qualname__': short, '__doc__': cls.__doc__, '__slots__': (), **checked}
            made: Any = MessageMeta(short, (cls,), body)
            made.__slots__ = cls.__slots__
            cls._checked = made
        return cls._checked
    cls._checked_class = staticmethod(checked_class)
    return checked_class() if CHECKED else cls
