"""`from distutils import log`: what a package tells while it is installed, which nobody reads."""
from __future__ import annotations

DEBUG, INFO, WARN, ERROR, FATAL = 1, 2, 3, 4, 5


def log(level: int, msg: str, *args: object) -> None:
    pass


def debug(msg: str, *args: object) -> None:
    pass


info = warn = error = fatal = debug


def set_threshold(level: int) -> int:
    return INFO


def set_verbosity(v: int) -> None:
    pass
