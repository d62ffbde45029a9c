"""The launch configurations that functions of launch files are given."""
from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

#: A variable whose name is written out.
_NAMED_VARIABLE = re.compile(r"\$\((?:var|arg) '?([\w./-]+)'?[ )]")
_VARIABLE = re.compile(r'\$\((?:var|arg) ')
#: What may look at anything.
_UNKNOWN = ('$(python ', '$(param ')


class Configurations(dict[str, str]):
    """Launch configurations that note which of them matter; `None`: all may."""

    def __init__(self, values: dict[str, str]) -> None:
        super().__init__(values)
        self.reads: set[str] | None = set()

    def read(self, name: Any) -> None:
        if self.reads is not None:
            self.reads.add(str(name))

    def read_by(self, text: str) -> None:
        """What a text of substitutions names; names that are substitutions themselves may be any."""
        names = _NAMED_VARIABLE.findall(text)
        is_known = len(names) == len(_VARIABLE.findall(text)) and not any(one in text for one in _UNKNOWN)
        if not is_known or self.reads is None:
            self.reads = None
        else:
            self.reads.update(names)

    def __getitem__(self, name: str) -> str:
        self.read(name)
        return super().__getitem__(name)

    def __contains__(self, name: object) -> bool:
        self.read(name)
        return super().__contains__(name)

    def get(self, name: str, default: Any = None) -> Any:
        self.read(name)
        return super().get(name, default)

    def __iter__(self) -> Iterator[str]:
        self.reads = None
        return super().__iter__()

    def keys(self) -> Any:
        self.reads = None
        return super().keys()

    def values(self) -> Any:
        self.reads = None
        return super().values()

    def items(self) -> Any:
        self.reads = None
        return super().items()

    def __setitem__(self, name: str, value: str) -> None:
        self.read(name)  # what is the same before and after is seen as not set
        super().__setitem__(name, value)

    def __delitem__(self, name: str) -> None:
        self.read(name)
        super().__delitem__(name)

    def pop(self, *arguments: Any) -> Any:
        self.reads = None
        return super().pop(*arguments)

    def setdefault(self, *arguments: Any) -> Any:
        self.reads = None
        return super().setdefault(*arguments)

    def update(self, *arguments: Any, **named: Any) -> None:
        self.reads = None
        super().update(*arguments, **named)

    def plain(self) -> dict[str, str]:
        """All of them, unnoted."""
        return {str(key): str(value) for key, value in super().items()}
