"""Expands xacro files by the evaluator of launch files."""
from __future__ import annotations

import os
import shlex
import sys
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


def parse(inp: Any, filename: str | None = None) -> minidom.Document:
    """The document as it is written; process_doc() expands the file that it came from."""
    name = filename or getattr(inp, 'name', None)
    if name is None:
        raise TypeError('a document is expanded by the name of its file')
    with open(name, encoding='utf-8') as stream:
        document: minidom.Document = minidom.parseString(stream.read())
    setattr(document, '_file', name)
    return document


def process_doc(doc: Any, *, mappings: Mapping[str, str] | None = None, **_more: Any) -> None:
    expanded = process_file(doc._file, mappings=mappings)
    doc.replaceChild(expanded.documentElement, doc.documentElement)


def open_output(output_filename: str | None) -> Any:
    """The file that a description is written to, with its folder."""
    if output_filename is None:
        return sys.stdout
    os.makedirs(os.path.dirname(output_filename) or '.', exist_ok=True)
    return open(output_filename, 'w', encoding='utf-8')
