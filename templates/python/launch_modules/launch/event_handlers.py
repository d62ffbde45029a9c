"""What is done when something happens to a process."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ros2wasm_launch import host

from .events import Shutdown
from .events.process import ProcessExited, ProcessStarted


class EventHandler:
    """`event` says which; `_made`: actions, or a function of event and context that gives them."""

    _event = ''

    def __init__(self, *, matcher: Callable[[Any], bool] | None = None, entities: Any = None,
                 handle_once: bool = False) -> None:
        self._target: Any = None
        self._made = entities
        self.handle_once = handle_once

    def _attributes(self) -> dict[str, Any]:
        attributes: dict[str, Any] = {'event': self._event, 'handler': host.OBJECTS.number(self)}
        from .actions import ExecuteLocal

        # A function that chooses among processes, or another action, is no process that is followed.
        if isinstance(self._target, ExecuteLocal):
            attributes['process'] = host.OBJECTS.number(self._target)
        if callable(self._made):
            attributes['call'] = host.OBJECTS.number(self._call)
        if self.handle_once:
            attributes['once'] = True
        return attributes

    def _call(self, context: Any) -> Any:
        """What the function gives back for a process that did well."""
        if self._event == 'shutdown':
            return self._made(Shutdown(), context)
        kind = ProcessStarted if self._event == 'start' else ProcessExited
        return self._made(kind(action=self._target, returncode=0, pid=0, cmd=[], cwd=None, env=None, name=''), context)

    def _actions(self) -> Any:
        return None if callable(self._made) else self._made


class _OnProcess(EventHandler):
    def __init__(self, target_action: Any, made: Any, handle_once: bool) -> None:
        super().__init__(entities=made, handle_once=handle_once)
        self._target = target_action


class OnProcessStart(_OnProcess):
    _event = 'start'

    def __init__(self, *, target_action: Any = None, on_start: Any, handle_once: bool = False, **_more: Any) -> None:
        super().__init__(target_action, on_start, handle_once)


class OnProcessExit(_OnProcess):
    _event = 'exit'

    def __init__(self, *, target_action: Any = None, on_exit: Any, handle_once: bool = False, **_more: Any) -> None:
        super().__init__(target_action, on_exit, handle_once)


class OnExecutionComplete(_OnProcess):
    _event = 'exit'

    def __init__(self, *, target_action: Any = None, on_completion: Any, handle_once: bool = False,
                 **_more: Any) -> None:
        super().__init__(target_action, on_completion, handle_once)


class OnProcessIO(_OnProcess):
    _event = 'output'

    def __init__(self, *, target_action: Any = None, on_stdin: Any = None, on_stdout: Any = None,
                 on_stderr: Any = None, **_more: Any) -> None:
        super().__init__(target_action, on_stdout or on_stderr or on_stdin, False)


class OnShutdown(EventHandler):
    _event = 'shutdown'

    def __init__(self, *, on_shutdown: Any, **_more: Any) -> None:
        super().__init__(entities=on_shutdown)


class OnIncludeLaunchDescription(EventHandler):
    _event = 'include'


def event_named(name: str) -> Callable[[Any], bool]:
    return lambda event: getattr(event, 'name', None) == name
