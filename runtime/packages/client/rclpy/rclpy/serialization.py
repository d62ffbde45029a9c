"""Messages as bytes, and back."""
from __future__ import annotations

from typing import Any

from rclpy.type_support import check_for_type_support
from ros2wasm import host


def serialize_message(message: Any) -> bytes:
    """The bytes of a message, as they travel."""
    check_for_type_support(type(message))
    return host.serialize(message._codec, message)


def deserialize_message(serialized_message: bytes, message_type: Any) -> Any:
    """The message that bytes are of."""
    check_for_type_support(message_type)
    return host.decode(message_type._codec, bytes(serialized_message))
