"""Finds the field that kept a message from being written. Asked only after that has failed."""
from __future__ import annotations

from typing import Any

from ros2wasm.codec import Codec, Encoder
from ros2wasm.message_class import Checks

#: A value that is written alone needs no more than this, unless it has many elements.
ROOM = 1 << 16


def fails(codec: Codec, field: Any, value: Any) -> bool:
    """Whether this field cannot be written for its value's sake."""
    encoder = Encoder(1)
    encoder.field(field.type, 'value', codec.find)
    write = encoder.compile('write_field', 'value, buf, at', 'at')
    room = memoryview(bytearray(ROOM + (16 * len(value) if hasattr(value, '__len__') else 0)))
    try:
        write(value, room, 0)
    except Exception:
        return True
    return False


def about(codec: Codec, message: Any) -> str | None:
    """What is wrong, as rclpy's assertion about the field says, and where the field is; None: nothing is."""
    structure = codec.structure
    for field in structure.fields:
        value = getattr(message, f'_{field.name}', None)
        if field.type.is_message:
            inner = codec.find(field.type.base)
            several = field.type.container != ''
            for i, part in enumerate(value if several and isinstance(value, (list, tuple)) else (value,)):
                if isinstance(part, inner.cls):
                    found = about(inner, part)
                    if found is not None:
                        place = f'{field.name}[{i}]' if several else field.name
                        return f"{found}, in '{place}' of {structure.name}"
        if fails(codec, field, value):
            return f'{sentence(codec, field, value)}: {structure.name} has {shown(value)}'
    return None


def sentence(codec: Codec, field: Any, value: Any) -> str:
    checks = Checks(field.name, field.type, lambda name: codec.find(name).cls)
    try:
        (checks.many if field.type.container else checks.single)(value)
    except AssertionError as error:
        return str(error)
    return f"The '{field.name}' field cannot be written"


def shown(value: Any) -> str:
    text = repr(value)
    return f"a '{type(value).__name__}', {text if len(text) <= 60 else text[:57] + '...'}"
