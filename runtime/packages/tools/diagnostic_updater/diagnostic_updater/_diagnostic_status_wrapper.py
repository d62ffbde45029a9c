"""A status that is filled in by calls."""
from __future__ import annotations

from typing import Any

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue


def level_and_message(args: tuple[Any, ...]) -> tuple[bytes, str]:
    """Of a status, or of two arguments."""
    if len(args) == 1:
        return args[0].level, args[0].message
    level, message = args
    return level, str(message)


class DiagnosticStatusWrapper(DiagnosticStatus):  # type: ignore[misc]
    """A message that can be published as it is."""

    def summary(self, *args: Any) -> None:
        """Take level and message: of a status, or as two arguments."""
        self.level, self.message = level_and_message(args)

    def clearSummary(self) -> None:
        self.summary(DiagnosticStatus.OK, '')

    def mergeSummary(self, *args: Any) -> None:
        """The worse level wins; messages are joined when both are fine or neither is."""
        level, message = level_and_message(args)
        if (level > DiagnosticStatus.OK) == (self.level > DiagnosticStatus.OK):
            self.message = f'{self.message}; {message}' if self.message else message
        elif level > self.level:
            self.message = message
        self.level = max(level, self.level)

    def add(self, key: str, val: str) -> None:
        self.values.append(KeyValue(key=key, value=val))
