"""What functions do with the lines that a process prints, before there are any: a text that stands for each line notes
what is asked of it, and each answer is tried."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ros2wasm_launch import host
from ros2wasm_launch.entities import Entity, entities_of, entity
from ros2wasm_launch.texts import plain

#: In texts, where the line will stand; launch_steps.ts and bundler/launch/launch_step.hpp know it too.
LINE = '\u2039what it prints\u203a'
#: Of one function.
_MOST_TRIES = 64

#: How the line is looked at (contains, begins, ends, is), the text, and whether case counts.
Question = tuple[str, str, bool]


class Answers:
    """Of one try: those that were chosen before, then no."""

    def __init__(self, chosen: list[bool]) -> None:
        self._chosen = chosen
        self.given: dict[Question, bool] = {}

    def of(self, question: Question) -> bool:
        if question not in self.given:
            number = len(self.given)
            self.given[question] = number < len(self._chosen) and self._chosen[number]
        return self.given[question]


def _plain(text: Any) -> str:
    if isinstance(text, (bytes, bytearray)):
        return text.decode()
    if not isinstance(text, str):
        raise TypeError(f'a line is compared with texts, not with {text!r}')
    return text


class PrintedText:
    """Bytes or text, which a line is here."""

    def __init__(self, answers: Answers, fold: Callable[[str], str] | None = None) -> None:
        self._answers, self._fold = answers, fold

    def _is(self, how: str, text: Any) -> bool:
        wanted = _plain(text)
        if how in ('is', 'ends'):
            wanted = wanted.rstrip('\r\n')
        if self._fold is not None and self._fold(wanted) != wanted:
            return False
        if wanted == '' and how != 'is':
            return True
        return self._answers.of((how, wanted, self._fold is None))

    def __contains__(self, text: Any) -> bool:
        return self._is('contains', text)

    def __eq__(self, other: object) -> bool:
        return self._is('is', other) if isinstance(other, (str, bytes)) else other is self

    __hash__ = object.__hash__

    def startswith(self, start: Any) -> bool:
        return any(self._is('begins', one) for one in (start if isinstance(start, tuple) else (start,)))

    def endswith(self, end: Any) -> bool:
        return any(self._is('ends', one) for one in (end if isinstance(end, tuple) else (end,)))

    def find(self, text: Any) -> int:
        return 0 if text in self else -1

    def count(self, text: Any) -> int:
        return int(text in self)

    def decode(self, *_how: Any, **_more: Any) -> PrintedText:
        return self

    encode = decode

    def strip(self, marks: Any = None) -> PrintedText:
        if marks is not None and _plain(marks).strip():
            raise TypeError('of a line that is to come, white space can be taken away only')
        return self

    rstrip = lstrip = strip

    def lower(self) -> PrintedText:
        return PrintedText(self._answers, str.lower)

    casefold = lower

    def upper(self) -> PrintedText:
        return PrintedText(self._answers, str.upper)

    def splitlines(self, keepends: bool = False) -> list[PrintedText]:
        return [self]

    def split(self, mark: Any = None) -> list[PrintedText]:
        if mark is None or _plain(mark) != '\n':
            raise TypeError('a line that is to come has no parts')
        return [self]

    def __bool__(self) -> bool:
        return True

    def __str__(self) -> str:
        return LINE

    def __repr__(self) -> str:
        return LINE

    def __format__(self, form: str) -> str:
        return LINE

    def __add__(self, other: Any) -> str:
        return LINE + _plain(other)

    def __radd__(self, other: Any) -> str:
        return _plain(other) + LINE


class Printed:
    """The event."""

    name = 'launch.events.process.ProcessIO'

    def __init__(self, stream: str, text: PrintedText, started: Any) -> None:
        self.text = text
        self.from_stdin, self.from_stdout, self.from_stderr = False, stream == 'stdout', stream == 'stderr'
        self.fd = 1 if self.from_stdout else 2
        self.action, self.pid, self.process_name = started.action, started.pid, started.process_name


def _place(function: Any) -> dict[str, Any]:
    code = getattr(function, '__code__', None)
    return {'file': code.co_filename, 'line': code.co_firstlineno} if code is not None else host.place()


class When:
    """What follows when the answers are these."""

    def __init__(self, place: dict[str, Any], stream: str, given: dict[Question, bool], followed: list[Entity]) -> None:
        tests = [part for (how, text, case), holds in given.items() for part in (how, text, case, holds)]
        self._entity = entity('when_printed', place, {'stream': stream, 'tests': tests}, followed)

    def _entities(self) -> list[Entity]:
        return [self._entity]


class LeftOut:
    """A function that asks more of a line than can be known before."""

    def __init__(self, place: dict[str, Any], error: Exception) -> None:
        why = f'the function asks more of a line than can be known before it is printed: {error}'
        self._entity = entity('left_out', place, {'what': 'what follows when a process prints', 'why': plain(why)})

    def _entities(self) -> list[Entity]:
        return [self._entity]


def when_printed(stream: str, function: Callable[[Any], Any], started: Any) -> list[When | LeftOut]:
    """`started`: an event of the process."""
    result: list[When | LeftOut] = []
    waiting: list[list[bool]] = [[]]
    tries = 0
    while waiting:
        chosen = waiting.pop(0)
        tries += 1
        answers = Answers(chosen)
        try:
            if tries > _MOST_TRIES:
                raise TypeError('it has too many cases')
            followed = entities_of(function(Printed(stream, PrintedText(answers), started)))
        except (TypeError, AttributeError, ValueError, IndexError) as error:
            return [LeftOut(_place(function), error)]
        if followed:
            result.append(When(_place(function), stream, answers.given, followed))
        given = list(answers.given.values())
        waiting += [[*given[:number], True] for number in range(len(chosen), len(given))]
    return result
