"""Expands xacro files by the evaluator of launch files."""
from __future__ import annotations

import shlex
from collections.abc import Mapping
from typing import Any
from xml.dom import minidom

from ros2wasm_launch import host
from ros2wasm_launch.texts import call


def process(input_file_name: Any, *, mappings: Mapping[str, str] | None = None, **_more: Any) -> str:
    words = ['xacro', str(input_file_name), *(f'{name}:={value}' for name, value in (mappings or {}).items())]
    return host.evaluate(call('command', shlex.join(words)), {})


def process_file(input_file_name: Any, *, mappings: Mapping[str, str] | None = None, **_more: Any) -> minidom.Document:
    document: minidom.Document = minidom.parseString(process(input_file_name, mappings=mappings))
    return document
