"""Loggers: levels by name, lines on stderr as rcutils writes them, and a copy for /rosout."""
from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable

UNSET, DEBUG, INFO, WARN, ERROR, FATAL = 0, 10, 20, 30, 40, 50
NAMES = {UNSET: 'UNSET', DEBUG: 'DEBUG', INFO: 'INFO', WARN: 'WARN', ERROR: 'ERROR', FATAL: 'FATAL'}
DEFAULT_FORMAT = '[{severity}] [{time}] [{name}]: {message}'
NS = 1_000_000_000

#: Where a line was logged: file, function, line.
Place = tuple[str, str, int]
#: Told of each line that is written: severity, logger, text, time, place.
Listener = Callable[[int, str, str, int, Place], None]


class Logging:
    """The state of all loggers of the program."""

    def __init__(self) -> None:
        self.levels: dict[str, int] = {}
        self.default_level = INFO
        self.console = True
        self.listener: Listener | None = None
        self.effective: dict[str, int] = {}

    def set_level(self, name: str, level: int) -> None:
        if name:
            self.levels[name] = level
        else:
            self.default_level = level or INFO
        self.effective.clear()

    def own_level(self, name: str) -> int:
        return self.levels.get(name, UNSET) if name else self.default_level

    def effective_level(self, name: str) -> int:
        """The level of the nearest of the name's ancestors that has one."""
        found = self.effective.get(name)
        if found is None:
            found, part = self.levels.get(name, UNSET), name
            while found == UNSET and '.' in part:
                part = part.rpartition('.')[0]
                found = self.levels.get(part, UNSET)
            found = found or self.default_level
            self.effective[name] = found
        return found

    def log(self, severity: int, name: str, text: str, place: Place) -> None:
        """Write a line whose level was looked at already."""
        now = time.time_ns()
        if self.console:
            sys.stderr.write(format_line(severity, name, text, now, place) + '\n')
        if self.listener is not None:
            self.listener(severity, name, text, now, place)


logging = Logging()


def format_line(severity: int, name: str, text: str, now: int, place: Place) -> str:
    form = os.environ.get('RCUTILS_CONSOLE_OUTPUT_FORMAT', '') or DEFAULT_FORMAT
    clock = f'{now // NS}.{now % NS:09d}'
    if form == DEFAULT_FORMAT:
        return f'[{NAMES.get(severity, "UNKNOWN")}] [{clock}] [{name}]: {text}'
    values = {
        'severity': NAMES.get(severity, 'UNKNOWN'), 'name': name, 'message': text, 'time': clock,
        'time_as_nanoseconds': str(now), 'file_name': place[0], 'function_name': place[1], 'line_number': str(place[2]),
    }
    line, at = '', 0
    while at < len(form):
        end = form.find('}', at)
        key = form[at + 1:end] if form[at] == '{' and end > 0 else None
        if key is not None and key in values:
            line += values[key]
            at = end + 1
        else:
            line += form[at]
            at += 1
    return line
