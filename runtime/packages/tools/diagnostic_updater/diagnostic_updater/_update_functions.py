"""Tasks that many nodes need: how often something happens, and how old its stamps are."""
from __future__ import annotations

import threading
from collections import deque
from typing import Any

from diagnostic_msgs.msg import DiagnosticStatus
from diagnostic_updater._diagnostic_status_wrapper import DiagnosticStatusWrapper
from diagnostic_updater._diagnostic_updater import DiagnosticTask
from rclpy.clock import Clock, ClockType

NS = 1e-9


class FrequencyStatusParam:
    """freq_bound: {'min': Hz, 'max': Hz}, which the caller may change; window_size: updates."""

    def __init__(self, freq_bound: dict[str, float], tolerance: float = 0.1, window_size: int = 5) -> None:
        self.freq_bound = freq_bound
        self.tolerance = tolerance
        self.window_size = window_size


class FrequencyStatus(DiagnosticTask):
    """Whether something happens as often as it should."""

    def __init__(self, params: FrequencyStatusParam, name: str = 'FrequencyStatus') -> None:
        super().__init__(name)
        self.params = params
        self.lock = threading.Lock()
        self._clock = Clock(clock_type=ClockType.ROS_TIME)
        self.clear()

    def clear(self) -> None:
        with self.lock:
            self.count = 0
            begin = (self._clock.now(), 0)
            #: Of the last updates: when, and how many events there were by then.
            self._windows = deque([begin] * self.params.window_size)

    def tick(self) -> None:
        """It has happened."""
        with self.lock:
            self.count += 1

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        bound, tolerance = self.params.freq_bound, self.params.tolerance
        with self.lock:
            now, count = self._clock.now(), self.count
            begin, before = self._windows.popleft()
            self._windows.append((now, count))
        events = count - before
        window = (now - begin).nanoseconds * NS
        frequency = events / window if window > 0 else 0.0
        least = bound['min'] * (1 - tolerance)
        most = bound['max'] * (1 + tolerance) if 'max' in bound else None
        if events == 0:
            stat.summary(DiagnosticStatus.ERROR, 'No events recorded.')
        elif frequency < least:
            stat.summary(DiagnosticStatus.WARN, 'Frequency too low.')
        elif most is not None and frequency > most:
            stat.summary(DiagnosticStatus.WARN, 'Frequency too high.')
        else:
            stat.summary(DiagnosticStatus.OK, 'Desired frequency met')
        stat.add('Events in window', f'{events}')
        stat.add('Events since startup', f'{count}')
        stat.add('Duration of window (s)', f'{window:f}')
        stat.add('Actual frequency (Hz)', f'{frequency:f}')
        if bound['min'] == bound.get('max'):
            stat.add('Target frequency (Hz)', f"{bound['min']:f}")
        if bound['min'] > 0:
            stat.add('Minimum acceptable frequency (Hz)', f'{least:f}')
        if most is not None:
            stat.add('Maximum acceptable frequency (Hz)', f'{most:f}')
        return stat


class TimeStampStatusParam:
    """How many seconds a stamp may be old."""

    def __init__(self, min_acceptable: float = -1, max_acceptable: float = 5) -> None:
        self.max_acceptable = max_acceptable
        self.min_acceptable = min_acceptable


class TimeStampStatus(DiagnosticTask):
    """Whether stamps are near the time at which they are told of."""

    def __init__(
        self, params: TimeStampStatusParam = TimeStampStatusParam(), name: str = 'Timestamp Status'
    ) -> None:
        super().__init__(name)
        self.params = params
        self.lock = threading.Lock()
        self.early_count = 0
        self.late_count = 0
        self.zero_count = 0
        self._clock = Clock(clock_type=ClockType.ROS_TIME)
        self._begin()

    def _begin(self) -> None:
        self.zero_seen = False
        self._delays: list[float] = []

    def tick(self, stamp: Any) -> None:
        """A stamp: seconds, or a Time."""
        seconds = stamp if isinstance(stamp, float) else stamp.nanoseconds * NS
        with self.lock:
            if seconds == 0:
                self.zero_seen = True
                return
            delay = self._clock.now().nanoseconds * NS - seconds
            # The two at the ends are all that is asked for.
            self._delays = [min([delay, *self._delays]), max([delay, *self._delays])]

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        with self.lock:
            least, most = self._delays or (0.0, 0.0)
            stat.summary(DiagnosticStatus.OK, 'Timestamps are reasonable.')
            if not self._delays:
                stat.summary(DiagnosticStatus.WARN, 'No data since last update.')
            else:
                if least < self.params.min_acceptable:
                    stat.summary(DiagnosticStatus.ERROR, 'Timestamps too far in future seen.')
                    self.early_count += 1
                if most > self.params.max_acceptable:
                    stat.summary(DiagnosticStatus.ERROR, 'Timestamps too far in past seen.')
                    self.late_count += 1
                if self.zero_seen:
                    stat.summary(DiagnosticStatus.ERROR, 'Zero timestamp seen.')
                    self.zero_count += 1
            self._begin()
        stat.add('Earliest timestamp delay:', f'{least:f}')
        stat.add('Latest timestamp delay:', f'{most:f}')
        stat.add('Earliest acceptable timestamp delay:', f'{self.params.min_acceptable:f}')
        stat.add('Latest acceptable timestamp delay:', f'{self.params.max_acceptable:f}')
        stat.add('Late diagnostic update count:', f'{self.late_count}')
        stat.add('Early diagnostic update count:', f'{self.early_count}')
        stat.add('Zero seen diagnostic update count:', f'{self.zero_count}')
        return stat


class Heartbeat(DiagnosticTask):
    """Says that the node runs."""

    def __init__(self) -> None:
        super().__init__('Heartbeat')

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        stat.summary(DiagnosticStatus.OK, 'Alive')
        return stat
