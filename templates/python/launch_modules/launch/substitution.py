"""The base of substitutions."""
from __future__ import annotations

from typing import Any

from ros2wasm_launch import host


class Substitution:
    """A text that is known when the launch file is evaluated. One with a `perform` of its own is asked for it."""

    def _text(self) -> str:
        return f'$(python {host.OBJECTS.number(self)})'

    def perform(self, context: Any) -> str:
        return host.evaluate(self._text(), context.launch_configurations)

    def describe(self) -> str:
        return f'{type(self).__name__}({self._text()})'

    def __repr__(self) -> str:
        return self.describe()
