"""launch's substitutions: each is a name and arguments."""
from __future__ import annotations

from typing import Any

from ros2wasm_launch.texts import call, plain, text_of

from .substitution import Substitution


class SubstitutionFailure(RuntimeError):
    """A substitution that cannot be."""


class Called(Substitution):
    """One that the evaluator knows under a name. Arguments that are None are skipped."""

    def __init__(self, name: str, *arguments: Any) -> None:
        self._name = name
        self._arguments = tuple(one for one in arguments if one is not None)

    def _written(self) -> str:
        return call(self._name, *self._arguments)


class TextSubstitution(Substitution):
    def __init__(self, *, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(f'text is a str, found {text!r}')
        self.text = text

    def _written(self) -> str:
        return plain(self.text)


class LaunchConfiguration(Called):
    def __init__(self, variable_name: Any, *, default: Any = None) -> None:
        # A default that is not text, such as True, is what it prints as.
        given = str(default) if isinstance(default, (bool, int, float)) else default
        super().__init__('var', variable_name, given)
        self.variable_name = variable_name


class EnvironmentVariable(Called):
    def __init__(self, name: Any, *, default_value: Any = None) -> None:
        super().__init__('env', name, default_value)


class PythonExpression(Called):
    def __init__(self, expression: Any, python_modules: Any = None) -> None:
        super().__init__('eval', expression, python_modules and ', '.join(text_of(one) for one in python_modules))


class Command(Called):
    def __init__(self, command: Any, *, on_stderr: Any = None) -> None:
        super().__init__('command', command, on_stderr)


class PathJoinSubstitution(Called):
    def __init__(self, substitutions: Any) -> None:
        super().__init__('path-join', *substitutions)

    def __truediv__(self, other: Any) -> PathJoinSubstitution:
        return PathJoinSubstitution([*self._arguments, other])


class PathSubstitution(PathJoinSubstitution):
    """A beginning, to be gone on from with `/`."""

    def __init__(self, path: Any) -> None:
        super().__init__([path])


class StringJoinSubstitution(Called):
    def __init__(self, substitutions: Any, delimiter: Any = '') -> None:
        super().__init__('string-join', delimiter, *substitutions)


class StringStripSubstitution(Called):
    def __init__(self, substitution: Any) -> None:
        super().__init__('string-strip', substitution)


class AnonName(Called):
    def __init__(self, name: Any) -> None:
        super().__init__('anon', name)


class FileContent(Called):
    def __init__(self, path: Any) -> None:
        super().__init__('file-content', path)


class FindExecutable(Called):
    def __init__(self, *, name: Any) -> None:
        super().__init__('find-exec', name)


class LaunchLogDir(Called):
    def __init__(self) -> None:
        super().__init__('log_dir')


class ThisLaunchFile(Called):
    def __init__(self) -> None:
        super().__init__('filename')


class ThisLaunchFileDir(Called):
    def __init__(self) -> None:
        super().__init__('dirname')


class NotSubstitution(Called):
    def __init__(self, value: Any) -> None:
        super().__init__('not', _condition(value))


class AndSubstitution(Called):
    def __init__(self, left: Any, right: Any) -> None:
        super().__init__('and', _condition(left), _condition(right))


class OrSubstitution(Called):
    def __init__(self, left: Any, right: Any) -> None:
        super().__init__('or', _condition(left), _condition(right))


class AnySubstitution(Called):
    def __init__(self, *args: Any) -> None:
        super().__init__('any', *map(_condition, args))


class AllSubstitution(Called):
    def __init__(self, *args: Any) -> None:
        super().__init__('all', *map(_condition, args))


class EqualsSubstitution(Called):
    def __init__(self, left: Any, right: Any) -> None:
        super().__init__('equals', _condition(left), _condition(right))


class NotEqualsSubstitution(Called):
    def __init__(self, left: Any, right: Any) -> None:
        super().__init__('not-equals', _condition(left), _condition(right))


class IfElseSubstitution(Called):
    def __init__(self, condition: Any, if_value: Any = '', else_value: Any = '') -> None:
        super().__init__('if', _condition(condition), if_value, else_value)


class ForEachVar(Called):
    def __init__(self, name: Any, *, default_value: Any = None) -> None:
        super().__init__('for-var', name, default_value)


class ForLoopIndex(Called):
    def __init__(self, name: Any) -> None:
        super().__init__('index', name)


class LocalSubstitution(Called):
    """Of an event, which only a running launch has: the evaluator knows where it may stand."""

    def __init__(self, expression: str, description: str | None = None) -> None:
        super().__init__('local', expression)
        self.expression = expression
        self.description = description


def _condition(value: Any) -> Any:
    if value is None:
        return ''
    return str(value) if isinstance(value, (bool, int, float)) else value
