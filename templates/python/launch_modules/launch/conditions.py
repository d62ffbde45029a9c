"""When an action takes place."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ros2wasm_launch.texts import call, text_of

from .substitution import Substitution

VALID_TRUE_EXPRESSIONS = ['true', '1']
VALID_FALSE_EXPRESSIONS = ['false', '0']


class InvalidConditionExpressionError(Exception):
    """A condition that is neither true nor false."""


class _Predicate(Substitution):
    def __init__(self, condition: Condition) -> None:
        self._condition = condition

    def perform(self, context: Any) -> str:
        return str(bool(self._condition.evaluate(context)))


class Condition:
    """One with a predicate, or an `evaluate`, of its own is asked when the evaluator comes to it."""

    def __init__(self, *, predicate: Callable[[Any], bool] | None = None) -> None:
        self._predicate = predicate

    def evaluate(self, context: Any) -> bool:
        if self._predicate is None:
            raise NotImplementedError('a condition needs a predicate')
        return self._predicate(context)

    def _attribute(self) -> tuple[str, str]:
        """`if` or `unless`, and its text."""
        return 'if', _Predicate(self)._text()


class _Written(Condition):
    _name = 'if'

    def __init__(self, text: str) -> None:
        super().__init__()
        self._written = text

    def evaluate(self, context: Any) -> bool:
        from .substitutions import Called

        name = 'any' if self._name == 'if' else 'not'
        return Called(name, _Raw(self._written)).perform(context) == 'true'

    def _attribute(self) -> tuple[str, str]:
        return self._name, self._written


class _Raw(Substitution):
    def __init__(self, text: str) -> None:
        self._raw = text

    def _written(self) -> str:
        return self._raw


class IfCondition(_Written):
    def __init__(self, predicate_expression: Any) -> None:
        super().__init__(text_of(predicate_expression))


class UnlessCondition(_Written):
    _name = 'unless'

    def __init__(self, predicate_expression: Any) -> None:
        super().__init__(text_of(predicate_expression))


class LaunchConfigurationEquals(_Written):
    """Of texts, as they are; one that is not set equals None."""

    def __init__(self, launch_configuration_name: str, expected_value: Any) -> None:
        super().__init__(_same(launch_configuration_name, expected_value))


class LaunchConfigurationNotEquals(_Written):
    _name = 'unless'

    def __init__(self, launch_configuration_name: str, expected_value: Any) -> None:
        super().__init__(_same(launch_configuration_name, expected_value))


def evaluate_condition_expression(context: Any, expression: Any) -> bool:
    """Of substitutions, whose text is `true`, `1`, `false` or `0`."""
    text = ''.join(context.perform_substitution(one) for one in expression).strip().lower()
    if text not in VALID_TRUE_EXPRESSIONS + VALID_FALSE_EXPRESSIONS:
        raise InvalidConditionExpressionError(f'{text!r} is neither true nor false')
    return text in VALID_TRUE_EXPRESSIONS


def _same(name: str, expected: Any) -> str:
    return call('var-is', name) if expected is None else call('var-is', name, expected)
