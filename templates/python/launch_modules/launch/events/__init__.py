"""What happens while a launch runs."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from . import process

__all__ = ['Event', 'ExecutionComplete', 'IncludeLaunchDescription', 'Shutdown', 'TimerEvent', 'matches_action',
           'process']

#: In texts, where the reason of a shutdown will stand; launch_steps.ts and bundler/launch/launch_step.hpp know it too.
_REASON = '\u2039why all ends\u203a'


class Event:
    name = 'launch.Event'


class Shutdown(Event):
    name = 'launch.events.Shutdown'

    def __init__(self, *, reason: str = 'reason not given', due_to_sigint: bool = False) -> None:
        self.reason = reason
        self.due_to_sigint = due_to_sigint


def to_come() -> Shutdown:
    """The one that a handler will hear of when the site runs."""
    return Shutdown(reason=_REASON)


class ExecutionComplete(Event):
    def __init__(self, *, action: Any) -> None:
        self.action = action


class IncludeLaunchDescription(Event):
    def __init__(self, launch_description: Any) -> None:
        self.launch_description = launch_description


class TimerEvent(Event):
    def __init__(self, *, timer_action: Any) -> None:
        self.timer_action = timer_action


class Matcher:
    """Says which process or node is meant. `action`: when it is one of the file's."""

    def __init__(self, action: Any) -> None:
        self.action = action

    def __call__(self, other: Any) -> bool:
        return other is self.action


def matches_action(target_action: Any) -> Callable[[Any], bool]:
    return Matcher(target_action)
