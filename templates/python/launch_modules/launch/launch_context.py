"""What functions of launch files are given."""
from __future__ import annotations

import os
from types import SimpleNamespace
from typing import Any


class LaunchContext:
    """The launch configurations where the evaluator now is; what is changed in them is taken over."""

    def __init__(self, *, argv: list[str] | None = None, noninteractive: bool = True) -> None:
        self.argv = list(argv or ())
        self.noninteractive = noninteractive
        self.launch_configurations: dict[str, str] = {}
        self.environment: dict[str, str] = dict(os.environ)
        self.locals = SimpleNamespace()
        self.is_shutdown = False

    def perform_substitution(self, substitution: Any) -> str:
        return str(substitution.perform(self))

    def extend_locals(self, extensions: dict[str, Any]) -> None:
        self.locals.__dict__.update(extensions)

    def extend_globals(self, extensions: dict[str, Any]) -> None:
        self.locals.__dict__.update(extensions)

    def get_locals_as_dict(self) -> dict[str, Any]:
        return dict(self.locals.__dict__)
