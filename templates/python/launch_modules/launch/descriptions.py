"""A program with its arguments, of which a process is made."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any


class Executable:
    def __init__(self, *, cmd: Iterable[Any], prefix: Any = None, name: Any = None, cwd: Any = None, env: Any = None,
                 additional_env: Any = None, arguments: Iterable[Any] | None = None) -> None:
        self.cmd = [*cmd, *(arguments or ())]
        self.prefix, self.name, self.cwd = prefix, name, cwd
        self.env, self.additional_env = env, additional_env
