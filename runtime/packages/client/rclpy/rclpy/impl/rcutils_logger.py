"""A logger with the options of rclpy: once, throttled, without the first."""
from __future__ import annotations

import sys
from types import FrameType
from typing import Any

from rclpy.clock import Clock
from rclpy.impl.logging_severity import LoggingSeverity
from ros2wasm.log import Place, logging

OPTIONS = {'throttle_duration_sec', 'throttle_time_source_type', 'skip_first', 'once', 'severity'}
NS = 1_000_000_000
#: What the filters of a call remember, by the place of the call.
_contexts: dict[tuple[str, int, int], dict[str, Any]] = {}


def _caller() -> FrameType:
    """The frame that called the logger."""
    frame: FrameType | None = sys._getframe(1)
    while frame is not None and frame.f_code.co_filename == __file__:
        frame = frame.f_back
    assert frame is not None
    return frame


class RcutilsLogger:
    def __init__(self, name: str = '') -> None:
        self.name = name

    def get_child(self, name: str) -> RcutilsLogger:
        if not name:
            raise ValueError('Child logger name must not be empty.')
        return RcutilsLogger(f'{self.name}.{name}' if self.name else name)

    def set_level(self, level: int) -> None:
        logging.set_level(self.name, int(LoggingSeverity(level)))

    def get_effective_level(self) -> LoggingSeverity:
        return LoggingSeverity(logging.effective_level(self.name))

    def is_enabled_for(self, severity: int) -> bool:
        return int(severity) >= logging.effective_level(self.name)

    def log(self, message: object, severity: int, **kwargs: Any) -> bool:
        """Log a line; whether it was. Options: once, skip_first, throttle_duration_sec, throttle_time_source_type."""
        level = int(LoggingSeverity(severity))
        frame = _caller()
        if kwargs and not self._passes(frame, level, kwargs):
            return False
        if level < logging.effective_level(self.name):
            return False
        code = frame.f_code
        place: Place = (code.co_filename, code.co_name, frame.f_lineno)
        logging.log(level, self.name, str(message), place)
        return True

    def _passes(self, frame: FrameType, level: int, options: dict[str, Any]) -> bool:
        for name in options:
            if name not in OPTIONS:
                raise TypeError(f'parameter "{name}" is not supported')
        if 'throttle_time_source_type' in options and 'throttle_duration_sec' not in options:
            raise TypeError('required parameter "throttle_duration_sec" not specified but is required for the '
                            'the logging filter "throttle"')
        key = (frame.f_code.co_filename, frame.f_lineno, frame.f_lasti)
        context = _contexts.get(key)
        wanted = {name: value for name, value in options.items() if name != 'throttle_time_source_type'}
        if context is None:
            context = {'severity': level, 'options': wanted, 'told': False, 'skipped': False, 'last': 0}
            _contexts[key] = context
        if context['severity'] != level:
            raise ValueError('Logger severity cannot be changed between calls.')
        if context['options'] != wanted:
            raise ValueError('Requested logging filters cannot be changed between calls.')
        passes = True
        if options.get('once'):
            passes, context['told'] = not context['told'], True
        if passes and options.get('throttle_duration_sec'):
            passes = self._throttle(context, options)
        if options.get('skip_first'):
            skipped, context['skipped'] = context['skipped'], True
            passes = passes and skipped
        return passes

    def _throttle(self, context: dict[str, Any], options: dict[str, Any]) -> bool:
        source = options.get('throttle_time_source_type')
        clock = source if isinstance(source, Clock) else Clock()
        now = clock.now().nanoseconds
        if now < context['last'] + options['throttle_duration_sec'] * NS:
            return False
        context['last'] = now
        return True

    def debug(self, message: object, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.DEBUG, **kwargs)

    def info(self, message: object, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.INFO, **kwargs)

    def warning(self, message: object, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.WARN, **kwargs)

    def warn(self, message: object, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.WARN, **kwargs)

    def error(self, message: object, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.ERROR, **kwargs)

    def fatal(self, message: object, **kwargs: Any) -> bool:
        return self.log(message, LoggingSeverity.FATAL, **kwargs)
