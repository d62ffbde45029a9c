"""What is done when something happens to a process, or when a launch file says that something has happened."""
from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from ros2wasm_launch import host
from ros2wasm_launch.printed_text import when_printed

from .events import Shutdown, to_come
from .events.process import ProcessExited, ProcessStarted

#: That were registered, for events of the launch file's own.
REGISTERED: list[EventHandler] = []
#: Of the process that is followed, and what it then hears.
_KINDS: tuple[tuple[str, type[Any]], ...] = (('start', ProcessStarted), ('exit', ProcessExited))

Followed = tuple[dict[str, Any], Any]


def _event_of(kind: type, process: Any) -> Any:
    """As of a process that did well."""
    name = getattr(process, 'node_executable', None) or getattr(process, '_process_name', None) or ''
    return kind(action=process, returncode=0, pid=0, cmd=[], cwd=None, env=None, name=name, process_name=name)


def _processes() -> list[Any]:
    from .actions import PROCESSES

    return PROCESSES


class EventHandler:
    """`_made`: actions, or a function of event and context that gives them."""

    def __init__(self, *, matcher: Callable[[Any], bool] | None = None, entities: Any = None,
                 handle_once: bool = False) -> None:
        self._matcher = matcher
        self._made = entities
        self.handle_once = handle_once

    @property
    def entities(self) -> Any:
        return self._made

    def matches(self, event: Any) -> bool:
        return self._matcher is not None and bool(self._matcher(event))

    def handle(self, event: Any, context: Any) -> Any:
        return self._made(event, context) if callable(self._made) else self._made

    def _attributes(self, kind: str, **more: Any) -> dict[str, Any]:
        attributes = {'event': kind, 'handler': host.OBJECTS.number(self), **more}
        return {**attributes, 'once': True} if self.handle_once else attributes

    def _on(self, kind: str, event: Any, **more: Any) -> Followed:
        """For the evaluator: what is followed, and the actions unless they are asked for."""
        attributes = self._attributes(kind, **more)
        if callable(self._made) or type(self).handle is not EventHandler.handle:
            return {**attributes, 'call': host.OBJECTS.number(partial(self.handle, event))}, None
        return attributes, self._made

    def _hears(self, event: Any) -> bool:
        """A function that knows other events only may fail with this one."""
        try:
            return self.matches(event)
        except (AttributeError, TypeError):
            return False

    def _followed(self) -> Iterator[Followed]:
        for process in _processes():
            for kind, event_type in _KINDS:
                event = _event_of(event_type, process)
                if self._hears(event):
                    yield self._on(kind, event, process=host.OBJECTS.number(process))
        if self._hears(to_come()):
            yield self._on('shutdown', to_come())


BaseEventHandler = EventHandler


class _OnProcess(EventHandler):
    """Of one process, of those that a function chooses, or of any."""

    _event, _event_type = _KINDS[0]

    def __init__(self, target_action: Any, made: Any, handle_once: bool) -> None:
        super().__init__(entities=made, handle_once=handle_once)
        self._target = target_action

    def matches(self, event: Any) -> bool:
        if not isinstance(event, (ProcessStarted, ProcessExited)) or not isinstance(event, self._event_type):
            return False
        from .action import Action

        target = self._target
        action = event.action
        return target is None or (action is target if isinstance(target, Action) else bool(target(action)))

    def _followed(self) -> Iterator[Followed]:
        from .actions import ExecuteLocal

        target = self._target
        if target is None and not callable(self._made):
            yield self._attributes(self._event, any=True), self._made
            return
        chosen = [target] if isinstance(target, ExecuteLocal) else [
            one for one in _processes() if self._hears(_event_of(self._event_type, one))]
        for process in chosen:
            yield self._on(self._event, _event_of(self._event_type, process), process=host.OBJECTS.number(process))
        if not chosen and target is not None:
            yield self._attributes(self._event), None  # of nothing that is followed


class OnProcessStart(_OnProcess):
    def __init__(self, *, target_action: Any = None, on_start: Any, handle_once: bool = False) -> None:
        super().__init__(target_action, on_start, handle_once)


class OnProcessExit(_OnProcess):
    _event, _event_type = _KINDS[1]

    def __init__(self, *, target_action: Any = None, on_exit: Any, handle_once: bool = False) -> None:
        super().__init__(target_action, on_exit, handle_once)


class OnExecutionComplete(_OnProcess):
    _event, _event_type = _KINDS[1]

    def __init__(self, *, target_action: Any = None, on_completion: Any, handle_once: bool = False) -> None:
        super().__init__(target_action, on_completion, handle_once)


class OnProcessIO(_OnProcess):
    """What its functions do is found out by what they ask of a text, when the launch file is evaluated."""

    _event = 'output'

    def __init__(self, *, target_action: Any = None, on_stdin: Any = None, on_stdout: Any = None,
                 on_stderr: Any = None, handle_once: bool = False) -> None:
        super().__init__(target_action, self._explored, handle_once)
        self._functions = {'stdout': on_stdout, 'stderr': on_stderr}

    def _explored(self, event: Any, _context: Any) -> Any:
        return [one for stream, function in self._functions.items() if function is not None
                for one in when_printed(stream, function, event)]


class OnShutdown(EventHandler):
    def __init__(self, *, on_shutdown: Any, handle_once: bool = False) -> None:
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), entities=on_shutdown,
                         handle_once=handle_once)

    def _followed(self) -> Iterator[Followed]:
        yield self._on('shutdown', to_come())


class OnIncludeLaunchDescription(EventHandler):
    def _followed(self) -> Iterator[Followed]:
        yield self._attributes('include'), None


def event_named(name: str) -> Callable[[Any], bool]:
    return lambda event: getattr(event, 'name', None) == name
