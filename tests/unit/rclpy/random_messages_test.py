"""Random messages of all types, against a plain writer of CDR that shares no code with the one of the runtime."""
from __future__ import annotations

import importlib
import random
import struct
import unittest
from array import array
from typing import Any

from tests.unit.rclpy.installation import PAYLOAD_AT, ROOT, install

SEED = 20250
FORMATS = {
    'boolean': '?', 'octet': 'B', 'int8': 'b', 'uint8': 'B', 'int16': 'h', 'uint16': 'H', 'int32': 'i', 'uint32': 'I',
    'int64': 'q', 'uint64': 'Q', 'float': 'f', 'double': 'd',
}
LETTERS = 'az09 \u00e9\u4e2d'


class Cdr:
    """XCDR1, little endian: each number at a multiple of its size."""

    def __init__(self) -> None:
        self.out = bytearray()

    def number(self, form: str, value: Any) -> None:
        self.out += bytes(-len(self.out) % struct.calcsize(form)) + struct.pack('<' + form, value)

    def field(self, type_: Any, value: Any, find: Any) -> None:
        if not type_.container:
            self.single(type_, value, find)
            return
        if type_.container != 'array':
            self.number('I', len(value))
        for one in value:
            self.single(type_, one, find)

    def single(self, type_: Any, value: Any, find: Any) -> None:
        if type_.is_message:
            self.message(find(type_.base), value, find)
        elif type_.base == 'string':
            data = value.encode() + bytes(1)
            self.number('I', len(data))
            self.out += data
        elif type_.base == 'wstring':
            self.number('I', len(value))
            for char in value:
                self.number('I', ord(char))
        elif type_.base == 'octet':
            self.number('B', value[0])
        else:
            self.number(FORMATS[type_.base], value)

    def message(self, structure: Any, message: Any, find: Any) -> None:
        for field in structure.fields:
            self.field(field.type, getattr(message, field.name), find)
        if not structure.fields:
            self.number('B', 0)


class RandomMessagesTest(unittest.TestCase):
    types: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls)
        cls.types = importlib.import_module('ros2wasm.types')

    def value(self, rng: random.Random, type_: Any, depth: int) -> Any:
        if type_.is_message:
            return self.message(rng, type_.base, depth + 1)
        if type_.base in ('string', 'wstring'):
            return ''.join(rng.choices(LETTERS, k=rng.randrange(min(type_.string_bound or 9, 9) + 1)))
        if type_.base == 'octet':
            return bytes([rng.randrange(256)])
        if type_.base == 'boolean':
            return rng.random() < 0.5
        if type_.base in ('float', 'double'):
            return float(rng.randrange(-1000, 1000)) / 8
        bits = int(type_.base.lstrip('uint'))
        whole = rng.getrandbits(bits)
        return whole if type_.base.startswith('u') else whole - (1 << (bits - 1))

    def message(self, rng: random.Random, name: str, depth: int = 0) -> Any:
        message = self.types.find_message(name)()
        for field in self.types.find_structure(name).fields:
            type_ = field.type
            if not type_.container:
                setattr(message, field.name, self.value(rng, type_, depth))
                continue
            most = 0 if depth > 3 else min(type_.size if type_.container == 'bounded' else 3, 3)
            count = type_.size if type_.container == 'array' else rng.randrange(most + 1)
            setattr(message, field.name, [self.value(rng, type_, depth) for _ in range(count)])
        return message

    def test_bytes_are_those_of_a_plain_writer_and_come_back(self) -> None:
        rng = random.Random(SEED)
        count = 0
        for file in sorted((ROOT / 'runtime/packages/interfaces').glob('*/*/*.*')):
            kind = file.parent.name
            if file.suffix != f'.{kind}':
                continue
            for name in self.types.names_of(f'{file.parts[-3]}/{kind}/{file.stem}'):
                whole = self.types.definition_of(name) == name and kind != 'msg'
                if whole or name.endswith(('_SendGoal', '_GetResult')):
                    continue
                for _ in range(3):
                    message = self.message(rng, name)
                    plain = Cdr()
                    plain.message(self.types.find_structure(name), message, self.types.find_structure)
                    view = memoryview(bytearray(1 << 18))
                    data = bytes(view[PAYLOAD_AT:message._codec.write(message, view, PAYLOAD_AT)])
                    self.assertEqual(data.hex(), plain.out.hex(), name)
                    back = message._codec.read(array('B', bytes(PAYLOAD_AT) + data), PAYLOAD_AT)[0]
                    self.assertEqual(back, message, name)
                    count += 1
        self.assertGreater(count, 900)


if __name__ == '__main__':
    unittest.main()
