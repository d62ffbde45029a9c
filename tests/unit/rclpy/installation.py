"""The Python half of the runtime, as a site has it installed, for the tests of one class."""
from __future__ import annotations

import importlib
import os
import sys
import tempfile
import types
import unittest
from array import array
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[3]
WOKEN, TIMEOUT = 0, 1
#: Where a message begins in a buffer: behind its CDR header.
PAYLOAD_AT = 4


class FakeHost(types.ModuleType):
    """Only counts wakes: a wait that nothing would end fails the test."""

    def __init__(self) -> None:
        super().__init__('ros2wasm_host')
        self.wakes = 0
        self.places: list[array[int]] = []

    def address(self, place: 'array[int]') -> int:
        self.places.append(place)
        return len(self.places) - 1

    def ready(self, *_: int) -> int:
        return 0

    def look(self, out: int, *_: int) -> int:
        memoryview(self.places[out])[:4] = self.wakes.to_bytes(4, 'little')
        return 0

    def wake(self) -> None:
        self.wakes += 1

    def wake_token(self) -> int:
        return self.wakes

    def wait(self, token: int, low: int, high: int) -> int:
        if token != self.wakes:
            return WOKEN
        if high < 0:
            raise AssertionError('nothing would end this wait')
        return TIMEOUT


def forget() -> None:
    """The next class imports all of it anew, on a host of its own."""
    packages = ROOT / 'runtime/packages'
    for name, module in list(sys.modules.items()):
        file = getattr(module, '__file__', None)
        is_message = (packages / 'interfaces' / name.partition('.')[0]).is_dir()
        if is_message or (file and Path(file).is_relative_to(packages)):
            del sys.modules[name]


def install(cls: type[unittest.TestCase], *packages: str) -> None:
    """rclpy, the interfaces, and packages of runtime/packages/."""
    cls.addClassCleanup(forget)
    prefix = cls.enterClassContext(tempfile.TemporaryDirectory())
    (Path(prefix) / 'share').symlink_to(ROOT / 'runtime/packages/interfaces')
    cls.enterClassContext(mock.patch.dict(os.environ, AMENT_PREFIX_PATH=prefix))
    folders = [str(next((ROOT / 'runtime/packages').glob(f'*/{name}'))) for name in ('rclpy', *packages)]
    cls.enterClassContext(mock.patch.object(sys, 'path', [*folders, *sys.path]))
    cls.enterClassContext(mock.patch.object(sys, 'meta_path', [*sys.meta_path]))
    importlib.import_module('ros2wasm.import_hook').install()


def install_host(cls: type[unittest.TestCase]) -> None:
    """What programs run on: one without a bus."""
    ffi = types.ModuleType('pyodide.ffi')
    setattr(ffi, 'run_sync', lambda result: result)
    setattr(ffi, 'can_run_sync', lambda: False)
    cls.enterClassContext(mock.patch.dict(
        sys.modules, {'ros2wasm_host': FakeHost(), 'pyodide': types.ModuleType('pyodide'), 'pyodide.ffi': ffi}))
