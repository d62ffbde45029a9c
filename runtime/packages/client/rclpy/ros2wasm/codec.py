"""Makes the functions that turn messages into CDR (XCDR1, little endian) and back: Python text, compiled at first use.

Fixed parts of a message, also of messages within it, become one struct format, so that a message of numbers costs one
call. A message begins at one place in its buffer, so that places in the buffer tell the alignment.
"""
from __future__ import annotations

import importlib.util
import struct
from array import array
from collections.abc import Callable
from functools import cached_property, lru_cache
from typing import Any

from ros2wasm.definition import FieldType, Structure

#: struct and array codes of the types that arrays hold as they lie.
NUMBERS = {
    'float': 'f', 'double': 'd', 'int8': 'b', 'uint8': 'B', 'int16': 'h', 'uint16': 'H', 'int32': 'i', 'uint32': 'I',
    'int64': 'q', 'uint64': 'Q',
}
CODES = {**NUMBERS, 'boolean': '?', 'octet': 'c'}
SIZES = {code: struct.calcsize('<' + code) for code in CODES.values()}
TRUTH = {False: False, True: True}
WIDEST = 8
#: Where a message begins in a buffer: behind its CDR header. The header begins the buffer, as it begins what is sent:
#: an engine copies between memories by words only where both places are equally far from a multiple of 8.
PAYLOAD_AT = 4
ZEROS = tuple(bytes(n) for n in range(WIDEST))


class CdrError(ValueError):
    """Bytes that are not a message of the type."""


class Writer:
    """Writes the text of one function. Knows the alignment of `at` as far as it can be known."""

    def __init__(self, modulus: int) -> None:
        self.lines: list[str] = []
        self.names: dict[str, Any] = {}
        self.depth = 1
        #: `at` is PAYLOAD_AT, a multiple of `modulus`, and `rest`.
        self.modulus, self.rest = modulus, 0
        self.format = ''
        self.values: list[str] = []
        self.span = 0
        self.counter = 0

    def line(self, text: str) -> None:
        self.lines.append('    ' * self.depth + text)

    def name(self, value: Any, stem: str) -> str:
        """Give a value a name that the function's text can use."""
        for known, other in self.names.items():
            if other is value:
                return known
        found = f'{stem}{len(self.names)}'
        self.names[found] = value
        return found

    def local(self, stem: str) -> str:
        self.counter += 1
        return f'{stem}{self.counter}'

    def forget_alignment(self, modulus: int = 1) -> None:
        self.modulus, self.rest = modulus, 0

    def fixed(self, code: str, value: str) -> None:
        """Add a number to the struct format that is being gathered."""
        size = SIZES[code]
        if size > self.modulus:
            self.flush()
            self.align(size)
        padding = -(self.rest + self.span) % size
        self.format += 'x' * padding + code
        self.span += padding + size
        self.values.append(value)

    def flush(self) -> None:
        if self.format:
            self.emit_fixed(struct.Struct('<' + self.format), self.values)
            self.line(f'at += {self.span}')
            self.rest = (self.rest + self.span) % self.modulus
        self.format, self.values, self.span = '', [], 0

    def align(self, size: int) -> None:
        """Bring `at` to a multiple of `size`."""
        if self.modulus >= size:
            padding = -self.rest % size
            if padding:
                self.emit_padding(str(padding))
            self.rest = (self.rest + padding) % self.modulus
        elif size > 1:
            self.line(f'gap = {PAYLOAD_AT % size} - at & {size - 1}')
            self.line('if gap:')
            self.depth += 1
            self.emit_padding('gap')
            self.depth -= 1
            self.forget_alignment(size)

    def limit(self, condition: str, message: str) -> None:
        self.line(f'if {condition}:')
        self.line(f'    raise {self.name(CdrError, "error")}({message!r})')

    def emit_fixed(self, packer: struct.Struct, values: list[str]) -> None:
        raise NotImplementedError

    def emit_padding(self, count: str) -> None:
        raise NotImplementedError

    def compile(self, name: str, parameters: str, result: str) -> Callable[..., Any]:
        self.flush()
        text = '\n'.join([f'def {name}({parameters}):', *self.lines, f'    return {result}'])
        exec(compile(text, f'<ros2wasm {name}>', 'exec'), self.names)
        made: Callable[..., Any] = self.names[name]
        return made


class Encoder(Writer):
    def emit_fixed(self, packer: struct.Struct, values: list[str]) -> None:
        self.line(f'{self.name(packer.pack_into, "pack")}(buf, at, {", ".join(values)})')

    def emit_padding(self, count: str) -> None:
        zeros = self.name(ZEROS, 'zeros')
        self.line(f'buf[at:at + {count}] = {zeros}[{count}]')
        self.line(f'at += {count}')

    def count(self, value: str) -> None:
        self.fixed('I', value)
        self.flush()

    def bound(self, length: str, type_: FieldType) -> None:
        if type_.string_bound:
            self.limit(f'{length} > {type_.string_bound}', f'a string is longer than {type_.string_bound}')

    def text(self, value: str, type_: FieldType) -> None:
        bytes_ = self.local('text')
        self.flush()
        if type_.base == 'wstring':
            self.line(f'{bytes_} = {self.name(encode_wide, "wide")}({value})')
            self.bound(f'len({bytes_}) >> 2', type_)
            self.count(f'len({bytes_}) >> 2')
            self.line(f'buf[at:at + len({bytes_})] = {bytes_}')
            self.line(f'at += len({bytes_})')
            self.forget_alignment(4)
            return
        self.line(f"{bytes_} = {value}.encode() + b'\\0'")
        self.bound(f'len({bytes_}) - 1', type_)
        self.count(f'len({bytes_})')
        self.line(f'end = at + len({bytes_})')
        self.line(f'buf[at:end] = {bytes_}')
        self.line('at = end')
        self.forget_alignment()

    def raw(self, code: str, value: str) -> None:
        """Elements that lie in memory as on the wire."""
        self.flush()
        items = self.local('items')
        self.line(f'{items} = {value}')
        self.line(f'if {items}.__class__ is not {self.name(array, "array")} or {items}.typecode != {code!r}:')
        self.line(f'    {items} = {self.name(as_array, "flat")}({items}, {code!r})')
        self.line(f'if len({items}):')
        self.depth += 1
        self.align(SIZES[code])
        self.line(f'end = at + len({items}) * {SIZES[code]}')
        plain = items if code == 'B' else f'{self.name(memoryview, "view")}({items}).cast("B")'
        self.line(f'buf[at:end] = {plain}')
        self.line('at = end')
        self.depth -= 1
        self.forget_alignment(1 if SIZES[code] < 4 else 4)

    def single(self, type_: FieldType, value: str, codec: Callable[[str], 'Codec'], inline: bool) -> None:
        base = type_.base
        if base == 'boolean':
            # struct would take anything.
            self.fixed('?', f'{self.name(TRUTH, "truth")}[{value}]')
        elif base in CODES:
            self.fixed(CODES[base], value)
        elif base in ('string', 'wstring'):
            self.text(value, type_)
        elif inline:
            part = self.local('part')
            self.line(f'{part} = {value}')
            codec(base).write_fields(self, part)
        else:
            self.flush()
            self.line(f'at = {self.name(codec(base).write_part, "write")}({value}, buf, at)')
            self.forget_alignment()

    def field(self, type_: FieldType, value: str, codec: Callable[[str], 'Codec']) -> None:
        if not type_.container:
            self.single(type_, value, codec, True)
            return
        if type_.container == 'array':
            self.limit(f'len({value}) != {type_.size}', f'an array has not {type_.size} elements')
        elif type_.container == 'bounded':
            self.limit(f'len({value}) > {type_.size}', f'a sequence has more than {type_.size} elements')
        if type_.container != 'array':
            self.count(f'len({value})')
        if type_.base in NUMBERS:
            self.raw(NUMBERS[type_.base], value)
            return
        self.flush()
        if type_.base in ('boolean', 'octet'):
            bytes_ = 'bytes(map(bool, {}))' if type_.base == 'boolean' else "b''.join({})"
            self.raw('B', bytes_.format(value))
            return
        self.forget_alignment()
        item = self.local('item')
        self.line(f'for {item} in {value}:')
        self.depth += 1
        self.single(type_, item, codec, False)
        self.flush()
        self.depth -= 1
        self.forget_alignment()


class Decoder(Writer):
    def emit_fixed(self, packer: struct.Struct, values: list[str]) -> None:
        self.line(f'{", ".join(values)}, = {self.name(packer.unpack_from, "unpack")}(buf, at)')

    def emit_padding(self, count: str) -> None:
        self.line(f'at += {count}')

    def count(self) -> str:
        count = self.local('n')
        self.fixed('I', count)
        self.flush()
        return count

    def text(self, target: str, type_: FieldType) -> None:
        self.flush()
        count = self.count()
        if type_.base == 'wstring':
            self.line(f'end = at + ({count} << 2)')
            self.line(f'{target} = {self.name(decode_wide, "wide")}(buf[at:end])')
            self.line('at = end')
            self.forget_alignment(4)
            return
        self.line(f'end = at + {count}')
        self.line(f"{target} = str(buf[at:end - 1], 'utf-8', 'replace') if {count} else ''")
        self.line('at = end')
        self.forget_alignment()

    def raw(self, target: str, type_: FieldType, count: str) -> None:
        code = NUMBERS[type_.base]
        self.flush()
        if type_.container == 'array':
            self.align(SIZES[code])
            self.line(f'end = at + {count} * {SIZES[code]}')
            self.line(f'{target} = {self.name(fixed_array, "fixed")}({code!r}, buf[at:end])')
            self.line('at = end')
        elif code == 'B':
            self.line(f'end = at + {count}')
            self.line(f'{target} = buf[at:end]')
            self.line('at = end')
        else:
            # The sum of two empty arrays is a new one, at half of what it costs to call for it.
            empty = self.name(array(code), 'empty')
            self.line(f'{target} = {empty} + {empty}')
            self.line(f'if {count}:')
            self.depth += 1
            self.align(SIZES[code])
            self.line(f'end = at + {count} * {SIZES[code]}')
            self.line(f'{target}.frombytes({self.name(memoryview, "view")}(buf)[at:end])')
            self.line('at = end')
            self.depth -= 1
        self.forget_alignment(1 if SIZES[code] < 4 else 4)

    def single(self, type_: FieldType, target: str, codec: Callable[[str], 'Codec'], inline: bool) -> None:
        base = type_.base
        if base in CODES:
            self.fixed(CODES[base], target)
        elif base in ('string', 'wstring'):
            self.text(target, type_)
        elif inline:
            part = self.local('part')
            inner = codec(base)
            self.line(f'{part} = {target} = {self.name(inner.cls.__new__, "new")}({self.name(inner.cls, "cls")})')
            inner.read_fields(self, part)
        else:
            self.flush()
            self.line(f'{target}, at = {self.name(codec(base).read_part, "read")}(buf, at)')
            self.forget_alignment()

    def field(self, type_: FieldType, target: str, codec: Callable[[str], 'Codec']) -> None:
        if not type_.container:
            self.single(type_, target, codec, True)
            return
        count = str(type_.size) if type_.container == 'array' else self.count()
        if type_.container == 'bounded':
            self.limit(f'{count} > {type_.size}', f'a sequence has more than {type_.size} elements')
        if type_.base in NUMBERS:
            self.raw(target, type_, count)
            return
        self.flush()
        if type_.base in ('boolean', 'octet'):
            self.line(f'end = at + {count}')
            items = '[one != 0 for one in buf[at:end]]' if type_.base == 'boolean' else \
                '[bytes((one,)) for one in buf[at:end]]'
            self.line(f'{target} = {items}')
            self.line('at = end')
            self.forget_alignment()
            return
        self.forget_alignment()
        items, item = self.local('items'), self.local('item')
        self.line(f'{target} = {items} = []')
        self.line(f'for _ in range({count}):')
        self.depth += 1
        self.single(type_, item, codec, False)
        self.flush()
        self.line(f'{items}.append({item})')
        self.depth -= 1
        self.forget_alignment()


def encode_wide(text: str) -> bytes:
    """A character of a wide string travels as 32 bits."""
    units = array('H', text.encode('utf-16-le'))
    return array('I', units).tobytes()


def decode_wide(data: 'array[int]') -> str:
    units = array('I')
    units.frombytes(data)
    return array('H', [unit & 0xFFFF for unit in units]).tobytes().decode('utf-16-le')


def as_array(items: Any, code: str) -> Any:
    """Numbers as they lie on the wire; those of bytes are left where they are."""
    if code == 'B' and isinstance(items, (bytes, bytearray)):
        return items
    if isinstance(items, array) and items.typecode == code:
        return items
    return array(code, items.tolist() if hasattr(items, 'tolist') else items)


def fixed_array(code: str, data: 'array[int]') -> Any:
    """What a fixed array of numbers is in a message: numpy's, over these bytes, if the site has it, as in ROS 2."""
    numpy = find_numpy()
    if numpy is None:
        return array(code, data.tobytes())
    return numpy.frombuffer(data, dtype=numpy.dtype(code))


@lru_cache(maxsize=None)
def find_numpy() -> Any:
    """The module, or None when the site has none."""
    return importlib.import_module('numpy') if importlib.util.find_spec('numpy') is not None else None


class Codec:
    """Reads and writes one type of message; its functions are made when they are first called."""

    def __init__(self, cls: Any, structure: Structure, find: Callable[[str], 'Codec'], check_fields: bool) -> None:
        self.cls = cls
        self.structure = structure
        self.find = find
        self.check_fields = check_fields

    @cached_property
    def write(self) -> Callable[[Any, memoryview, int], int]:
        """(message, buffer, PAYLOAD_AT) -> place behind it."""
        return self._writer(WIDEST)

    @cached_property
    def read(self) -> Callable[['array[int]', int], tuple[Any, int]]:
        """
        (bytes, PAYLOAD_AT) -> message, place behind it. The bytes are an array, whose slices are copies. Whether the
        place behind it is beyond the message's end is for the caller to see.
        """
        return self._reader(WIDEST)

    @cached_property
    def write_part(self) -> Callable[[Any, memoryview, int], int]:
        """As write, at any place: for elements of sequences."""
        return self._writer(1)

    @cached_property
    def read_part(self) -> Callable[['array[int]', int], tuple[Any, int]]:
        return self._reader(1)

    def _writer(self, modulus: int) -> Callable[[Any, memoryview, int], int]:
        encoder = Encoder(modulus)
        self.write_fields(encoder, 'm')
        return encoder.compile('write_' + self.structure.name.replace('/', '_'), 'm, buf, at', 'at')

    def _reader(self, modulus: int) -> Callable[['array[int]', int], tuple[Any, int]]:
        decoder = Decoder(modulus)
        decoder.line(f'm = {decoder.name(self.cls.__new__, "new")}({decoder.name(self.cls, "cls")})')
        self.read_fields(decoder, 'm')
        return decoder.compile('read_' + self.structure.name.replace('/', '_'), 'buf, at', 'm, at')

    def write_fields(self, encoder: Encoder, name: str) -> None:
        for field in self.structure.fields:
            encoder.field(field.type, f'{name}._{field.name}', self.find)
        if not self.structure.fields:
            encoder.fixed('B', '0')

    def read_fields(self, decoder: Decoder, name: str) -> None:
        decoder.line(f'{name}._check_fields = {self.check_fields}')
        for field in self.structure.fields:
            decoder.field(field.type, f'{name}._{field.name}', self.find)
        if not self.structure.fields:
            decoder.fixed('B', '_')
