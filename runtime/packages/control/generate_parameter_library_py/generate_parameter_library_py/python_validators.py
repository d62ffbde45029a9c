"""Checks of a parameter's value: an empty text when it holds, else the reason for refusing it."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any


def _compared(holds: Callable[[Any, Any], object], must: str) -> Callable[[Any, Any], str]:
    def check(param: Any, value: Any) -> str:
        if holds(param.value, value):
            return ''
        return f"Parameter '{param.name}' with the value {param.value} must be {must} {value}"
    return check


def _length(holds: Callable[[int, int], bool], must: str) -> Callable[[Any, int], str]:
    def check(param: Any, length: int) -> str:
        count = len(param.value)
        if holds(count, length):
            return ''
        return f"Length of parameter '{param.name}' is '{count}' but must be {must} {length}"
    return check


class ParameterValidators:
    """Names and texts are those of generate_parameter_library for Python; those for C++ differ a little."""

    lt = staticmethod(_compared(lambda a, b: a < b, 'less than'))
    gt = staticmethod(_compared(lambda a, b: a > b, 'greater than'))
    lt_eq = upper_bounds = staticmethod(_compared(lambda a, b: a <= b, 'below upper bound of'))
    gt_eq = lower_bounds = staticmethod(_compared(lambda a, b: a >= b, 'above lower bound of'))
    fixed_size = staticmethod(_length(lambda a, b: a == b, 'equal to'))
    size_gt = staticmethod(_length(lambda a, b: a > b, 'greater than'))
    size_lt = staticmethod(_length(lambda a, b: a < b, 'less than'))

    @staticmethod
    def bounds(param: Any, lower: Any, upper: Any) -> str:
        if param.value < lower or param.value > upper:
            return f"Value {param.value} in parameter '{param.name}' must be within bounds [{lower}, {upper}]"
        return ''

    @staticmethod
    def one_of(param: Any, values: Sequence[Any]) -> str:
        if param.value in values:
            return ''
        return f"Parameter '{param.name}' with the value '{param.value}' is not in the set {values}"

    @staticmethod
    def not_empty(param: Any) -> str:
        return '' if len(param.value) > 0 else f"Parameter '{param.name}' cannot be empty"

    @staticmethod
    def unique(param: Any) -> str:
        if len(set(param.value)) == len(param.value):
            return ''
        return f"Parameter '{param.name}' must only contain unique values"

    @staticmethod
    def subset_of(param: Any, values: Sequence[Any]) -> str:
        for value in param.value:
            if value not in values:
                return f"Entry '{value}' in parameter '{param.name}' is not in the set {values}"
        return ''

    @staticmethod
    def element_bounds(param: Any, lower: Any, upper: Any) -> str:
        if any(value < lower or value > upper for value in param.value):
            return f"Value {param.value} in parameter '{param.name}' must be within bounds [{lower}, {upper}]"
        return ''

    @staticmethod
    def lower_element_bounds(param: Any, lower: Any) -> str:
        for value in param.value:
            if value < lower:
                return f"Value {value} in parameter '{param.name}' must be above lower bound of {lower}"
        return ''

    @staticmethod
    def upper_element_bounds(param: Any, upper: Any) -> str:
        for value in param.value:
            if value > upper:
                return f"Value {value} in parameter '{param.name}' must be below upper bound of {upper}"
        return ''
