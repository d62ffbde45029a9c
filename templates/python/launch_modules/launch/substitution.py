"""The base of substitutions."""
from __future__ import annotations

from typing import Any

from ros2wasm_launch import host


class Substitution:
    """A text that is known when the launch file is evaluated. One with a `perform` of its own is asked for it."""

    def _text(self) -> str:
        is_own = type(self).perform is not Substitution.perform
        return f'$(python {host.OBJECTS.number(self)})' if is_own else self._written()

    def _written(self) -> str:
        """As the evaluator knows it."""
        raise NotImplementedError(f'{type(self).__name__} has no perform()')

    def perform(self, context: Any) -> str:
        from .substitutions import SubstitutionFailure

        try:
            return host.evaluate(self._written(), context.launch_configurations)
        except host.HostError as error:
            raise SubstitutionFailure(str(error)) from error

    def describe(self) -> str:
        return f'{type(self).__name__}({self._text()})'

    def __repr__(self) -> str:
        return self.describe()
