"""Asks the evaluator of launch files, which waits for what this interpreter records."""
from __future__ import annotations

import json
import sys
from collections.abc import Callable
from typing import Any

import ros2wasm_host
from ros2wasm_launch.configurations import Configurations

#: Files of this path are not the user's.
OURS = __file__.rsplit('/', 2)[0] + '/'


class HostError(Exception):
    """What the evaluator refuses."""


def ask(kind: str, **more: Any) -> dict[str, Any]:
    answer: dict[str, Any] = json.loads(ros2wasm_host.ask(json.dumps({'ask': kind, **more})))
    if 'error' in answer:
        raise HostError(answer['error'])
    return answer


def evaluate(text: str, configurations: dict[str, str]) -> str:
    """What a text with substitutions comes to, where the evaluator now is."""
    if isinstance(configurations, Configurations):
        configurations.read_by(text)
        configurations = configurations.plain()
    return str(ask('evaluate', text=text, configurations=configurations)['text'])


#: The arguments of the launch, for what upstream reads from the command line.
GIVEN: dict[str, str] = {}


class Objects:
    """Things of Python that the evaluator holds by a number."""

    def __init__(self) -> None:
        self._all: list[Any] = []
        self._numbers: dict[int, int] = {}

    def number(self, thing: Any) -> int:
        if id(thing) not in self._numbers:
            self._numbers[id(thing)] = len(self._all)
            self._all.append(thing)  # held, so that its id is never another's
        return self._numbers[id(thing)]

    def __getitem__(self, number: int) -> Any:
        return self._all[number]


OBJECTS = Objects()


def place() -> dict[str, Any]:
    """File and line of the user's that is being run."""
    frame = sys._getframe(1)
    found = None
    while frame is not None:
        name = frame.f_code.co_filename
        if name.startswith('/') and not name.startswith((OURS, '/lib/')):
            found = frame
            break
        if frame.f_back is None:
            break
        frame = frame.f_back
    return {'file': found.f_code.co_filename, 'line': found.f_lineno} if found else {'file': '', 'line': 0}


def noted_place(initialize: Callable[..., None]) -> Callable[..., None]:
    """Wraps an `__init__`, so that the thing knows where it was made."""
    def wrapped(self: Any, *arguments: Any, **named: Any) -> None:
        if not hasattr(self, '_place'):
            self._place = place()
        initialize(self, *arguments, **named)
    return wrapped
