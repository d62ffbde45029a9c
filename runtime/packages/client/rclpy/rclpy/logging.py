"""Loggers and their levels."""
from __future__ import annotations

from pathlib import Path

from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.impl.rcutils_logger import RcutilsLogger
from ros2wasm.log import logging as _logging

__all__ = [
    'LoggingSeverity', 'clear_config', 'get_logger', 'get_logger_effective_level', 'get_logger_level',
    'get_logging_directory', 'get_logging_severity_from_string', 'initialize', 'set_logger_level', 'shutdown',
]

_root_logger = RcutilsLogger()


def get_logger(name: str) -> RcutilsLogger:
    if not name:
        raise ValueError('Logger name must not be empty.')
    return _root_logger.get_child(name)


def initialize() -> None:
    """Nothing is set up before the first line."""


def shutdown() -> None:
    """Nothing is kept open."""


def clear_config() -> None:
    shutdown()
    initialize()


def set_logger_level(name: str, level: int, detailed_error: bool = False) -> None:
    _logging.set_level(name, int(LoggingSeverity(level)))


def get_logger_level(name: str) -> LoggingSeverity:
    return LoggingSeverity(_logging.own_level(name))


def get_logger_effective_level(name: str) -> LoggingSeverity:
    return LoggingSeverity(_logging.effective_level(name))


def get_logging_severity_from_string(log_severity: str) -> int:
    try:
        return int(LoggingSeverity[log_severity.upper()])
    except KeyError:
        raise RuntimeError(f"Severity string '{log_severity}' is not valid") from None


def get_logging_directory() -> Path:
    return Path.home() / '.ros' / 'log'
