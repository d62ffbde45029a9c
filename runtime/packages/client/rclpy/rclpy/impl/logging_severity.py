"""The severities of log lines."""
from __future__ import annotations

from enum import IntEnum

from ros2wasm import log


class LoggingSeverity(IntEnum):
    UNSET = log.UNSET
    DEBUG = log.DEBUG
    INFO = log.INFO
    WARN = log.WARN
    ERROR = log.ERROR
    FATAL = log.FATAL
