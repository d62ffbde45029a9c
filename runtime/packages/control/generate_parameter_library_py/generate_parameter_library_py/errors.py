"""What is wrong with a file of parameters, and where."""
from __future__ import annotations

import sys
from collections.abc import Callable


class ParameterFileError(Exception):
    """One line: FILE:LINE: what is wrong; and lines that say what to do about it."""

    def __init__(self, file: str, line: int, what: str, *ways_out: str) -> None:
        place = f'{file}:{line}' if line else file
        super().__init__('\n'.join([f'{place}: error: {what}', *(f'  fix: {way}' for way in ways_out)]))


def reported(program: Callable[[], None]) -> int:
    """The exit code of a program; what is wrong with its files goes to standard error, not a traceback."""
    try:
        program()
    except ParameterFileError as error:
        print(error, file=sys.stderr)
        return 1
    return 0
