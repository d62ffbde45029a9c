"""Work that is done whenever the program waits, whoever waits: reading /clock, answering what no executor knows of."""
from __future__ import annotations

from collections.abc import Callable

#: Handle of an own reader -> what reads it.
readers: dict[int, Callable[[], None]] = {}


def add(handle: int, read: Callable[[], None]) -> None:
    readers[handle] = read


def remove(handle: int) -> None:
    readers.pop(handle, None)


def run() -> None:
    """Read what has come for the readers of this table."""
    if not readers:
        return
    from ros2wasm import host
    for handle in host.ready():
        read = readers.get(handle)
        if read is not None:
            read()
