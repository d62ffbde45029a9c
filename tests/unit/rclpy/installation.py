"""The Python half of the runtime, as a site has it installed, for the tests of one class."""
from __future__ import annotations

import importlib
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[3]


def forget() -> None:
    """The next class imports all of it anew, on a host of its own."""
    interfaces = ROOT / 'runtime/interfaces'
    for name in list(sys.modules):
        root = name.partition('.')[0]
        if root in ('rclpy', 'ros2wasm') or (interfaces / root).is_dir():
            del sys.modules[name]


def install(cls: type[unittest.TestCase]) -> None:
    cls.addClassCleanup(forget)
    prefix = cls.enterClassContext(tempfile.TemporaryDirectory())
    (Path(prefix) / 'share').symlink_to(ROOT / 'runtime/interfaces')
    cls.enterClassContext(mock.patch.dict(os.environ, AMENT_PREFIX_PATH=prefix))
    cls.enterClassContext(mock.patch.object(sys, 'path', [str(ROOT / 'runtime/rclpy'), *sys.path]))
    cls.enterClassContext(mock.patch.object(sys, 'meta_path', [*sys.meta_path]))
    importlib.import_module('ros2wasm.import_hook').install()
