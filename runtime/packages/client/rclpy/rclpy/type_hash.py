"""The hash of a type's description."""
from __future__ import annotations

SIZE = 32
PREFIX = 'RIHS'


class TypeHash:
    """Version and value of a hash; the text is RIHS01_ and 64 digits."""

    def __init__(self, version: int = -1, value: bytes = bytes(SIZE)) -> None:
        self.version = version
        self.value = value

    @classmethod
    def _from_text(cls, text: str) -> TypeHash:
        if not text.startswith(PREFIX):
            return cls()
        return cls(int(text[4:6]), bytes.fromhex(text[7:]))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TypeHash) and (self.version, self.value) == (other.version, other.value)

    def __hash__(self) -> int:
        return hash((self.version, self.value))

    def __str__(self) -> str:
        if self.version <= 0:
            return 'INVALID'
        return f'{PREFIX}{self.version:02d}_{self.value.hex()}'
