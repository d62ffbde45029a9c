"""What happens to processes."""
from __future__ import annotations

import signal
from typing import Any


class _OfProcess:
    def __init__(self, *, action: Any = None, **facts: Any) -> None:
        self.action = action
        self.__dict__.update(facts)


class ProcessStarted(_OfProcess):
    name = 'launch.events.process.ProcessStarted'


class ProcessExited(_OfProcess):
    name = 'launch.events.process.ProcessExited'


class ProcessIO(_OfProcess):
    name = 'launch.events.process.ProcessIO'


class ProcessStdout(ProcessIO):
    pass


class ProcessStderr(ProcessIO):
    pass


class ProcessStdin(ProcessIO):
    pass


class Named:
    """Which process is meant: one that no action names."""

    def __init__(self, what: Any) -> None:
        self.what = what

    def __call__(self, action: Any) -> bool:
        return self.what in (getattr(action, '_process_name', None), getattr(action, 'node_executable', None))


matches_executable = matches_name = matches_pid = Named


class ShutdownProcess:
    name = 'launch.events.process.ShutdownProcess'
    signal_name = 'SIGINT'
    _ends = True

    def __init__(self, *, process_matcher: Any) -> None:
        self.process_matcher = process_matcher


class SignalProcess:
    name = 'launch.events.process.SignalProcess'

    def __init__(self, *, signal_number: Any, process_matcher: Any) -> None:
        self.signal = signal_number
        self.signal_name = signal_number if isinstance(signal_number, str) else signal.Signals(signal_number).name
        self.process_matcher = process_matcher
        self._ends = self.signal_name in ('SIGINT', 'SIGTERM', 'SIGKILL', 'SIGQUIT')
