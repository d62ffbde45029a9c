"""Turns interface definitions into the generator's descriptions, the way a build does."""
from __future__ import annotations

import tempfile
from pathlib import Path

import type_description as td
from generate import Interface
import rosidl_adapter.action
import rosidl_adapter.msg
import rosidl_adapter.srv
from rosidl_adapter import convert_to_idl

from . import ROOT

for _module in (rosidl_adapter.action, rosidl_adapter.msg, rosidl_adapter.srv):
    _module.print = lambda *_, **__: None  # they tell of each file; tests are quiet


def described(package: str, relative: str, text: str) -> Interface:
    """Adapts and parses one definition; raises what Debian's rosidl raises."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        source = folder / relative
        source.parent.mkdir(parents=True)
        source.write_text(text, encoding="utf-8")
        made = convert_to_idl(folder, package, Path(relative), folder / "idl")
        return Interface(package, str(folder / "idl"), str(made.relative_to(folder / "idl")))


def shipped(*types: str) -> td.TypeTable:
    """Returns a table of interfaces that we ship; `types` must name all that they refer to."""
    table = td.TypeTable()
    for type_name in types:
        package, kind, name = type_name.split("/")
        relative = f"{kind}/{name}.{kind}"
        text = (ROOT / "runtime" / "packages" / "interfaces" / package / relative).read_text(encoding="utf-8")
        table.add(described(package, relative, text).descriptions)
    return table
